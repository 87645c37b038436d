// SPDX-License-Identifier: GPL-3.0-or-later
// The apparatus' outline behind the needles, so that nobody has to remember which way 'right' or 'up' is. A
// fire engine in as few lines as are recognised at 100 px; the monitor stands on its deck behind the cab.
#pragma once

#include <QPainterPath>

namespace deckpipe {

// From above, ahead up; the monitor at `pivot`, sized for a dial of `radius` pixels.
QPainterPath apparatusFromAbove(const QPointF& pivot, double radius);
// From its left side, ahead to the left; reaches `behind` radii to the right of the monitor and is cut there.
QPainterPath apparatusFromLeft(const QPointF& pivot, double radius, double behind);

}  // namespace deckpipe
