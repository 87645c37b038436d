// SPDX-License-Identifier: GPL-3.0-or-later
// How often one message comes whose period is a setting of its sender. Device owns one for each report of a CANopen
// node.
//
// It is the longest gap that came twice in a row: a single longer one is a message that is missing. After the first gap
// it is that gap.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/time.h"

namespace deckpipe {

class OwnPeriod {
 public:
  // The message came, and the one before it so long ago.
  void came(Duration gap) {
    const auto units =
        static_cast<std::uint32_t>(std::clamp<Duration::rep>((gap + kUnit / 2) / kUnit, 1, kMax));
    const std::uint32_t before = m_gap, longest = m_isRepeated ? m_period : 0u;
    m_period = (before == 0 ? units : std::max(longest, std::min(units, before))) & kMax;
    m_isRepeated = before != 0;
    m_gap = units & kMax;
  }
  // 0 until the message has come twice.
  Duration value() const { return m_period * kUnit; }
  friend bool operator==(const OwnPeriod&, const OwnPeriod&) = default;

 private:
  static constexpr Duration kUnit = 20ms;
  static constexpr std::uint32_t kMax = (1u << 15) - 1;  // 11 minutes

  std::uint32_t m_gap : 15 = 0;  // before the last message; 0: there was none before it
  std::uint32_t m_period : 15 = 0;
  std::uint32_t m_isRepeated : 1 = 0;  // it is a gap that came twice in a row
};
static_assert(sizeof(OwnPeriod) == 4, "State holds three for every device");

}  // namespace deckpipe
