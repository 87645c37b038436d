// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/conversations.h"

#include <algorithm>

#include "bus/j1939.h"

namespace deckpipe {
namespace {

constexpr std::uint8_t kAnnouncementType = 0xFF;  // protocol.md, 1.3

// Byte 1 of what is sent to or by one device; a cheap look before the roles are asked.
bool mayBeSaid(std::uint8_t type) {
  switch (type) {
    case 0x02:
    case 0x03:
    case 0x04:
    case 0x05:
    case 0x21:
    case 0x22:
    case 0x41:
    case 0x45:
    case 0x46:
    case 0xFE: return true;
    default: return false;
  }
}

}  // namespace

bool Conversations::take(const LogDocument& log, std::uint64_t until, std::uint64_t atMost) {
  const std::uint64_t end = std::min({until, log.roles.built(), m_looked + atMost});
  LogTimes times(log.frames);
  while (m_looked < end && !isFull()) {
    for (const Frame& frame : log.frames.run(m_looked)) {
      if (m_looked == end || isFull()) break;
      if (frame.isExtended() && !frame.isRemote() && !frame.isError() && frame.channel < kMaxChannels)
        look(log, frame, m_looked, times.at(m_looked));
      ++m_looked;
    }
  }
  return m_looked >= until || isFull();
}

void Conversations::look(const LogDocument& log, const Frame& frame, std::uint64_t index, Instant time) {
  const J1939Id id = J1939Id::of(frame.identifier());
  const Channel channel{frame.channel};
  if (id.pgn == pgn::kAddressClaimed && frame.length == 8)
    return nameHeard(channel, id.source, Name::of(frame));
  if (id.pgn != pgn::kProprietaryA || frame.length == 0) return;
  if (id.destination == kGlobalAddress) {
    if (frame.data[0] != kAnnouncementType || frame.length != 8) return;
    if (const auto pin = announcedPin(frame)) announced(channel, id.source, *pin);
    return;
  }
  if (!mayBeSaid(frame.data[0])) return;
  const Classified what = log.roles.classify(index, frame, time, m_roles);
  if (!what.isDecoded() || what.family == Family::Copley) return;
  const bool isFromDevice = [&] {
    // The pipe goes both ways under one message: whoever is Akron's is the device.
    if (what.message == MessageId::PipeData || what.message == MessageId::PipeAck)
      return !m_holders[channel.value][id.source.value].pin.isNull() ||
             m_holders[channel.value][id.destination.value].pin.isNull();
    return messageOf(what.message).device == DeviceEnd::Sender;
  }();
  const Address at = isFromDevice ? id.source : id.destination;
  const Pin& pin = m_holders[channel.value][at.value].pin;
  m_list.push_back({index, time, what.message, isFromDevice,
                    pin.isNull() ? DeviceKey::at(channel, at) : DeviceKey::of(pin, channel)});
}

void Conversations::nameHeard(Channel channel, Address source, Name name) {
  if (name.value == 0 || source == kGlobalAddress) return;
  auto& holders = m_holders[channel.value];
  for (std::size_t i = 0; i < holders.size(); ++i) {
    if (i != source.value && holders[i].name == name.value) holders[i] = {};  // it has moved, or cannot claim
  }
  if (source == kNullAddress) return;
  Holder& holder = holders[source.value];
  // The NAME's identity number is the low 21 bits of PIN digits 7-15.
  const bool isItsOwn = !holder.pin.isNull() && (holder.pin.serial() & 0x1F'FFFF) == name.identityNumber();
  if (!isItsOwn) holder.pin = {};
  holder.name = name.value;
}

void Conversations::announced(Channel channel, Address source, const Pin& pin) {
  for (Holder& holder : m_holders[channel.value]) {
    if (holder.pin == pin) holder.pin = {};
  }
  m_holders[channel.value][source.value].pin = pin;
}

}  // namespace deckpipe
