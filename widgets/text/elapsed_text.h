// SPDX-License-Identifier: GPL-3.0-or-later
// Times since the begin of a log as figures that keep their width: for the readout and lists of what
// happened. Clocks and elapsed times are cut to the decimals that they have, never rounded, here and in deckpipectl: an
// event has one text, and no clock shows a time that has not come.
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

}  // namespace deckpipe
