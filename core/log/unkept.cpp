// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/unkept.h"

#include <algorithm>

namespace deckpipe {

std::string_view unkeptText(Unkept reason) {
  switch (reason) {
    case Unkept::CanFd: return "CAN FD frame, not held";
    case Unkept::CanXl: return "CAN XL frame, not held";
    case Unkept::RecorderDropped: return "the recorder lost frames here";
    case Unkept::Fraction: return "fraction of a time, as it has more than nine digits";
    case Unkept::Layout: return "not a line of a known form";
    case Unkept::Binary: return "control characters";
    case Unkept::LineTooLong: return "line too long";
    case Unkept::Time: return "unreadable time";
    case Unkept::TimeRange: return "time out of range";
    case Unkept::Interface: return "unreadable interface name";
    case Unkept::Identifier: return "unreadable identifier";
    case Unkept::Data: return "unreadable data";
    case Unkept::DataTooLong: return "more than 8 data bytes";
    case Unkept::LengthMismatch: return "number of data bytes differs from the length";
  }
  return {};
}

void UnkeptPlaces::add(const UnkeptPlaces& other, std::uint64_t placesOn) {
  for (const Unkept reason : kAllOf<Unkept>) m_counts[reason] += other.m_counts[reason];
  const std::size_t room = kMaxPlaces - m_places.size();
  const std::size_t n = std::min(room, other.m_places.size());
  for (std::size_t i = 0; i < n; ++i) {
    m_places.push_back({other.m_places[i].place + placesOn, other.m_places[i].reason});
  }
}

std::uint64_t UnkeptPlaces::sum(bool unreadable) const {
  std::uint64_t n = 0;
  for (const Unkept reason : kAllOf<Unkept>) {
    if (isUnreadable(reason) == unreadable) n += m_counts[reason];
  }
  return n;
}

}  // namespace deckpipe
