// SPDX-License-Identifier: GPL-3.0-or-later
// Copies link state, error, bit rate and counters from what the bus has published. Session calls it every tick.
#pragma once

#include "session/live_bus.h"
#include "session/snapshot.h"

namespace deckpipe {

void takeLink(Snapshot& snapshot, const LiveBus::Published& published);
// The link is left: what waits then stays in the snapshot.
void keepWaiting(Snapshot& snapshot, const ServiceStatus& services);

}  // namespace deckpipe
