// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/clocks.h"

#include <ctime>

namespace deckpipe {
namespace {

Instant timeOf(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return Instant{std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec};
}

}  // namespace

Instant bootTime() { return timeOf(CLOCK_BOOTTIME); }
Instant monotonicTime() { return timeOf(CLOCK_MONOTONIC); }
Instant wallClockTime() { return timeOf(CLOCK_REALTIME); }

}  // namespace deckpipe
