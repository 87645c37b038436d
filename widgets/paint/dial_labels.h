// SPDX-License-Identifier: GPL-3.0-or-later
// Where the end values of a dial's band stand: outside the circle beside their end, clear of each other and
// of the chips. Called by dialGeometry alone.
#pragma once

#include "paint/dial_geometry.h"

namespace deckpipe {

// Fills `low->label` and `high->label`; they stay null where the layout has no room for labels.
void placeLimitLabels(DialView& view, const DialLayout& layout);

}  // namespace deckpipe
