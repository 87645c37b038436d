// SPDX-License-Identifier: GPL-3.0-or-later
// `candump -t d` prints the time since the frame before instead of the time. Such a log can only be told by
// how its times run; ReadOptions::addsUpTimes makes times of them.
#pragma once

#include "log/frame_store.h"

namespace deckpipe {

// Whether the stamps of a log, read as they stand, are differences: none is negative or longer than a day, and from the
// second on they fall about as much as they rise, where times hardly ever fall. By the first kMaxDeltas frames. A whole
// log begins with 0: then fewer than kFewestDeltas tell nothing. Of one whose begin is cut off kFewestOfPart are
// needed, among which one in eight falls.
inline constexpr std::uint64_t kFewestDeltas = 4, kFewestOfPart = 16, kMaxDeltas = 1'000;
bool hasDeltaTimes(const FrameStore& frames);

}  // namespace deckpipe
