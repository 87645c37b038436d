// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/time_grain.h"

#include <algorithm>

namespace deckpipe {

namespace {
constexpr std::int64_t kSecond = 1'000'000'000;
}  // namespace

bool areAtWholeSeconds(std::span<const Frame> frames) {
  return std::ranges::all_of(frames, [](const Frame& frame) { return frame.stamp % kSecond == 0; });
}

TimeGrain timeGrainOf(const FrameStore& frames) {
  if (!frames.hasTimes()) return TimeGrain::None;
  if (frames.hasLostFractions()) return TimeGrain::Seconds;
  const std::uint64_t count = std::min(frames.count(), kGrainFrames);
  if (count < kFewestGrains) return TimeGrain::Fine;
  LogTimes times(frames);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (times.at(i).ns % kSecond != 0) return TimeGrain::Fine;
  }
  return TimeGrain::Seconds;
}

}  // namespace deckpipe
