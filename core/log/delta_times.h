// SPDX-License-Identifier: GPL-3.0-or-later
// `candump -t d` prints the time since the frame before instead of the time. Such a log can only be told by
// how its times run; ReadOptions::addsUpTimes makes times of them. Until then such a log has no times: its reader
// says so to the store (FrameStore::takeNoTimes).
#pragma once

#include <span>

#include "log/frame_store.h"
#include "log/reading.h"

namespace deckpipe {

// Whether the stamps of a log, read as they stand, are differences: none is negative or longer than a day, and from the
// second on they fall about as much as they rise, where times hardly ever fall. By the first kMaxDeltas frames. A whole
// log begins with 0: then fewer than kFewestDeltas tell nothing. Of one whose begin is cut off kFewestOfPart are
// needed, among which one in eight falls.
inline constexpr std::uint64_t kFewestDeltas = 4, kFewestOfPart = 16, kMaxDeltas = 1'000;
bool hasDeltaTimes(const FrameStore& frames);
// The same of a log's first frames. Open: more of them are needed.
Sniff sniffDeltaTimes(std::span<const Frame> first);
// The same of a whole log, or of so many of its first frames.
bool areDeltaTimes(std::span<const Frame> frames);

}  // namespace deckpipe
