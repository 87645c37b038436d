// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of times that cannot overflow: a damaged log may stamp anything.
#pragma once

#include <cstdint>
#include <limits>

namespace deckpipe {

// a + b in ns, or the nearest number there is.
constexpr std::int64_t plus(std::int64_t a, std::int64_t b) {
  std::int64_t sum = 0;
  if (!__builtin_add_overflow(a, b, &sum)) return sum;
  return b > 0 ? std::numeric_limits<std::int64_t>::max() : std::numeric_limits<std::int64_t>::min();
}
// a - b in ns, or the nearest number there is.
constexpr std::int64_t minus(std::int64_t a, std::int64_t b) {
  std::int64_t difference = 0;
  if (!__builtin_sub_overflow(a, b, &difference)) return difference;
  return b < 0 ? std::numeric_limits<std::int64_t>::max() : std::numeric_limits<std::int64_t>::min();
}

}  // namespace deckpipe
