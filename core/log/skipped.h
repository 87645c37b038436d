// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader found in a file and could not put into the store, with its place and why: frames that the
// store does not hold (CAN FD) and lines that cannot be read. Every reader fills one, and so does the bus
// thread; windows and the headless tool show it. Memory is bounded: the first kMaxPlaces are kept with their
// place, all are counted by reason.
#pragma once

#include <cstdint>
#include <mutex>
#include <string_view>
#include <vector>

#include "base/enum_table.h"

namespace deckpipe {

enum class Skipped : std::uint8_t {
  // Understood, and not kept.
  CanFd,
  CanXl,
  RecorderDropped,  // the recording says itself that it lost frames here
  Fraction,         // of a frame's time; the frame is kept, with its second
  // Unreadable.
  Layout,
  Binary,
  LineTooLong,
  Time,
  TimeRange,
  Interface,
  Identifier,
  Data,
  DataTooLong,
  LengthMismatch,
};
template <>
inline constexpr Skipped kLastOf<Skipped> = Skipped::LengthMismatch;

// Something stands there that no reader understands.
constexpr bool isUnreadable(Skipped reason) { return reason >= Skipped::Layout; }

// English, for the standard error of the headless tool; windows translate the enum.
std::string_view skippedText(Skipped reason);

struct SkippedPlace {
  // Line number from 1, of a binary format the byte offset; live, so many frames stand before it.
  std::uint64_t place = 0;
  Skipped reason = Skipped::Layout;

  friend constexpr bool operator==(const SkippedPlace&, const SkippedPlace&) = default;
};

// The bare list; a reader's threads fill one a block.
class SkippedPlaces {
 public:
  static constexpr std::size_t kMaxPlaces = 10'000;

  void add(std::uint64_t place, Skipped reason) {
    ++m_counts[reason];
    if (m_places.size() < kMaxPlaces) m_places.push_back({place, reason});
  }
  // All of another list behind these, its places moved on by so many.
  void add(const SkippedPlaces& other, std::uint64_t placesOn);
  void clear() { *this = {}; }

  const std::vector<SkippedPlace>& places() const { return m_places; }
  std::uint64_t count(Skipped reason) const { return m_counts[reason]; }
  // All of which isUnreadable() is true, and all others. A file is read whole if it has neither unreadable
  // places nor skipped frames.
  std::uint64_t unreadable() const { return sum(true); }
  std::uint64_t understood() const { return sum(false); }
  // Frames of a kind that the store does not hold.
  std::uint64_t skipped() const { return count(Skipped::CanFd) + count(Skipped::CanXl); }

 private:
  std::uint64_t sum(bool unreadable) const;

  std::vector<SkippedPlace> m_places;
  EnumArray<Skipped, std::uint64_t> m_counts;
};

// The same, to be looked at while a reader on another thread fills it.
class SkippedList {
 public:
  void add(std::uint64_t place, Skipped reason) {
    const std::lock_guard lock(m_lock);
    m_content.add(place, reason);
  }
  void add(const SkippedPlaces& other, std::uint64_t placesOn) {
    const std::lock_guard lock(m_lock);
    m_content.add(other, placesOn);
  }
  SkippedPlaces content() const {
    const std::lock_guard lock(m_lock);
    return m_content;
  }

 private:
  mutable std::mutex m_lock;
  SkippedPlaces m_content;
};

}  // namespace deckpipe
