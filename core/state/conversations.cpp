// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/conversations.h"

#include <algorithm>

#include "bus/j1939.h"

namespace deckpipe {
namespace {

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
  if (id.pgn != pgn::kProprietaryA || frame.length == 0) return;
  if (id.destination == kGlobalAddress || !mayBeSaid(frame.data[0])) return;
  const Classified what = log.roles.classify(index, frame, time, m_roles);
  if (!what.isDecoded() || what.family == Family::Copley) return;
  const AddressBook& book = m_roles.walk.book(channel);
  const bool isFromDevice = [&] {
    // The pipe goes both ways under one message: whoever is Akron's is the device.
    if (what.message == MessageId::PipeData || what.message == MessageId::PipeAck)
      return book.isAkron(id.source) || !book.isAkron(id.destination);
    return messageOf(what.message).device == DeviceEnd::Sender;
  }();
  const Address at = isFromDevice ? id.source : id.destination;
  const Pin pin = book.pin(at);
  m_list.push_back({index, time, what.message, isFromDevice,
                    pin.isNull() ? DeviceKey::at(channel, at) : DeviceKey::of(pin, channel)});
}

}  // namespace deckpipe
