// SPDX-License-Identifier: GPL-3.0-or-later
// Time as a value. Core reads no clock: whoever has one (link, session, a test) passes the time in.
#pragma once

#include <chrono>
#include <compare>
#include <cstdint>
#include <limits>

namespace deckpipe {

using Duration = std::chrono::nanoseconds;
using namespace std::chrono_literals;

// A point in log time: nanoseconds, never falling within one log. Live it follows CLOCK_BOOTTIME, of a
// file it is the running maximum of the stamps (design: "Two times").
struct Instant {
  std::int64_t ns = 0;

  friend constexpr auto operator<=>(Instant, Instant) = default;
  // Stays at the ends of time: a log may hold any stamp.
  friend constexpr Instant operator+(Instant t, Duration d) {
    std::int64_t sum = 0;
    if (!__builtin_add_overflow(t.ns, d.count(), &sum)) return {sum};
    return {d.count() > 0 ? std::numeric_limits<std::int64_t>::max()
                          : std::numeric_limits<std::int64_t>::min()};
  }
  friend constexpr Instant operator-(Instant t, Duration d) { return t + -d; }
  friend constexpr Duration operator-(Instant a, Instant b) {
    std::int64_t gap = 0;
    if (!__builtin_sub_overflow(a.ns, b.ns, &gap)) return Duration{gap};
    return a.ns > b.ns ? Duration::max() : Duration::min();
  }
};

// Later than every event; "never" as an answer to "when do you next need time?".
inline constexpr Instant kNever{std::numeric_limits<std::int64_t>::max()};
// Before every event; the time of something that has not happened.
inline constexpr Instant kNotYet{std::numeric_limits<std::int64_t>::min()};

}  // namespace deckpipe
