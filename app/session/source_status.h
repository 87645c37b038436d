// SPDX-License-Identifier: GPL-3.0-or-later
// The status of a source takes these facts from what its bus has published.
#pragma once

#include "session/live_bus.h"
#include "session/snapshot.h"

namespace deckpipe {

void takeLink(SourceStatus& source, const LiveBus::Published& published);

}  // namespace deckpipe
