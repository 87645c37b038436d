// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/conversations.h"

#include <algorithm>

#include "bus/j1939.h"
#include "protocol/lists.h"

namespace deckpipe {

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
  if (id.destination == kGlobalAddress || !kSaidTypes[frame.data[0]]) return;
  const Classified what = log.roles.classify(index, frame, time, m_roles);
  if (!what.isDecoded() || what.family == Family::Copley) return;
  const AddressBook& book = m_roles.walk.book(channel);
  const bool isFromDevice = [&] {
    // The pipe: whoever is Akron's is the device.
    if (messageOf(what.message).device == DeviceEnd::Either)
      return book.isAkron(id.source) || !book.isAkron(id.destination);
    return messageOf(what.message).device == DeviceEnd::Sender;
  }();
  const Address at = isFromDevice ? id.source : id.destination;
  const Pin pin = book.pin(at);
  m_list.push_back({index, time, what.message, isFromDevice,
                    pin.isNull() ? DeviceKey::at(channel, at) : DeviceKey::of(pin, channel)});
}

}  // namespace deckpipe
