// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/delta_times.h"

#include <algorithm>
#include <cstdlib>

namespace deckpipe {

bool hasDeltaTimes(const FrameStore& frames) {
  constexpr std::int64_t kLongestPause = 24 * 3600 * std::int64_t{1'000'000'000};
  const std::uint64_t count = std::min(frames.count(), kMaxDeltas);
  const bool isWhole = count > 0 && frames[0].stamp == 0;
  std::int64_t before = 0, longest = 0, rises = 0, falls = 0;
  std::uint64_t fallen = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::int64_t stamp = frames[i].stamp;
    if (stamp < 0 || stamp > kLongestPause) return false;
    if (i > 1) (stamp > before ? rises : falls) += std::abs(stamp - before);
    if (i > 1 && stamp < before) ++fallen;
    before = stamp;
    longest = std::max(longest, stamp);
  }
  const bool isEnough = isWhole ? count >= kFewestDeltas : count >= kFewestOfPart && fallen >= count / 8;
  return isEnough && longest > 0 && falls >= rises / 4;
}

}  // namespace deckpipe
