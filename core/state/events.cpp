// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/events.h"

#include <algorithm>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "protocol/lists.h"

namespace deckpipe {

bool Events::take(const LogDocument& log, std::uint64_t until, std::uint64_t atMost) {
  const std::uint64_t end = std::min({until, log.roles.built(), m_looked + atMost});
  LogTimes times(log.frames);
  while (m_looked < end && !isFull()) {
    for (const Frame& frame : log.frames.run(m_looked)) {
      if (m_looked == end || isFull()) break;
      Event at;
      at.frame = m_looked;
      at.time = times.at(m_looked);
      at.channel = Channel{frame.channel};
      look(log, frame, at);
      ++m_looked;
    }
  }
  return m_looked >= until || isFull();
}

// What the index of roles says of this frame. Asked only where something may have changed.
bool Events::isMessage(const LogDocument& log, const Frame& frame, const Event& at, MessageId id) {
  const Classified what = log.roles.classify(at.frame, frame, at.time, m_roles);
  return what.isDecoded() && what.message == id;
}

void Events::look(const LogDocument& log, const Frame& frame, Event at) {
  if ((frame.flags & Frame::kTimeJump) != 0) add(EventKind::ClockJump, at);
  if (frame.channel >= kMaxChannels) return;
  Bus& bus = m_buses[frame.channel];
  if (at.time >= bus.nextDecision) timeCame(log, bus, at);
  if (frame.isError()) {
    const bool isNew = bus.lastError == kNotYet || at.time - bus.lastError >= kSilence;
    bus.lastError = at.time;
    if (isNew) add(EventKind::ErrorFrames, at);
    return;
  }
  if (frame.isRemote() || frame.length == 0) return;
  if (frame.isExtended()) {
    lookExtended(log, bus, frame, at);
  } else {
    lookStandard(log, bus, frame, at);
  }
}

void Events::lookExtended(const LogDocument& log, Bus& bus, const Frame& frame, Event at) {
  const J1939Id id = J1939Id::of(frame.identifier());
  at.address = id.source;
  if (id.pgn == pgn::kAddressClaimed && frame.length == 8) {
    nameHeard(log, bus, Name::of(frame), at);
    return;
  }
  if (id.pgn != pgn::kProprietaryA || id.destination != kGlobalAddress || frame.length != 8) return;
  if (hasTypeOf(frame, MessageId::PositionLimitStatus)) {
    statusHeard(log, bus.addresses[id.source.value], frame, at);
  } else if (hasTypeOf(frame, MessageId::AddressAnnouncement)) {
    announced(log, bus, at);
  }
}

void Events::lookStandard(const LogDocument& log, Bus& bus, const Frame& frame, Event at) {
  const CobId cob = CobId::of(frame.identifier());
  if (!cob.hasNode()) return;
  at.address = kNullAddress;
  at.node = cob.node;
  const auto is = [&cob](CobFunction function) {
    return cob.function == static_cast<std::uint16_t>(function);
  };
  if (is(CobFunction::Heartbeat) && frame.length == 1 && frame.data[0] == gateway::kBooting) {
    add(EventKind::NodeStarted, at);
  } else if (is(CobFunction::Tpdo1) && frame.length == 8 &&
             hasTypeOf(frame, MessageId::PositionLimitStatus)) {
    statusHeard(log, bus.nodes[cob.node.value], frame, at);
  }
}

void Events::nameHeard(const LogDocument& log, Bus& bus, Name name, const Event& at) {
  if (name.isNull() || at.address == kGlobalAddress) return;
  if (at.address == kNullAddress) {
    Event event = at;
    event.name = name;
    const auto holder = std::ranges::find(bus.addresses, name, &Talker::name);
    if (holder != bus.addresses.end())
      event.address = {static_cast<std::uint8_t>(holder - bus.addresses.begin())};
    add(EventKind::CannotClaim, event);
  }
  const AddressBook& book = log.roles.bookAfter(at.frame, at.channel, m_roles);
  bus.nextDecision = book.nextDecision();
  if (at.address != kNullAddress) return compareHolder(book, bus, at.address, at);
  for (std::size_t a = 0; a < bus.addresses.size(); ++a) {
    if (bus.addresses[a].name == name) compareHolder(book, bus, {static_cast<std::uint8_t>(a)}, at);
  }
}

// A contest for an address was decided before this frame.
void Events::timeCame(const LogDocument& log, Bus& bus, const Event& at) {
  const AddressBook& book = log.roles.bookBefore(at.frame, at.channel, m_roles);
  bus.nextDecision = book.nextDecision();
  for (std::size_t a = 0; a < bus.addresses.size(); ++a)
    compareHolder(book, bus, {static_cast<std::uint8_t>(a)}, at);
}

void Events::compareHolder(const AddressBook& book, Bus& bus, Address address, Event at) {
  Talker& talker = bus.addresses[address.value];
  const Name holder = book.holder(address);
  if (talker.name == holder) return;
  talker.name = holder;
  talker.pin = book.pin(address);
  at.address = address;
  at.name = holder;
  if (!holder.isNull()) add(EventKind::Claimed, at);
}

void Events::announced(const LogDocument& log, Bus& bus, Event at) {
  Talker& talker = bus.addresses[at.address.value];
  at.pin = log.roles.bookAfter(at.frame, at.channel, m_roles).pin(at.address);
  if (at.pin.isNull() || talker.pin == at.pin) return;
  const auto before = std::ranges::find(bus.addresses, at.pin, &Talker::pin);
  const bool hasMoved = before != bus.addresses.end();
  if (hasMoved) {
    at.previous = {static_cast<std::uint8_t>(before - bus.addresses.begin())};
    before->pin = {};
    before->lastStatus = kNotYet;  // its silence there is no riddle
  }
  talker.pin = at.pin;
  add(hasMoved ? EventKind::AddressChanged : EventKind::Announced, at);
}

void Events::statusHeard(const LogDocument& log, Talker& talker, const Frame& frame, const Event& at) {
  const bool hasError = PositionLimitStatus::of(frame).operationalError == Status2::On;
  const Instant before = talker.lastStatus;
  const bool wasSilent = before != kNotYet && at.time - before >= kSilence;
  talker.lastStatus = at.time;
  if (!wasSilent && hasError == talker.hasError) return;
  if (!isMessage(log, frame, at, MessageId::PositionLimitStatus)) return;
  if (wasSilent) {
    Event silence = at;
    silence.lasted = at.time - before;
    add(EventKind::SilenceEnded, silence);
  }
  if (hasError != talker.hasError) add(hasError ? EventKind::ErrorBegan : EventKind::ErrorEnded, at);
  talker.hasError = hasError;
}

void Events::add(EventKind kind, Event at) {
  at.kind = kind;
  m_list.push_back(at);
}

}  // namespace deckpipe
