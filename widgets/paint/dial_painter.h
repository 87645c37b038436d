// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes and fills one view of a dial from its geometry. Solid is measured, hollow is commanded, dashed is
// not live; the same in every theme. The face lies below; it changes with limits and sizes, seldom with a
// position, so that the dial can keep its picture.
#pragma once

#include "paint/dial_geometry.h"
#include "paint/palette.h"

class QFont;
class QPainter;

namespace deckpipe {

class DialPainter {
 public:
  DialPainter(QPainter& painter, const Colours& colours, const QFont& font, double textSize);

  void drawFace(const DialView& view);
  // `sway` −1..1 shifts the dashes of an oscillating band.
  void drawMoving(const DialView& view, double sway);

 private:
  void drawApparatus();
  void drawTicks();
  void drawBand(double sway);
  void drawLimit(const DialLimit& limit);
  void drawNeedle();
  void drawHub();
  void drawStop(const DialBlock& block, std::optional<Status2> stop);
  void drawCommand();
  void drawNoReading();
  double line(double fraction, double least) const;

  QPainter& m_painter;
  const Colours& m_colours;
  const QFont& m_font;
  double m_textSize;
  const DialView* m_view = nullptr;
};

}  // namespace deckpipe
