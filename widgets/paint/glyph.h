// SPDX-License-Identifier: GPL-3.0-or-later
// The signs that stand beside every colour that means something, drawn as strokes so that they are sharp at 9
// and at 90 pixels and need no font. Used by the dial, the status lamp and delegates of lists.
#pragma once

#include <QColor>
#include <QIcon>
#include <QRectF>

#include <cstdint>
#include <optional>

#include "base/event_kind.h"
#include "base/severity.h"
#include "paint/palette.h"

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

// The sign and the colour of a severity, the same wherever one is shown.
struct SeverityLook {
  std::optional<Glyph> glyph;
  Ink ink;
};

inline constexpr EnumTable<Severity, SeverityLook> kSeverityLooks{{
    {Severity::Plain, {{}, Ink::Text}},
    {Severity::Fine, {Glyph::Fine, Ink::Fine}},
    {Severity::Unknown, {Glyph::NoData, Ink::Stale}},
    {Severity::Busy, {Glyph::Stale, Ink::Accent}},
    {Severity::Warning, {Glyph::Warning, Ink::Warning}},
    {Severity::Fault, {Glyph::Fault, Ink::Fault}},
    {Severity::Silent, {Glyph::Stale, Ink::Stale}},
}};

inline std::optional<Glyph> glyphOf(Severity severity) { return kSeverityLooks[severity].glyph; }
inline Ink inkOf(Severity severity) { return kSeverityLooks[severity].ink; }

// The marks of events: each group has a shape of its own, each weight a colour. The timeline, the list of
// events and its legend draw the same ones. The colour of a weight on window and surface.
QColor eventInk(Severity weight, const Colours& colours);
// Fills the middle of `box` as far as its smaller side goes. Presence: circle; address: diamond; fault:
// triangle that points down; mode: square; stop: bar with a foot; joystick: triangle that points up; bus:
// cross; note: flag.
void drawEventMark(QPainter& painter, const QRectF& box, EventGroup group, const QColor& ink);
// For buttons and menus.
QIcon eventMarkIcon(EventGroup group, const Colours& colours);

}  // namespace deckpipe
