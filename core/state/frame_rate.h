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
      m_last = isNext ? m_current : std::uint16_t{0};
      m_current = 0;
    }
    if (m_current < kMax) ++m_current;
  }
  // Of the last whole second before `now`; `heard` is when the last frame came.
  unsigned at(Instant now, Instant heard) const {
    const std::int64_t since = secondOf(now) - secondOf(heard);
    return since == 0 ? m_last : since == 1 ? m_current : 0u;
  }
  friend bool operator==(const FrameRate&, const FrameRate&) = default;

 private:
  static constexpr unsigned kMax = (1u << 15) - 1;  // more than a bus of 1 Mbit/s carries

  static std::int64_t secondOf(Instant t) { return t.ns / 1'000'000'000; }

  std::uint16_t m_current = 0;  // in the second of the last frame
  std::uint16_t m_last = 0;     // in the one before it
};

}  // namespace deckpipe
