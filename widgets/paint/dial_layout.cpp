// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/dial_layout.h"

#include <algorithm>
#include <cmath>

namespace deckpipe {
namespace {

// Widths in units of the font size, wide enough for any font that a desktop uses for its interface.
constexpr double kRotationFigures = 4.5;   // "−180.0°"
constexpr double kElevationFigures = 3.9;  // "−90.0°"
constexpr double kTitleWidth = 6.2;
constexpr double kChipWidth = 7.0;
constexpr double kRotationShare = 0.52;  // of the texts' width, for its number is longer
constexpr double kLabelWidth = 4.4;
constexpr double kLine = 1.4;
constexpr double kValueLine = 0.98;  // figures have nothing below their baseline

// The side view shows the half circle ahead of the monitor and a strip of the apparatus behind it.
constexpr double kBehind = 0.36;
constexpr double kPlanWidth = 2.0;
constexpr double kSideWidth = 1.0 + kBehind;

// Side of the largest square in a corner of `box` that leaves a circle in its middle free.
double freeCorner(const QSizeF& box, double radius) {
  const double a = box.width() / 2, b = box.height() / 2;
  const double root = 2 * radius * radius - (a - b) * (a - b);
  return root > 0 ? (a + b - std::sqrt(root)) / 2 : std::min(a, b);
}

// Radius of both circles in drawings that are so high and share `free` of the width. They have labels if that leaves a
// circle worth looking at, otherwise the circles have all of the room.
double layOutCircles(DialLayout& dial, double height, double free) {
  const double line = std::ceil(dial.textSize * kLine);
  const double labelWidth = std::ceil(dial.textSize * kLabelWidth);
  const double labelGap = std::ceil(dial.textSize * 0.35);
  double radius = std::min(height / 2 - line - labelGap,
                           (free - 3 * (labelWidth + labelGap)) / (kPlanWidth + kSideWidth));
  if (radius >= 60) {
    dial.labelWidth = labelWidth;
    dial.labelHeight = line;
    dial.labelGap = labelGap;
  } else {
    radius = std::min(height / 2, free / (kPlanWidth + kSideWidth)) - 1;
  }
  return std::floor(std::max(radius, 1.0));
}

// From here on the numbers stand beside the drawings: below them they would take more from the circle.
constexpr double kBesideAspect = 2.6;  // width over height
constexpr double kBesideShare = 0.45;  // of the width, at most, for the texts

// A column: the title, the number, under it condition and source, then the sign and word of a chip.
void placeColumn(DialViewLayout& view, QRectF& chip, const DialLayout& dial) {
  const QRectF& all = view.texts;
  const double line = std::ceil(dial.textSize * kLine);
  const double valueHeight = std::ceil(dial.valueSize * kValueLine);
  const double needed = valueHeight + 3 * line;
  const bool hasTitle = needed + line <= all.height();
  double y = std::max(all.top(), all.center().y() - (needed + (hasTitle ? line : 0)) / 2);
  const auto row = [&](double height) {
    const QRectF slot(all.left(), y, all.width(), height);
    y += height;
    return slot;
  };
  if (hasTitle) view.title = row(line);
  view.value = row(valueHeight);
  view.condition = row(line);
  view.source = row(line);
  chip = row(line);
  chip.setWidth(std::min(chip.width(), kChipWidth * dial.textSize));
}

DialLayout layOutBeside(DialLayout dial, double pad) {
  dial.beside = true;
  const QRectF inner = dial.bounds.adjusted(pad, pad, -pad, -pad);
  const double gap = pad * 2;
  dial.textSize = std::floor(std::max(12.0, std::min(inner.height() * 0.065, inner.width() * 0.021)));
  dial.valueSize =
      std::floor(std::max(12.0, std::min(inner.height() * 0.26, inner.width() * kBesideShare /
                                                                    (kRotationFigures + kElevationFigures))));
  const double rotationTexts = std::max(kRotationFigures * dial.valueSize, kChipWidth * dial.textSize);
  const double elevationTexts = std::max(kElevationFigures * dial.valueSize, kChipWidth * dial.textSize);
  const double free = inner.width() - rotationTexts - elevationTexts - 3 * gap;
  const double radius = layOutCircles(dial, inner.height(), free);
  const double labels = std::max(1.0, dial.labelWidth + dial.labelGap);
  const double planNeed = kPlanWidth * radius + 2 * labels, sideNeed = kSideWidth * radius + labels;
  const double slack = std::max(0.0, free - planNeed - sideNeed) / 3;
  double x = inner.left() + slack;
  const auto take = [&](double width, double gapAfter) {
    const QRectF part(x, inner.top(), width, inner.height());
    x += width + gapAfter;
    return part;
  };
  dial.rotation.drawing = take(planNeed, gap);
  dial.rotation.texts = take(rotationTexts, gap + slack);
  dial.elevation.drawing = take(sideNeed, gap);
  dial.elevation.texts = take(elevationTexts, 0);
  dial.rotation.radius = dial.elevation.radius = radius;
  dial.rotation.pivot = dial.rotation.drawing.center();
  dial.elevation.pivot =
      QPointF(dial.elevation.drawing.left() + labels + radius, dial.elevation.drawing.center().y());
  placeColumn(dial.rotation, dial.enableChip, dial);
  placeColumn(dial.elevation, dial.stowedChip, dial);
  return dial;
}

void placeTexts(DialViewLayout& view, const DialLayout& dial) {
  const double figures = view.kind == DialAxisKind::Rotation ? kRotationFigures : kElevationFigures;
  const double line = std::ceil(dial.textSize * kLine);
  const double valueHeight = std::ceil(dial.valueSize * kValueLine);
  const QRectF& all = view.texts;
  double y = all.top();
  if (dial.compact) {
    view.value = QRectF(all.left(), y, all.width(), valueHeight);
    y += valueHeight;
    if (dial.bounds.height() >= 110) view.condition = QRectF(all.left(), y, all.width(), line);
    y += line;
    if (dial.bounds.height() >= 170) view.source = QRectF(all.left(), y, all.width(), line);
    return;
  }
  const double titleWidth = kTitleWidth * dial.textSize;
  const double width = std::min(all.width(), titleWidth + figures * dial.valueSize);
  const double left = all.center().x() - width / 2;
  view.title = QRectF(left, y, titleWidth, valueHeight / 2);
  view.age = QRectF(left, y + valueHeight / 2, titleWidth, valueHeight / 2);
  view.value = QRectF(left + titleWidth, y, width - titleWidth, valueHeight);
  y += valueHeight + line * 0.2;
  const double gap = dial.textSize / 2;
  const double half = (width - gap) / 2;
  view.condition = QRectF(left, y, half, line);
  view.source = QRectF(left + half + gap, y, half, line);
}

}  // namespace

DialLayout layOutDial(const QRectF& bounds) {
  DialLayout dial;
  dial.bounds = bounds;
  dial.rotation.kind = DialAxisKind::Rotation;
  dial.elevation.kind = DialAxisKind::Elevation;
  const double w = bounds.width();
  const double h = bounds.height();
  if (w < 40 || h < 30) return dial;  // no instrument fits; the widget's minimum is far above

  const double pad = std::clamp(std::min(w, h) * 0.03, 4.0, 32.0);
  if (w >= 440 && w > kBesideAspect * h) return layOutBeside(dial, pad);
  const QRectF inner = bounds.adjusted(pad, pad, -pad, -pad);
  const double gap = pad * 2;
  const double free = inner.width() - gap;
  dial.compact = w < 440 || h < 220;
  dial.textSize = std::floor(std::max(11.0, std::min(h * 0.038, w * 0.021)));
  const double line = std::ceil(dial.textSize * kLine);
  // Two numbers side by side must not read as one.
  const double textGap = dial.compact ? gap : std::max(gap, dial.textSize * 2.5);
  const double elevationTexts = (inner.width() - textGap) * (1 - kRotationShare);

  double below = 0;
  if (dial.compact) {
    dial.valueSize = std::floor(std::max(12.0, std::min(h * 0.17, elevationTexts / kElevationFigures)));
    below = std::ceil(dial.valueSize * kValueLine) + (h >= 110 ? line : 0) + (h >= 170 ? line : 0) + pad / 2;
  } else {
    const double room = elevationTexts - kTitleWidth * dial.textSize;
    dial.valueSize = std::floor(std::min(h * 0.13, room / kElevationFigures));
    below = std::ceil(dial.valueSize * kValueLine) + line * 1.2 + pad / 2;
  }

  const double height = inner.height() - below;
  const double radius = layOutCircles(dial, height, free);
  const double planNeed = kPlanWidth * radius + 2 * (dial.labelWidth + dial.labelGap);
  const double sideNeed = kSideWidth * radius + dial.labelWidth + dial.labelGap;
  const double slack = std::max(0.0, free - planNeed - sideNeed);
  const double planWidth = std::min(planNeed + slack * 0.5, free);
  const double rotationTexts = inner.width() - textGap - elevationTexts;
  const double textTop = inner.top() + height + pad / 2;
  const double right = inner.left() + planWidth + gap;
  dial.rotation.drawing = QRectF(inner.left(), inner.top(), planWidth, height);
  dial.elevation.drawing = QRectF(right, inner.top(), inner.right() - right, height);
  dial.rotation.texts = QRectF(inner.left(), textTop, rotationTexts, inner.bottom() - textTop);
  dial.elevation.texts =
      QRectF(inner.left() + rotationTexts + textGap, textTop, elevationTexts, inner.bottom() - textTop);
  for (DialViewLayout* view : {&dial.rotation, &dial.elevation}) {
    view->radius = radius;
    view->pivot = view->drawing.center();
    placeTexts(*view, dial);
  }
  dial.elevation.pivot.setX(dial.elevation.drawing.center().x() - sideNeed / 2 + dial.labelWidth +
                            dial.labelGap + radius);

  // In the corners beside the top of the plan; labels make way for them.
  const double sign = std::floor(
      std::min(std::max(14.0, dial.textSize * 1.2), freeCorner(dial.rotation.drawing.size(), radius)));
  const QSizeF chip =
      dial.compact ? QSizeF(sign, sign) : QSizeF(kChipWidth * dial.textSize, dial.textSize * kLine);
  dial.enableChip = QRectF(dial.rotation.drawing.topLeft(), chip);
  dial.stowedChip = QRectF(dial.rotation.drawing.topRight() - QPointF(chip.width(), 0), chip);
  return dial;
}

}  // namespace deckpipe
