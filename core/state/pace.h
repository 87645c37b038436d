// SPDX-License-Identifier: GPL-3.0-or-later
// Whether one periodic message comes twice a period, as it does when two devices send it from one address.
// Device owns one for each message that it repeats.
//
// Two devices are told by this alone: in each period two such messages come, or more, and that goes on for two
// seconds; or four times in a row the position leaps farther than a monitor turns in a period. One device alone can
// give the like in two ways, which do not count:
//
//   Frames that were held up. Those that come all at once lie much closer. Others drain slowly: after a message was
//   stale the rate says nothing for five seconds, or until one comes about a period after the one before.
//
//   A log that holds each frame twice, as one does that was merged of what two loggers heard. What changes, changes
//   in equal pairs there (A A B B). While nothing changes, such a log cannot be told from two devices that say the
//   same: only then is the answer Equal. Equal messages less than 5 ms apart are taken for one that is there twice.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "base/time.h"
#include "protocol/lists.h"

namespace deckpipe {

// What one more message shows of how many send it.
enum class Doubling : std::uint8_t {
  None,       // nothing
  InPairs,    // it changed after two that were equal: it may be one device, recorded twice
  Equal,      // two devices that say the same, or one that was recorded twice
  Differing,  // two devices
};

class Pace {
 public:
  // A message `id` came `gap` after the one before it. `differs`: its bytes are others. `leaps`: so is its position,
  // by more than a monitor turns in a period.
  Doubling next(MessageId id, Duration gap, bool differs, bool leaps) {
    const Duration period = messageOf(id).period;
    const Duration both = gap + m_gap * kUnit;
    const bool isApart = std::min<Duration>(gap, m_gap * kUnit) > kOne;
    const bool isTwice =
        m_gap != 0 && gap > 0ns && (differs || isApart) && both * 5 >= period * 2 && both * 3 <= period * 4;
    const bool isSingle = differs && m_differed;
    holdUp(id, gap);
    m_gap = units(gap);
    m_differed = differs;
    if (!isTwice || m_heldUp != 0) {
      m_doubled = 0;
      m_leaps = 0;
      m_hasSingles = false;
      return Doubling::None;
    }
    m_hasSingles = m_hasSingles || isSingle;
    m_leaps = leaps ? static_cast<std::uint8_t>(std::min<int>(m_leaps + 1, kLeaps)) : std::uint8_t{0};
    if (differs && !m_hasSingles) {
      m_doubled = 0;
      return Doubling::InPairs;
    }
    m_doubled = units(m_doubled * kUnit + gap);
    if (m_leaps < kLeaps && m_doubled * kUnit < kFor) return Doubling::None;
    return m_hasSingles ? Doubling::Differing : Doubling::Equal;
  }
  friend bool operator==(const Pace&, const Pace&) = default;

 private:
  static constexpr Duration kUnit = 100us;
  static constexpr Duration::rep kMax = std::numeric_limits<std::uint16_t>::max();
  static constexpr Duration kOne = 5ms;
  static constexpr Duration kFor = 2s;
  static constexpr Duration kDrainsFor = 5s;
  static constexpr std::uint8_t kLeaps = 4;
  static_assert(kDrainsFor / kUnit <= kMax);

  static std::uint16_t units(Duration d) {
    return static_cast<std::uint16_t>(std::clamp<Duration::rep>(d / kUnit, 0, kMax));
  }
  void holdUp(MessageId id, Duration gap) {
    if (gap >= staleAfter(id)) {
      m_heldUp = units(kDrainsFor);
    } else if (gap * 10 >= messageOf(id).period * 9) {
      m_heldUp = 0;
    } else {
      m_heldUp = units(m_heldUp * kUnit - gap);
    }
  }

  std::uint16_t m_gap = 0;      // before the last message
  std::uint16_t m_doubled = 0;  // for so long two or more came a period
  std::uint16_t m_heldUp = 0;   // for so long the rate says nothing
  std::uint8_t m_leaps = 0;     // messages in a row that leapt meanwhile
  bool m_differed = false;      // the last message from the one before it
  bool m_hasSingles = false;    // meanwhile one differed from the one before and from the one after it
};

// How often one message comes whose period is a setting of its sender. Device owns one for each report of a CANopen
// node.
//
// It is the longest gap that came twice in a row: a single longer one is a message that is missing. After the first gap
// it is that gap.
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

// Frames a second of one sender, counted in whole seconds of log time, so that the figure is the same however
// the cursor came here and stands still for a second at a time. Owned by Device and Node, which know when
// they were heard last.
class FrameRate {
 public:
  // A frame came at `time`, the one before it at `before`.
  void count(Instant time, Instant before) {
    const std::int64_t now = secondOf(time), then = secondOf(before);
    if (now != then) {
      const bool isNext = now == then + 1;
      m_last = isNext ? m_current : std::uint16_t{0};
      m_current = 0;
    }
    if (m_current < kMax) ++m_current;
  }
  // Of the last whole second before `now`; `heard` is when the last frame came.
  unsigned at(Instant now, Instant heard) const {
    const std::int64_t since = secondOf(now) - secondOf(heard);
    return since == 0 ? m_last : since == 1 ? m_current : 0u;
  }
  friend bool operator==(const FrameRate&, const FrameRate&) = default;

 private:
  static constexpr unsigned kMax = (1u << 15) - 1;  // more than a bus of 1 Mbit/s carries

  static std::int64_t secondOf(Instant t) { return t.ns / 1'000'000'000; }

  std::uint16_t m_current = 0;  // in the second of the last frame
  std::uint16_t m_last = 0;     // in the one before it
};

}  // namespace deckpipe
