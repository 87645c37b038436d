// SPDX-License-Identifier: GPL-3.0-or-later
// How old something is, in words. The dial writes ages the same way (paint/figures.h, a room that shares
// nothing with this one); a test of the panels holds the two together.
#pragma once

#include <QString>

#include "base/time.h"

namespace deckpipe {

// "0.4 s", "42 s", "12 min", "3 h", "5 d". Below zero counts as zero.
QString briefAge(Duration age);
// "0.4 s ago"
QString agoText(Duration age);
// For lists in which dozens of ages run at once: as above, but "< 1 s" for all that is fresh, so that only
// silence moves.
QString calmAge(Duration age);
// "20 ms", "1.5 s": a period or a gap.
QString periodText(Duration period);

}  // namespace deckpipe
