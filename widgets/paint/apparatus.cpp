// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/apparatus.h"

#include <QTransform>

namespace deckpipe {
namespace {

QPainterPath placed(const QPainterPath& unit, const QPointF& pivot, double radius) {
  return QTransform(radius, 0, 0, radius, pivot.x(), pivot.y()).map(unit);
}

}  // namespace

QPainterPath apparatusFromAbove(const QPointF& pivot, double radius) {
  QPainterPath unit;
  // Body.
  unit.addRoundedRect(QRectF(-0.2, -0.24, 0.4, 0.82), 0.03, 0.03);
  // Cab with a rounded nose, and its windscreen.
  unit.moveTo(-0.19, -0.27);
  unit.lineTo(-0.19, -0.54);
  unit.quadTo(-0.19, -0.64, -0.09, -0.65);
  unit.lineTo(0.09, -0.65);
  unit.quadTo(0.19, -0.64, 0.19, -0.54);
  unit.lineTo(0.19, -0.27);
  unit.closeSubpath();
  unit.moveTo(-0.15, -0.52);
  unit.quadTo(0, -0.57, 0.15, -0.52);
  // Mirrors.
  unit.moveTo(-0.19, -0.53);
  unit.lineTo(-0.245, -0.5);
  unit.moveTo(0.19, -0.53);
  unit.lineTo(0.245, -0.5);
  return placed(unit, pivot, radius);
}

QPainterPath apparatusFromLeft(const QPointF& pivot, double radius, double behind) {
  constexpr double kDeck = 0.22, kRoof = 0.16, kSill = 0.56, kFront = -0.66;
  QPainterPath unit;
  // Body, open to the right where the drawing ends.
  unit.moveTo(behind, kDeck);
  unit.lineTo(-0.24, kDeck);
  unit.lineTo(-0.24, kSill);
  unit.moveTo(behind, kSill);
  unit.lineTo(0.23, kSill);
  unit.moveTo(0.01, kSill);
  unit.lineTo(-0.39, kSill);
  unit.moveTo(-0.61, kSill);
  unit.lineTo(kFront, kSill);
  // Cab, windscreen ahead.
  unit.lineTo(kFront, 0.38);
  unit.lineTo(-0.6, kRoof);
  unit.lineTo(-0.28, kRoof);
  unit.lineTo(-0.28, kSill);
  unit.moveTo(-0.6, 0.22);
  unit.lineTo(-0.47, 0.22);
  unit.lineTo(-0.47, 0.36);
  unit.lineTo(-0.645, 0.36);
  // Wheels.
  unit.addEllipse(QPointF(-0.5, kSill), 0.1, 0.1);
  unit.addEllipse(QPointF(0.12, kSill), 0.1, 0.1);
  // The monitor's riser.
  unit.moveTo(-0.05, kDeck);
  unit.lineTo(-0.05, 0.1);
  unit.moveTo(0.05, kDeck);
  unit.lineTo(0.05, 0.1);
  return placed(unit, pivot, radius);
}

}  // namespace deckpipe
