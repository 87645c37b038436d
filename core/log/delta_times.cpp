// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/delta_times.h"

#include <algorithm>
#include <cstdlib>

namespace deckpipe {
namespace {

constexpr std::int64_t kLongestPause = 24 * 3600 * std::int64_t{1'000'000'000};

bool isPause(const Frame& frame) { return frame.stamp >= 0 && frame.stamp <= kLongestPause; }

}  // namespace

bool areDeltaTimes(std::span<const Frame> frames) {
  const std::uint64_t count = std::min<std::uint64_t>(frames.size(), kMaxDeltas);
  const bool isWhole = count > 0 && frames[0].stamp == 0;
  std::int64_t before = 0, longest = 0, rises = 0, falls = 0;
  std::uint64_t fallen = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::int64_t stamp = frames[i].stamp;
    if (!isPause(frames[i])) return false;
    if (i > 1) (stamp > before ? rises : falls) += std::abs(stamp - before);
    if (i > 1 && stamp < before) ++fallen;
    before = stamp;
    longest = std::max(longest, stamp);
  }
  const bool isEnough = isWhole ? count >= kFewestDeltas : count >= kFewestOfPart && fallen >= count / 8;
  return isEnough && longest > 0 && falls >= rises / 4;
}

// They lie side by side: a chunk is larger.
bool hasDeltaTimes(const FrameStore& frames) { return areDeltaTimes(frames.run(0)); }

Sniff sniffDeltaTimes(std::span<const Frame> first) {
  if (first.size() >= kMaxDeltas) return areDeltaTimes(first) ? Sniff::Yes : Sniff::No;
  return std::ranges::all_of(first, isPause) ? Sniff::Open : Sniff::No;
}

}  // namespace deckpipe
