// SPDX-License-Identifier: GPL-3.0-or-later
// How old something is, in words. The dial writes ages the same way (paint/figures.h, a room that shares
// nothing with this one); a test of the panels holds the two together.
#pragma once

#include <QString>

#include "base/age.h"

namespace deckpipe {

// "0.4 s", "42 s", "12 min", "3 h", "5 d". Below zero counts as zero.
QString briefAge(Duration age);
// "0.4 s ago"
QString agoText(Duration age);
// For lists in which dozens of ages run at once: as above, but "< 1 s" for all that is fresh, so that only
// silence moves.
QString calmAge(Duration age);
// What stands where an age does: "< 1 s", "42 s"; "link down for 12 s"; empty of a log without times; "not heard".
// `isStale`: the value is overdue, which is said: "overdue, 4.0 s".
QString ageText(const Age& age, bool isStale = false);
// "20 ms", "1.5 s": a period or a gap.
QString periodText(Duration period);

}  // namespace deckpipe
