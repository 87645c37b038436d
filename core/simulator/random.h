// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that look random and follow from a seed alone, the same with every compiler (the standard library's
// distributions are not). SplitMix64, Steele, Lea and Flood 2014; public domain reference by S. Vigna.
#pragma once

#include <cstdint>

namespace deckpipe::simulator {

class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : m_state(seed) {}

  constexpr std::uint64_t next() {
    std::uint64_t z = (m_state += 0x9E37'79B9'7F4A'7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EBull;
    return z ^ (z >> 31);
  }
  // Both ends included; the bias of the remainder is far below what a simulator could show.
  constexpr int between(int low, int high) {
    return low + static_cast<int>(next() % (static_cast<std::uint64_t>(high - low) + 1));
  }

 private:
  std::uint64_t m_state;
};

}  // namespace deckpipe::simulator
