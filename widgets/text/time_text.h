// SPDX-License-Identifier: GPL-3.0-or-later
// Times in words: since the begin of a log, as figures that keep their width; and how old something is.
// Clocks and elapsed times are cut to the decimals that they have, never rounded, here and in deckpipectl: an
// event has one text, and no clock shows a time that has not come. The dial writes ages the same way
// (paint/figures.h, a room that shares nothing with this one); a test of the panels holds the two together.
#pragma once

#include <QString>

#include "base/time.h"

namespace deckpipe {

// "0:01:23.456", hours without limit. Below zero counts as zero.
QString elapsedText(Duration elapsed);
// ".456" in the person's writing: the milliseconds of a time in nanoseconds, which is not below zero.
QString millisecondsText(std::int64_t ns);

// Whether a stamp is a date: adapters that count from their own start and trimmed logs have small ones.
bool isDate(std::int64_t stampNs);
// "14:33:39.184225", the local time of a stamp that is a date.
QString clockText(std::int64_t stampNs);

// "0.4 s", "95 s", "1 min 45 s", "1 h 05 min", "2 d 03 h" (base/time.h).
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
