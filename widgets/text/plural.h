// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers for tr()'s plurals, which take an int: logs may hold more.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace deckpipe {

constexpr int forPlural(std::uint64_t number) {
  return static_cast<int>(std::min<std::uint64_t>(number, std::numeric_limits<int>::max()));
}

}  // namespace deckpipe
