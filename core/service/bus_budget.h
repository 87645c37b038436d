// SPDX-License-Identifier: GPL-3.0-or-later
// How full the bus is, and how long to wait between two polls so that asking everyone never floods it.
#pragma once

#include <algorithm>
#include <array>

#include "base/time.h"
#include "bus/load.h"

namespace deckpipe {

class BusBudget {
 public:
  // Of the bus, for polls and their answers together.
  static constexpr double kShare = 0.05, kMin = 0.01;
  // Above this load only kMin is left to polls.
  static constexpr double kFull = 0.85;

  explicit BusBudget(int bitRate) { setBitRate(bitRate); }
  // J1939's own where it is not known (0).
  void setBitRate(int bitRate) { m_bitRate = bitRate > 0 ? bitRate : 250'000; }

  void heard(Instant now, const Frame& frame) {
    turn(now);
    m_bits[m_slot] += estimatedBits(frame);
  }
  // Of the last second, 0..1.
  double load(Instant now) {
    turn(now);
    double bits = 0;
    for (const double slot : m_bits) bits += slot;
    const Duration heard = kSlot * static_cast<int>(kSlots - 1) + (now - m_begin);
    const double span = static_cast<double>(heard.count()) * 1e-9;
    return std::min(1.0, bits / (span * m_bitRate));
  }
  // From a request that costs so many bits, answer included, to the next one.
  Duration gapAfter(Instant now, unsigned bits) {
    const double share = std::clamp(kFull - load(now), kMin, kShare);
    return Duration(static_cast<std::int64_t>(bits / (share * m_bitRate) * 1e9));
  }

 private:
  static constexpr std::size_t kSlots = 10;
  static constexpr Duration kSlot = 100ms;

  void turn(Instant now) {
    if (m_begin == kNotYet || now - m_begin >= kSlot * static_cast<int>(kSlots)) {
      m_bits.fill(0);
      m_begin = now;
    }
    while (now - m_begin >= kSlot) {
      m_begin = m_begin + kSlot;
      m_slot = (m_slot + 1) % kSlots;
      m_bits[m_slot] = 0;
    }
  }

  double m_bitRate = 0;
  std::array<double, kSlots> m_bits{};  // each of kSlot
  std::size_t m_slot = 0;
  Instant m_begin = kNotYet;  // of the present slot
};

}  // namespace deckpipe
