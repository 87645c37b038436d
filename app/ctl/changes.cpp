// SPDX-License-Identifier: GPL-3.0-or-later
#include "changes.h"

#include "base/overload.h"
#include "json_line.h"
#include "protocol/device_types.h"
#include "protocol/lists.h"
#include "report/decode_lines.h"
#include "request_words.h"

namespace deckpipe::ctl {
namespace {

void addWho(JsonLine& line, const Device& device) {
  if (device.kind == Device::Kind::Node) {
    line.add("node", std::int64_t{device.node.value});
  } else {
    line.add("pin", device.pin).add("address", device.address);
  }
}

}  // namespace

Changes::Changes(BusFollower& follower, Channel channel, std::string channelName, std::string& out)
    : m_follower(follower), m_channel(channel), m_channelName(std::move(channelName)), m_out(out) {
  follower.onFrame = [this](const Frame& frame, const Classified& what) { frameCame(frame, what); };
  follower.onNote = [this](const Note& note) { noteCame(note); };
  follower.onChange = [this] { compare(); };
}

void Changes::frameCame(const Frame& frame, const Classified& what) {
  compare();  // who speaks comes before what is said
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
  JsonLine line;
  line.add("event", noteKey(note.value)).addTime("t", wallTime(note.time)).add("channel", m_channelName);
  const bool isSaid = std::visit(
      Overload{
          [&](const note::LinkUp& n) {
            if (!n.adapter.isEmpty()) line.add("adapter", n.adapter.str());
            if (n.bitRate != 0) line.add("bit_rate", std::int64_t{n.bitRate});
            return true;
          },
          [](const note::Locked&) { return true; }, [](const note::Unlocked&) { return true; },
          [&](const note::LinkDown& n) {
            line.add("reason", kLinkFaultKeys[n.fault]);
            if (!n.words.isEmpty()) line.add("words", n.words.str());
            return true;
          },
          [&](const note::Dropped& n) {
            return line.add("frames", static_cast<std::int64_t>(n.count)), true;
          },
          [&](const note::LeftOut& n) {
            return line.add("frames", static_cast<std::int64_t>(n.count)).add("reason", leftOutWord(n.why)),
                   true;
          },
          [&](const note::OwnAddress& n) {
            return line.add("address", n.address).add("reason", ownAddressWord(n.how)), true;
          },
          [&](const note::StillWaits& n) {
            return line.add("frames", static_cast<std::int64_t>(n.count)), true;
          },
          [](const note::Mark&) { return false; }, [](const note::DriveSaid&) { return false; },
          [](const note::Asked&) { return false; }, [](const note::RequestWaits&) { return false; },
          [](const note::RequestEnded&) { return false; }, [](const note::Pipe&) { return false; },
          [](const note::Label&) { return false; }, [](const note::Added&) { return false; }},
      note.value);
  if (isSaid) m_out += line.text();
}

void Changes::compare() {
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
    std::string text;
    appendHex(text, name != 0 ? name : m_names[a], 16);
    m_out += begin(name != 0 ? "claimed" : "claim_lost").add("address", address).add("name", text).text();
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
    if (device.kind == Device::Kind::Free) {  // an address that turned out to be somebody else's
      m_out += begin("device_left").add("address", shown.address).text();
    } else {
      JsonLine line = begin("device_appeared");
      if (!device.pin.isNull()) {
        const std::string_view type = deviceTypeName(device.pin.deviceType());
        line.add("device_type", std::int64_t{device.pin.deviceType()});
        type.empty() ? line.add("type_name", Value()) : line.add("type_name", type);
      }
      m_out += line.text();
    }
    shown = {device.kind, device.pin, device.address, device.node, {}};
  }
  if (shown.address != device.address) {
    m_out += begin(device.address == kNullAddress ? "address_lost" : "address_changed")
                 .add("previous", shown.address)
                 .text();
    shown.address = device.address;
  }
  for (const MessageId id : kPeriodicReports) {
    if (shown.stale.has(id) == device.isStale(id)) continue;
    m_out += begin(device.isStale(id) ? "stale" : "fresh").add("message", messageOf(id).key).text();
  }
  shown.stale = device.stale();
}

}  // namespace deckpipe::ctl
