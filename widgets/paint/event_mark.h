// SPDX-License-Identifier: GPL-3.0-or-later
// The marks of events: each group has a shape of its own, each weight a colour. The timeline, the list of
// events and its legend draw the same ones.
#pragma once

#include <QIcon>
#include <QRectF>

#include "base/event_kind.h"
#include "paint/palette.h"

class QPainter;

namespace deckpipe {

// The colour of a weight on window and surface.
QColor eventInk(Severity weight, const Colours& colours);
// Fills the middle of `box` as far as its smaller side goes. Presence: circle; address: diamond; fault:
// triangle that points down; mode: square; stop: bar with a foot; joystick: triangle that points up; bus:
// cross; note: flag.
void drawEventMark(QPainter& painter, const QRectF& box, EventGroup group, const QColor& ink);
// For buttons and menus.
QIcon eventMarkIcon(EventGroup group, const Colours& colours);

}  // namespace deckpipe
