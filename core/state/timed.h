// SPDX-License-Identifier: GPL-3.0-or-later
// A value and when it came. What a view shows with an age.
#pragma once

#include "base/time.h"

namespace deckpipe {

template <typename T>
struct Timed {
  T value{};
  Instant at = kNotYet;

  bool isKnown() const { return at != kNotYet; }
  void set(const T& newValue, Instant time) {
    value = newValue;
    at = time;
  }
  friend bool operator==(const Timed&, const Timed&) = default;
};

}  // namespace deckpipe
