// SPDX-License-Identifier: GPL-3.0-or-later
// Frames a second of one sender, counted in whole seconds of log time, so that the figure is the same however
// the cursor came here and stands still for a second at a time. Owned by Device and Node, which know when
// they were heard last.
#pragma once

#include <cstdint>

#include "base/time.h"

namespace deckpipe {

class FrameRate {
 public:
  // A frame came at `time`, the one before it at `before`.
  void count(Instant time, Instant before) {
    const std::int64_t now = secondOf(time), then = secondOf(before);
    if (now != then) {
      const bool isNext = now == then + 1;
      m_last = isNext ? m_current : 0u;
      m_inRow = !isNext ? 0u : m_inRow < kSteady ? m_inRow + 1u : kSteady;
      m_current = 0;
    }
    if (m_current < kMost) ++m_current;
  }
  // Of the last whole second before `now`; `heard` is when the last frame came.
  unsigned at(Instant now, Instant heard) const {
    const std::int64_t since = secondOf(now) - secondOf(heard);
    return since == 0 ? m_last : since == 1 ? m_current : 0u;
  }
  // Something of it comes by itself: up to the last frame it was heard in each of four seconds in a row.
  bool isSteady() const { return m_inRow == kSteady; }
  friend bool operator==(const FrameRate&, const FrameRate&) = default;

 private:
  static constexpr unsigned kMost = (1u << 15) - 1;  // more than a bus of 1 Mbit/s carries
  static constexpr unsigned kSteady = 3;

  static std::int64_t secondOf(Instant t) { return t.ns / 1'000'000'000; }

  std::uint32_t m_current : 15 = 0;  // in the second of the last frame
  std::uint32_t m_last : 15 = 0;     // in the one before it
  std::uint32_t m_inRow : 2 = 0;     // seconds before that of the last frame, without one left out; 3 at most
};

}  // namespace deckpipe
