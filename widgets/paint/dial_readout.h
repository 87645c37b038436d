// SPDX-License-Identifier: GPL-3.0-or-later
// The dial's texts: numbers, ages, conditions, who commands, the two chips. What does not fit is written
// shorter, then as its glyph alone; nothing is clipped.
#pragma once

#include "paint/dial_geometry.h"
#include "paint/glyph.h"
#include "paint/palette.h"

class QFont;
class QPainter;

namespace deckpipe {

class DialReadout {
 public:
  DialReadout(QPainter& painter, const Colours& colours, const QFont& font, const DialLayout& layout);

  void draw(const DialView& view);
  void drawChips(const DialValues& values);

 private:
  struct Note {
    Glyph glyph = Glyph::Fine;
    QColor ink;
    QColor textInk;
    QString text;
    double turned = 0;  // degrees clockwise, of the glyph
    bool bare = false;  // no glyph
  };

  void drawValue(const DialView& view);
  void drawAge(const DialView& view);
  void drawCondition(const DialView& view);
  void drawSource(const DialView& view);
  void drawNote(const QRectF& slot, const Note& note, bool right = false);
  void drawChip(const QRectF& slot, const Note& note, const Tone* plate);
  Note ageNote(const DialAxis& axis) const;
  QFont font(double pixels, bool strong = false) const;

  QPainter& m_painter;
  const Colours& m_colours;
  const QFont& m_font;
  const DialLayout& m_layout;
};

}  // namespace deckpipe
