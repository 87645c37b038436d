// SPDX-License-Identifier: GPL-3.0-or-later
// From values and a rectangle to positions: needles, bands, blocks, arrows. Pure, tested without a window;
// the painter only strokes and fills what stands here.
//
// Both views turn the same way on the screen: plus is clockwise. Plan: 0° up, right is clockwise. Elevation
// is seen from the apparatus' left side, so ahead is to the LEFT: 0° points left and up is clockwise from
// there. A bearing is degrees clockwise from straight up on the screen.
#pragma once

#include <QLineF>
#include <QPolygonF>
#include <optional>
#include <vector>

#include "paint/dial_layout.h"
#include "paint/dial_values.h"

namespace deckpipe {

// Lengths as fractions of the radius.
namespace dial {
inline constexpr double kHub = 0.1;
inline constexpr double kNeedleTip = 0.89;
inline constexpr double kTickInner = 0.86;
inline constexpr double kTickOuter = 0.92;
inline constexpr double kBand = 0.965;  // its middle
inline constexpr double kBandWidth = 0.07;
inline constexpr double kCommand = 0.44;  // the arrow's middle
}  // namespace dial

struct DialArc {
  double from = 0;  // degrees of the axis, from <= to
  double to = 0;
};

struct DialBlock {
  QPolygonF shape;
  QRectF glyph;
};

struct DialLimit {
  QLineF end;    // closes the band; never stands out of it: before a label it would read as a minus
  QRectF label;  // null where there is no room
  double degrees = 0;
};

struct DialTick {
  QLineF line;
  bool numbered = false;  // not where the needle would lie on the number
  double degrees = 0;
  bool major = false;
};

struct DialView : DialViewLayout {
  DialAxis axis;

  std::optional<QLineF> needle;  // hub to tip; only of a reading that is Ok
  QPolygonF needleShape;
  std::optional<QLineF> offScale;  // at the scale's end where the needle is held back by it

  std::optional<DialArc> band;
  std::optional<DialLimit> low;
  std::optional<DialLimit> high;

  std::optional<DialBlock> plusStop;  // on or error; against the needle, or beside the hub without one
  std::optional<DialBlock> minusStop;

  QPolygonF command;         // empty: nobody commands, or at rest
  double commandLength = 0;  // pixels along the arrow

  std::vector<DialTick> ticks;

  DialArc scale() const;
  double bearing(double degrees) const;
  QPointF at(double degrees, double fraction) const;  // fraction of the radius
  double px(double fraction) const { return fraction * radius; }
};

struct DialGeometry {
  DialLayout layout;
  DialView rotation;
  DialView elevation;
};

DialGeometry dialGeometry(const DialValues& values, const QRectF& bounds);

}  // namespace deckpipe
