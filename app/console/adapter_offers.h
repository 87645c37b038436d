// SPDX-License-Identifier: GPL-3.0-or-later
// Adapters as the connection page offers them: their state in words, and what to type where something stands
// in the way. A pure function of what was found, so that every case is tested without hardware.
#pragma once

#include <functional>

#include "link/adapters.h"
#include "panel/connect/adapter_row.h"

namespace deckpipe {

// `bitRate`: what a person wants to connect with; 0: as the interface is set. `isHeard`: whether frames come.
AdapterOffers offersOf(const AdapterList& list, int bitRate, bool isSearching,
                       const std::function<bool(const Adapter&)>& isHeard);

}  // namespace deckpipe
