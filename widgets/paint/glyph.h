// SPDX-License-Identifier: GPL-3.0-or-later
// The signs that stand beside every colour that means something, drawn as strokes so that they are sharp at 9
// and at 90 pixels and need no font. Used by the dial, the status lamp and delegates of lists.
#pragma once

#include <QColor>
#include <QRectF>
#include <cstdint>

class QPainter;

namespace deckpipe {

enum class Glyph : std::uint8_t {
  Fine,          // tick
  Warning,       // triangle with an exclamation mark
  Fault,         // circle with a cross
  Stop,          // needle against a block
  Stale,         // clock
  NoData,        // dotted circle
  NotFitted,     // circle with a slash
  Invalid,       // diamond with a question mark
  Unknown,       // question mark
  NotAvailable,  // dash
  Off,           // ring
  On,            // ring with a filled middle
  Locked,        // padlock
  Stowed,        // arrow down into a tray
  CommandPlus,   // hollow arrow to the right; the widget turns it
  Commanded,     // hollow diamond: someone commands, at rest
  Oscillating,   // arrow both ways
};

// Draws into the largest square in the middle of `box`. `ink` strokes, `fill` fills closed glyphs
// (transparent: outline only). `weight`: factor on the width of lines.
void drawGlyph(QPainter& painter, const QRectF& box, Glyph glyph, const QColor& ink,
               const QColor& fill = Qt::transparent, double weight = 1.0);

}  // namespace deckpipe
