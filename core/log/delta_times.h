// SPDX-License-Identifier: GPL-3.0-or-later
// `candump -t d` prints the time since the frame before instead of the time. Such a log can only be told by
// how its times run; ReadOptions::addsUpTimes makes times of them.
#pragma once

#include "log/frame_store.h"

namespace deckpipe {

// Whether the stamps of a log, read as they stand, are differences: the first is 0, none is negative or longer
// than a day, and from the second on they fall about as much as they rise, where times hardly ever fall. By the
// first kMaxDeltas frames; fewer than kFewestDeltas tell nothing.
inline constexpr std::uint64_t kFewestDeltas = 4, kMaxDeltas = 1'000;
bool hasDeltaTimes(const FrameStore& frames);

}  // namespace deckpipe
