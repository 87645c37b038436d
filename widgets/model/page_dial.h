// SPDX-License-Identifier: GPL-3.0-or-later
// What the dial of a monitor shows at the state's cursor: on its own page, on its tile of the overview.
#pragma once

#include "model/device_page_values.h"

namespace deckpipe {

DialValues dialOf(const State& state, const Device& monitor);

}  // namespace deckpipe
