// SPDX-License-Identifier: GPL-3.0-or-later
// What a view shows where an age stands.
#pragma once

#include <optional>

#include "base/time.h"

namespace deckpipe {

// Whether a value was ever heard, and how long ago, are two things: of a log without times only the first is known.
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

}  // namespace deckpipe
