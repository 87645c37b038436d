// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/event_walk.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "state/advance.h"

namespace deckpipe {
namespace {

// Of each message that `indexOf` gives a place below N, the message at that place; Count where there is none.
template <std::size_t N, typename F>
constexpr std::array<MessageId, N> messagesBy(F&& indexOf) {
  std::array<MessageId, N> ids{};
  ids.fill(MessageId::Count);
  for (const Message& message : kCatalogue) {
    const std::size_t index = indexOf(message);
    if (index >= N) continue;
    if (ids[index] != MessageId::Count) throw "two messages at one place";
    ids[index] = message.id;
  }
  return ids;
}

// The message that the first byte of a frame of PGN EF00 stands for, of reports and of what tells who sends them.
// Whether the frame is that message is for the state to say: then the device has a new report.
constexpr auto kByType = messagesBy<256>([](const Message& message) -> std::size_t {
  const bool isLookedAt = message.family == Family::Akron && (isReport(message) || isIdentity(message));
  return isLookedAt ? typeOf(message.id) : 256;
});

// The same of a CANopen node's frames, by function: what the gateway sends of a monitor's reports, and what stands
// on the page of a node.
constexpr std::size_t kCobFunctions = 16;
constexpr std::size_t functionPlace(std::uint32_t function) { return function >> 7; }
constexpr auto kByFunction = messagesBy<kCobFunctions>([](const Message& message) {
  if (message.pdo != 0 && isReport(message)) return functionPlace(message.pdo);
  const bool isOnPage = message.family == Family::Canopen && !message.page.isEmpty();
  return isOnPage ? functionPlace(message.selector) : kCobFunctions;
});

constexpr bool everyReportIsLookedAt() {
  return std::ranges::all_of(kReports, [](MessageId id) {
    return std::ranges::count(kByType, id) + std::ranges::count(kByFunction, id) > 0;
  });
}
static_assert(everyReportIsLookedAt());

}  // namespace

EventWalk::EventWalk() : m_state(std::make_unique<State>()), m_devices(kMaxDevices) {
  for (std::size_t c = 0; c < kMaxChannels; ++c) {
    m_buses.emplace_back(Channel{static_cast<std::uint8_t>(c)});
    m_nodes.emplace_back(Channel{static_cast<std::uint8_t>(c)});
  }
}

void EventWalk::advance(const FrameStore& frames, const NoteStore& notes, Cursor to,
                        std::vector<Event>& out) {
  m_found.swap(out);
  walkLog(*this, frames, notes, to);
  m_found.swap(out);
}

std::size_t EventWalk::placeOf(const Device& device) const {
  return static_cast<std::size_t>(&device - m_state->devices().all().data());
}

void EventWalk::plan() {
  m_due = kNever;
  for (std::size_t i = 0; i < m_used; ++i) m_due = std::min(m_due, m_devices[i].due());
  for (std::size_t c = 0; c < m_state->channelCount(); ++c)
    m_due = std::min({m_due, m_buses[c].due(), m_nodes[c].due()});
}

void EventWalk::catchUp(Instant time) {
  const std::size_t found = m_found.size();
  while (m_due <= time && m_due != kNever) {
    const Instant now = std::max(m_due, cursor().time);
    m_state->timeCame(now);
    for (std::size_t c = 0; c < m_state->channelCount(); ++c) {
      BusWatch& bus = m_buses[c];
      if (bus.contestsDue() <= now) lookAtIdentities({static_cast<std::uint8_t>(c)}, bus);
      if (bus.due() <= now) bus.timeCame(*m_state, m_found);
      if (m_nodes[c].due() <= now) m_nodes[c].timeCame(*m_state, m_found);
    }
    const auto devices = m_state->devices().all();
    for (std::size_t i = 0; i < m_used; ++i) {
      if (m_devices[i].due() <= now) m_devices[i].timeCame(*m_state, devices[i], m_found);
    }
    plan();
    if (m_due <= now) m_due = now + Duration(1);
  }
  dropSilences(found);
}

void EventWalk::timeCame(Instant time) {
  catchUp(time);
  m_state->timeCame(time);
}

// Of what was found since so many events. The state of such a log knows only restarts that a node says itself.
void EventWalk::dropSilences(std::size_t since) {
  if (!m_state->isFiltered()) return;
  const auto isDropped = [](const Event& event) {
    return kEvents[event.kind].basis == EventBasis::Silence && event.kind != EventKind::Restarted;
  };
  const auto first = m_found.begin() + static_cast<std::ptrdiff_t>(since);
  m_found.erase(std::remove_if(first, m_found.end(), isDropped), m_found.end());
}

void EventWalk::apply(const Note& note) {
  timeCame(std::max(note.time, cursor().time));
  const auto channel = channelOf(note.value);
  const bool wasDown = channel && m_state->channel(*channel).link == ChannelLink::Down;
  const bool comesBack = wasDown && std::holds_alternative<note::LinkUp>(note.value);
  for (std::size_t i = 0; comesBack && i < m_used; ++i) {
    if (m_devices[i].isUsed() && m_devices[i].channel() == channel)
      m_devices[i].expectBack(*m_state, m_state->devices().all()[i]);
  }
  m_state->apply(note);
  const bool isLink =
      std::holds_alternative<note::LinkUp>(note.value) || std::holds_alternative<note::LinkDown>(note.value);
  if (!isLink || channel->value >= kMaxChannels) return;
  const bool isBack = wasDown && m_state->channel(*channel).link == ChannelLink::Up;
  if (isBack) m_buses[channel->value].linkCameBack(m_devices);
  for (std::size_t i = 0; i < m_used; ++i) {
    DeviceWatch& watch = m_devices[i];
    if (!watch.isUsed() || watch.channel() != channel) continue;
    isBack ? watch.linkCameBack(m_state->devices().all()[i], cursor().time)
           : watch.linkChanged(cursor().time);
  }
  m_nodes[channel->value].linkChanged(cursor().time);
  m_buses[channel->value].linkChanged(*m_state);
  plan();
}

void EventWalk::apply(const Frame& frame, Instant time) {
  if (m_due <= time) catchUp(time);
  const std::size_t found = m_found.size();
  m_state->apply(frame, time);
  if ((frame.flags & Frame::kTimeJump) != 0)
    m_found.push_back(eventAt(*m_state, {frame.channel}, EventKind::ClockJump));
  if (frame.channel >= kMaxChannels) return;
  BusWatch& bus = m_buses[frame.channel];
  if (bus.heard(*m_state)) m_due = std::min(m_due, bus.due());
  if (frame.isError()) {
    bus.errorCame(*m_state, m_found);
    m_due = std::min(m_due, bus.due());
  } else if (!frame.isRemote()) {
    if (frame.isExtended()) {
      lookExtended(frame, bus);
    } else {
      lookStandard(frame, bus);
    }
  }
  dropSilences(found);
}

void EventWalk::lookExtended(const Frame& frame, BusWatch& bus) {
  const J1939Id id = J1939Id::of(frame.identifier());
  const Channel channel{frame.channel};
  NodeWatch& nodes = m_nodes[frame.channel];
  nodes.heard(*m_state, id.source, m_found);
  m_due = std::min(m_due, nodes.due());
  MessageId message = MessageId::Count;
  if (id.pgn == pgn::kProprietaryA) {
    if (frame.length > 0) message = kByType[frame.data[0]];
  } else if (id.pgn == pgn::kBasicJoystick) {
    const bool isBack = bus.stickCame(*m_state, id.source, m_found);
    m_due = std::min(m_due, bus.sticksDue());
    if (!isBack) return;
  } else if (id.pgn != pgn::kAddressClaimed && id.pgn != pgn::kExtendedJoystick) {
    return;  // none of what a device of Akron's sends
  }
  if (id.pgn == pgn::kAddressClaimed && id.source == kNullAddress && frame.length == 8)
    bus.cannotClaim(*m_state, Name::of(frame), m_devices, m_found);
  if (id.pgn == pgn::kAddressClaimed || message == MessageId::AddressAnnouncement) {
    if (id.pgn == pgn::kAddressClaimed && frame.length == 8) bus.claimed(id.source, Name::of(frame));
    lookAtIdentities(channel, bus);
    m_due = std::min(m_due, bus.due());
    message = MessageId::Count;
  }
  const bool isToDevice = message != MessageId::Count && messageOf(message).device == DeviceEnd::Receiver;
  const Device* device = m_state->devices().byAddress(channel, isToDevice ? id.destination : id.source);
  if (device != nullptr) {
    look(*device, message, frame.data, bus);
  } else if (message != MessageId::Count && !isToDevice) {
    bus.strangerCame(id.source, cursor().time);
  }
}

void EventWalk::lookStandard(const Frame& frame, BusWatch& bus) {
  const CobId cob = CobId::of(frame.identifier());
  if (!cob.hasNode()) return;
  const MessageId message = kByFunction[functionPlace(cob.function)];
  if (message != MessageId::Count) bus.nodeCame(cob.node, cursor().time);
  const Device* device = m_state->devices().byNode({frame.channel}, cob.node);
  if (device == nullptr) return;
  // Other buses use these identifiers too: nothing is told of a node that was not heard as one. Two of its statuses
  // that are both in order are no coincidence.
  const bool isNode =
      device->isKnownNow(MessageId::Heartbeat) || device->isKnownNow(MessageId::FaultResponse) ||
      (device->isKnownNow(MessageId::PositionLimitStatus) && device->isKnownNow(MessageId::DigitalOutputs)) ||
      m_state->channel({frame.channel}).book.isAkronNode(cob.node);
  if (isNode && message != MessageId::Count) look(*device, message, frame.data, bus);
}

void EventWalk::look(const Device& device, MessageId id, const Payload& data, BusWatch& bus) {
  const std::size_t place = placeOf(device);
  const Instant now = cursor().time;
  DeviceWatch& watch = m_devices[place];
  if (!watch.isUsed()) {
    m_used = std::max(m_used, place + 1);
    watch.begin(device, now);
    const Instant since = bus.heardSince(device, now);
    if (bus.isBehindGap() && !device.pin.isNull()) {
      bus.pinCame(*m_state, device, since, watch.toldAs(), m_found);
    } else if (bus.isSettled(since)) {
      Event event = watch.appeared(*m_state, bus.formerAddress(device.address, now));
      if (since < now) event.since = since;
      m_found.push_back(event);
    }
  }
  watch.look(*m_state, device, id, data, m_found);
  if (device.doubled == now && !bus.isShared(device.address)) {
    bus.lookAtShared(*m_state, m_found);
    m_due = std::min(m_due, bus.due());
  }
  m_due = std::min(m_due, watch.due());
}

void EventWalk::lookAtIdentities(Channel channel, BusWatch& bus) {
  bus.lookAtHolders(*m_state, m_devices, m_found);
  const auto devices = m_state->devices().all();
  for (std::size_t i = 0; i < m_used; ++i) {
    DeviceWatch& watch = m_devices[i];
    if (!watch.isUsed()) continue;
    if (!watch.isOf(devices[i])) {
      // It says now who it is, and was heard before.
      if (watch.channel() == channel && watch.nobodySince() != kNotYet)
        bus.strangerCame(watch.address(), watch.nobodySince());
      watch = {};
    } else if (watch.channel() == channel) {
      const std::size_t found = m_found.size();
      watch.lookAtIdentity(*m_state, devices[i], m_found);
      bus.pinCame(*m_state, devices[i], watch.heardFrom(cursor().time), watch.toldAs(), m_found);
      for (Event& event : std::span(m_found).subspan(found)) {
        const Device* taker = m_state->devices().byAddress(channel, event.address);
        if (event.kind == EventKind::AddressLost && taker != nullptr) bus.nameParties(event, taker->pin);
      }
    }
  }
  bus.lookAtShared(*m_state, m_found);
}

}  // namespace deckpipe
