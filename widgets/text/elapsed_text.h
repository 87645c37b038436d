// SPDX-License-Identifier: GPL-3.0-or-later
// Times since the begin of a log as figures that keep their width: for the readout and lists of what
// happened.
#pragma once

#include <QString>

#include "base/time.h"

namespace deckpipe {

// "0:01:23.456", hours without limit. Below zero counts as zero.
QString elapsedText(Duration elapsed);
// ".456" in the person's writing: the milliseconds of a time in nanoseconds, which is not below zero.
QString millisecondsText(std::int64_t ns);

}  // namespace deckpipe
