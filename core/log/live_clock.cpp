// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/live_clock.h"

#include <algorithm>

namespace deckpipe {

std::int64_t LiveClock::smallestOf(Channel& channel, std::int64_t stamp, std::int64_t now, bool anew) {
  const std::int64_t age = saturatedMinus(now, stamp);
  constexpr std::int64_t kHalf = kWindow.count() / 2;
  if (anew || saturatedMinus(now, channel.halfBegan) >= 2 * kHalf) {
    channel.smallest = channel.smallestBefore = age;
    channel.halfBegan = now;
  } else if (saturatedMinus(now, channel.halfBegan) >= kHalf) {
    channel.smallestBefore = channel.smallest;
    channel.smallest = age;
    channel.halfBegan = now;
  }
  channel.smallest = std::min(channel.smallest, age);
  return std::min(channel.smallest, channel.smallestBefore);
}

LiveClock::Verdict LiveClock::next(const Frame& frame, const Arrival& arrival, std::int64_t last) {
  const std::int64_t now = arrival.now.ns;
  Channel& channel = m_channels[frame.channel];
  if (!frame.hasStamp()) {
    if (saturatedMinus(now, last) <= kStampless.count()) return {.kind = Kind::Timeless};
    return {.kind = Kind::NewOffset, .time = now, .offset = channel.offset};
  }
  const bool wrapped = channel.isKnown && saturatedMinus(channel.lastStamp, frame.stamp) > kWrap.count();
  const auto movesBy = [&](std::int64_t to, Duration more) {
    const std::int64_t moved = saturatedMinus(to, channel.offset);
    return moved > more.count() || moved < -more.count();
  };
  std::int64_t offset = channel.offset;
  bool isJump = false;
  if (arrival.wallOffset) {
    const bool isSet = movesBy(arrival.wallOffset->count(), kClockSet);
    if (isSet || !channel.isKnown) offset = arrival.wallOffset->count();
    isJump = isSet && channel.isKnown;
  } else {
    offset = smallestOf(channel, frame.stamp, now, !channel.isKnown || wrapped);
    isJump = movesBy(offset, kWrap) && channel.isKnown;
  }
  const bool isNew = !channel.isKnown || offset != channel.offset;
  channel.isKnown = true;
  channel.lastStamp = frame.stamp;
  channel.offset = offset;

  const std::int64_t own = std::min(saturatedPlus(frame.stamp, offset), now);
  const bool isLate = arrival.reached != kNotYet && own < arrival.reached.ns;
  const std::int64_t time = isLate ? arrival.reached.ns : own;
  const bool isPlain = !isNew && time == saturatedPlus(frame.stamp, offset);
  return {.kind = isPlain ? Kind::Plain : Kind::NewOffset,
          .isJump = isJump,
          .isLate = isLate,
          .time = time,
          .offset = offset};
}

}  // namespace deckpipe
