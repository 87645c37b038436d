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

// a + b and a - b in ns, or the nearest number there is: a damaged log may stamp anything.
constexpr std::int64_t saturatedPlus(std::int64_t a, std::int64_t b) {
  std::int64_t sum = 0;
  if (!__builtin_add_overflow(a, b, &sum)) return sum;
  return b > 0 ? std::numeric_limits<std::int64_t>::max() : std::numeric_limits<std::int64_t>::min();
}
constexpr std::int64_t saturatedMinus(std::int64_t a, std::int64_t b) {
  std::int64_t difference = 0;
  if (!__builtin_sub_overflow(a, b, &difference)) return difference;
  return a > b ? std::numeric_limits<std::int64_t>::max() : std::numeric_limits<std::int64_t>::min();
}

// A point in log time: nanoseconds, never falling within one log. Live it follows CLOCK_BOOTTIME, of a
// file it is the running maximum of the stamps (design: "Two times").
struct Instant {
  std::int64_t ns = 0;

  friend constexpr auto operator<=>(Instant, Instant) = default;
  // Stays at the ends of time: a log may hold any stamp.
  friend constexpr Instant operator+(Instant t, Duration d) { return {saturatedPlus(t.ns, d.count())}; }
  friend constexpr Instant operator-(Instant t, Duration d) { return t + -d; }
  friend constexpr Duration operator-(Instant a, Instant b) { return Duration{saturatedMinus(a.ns, b.ns)}; }
};

// Later than every event; "never" as an answer to "when do you next need time?".
inline constexpr Instant kNever{std::numeric_limits<std::int64_t>::max()};
// Before every event; the time of something that has not happened.
inline constexpr Instant kNotYet{std::numeric_limits<std::int64_t>::min()};

}  // namespace deckpipe
