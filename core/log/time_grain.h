// SPDX-License-Identifier: GPL-3.0-or-later
// How fine the times of a log are: the one place that says which rules may judge by them.
#pragma once

#include <span>

#include "log/frame_store.h"

namespace deckpipe {

enum class TimeGrain : std::uint8_t {
  None,     // it has no times (FrameStore::hasTimes)
  Seconds,  // good to the second: no rule below one second tells anything
  Fine,
};

// Of a log of which so much is there: Seconds if fractions of its stamps were not read, or if its first kGrainFrames
// frames, of at least kFewestGrains, stand at whole seconds.
inline constexpr std::uint64_t kGrainFrames = 1'000, kFewestGrains = 16;
TimeGrain timeGrainOf(const FrameStore& frames);

// Whether all stamps of some frames are whole seconds.
bool areAtWholeSeconds(std::span<const Frame> frames);

// What a time that is good to the second errs by.
inline constexpr Duration kSecondGrain = 1s;

}  // namespace deckpipe
