// SPDX-License-Identifier: GPL-3.0-or-later
// Whether one periodic message comes twice a period, as it does when two devices send it from one address.
// Device owns one for each message that it repeats.
//
// Two devices are told by this alone: in each period two such messages come, or more, and that goes on for two
// seconds; or four times in a row the position leaps farther than a monitor turns in a period. A lawful bus cannot
// give either. Frames that were held up and come all at once do not count, as they lie much closer; nor do frames
// that a log holds twice, as their bytes are equal and there is next to no time between the two.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "base/time.h"

namespace deckpipe {

class Pace {
 public:
  // A message came `gap` after the one before it. `differs`: its bytes are others. `leaps`: so is its position,
  // by more than a monitor turns in a period. Returns whether two devices must be sending it.
  bool isDoubled(Duration gap, Duration period, bool differs, bool leaps) {
    const Duration both = gap + m_gap * kUnit;
    const bool isApart = std::min<Duration>(gap, m_gap * kUnit) * 5 >= period;
    const bool isTwice =
        m_gap != 0 && gap > 0ns && (differs || isApart) && both * 5 >= period * 2 && both * 3 <= period * 4;
    m_gap = units(gap);
    m_doubled = isTwice ? units(m_doubled * kUnit + gap) : std::uint16_t{0};
    m_leaps = isTwice && leaps ? next(m_leaps) : std::uint8_t{0};
    return m_leaps >= kLeaps || m_doubled * kUnit >= kFor;
  }
  friend bool operator==(const Pace&, const Pace&) = default;

 private:
  static constexpr Duration kUnit = 100us;
  static constexpr Duration::rep kMost = std::numeric_limits<std::uint16_t>::max();
  static constexpr Duration kFor = 2s;
  static constexpr std::uint8_t kLeaps = 4;

  static std::uint16_t units(Duration d) {
    return static_cast<std::uint16_t>(std::clamp<Duration::rep>(d / kUnit, 0, kMost));
  }
  static std::uint8_t next(std::uint8_t n) { return n == 255 ? n : static_cast<std::uint8_t>(n + 1); }

  std::uint16_t m_gap = 0;      // before the last message
  std::uint16_t m_doubled = 0;  // for so long two or more came a period
  std::uint8_t m_leaps = 0;     // messages in a row that leapt meanwhile
};

}  // namespace deckpipe
