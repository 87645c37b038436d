// SPDX-License-Identifier: GPL-3.0-or-later
// Where the parts of a dial lie in a rectangle. It depends on the size alone, never on a value, so that
// nothing moves when a value does. Pixels, y downwards; no font is asked: text rectangles follow from the
// sizes below.
//
// Full: under the drawings, for each axis, left the title over the age, right the number, below them
// condition and source. Beside (much wider than high, down to 112 px of height): the same under one another
// to the right of each drawing, which has all of the height. Compact (down to 200 px): number, condition and
// source under one another below the drawings. With less room the title and the limits' labels go first, then
// the source, then the condition. A null rectangle is not drawn. No rectangle of one view reaches into the
// other.
#pragma once

#include <QPointF>
#include <QRectF>

namespace deckpipe {

enum class DialAxisKind { Rotation, Elevation };

struct DialViewLayout {
  DialAxisKind kind = DialAxisKind::Rotation;
  QRectF drawing;  // with the margin for its labels
  QRectF texts;    // below or beside; as wide as the number needs, for both numbers have the same size
  QPointF pivot;   // the monitor
  double radius = 0;

  QRectF title;
  QRectF value;      // number, right aligned
  QRectF age;        // null but in full: the condition's place then serves both
  QRectF condition;  // hard stop, or the reason why there is no value
  QRectF source;     // who commands
};

struct DialLayout {
  QRectF bounds;
  DialViewLayout rotation;
  DialViewLayout elevation;
  QRectF enableChip;  // motion allowed or not; in compact a square, for the sign alone
  QRectF stowedChip;
  double textSize = 0;    // pixels, secondary text
  double valueSize = 0;   // pixels, numbers
  double labelWidth = 0;  // of a soft limit's label; 0 where there is no room for labels
  double labelHeight = 0;
  double labelGap = 0;  // between the circle and a label
  bool compact = false;
  bool beside = false;
};

DialLayout layOutDial(const QRectF& bounds);

}  // namespace deckpipe
