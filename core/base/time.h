// SPDX-License-Identifier: GPL-3.0-or-later
// Time as a value. Core reads no clock: whoever has one (link, session, a test) passes the time in.
#pragma once

#include <chrono>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>

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

// What a view shows where an age stands. Whether a value was ever heard, and how long ago, are two things: of a log without times only the first is known.
struct Age {
  enum class Kind : std::uint8_t {
    NotHeard,  // the value never came
    NoTimes,   // it came; the log does not tell when
    Ago,       // it came `length` ago
    LinkDown,  // it came, and the link is down for `length`: whether it still holds is not known
  };
  Kind kind = Kind::NotHeard;
  Duration length{0};  // 0 of the first two

  static constexpr Age ago(Duration length) { return {Kind::Ago, length}; }
  static constexpr Age linkDown(Duration length) { return {Kind::LinkDown, length}; }

  constexpr bool isHeard() const { return kind != Kind::NotHeard; }
  constexpr bool isLinkDown() const { return kind == Kind::LinkDown; }
  // Whether there is a time to write.
  constexpr bool isTimed() const { return kind == Kind::Ago || kind == Kind::LinkDown; }
  friend constexpr bool operator==(const Age&, const Age&) = default;
};

// How a length of time is written: "0.4 s", "95 s", "1 min 45 s", "1 h 05 min", "2 d 03 h". Cut, never rounded,
// so that an age that grows never seems to run backwards. Below zero counts as zero. The rooms that write ages
// put these figures into words.
struct AgeFigures {
  enum class Form : std::uint8_t { Tenths, Seconds, Minutes, Hours, Days };
  Form form = Form::Tenths;
  std::int64_t whole = 0;  // seconds, minutes, hours or days
  std::int64_t rest = 0;   // tenths of a second; nothing; seconds; minutes; hours
  friend constexpr bool operator==(const AgeFigures&, const AgeFigures&) = default;
};

constexpr AgeFigures ageFigures(Duration age) {
  using Form = AgeFigures::Form;
  const std::int64_t tenths = age.count() > 0 ? age.count() / 100'000'000 : 0, seconds = tenths / 10;
  if (seconds < 10) return {Form::Tenths, seconds, tenths % 10};
  if (seconds < 100) return {Form::Seconds, seconds, 0};
  if (seconds < 3600) return {Form::Minutes, seconds / 60, seconds % 60};
  const std::int64_t hours = seconds / 3600;
  if (hours < 48) return {Form::Hours, hours, seconds / 60 % 60};
  return {Form::Days, hours / 24, hours % 24};
}

}  // namespace deckpipe
