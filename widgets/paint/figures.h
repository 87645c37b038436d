// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and PINs as this console writes them; numbers drawn so that nothing moves when they change: digits take
// cells of the same width whatever the font (Qt 6.4 cannot ask a font for tabular figures), right aligned.
#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>

#include "base/time.h"

class QFontMetricsF;
class QPainter;

namespace deckpipe {

// "47.3", "−5.5" (U+2212), "0.0": one decimal, the person's decimal sign, never a negative zero, no unit.
QString degreesText(double degrees);

// "0.4 s", "95 s", "1 min 45 s" (base/time.h): short, for beside a value.
QString ageText(Duration age);

// A device's name in `room` pixels: whole if it fits. A PIN keeps its first four characters, the type, and its
// last six, by which those of one fleet differ: "1032…801035". In less room than that its end alone is left;
// names with spaces are elided in the middle.
QString elidedPin(const QString& name, const QFontMetricsF& metrics, double room);

// Width in pixels of `text` in cells of equal digits.
double figuresWidth(const QFont& font, const QString& text);

// `number` right aligned against `unit`, the unit against the right edge; the digits' height is centred in
// `slot`. The unit stands in the unit's own font, which should be lighter.
struct Figures {
  QString number;
  QString unit;
  QFont numberFont;
  QFont unitFont;
  QColor numberColour;
  QColor unitColour;
};
void drawFigures(QPainter& painter, const QRectF& slot, const Figures& figures);

// The font at `pixels` or, where `widest` would then not fit `width`, as much smaller as needed; not below
// `least` (then the caller drops or elides).
QFont fittedFont(QFont font, double pixels, const QString& widest, double width, double least);

}  // namespace deckpipe
