// SPDX-License-Identifier: GPL-3.0-or-later
// LiveClock: what the stamps of an adapter say about time while frames arrive. FrameStore asks it for each
// live frame, in order. Log time is CLOCK_BOOTTIME; a stamp plus the offset of its channel is log time.
//
// 1. Where stamps are the wall clock (socketcan, virtualcan) the offset is CLOCK_BOOTTIME minus CLOCK_REALTIME.
//    It is taken anew when that difference moves by more than kClockSet: somebody set the wall clock.
// 2. Other adapters count from a base of their own. There the offset is the smallest (arrival − stamp) of the
//    last kWindow, since a frame is often late and never early. A stamp that goes back by more than kWrap
//    begins anew: the counter wrapped.
// 3. No frame is later than its arrival. A frame that is handled late keeps its own earlier time: a slow thread
//    is no jump of the clock.
// 4. A frame that belongs before what the live State has reached takes the State's time, and is marked late.
// 5. A frame without a stamp takes the time of the frame before, unless that is more than kStampless old.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/time.h"
#include "bus/frame.h"

namespace deckpipe {

struct Arrival {
  Instant now;  // CLOCK_BOOTTIME when the frames are appended
  // CLOCK_BOOTTIME minus CLOCK_REALTIME, the two read together. Nothing where the stamps are not the wall
  // clock.
  std::optional<Duration> wallOffset{};
  Instant reached = kNotYet;  // log time that the live State has reached
};

class LiveClock {
 public:
  static constexpr Duration kClockSet = 10ms;
  static constexpr Duration kWindow = 10s;
  static constexpr Duration kWrap = 1s;
  static constexpr Duration kStampless = 100ms;

  enum class Kind : std::uint8_t {
    Plain,      // the offset of the channel stays as it is
    NewOffset,  // `offset` holds from this frame on, and this frame is at `time`
    Timeless,   // the frame keeps the time of the frame before
  };
  struct Verdict {
    Kind kind = Kind::Plain;
    bool isJump = false;  // the clock of the stamps was set, stopped or wrapped
    bool isLate = false;
    std::int64_t time = 0;    // log time of the frame in ns, unless Timeless
    std::int64_t offset = 0;  // log time minus stamp in ns
  };

  // `last` is the log time in ns of the frame before.
  Verdict next(const Frame& frame, const Arrival& arrival, std::int64_t last);

 private:
  struct Channel {
    bool isKnown = false;
    std::int64_t lastStamp = 0;
    std::int64_t offset = 0;
    // Smallest (arrival − stamp) of the present half of the window and of the half before.
    std::int64_t smallest = 0, smallestBefore = 0;
    std::int64_t halfBegan = 0;
  };
  static std::int64_t smallestOf(Channel& channel, std::int64_t stamp, std::int64_t now, bool anew);

  std::array<Channel, 256> m_channels{};
};

}  // namespace deckpipe
