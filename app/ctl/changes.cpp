// SPDX-License-Identifier: GPL-3.0-or-later
#include "changes.h"

#include <algorithm>

#include "base/overload.h"
#include "bus/j1939.h"
#include "event_lines.h"
#include "protocol/lists.h"
#include "report/decode_lines.h"
#include "state/bus_watch.h"

namespace deckpipe::ctl {
namespace {

void addWho(JsonLine& line, const Device& device) {
  if (device.kind == Device::Kind::Node) {
    line.add("node", device.node.value);
  } else {
    line.add("pin", device.pin).add("address", device.address);
  }
}

// Marks, labels and drives are a person's own words; what was asked and its answers are seen in the frames.
bool isWatched(const NoteValue& value) {
  return std::visit(
      Overload{[](const note::LinkUp&) { return true; }, [](const note::LinkDown&) { return true; },
               [](const note::Locked&) { return true; }, [](const note::Unlocked&) { return true; },
               [](const note::Dropped&) { return true; }, [](const note::LeftOut&) { return true; },
               [](const note::OwnAddress&) { return true; }, [](const note::StillWaits&) { return true; },
               [](const auto&) { return false; }},
      value);
}

}  // namespace

Changes::Changes(BusFollower& follower, Channel channel, std::string channelName, std::string& out)
    : m_follower(follower), m_channel(channel), m_channelName(std::move(channelName)), m_out(out) {
  follower.onFrame = [this](const Frame& frame, const Classified& what) { frameCame(frame, what); };
  follower.onNote = [this](const Note& note) { noteCame(note); };
  follower.onChange = [this] { compare(); };
  follower.due = [this] {
    Instant due = kNever;
    for (const StickWatch& stick : m_sticks) due = std::min(due, stick.due());
    return due;
  };
}

void Changes::frameCame(const Frame& frame, const Classified& what) {
  compare();  // who speaks comes before what is said
  if (m_newsFrom == kNever) m_newsFrom = m_follower.state().cursor().time + kSettling;
  stickCame(frame);
  if (!what.isDecoded() || !messageOf(what.message).isWatched) return;
  const Message& message = messageOf(what.message);
  if (message.period > 0ns) {
    const std::uint64_t bytes = loadLittle(frame.data) & newsBits(message);
    // Nor does the priority in its identifier say anything.
    const auto [last, isNew] = m_last.try_emplace({frame.identifier() & 0x3FF'FFFFu, what.message}, bytes);
    if (!isNew && last->second == bytes) return;
    last->second = bytes;
  }
  std::string decoded;
  appendDecoded(decoded, DecodeFormat::JsonLines, frame, m_channelName, what);
  const Device* device = m_follower.deviceOf(frame, what);
  JsonLine line;
  line.add("event", "value").add("pin", device != nullptr ? device->pin : Pin());
  m_out += line.addAllOf(decoded).text();
}

void Changes::noteCame(const Note& note) {
  // Behind a gap a value is compared with none of before.
  if (std::holds_alternative<note::LinkUp>(note.value)) {
    m_last.clear();
    for (StickWatch& stick : m_sticks) {
      stick.linkCameBack();
      stick.linkChanged(note.time);
    }
  } else if (std::holds_alternative<note::LinkDown>(note.value)) {
    m_newsFrom = kNever;
    for (StickWatch& stick : m_sticks) stick.linkChanged(note.time);
  }
  if (!isWatched(note.value)) return;
  JsonLine line;
  line.add("event", noteKey(note.value)).addTime("t", wallTime(note.time)).add("channel", m_channelName);
  if (const auto* own = std::get_if<note::OwnAddress>(&note.value)) line.add("address", own->address);
  addNoteFields(line, note.value);
  m_out += line.text();
}

// The events of `deckpipectl events`. One that sends already when the watch begins is told as one that begins; behind a
// gap of the link it may have sent before.
void Changes::stickCame(const Frame& frame) {
  if (!frame.isExtended() || frame.isRemote() || frame.isError()) return;
  const J1939Id id = J1939Id::of(frame.identifier());
  if (id.pgn != pgn::kBasicJoystick) return;
  const State& state = m_follower.state();
  const auto sticks = state.channel(m_channel).joysticks.all();
  std::vector<Event> found;
  for (std::size_t i = 0; i < sticks.size(); ++i) {
    if (sticks[i].source != id.source) continue;
    if (sticks[i].basic.at == state.cursor().time) {
      const bool isNews = state.cursor().time >= m_newsFrom;
      m_sticks[i].look(state, m_channel, sticks[i], isNews, found);
    } else {
      m_sticks[i].malformedCame(state, m_channel, sticks[i], found);
    }
  }
  tell(found);
}

void Changes::compareSticks() {
  const State& state = m_follower.state();
  const auto sticks = state.channel(m_channel).joysticks.all();
  std::vector<Event> found;
  for (std::size_t i = 0; i < sticks.size(); ++i) m_sticks[i].timeCame(state, m_channel, sticks[i], found);
  tell(found);
}

void Changes::tell(const std::vector<Event>& events) {
  for (const Event& event : events) {
    JsonLine line;
    line.add("event", kEvents[event.kind].key).addTime("t", wallTime(event.time));
    line.add("channel", m_channelName).add("address", event.address);
    addEventFields(line, event);
    if (event.since != kNotYet) line.addTime("since", wallTime(event.since));
    if (event.folded > 0) line.add("folded", event.folded);
    m_out += line.text();
  }
}

void Changes::compare() {
  compareSticks();
  const State& state = m_follower.state();
  const ChannelState& bus = state.channel(m_channel);
  const auto begin = [&](const char* event) {
    JsonLine line;
    line.add("event", event).addTime("t", wallTime(state.cursor().time)).add("channel", m_channelName);
    return line;
  };
  for (std::size_t a = 0; a < kNullAddress.value; ++a) {
    const Address address{static_cast<std::uint8_t>(a)};
    const std::uint64_t name = bus.book.holder(address).value;
    if (name == m_names[a]) continue;
    if (name == 0 && bus.book.formerHolder(address).value == m_names[a]) {
      m_names[a] = 0;
      continue;
    }
    m_out += begin(name != 0 ? "claimed" : "claim_lost")
                 .add("address", address)
                 .addHex("name", name != 0 ? name : m_names[a], 16)
                 .text();
    m_names[a] = name;
  }
  const auto devices = state.devices().all();
  for (std::size_t i = 0; i < devices.size(); ++i) compareDevice(devices[i], m_shown[i]);
}

void Changes::compareDevice(const Device& device, Shown& shown) {
  const auto begin = [&](const char* event) {
    JsonLine line;
    line.add("event", event)
        .addTime("t", wallTime(m_follower.state().cursor().time))
        .add("channel", m_channelName);
    if (device.kind != Device::Kind::Free) addWho(line, device);
    return line;
  };
  if (shown.kind != device.kind || shown.pin != device.pin || shown.node != device.node) {
    const AddressBook& book = m_follower.state().channel(m_channel).book;
    EnumSet<MessageId> stale;
    if (shown.kind == Device::Kind::Pin && device.kind == Device::Kind::Address &&
        book.formerPin(device.address) == shown.pin) {
      m_out += begin("pin_former").add("former_pin", shown.pin).text();
      stale = shown.stale;
    } else if (device.kind == Device::Kind::Free) {
      // An address that turned out to be somebody else's, or a PIN that had none when the link was down.
      m_out += begin("device_left").add("pin", shown.pin).add("address", shown.address).text();
    } else {
      m_out += begin("device_appeared").addTypeOf(device.pin).text();
    }
    shown = {device.kind, device.pin, device.address, device.node, stale, device.restarted};
  }
  if (shown.address != device.address) {
    m_out += begin(device.address == kNullAddress ? "address_lost" : "address_changed")
                 .add("previous", shown.address)
                 .text();
    shown.address = device.address;
  }
  if (std::exchange(shown.restarted, device.restarted) != device.restarted)
    m_out += begin("restarted").text();
  for (const MessageId id : kPeriodicReports) {
    if (shown.stale.has(id) == device.isStale(id)) continue;
    m_out += begin(device.isStale(id) ? "stale" : "fresh").add("message", messageOf(id).key).text();
  }
  shown.stale = device.stale();
}

}  // namespace deckpipe::ctl
