// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/exchanges.h"

#include <algorithm>

#include "bus/j1939.h"
#include "protocol/lists.h"
#include "state/devices.h"

namespace deckpipe {

Exchanges::Exchanges(const FrameStore& frames, const RoleIndex& roles) : m_frames(frames), m_roles(roles) {}

bool Exchanges::build(std::uint64_t atMost) {
  const std::uint64_t end = std::min(m_roles.built(), m_looked + atMost);
  const std::uint64_t before = m_looked;
  LogTimes times(m_frames);
  while (m_looked < end && m_list->size() < kMax) {
    for (const Frame& frame : m_frames.run(m_looked)) {
      if (m_looked == end || m_list->size() >= kMax) break;
      if (frame.isExtended() && !frame.isRemote() && !frame.isError() && frame.channel < kMaxChannels)
        look(frame, m_looked, times.at(m_looked));
      ++m_looked;
    }
  }
  return m_looked > before;
}

void Exchanges::restart() {
  m_stand = {};
  m_looked = 0;
  const std::lock_guard lock(m_lock);
  m_list = std::make_shared<List>();
}

std::shared_ptr<const Exchanges::List> Exchanges::list() const {
  const std::lock_guard lock(m_lock);
  return m_list;
}

void Exchanges::look(const Frame& frame, std::uint64_t index, Instant time) {
  const J1939Id id = J1939Id::of(frame.identifier());
  const Channel channel{frame.channel};
  if (id.pgn != pgn::kProprietaryA || frame.length == 0) return;
  if (id.destination == kGlobalAddress || !kSaidTypes[frame.data[0]]) return;
  const Classified what = m_roles.classify(index, frame, time, m_stand);
  if (!what.isDecoded() || what.family == Family::Copley) return;
  const AddressBook& book = m_stand.walk.book(channel);
  const bool isFromDevice = [&] {
    // The pipe: whoever is Akron's is the device.
    if (messageOf(what.message).device == DeviceEnd::Either)
      return book.isAkron(id.source) || !book.isAkron(id.destination);
    return messageOf(what.message).device == DeviceEnd::Sender;
  }();
  const Address at = isFromDevice ? id.source : id.destination;
  const Pin pin = book.pin(at);
  m_list->append({index, time, what.message, isFromDevice,
                  pin.isNull() ? DeviceKey::at(channel, at) : DeviceKey::of(pin, channel)});
}

}  // namespace deckpipe
