// SPDX-License-Identifier: GPL-3.0-or-later
// The dial's texts: numbers, ages, conditions, who commands, the two chips. What does not fit is written
// shorter, then as its glyph alone; nothing is clipped.
#pragma once

#include <QCoreApplication>
#include <QString>

#include "paint/dial_geometry.h"
#include "paint/dial_layout.h"
#include "paint/dial_values.h"
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

// The dial's words: short ones for its texts, whole sentences for who does not see it.
class DialText {
  Q_DECLARE_TR_FUNCTIONS(DialText)

 public:
  static QString title(DialAxisKind kind);
  // Why there is no value: "Sensor error"; empty for a reading that is Ok. readingShort() fits into 75
  // pixels.
  static QString reading(std::optional<PositionState> reading);
  static QString readingShort(std::optional<PositionState> reading);
  // "Right stop", "Down stop error"; empty where neither stop is on or in error.
  static QString stops(DialAxisKind kind, const DialAxis& axis);
  // nullopt: the device has not said it.
  static QString enable(std::optional<bool> flag);
  static QString stowed(std::optional<bool> flag);
  static QString enableLong(std::optional<bool> flag);
  static QString stowedLong(std::optional<bool> flag);
  // Everything that the dial draws, in sentences.
  static QString description(const DialValues& values);

 private:
  static QString angle(DialAxisKind kind, double degrees);
  static QString direction(DialAxisKind kind, bool plus);
  static QString describe(DialAxisKind kind, const DialAxis& axis);
};

}  // namespace deckpipe
