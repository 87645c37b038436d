// SPDX-License-Identifier: GPL-3.0-or-later
// The clocks of a session. Core reads none: their times are passed in.
#pragma once

#include "base/time.h"

namespace deckpipe {

// CLOCK_BOOTTIME: goes on while the laptop sleeps, and does not follow the wall clock. Live log time.
Instant bootTime();
// CLOCK_MONOTONIC: stands still while the laptop sleeps.
Instant monotonicTime();
// CLOCK_REALTIME: the wall clock.
Instant wallClockTime();

}  // namespace deckpipe
