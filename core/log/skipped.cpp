// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/skipped.h"

#include <algorithm>

namespace deckpipe {

std::string_view skippedText(Skipped reason) {
  switch (reason) {
    case Skipped::CanFd: return "CAN FD frame, not held";
    case Skipped::CanXl: return "CAN XL frame, not held";
    case Skipped::RecorderDropped: return "the recorder lost frames here";
    case Skipped::Fraction: return "fraction of a time, as it has more than nine digits";
    case Skipped::Layout: return "not a line of a known form";
    case Skipped::Binary: return "control characters";
    case Skipped::LineTooLong: return "line too long";
    case Skipped::Time: return "unreadable time";
    case Skipped::TimeRange: return "time out of range";
    case Skipped::Interface: return "unreadable interface name";
    case Skipped::Identifier: return "unreadable identifier";
    case Skipped::Data: return "unreadable data";
    case Skipped::DataTooLong: return "more than 8 data bytes";
    case Skipped::LengthMismatch: return "number of data bytes differs from the length";
  }
  return {};
}

void SkippedPlaces::add(const SkippedPlaces& other, std::uint64_t placesOn) {
  for (const Skipped reason : kAllOf<Skipped>) m_counts[reason] += other.m_counts[reason];
  const std::size_t room = kMaxPlaces - m_places.size();
  const std::size_t n = std::min(room, other.m_places.size());
  for (std::size_t i = 0; i < n; ++i) {
    m_places.push_back({other.m_places[i].place + placesOn, other.m_places[i].reason});
  }
}

std::uint64_t SkippedPlaces::sum(bool unreadable) const {
  std::uint64_t n = 0;
  for (const Skipped reason : kAllOf<Skipped>) {
    if (isUnreadable(reason) == unreadable) n += m_counts[reason];
  }
  return n;
}

}  // namespace deckpipe
