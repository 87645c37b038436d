// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/dial_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace deckpipe {
namespace {

// A label may slide along the circle by this much to find room; further off it would belong to nothing.
constexpr double kMaxSlide = 60;
constexpr double kSlideStep = 2;

struct Candidate {
  QRectF rect;
  double slide = 0;  // degrees clockwise
};

double distance(const QPointF& from, const QRectF& rect) {
  const double dx = std::max({rect.left() - from.x(), 0.0, from.x() - rect.right()});
  const double dy = std::max({rect.top() - from.y(), 0.0, from.y() - rect.bottom()});
  return std::hypot(dx, dy);
}

// Moved out along the bearing until all of it is beyond the circle's tangent, then into the drawing.
QRectF labelAt(const DialView& v, const DialLayout& layout, double bearing) {
  const double a = bearing * std::numbers::pi / 180;
  const QPointF out(std::sin(a), -std::cos(a));
  const double w = layout.labelWidth, h = layout.labelHeight;
  const double support = (std::abs(out.x()) * w + std::abs(out.y()) * h) / 2;
  const QPointF centre = v.pivot + out * (v.radius + layout.labelGap + support);
  const double left = std::clamp(centre.x() - w / 2, v.drawing.left(), v.drawing.right() - w);
  const double top = std::clamp(centre.y() - h / 2, v.drawing.top(), v.drawing.bottom() - h);
  return {left, top, w, h};
}

bool isClear(const DialView& v, const DialLayout& layout, const QRectF& rect) {
  return distance(v.pivot, rect) >= v.radius && !rect.intersects(layout.enableChip) &&
         !rect.intersects(layout.stowedChip);
}

std::vector<Candidate> candidatesFor(const DialView& v, const DialLayout& layout, double bearing) {
  std::vector<Candidate> all;
  for (double slide = -kMaxSlide; slide <= kMaxSlide; slide += kSlideStep) {
    const QRectF rect = labelAt(v, layout, bearing + slide);
    if (isClear(v, layout, rect)) all.push_back({rect, slide});
  }
  return all;
}

QRectF nearest(const std::vector<Candidate>& all) {
  const auto best = std::min_element(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
    return std::abs(a.slide) < std::abs(b.slide);
  });
  return best == all.end() ? QRectF() : best->rect;
}

// Where the end values of a dial's band stand: outside the circle beside their end, clear of each other and
// of the chips. Called by dialGeometry alone.
void placeLimitLabels(DialView& v, const DialLayout& layout) {
  if (layout.labelWidth <= 0) return;
  const auto bearingOf = [&](const DialLimit& limit) {
    return v.bearing(std::clamp(limit.degrees, v.scale().from, v.scale().to));
  };
  if (!v.low || !v.high) {
    for (auto* limit : {&v.low, &v.high})
      if (*limit) (*limit)->label = nearest(candidatesFor(v, layout, bearingOf(**limit)));
    return;
  }
  const double low = bearingOf(*v.low);
  // Over more than half the circle the ends are neighbours the other way round.
  const bool wraps = bearingOf(*v.high) - low > 180;
  const double high = bearingOf(*v.high) - (wraps ? 360 : 0);
  const double order = wraps || high < low ? -1 : 1;
  // Most often both have room right beside their ends, and nothing is better.
  v.low->label = labelAt(v, layout, low);
  v.high->label = labelAt(v, layout, high);
  if (isClear(v, layout, v.low->label) && isClear(v, layout, v.high->label) &&
      !v.low->label.intersects(v.high->label))
    return;
  v.low->label = v.high->label = {};
  const auto lows = candidatesFor(v, layout, low), highs = candidatesFor(v, layout, high);
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& a : lows) {
    for (const Candidate& b : highs) {
      const double cost = a.slide * a.slide + b.slide * b.slide;
      if (cost >= least || a.rect.intersects(b.rect)) continue;
      // They keep their order, or each would stand beside the other's end.
      if ((high + b.slide - low - a.slide) * order < 0) continue;
      least = cost;
      v.low->label = a.rect;
      v.high->label = b.rect;
    }
  }
}

using dial::kCommand;
using dial::kHub;
using dial::kNeedleTip;

constexpr double kStopInner = 0.54, kStopOuter = 0.88, kStopSweep = 20;
constexpr double kStopBeside = 0.42;  // of a block without a needle, from the hub

// Halves of the arrow's widths: hollow is seen as hollow only while both edges have a gap between them.
double halfShaft(const DialView& v) { return std::max(0.045, 2.6 / v.radius); }
double halfHead(const DialView& v) { return std::max(0.105, 5.5 / v.radius); }

QPointF polar(const QPointF& centre, double bearing, double radius) {
  const double a = bearing * std::numbers::pi / 180;
  return {centre.x() + radius * std::sin(a), centre.y() - radius * std::cos(a)};
}

void appendArc(QPolygonF& shape, const DialView& v, double from, double to, double fraction) {
  const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(to - from) / 3)));
  for (int i = 0; i <= steps; ++i) shape << polar(v.pivot, from + (to - from) * i / steps, v.px(fraction));
}

// Rotation beyond half a turn is still a direction; elevation beyond the half circle would point into the
// other drawing, so the needle stops at the scale's end and says so (offScale). The number stays true.
double shownDegrees(const DialView& v) {
  if (v.kind == DialAxisKind::Rotation) return v.axis.degrees;
  return std::clamp(v.axis.degrees, v.scale().from, v.scale().to);
}

void placeNeedle(DialView& v) {
  if (v.axis.reading != PositionState::Ok || !std::isfinite(v.axis.degrees)) return;
  const double shown = shownDegrees(v);
  const double b = v.bearing(shown);
  v.needle = QLineF(polar(v.pivot, b, v.px(kHub)), polar(v.pivot, b, v.px(kNeedleTip)));
  if (shown != v.axis.degrees) {
    const double side = v.axis.degrees > shown ? 1 : -1;
    const double sweep = std::max(7.0, 6 / v.px(0.75) * 180 / std::numbers::pi);
    v.offScale =
        QLineF(polar(v.pivot, b + side * 4, v.px(0.75)), polar(v.pivot, b + side * (4 + sweep), v.px(0.75)));
  }
  const QPointF along = (v.needle->p2() - v.needle->p1()) / v.needle->length();
  const QPointF across(-along.y(), along.x());
  const double base = std::max(2.0, v.px(0.045));
  const double shoulder = std::max(1.6, v.px(0.03));
  const QPointF neck = v.needle->p2() - along * std::max(5.0, v.px(0.12));
  v.needleShape << v.needle->p1() + across * base << neck + across * shoulder << v.needle->p2()
                << neck - across * shoulder << v.needle->p1() - across * base;
}

DialLimit limitAt(const DialView& v, double degrees) {
  DialLimit limit;
  limit.degrees = degrees;
  const double b = v.bearing(std::clamp(degrees, v.scale().from, v.scale().to));
  limit.end =
      QLineF(polar(v.pivot, b, v.px(dial::kBand - dial::kBandWidth / 2)), polar(v.pivot, b, v.px(1.0)));
  return limit;
}

void placeLimits(DialView& v, const DialLayout& layout) {
  const auto [from, to] = v.scale();
  const auto given = [](const std::optional<double>& limit) { return limit && std::isfinite(*limit); };
  if (given(v.axis.limitLow)) v.low = limitAt(v, *v.axis.limitLow);
  if (given(v.axis.limitHigh)) v.high = limitAt(v, *v.axis.limitHigh);
  if (v.low && v.high) {
    const DialArc band{std::clamp(v.low->degrees, from, to), std::clamp(v.high->degrees, from, to)};
    // One end alone gives no band, and ends the wrong way round none either: their end lines are shown.
    if (band.from < band.to) v.band = band;
  }
  placeLimitLabels(v, layout);
}

std::optional<DialBlock> stopBlock(const DialView& v, std::optional<Status2> stop, double side) {
  if (stop != Status2::On && stop != Status2::Error) return {};
  DialBlock block;
  QPointF middle;
  if (v.needle) {
    const double b = v.bearing(shownDegrees(v));
    const double near = b + side * 3.5;  // clear of the needle's own width at that radius
    const double far = near + side * kStopSweep;
    appendArc(block.shape, v, near, far, kStopOuter);
    appendArc(block.shape, v, far, near, kStopInner);
    middle = polar(v.pivot, (near + far) / 2, v.px((kStopInner + kStopOuter) / 2));
  } else {
    // Where it stands is not known, which end it is: right or left of the hub, above or below level.
    const double half = v.px(0.15);
    middle = v.kind == DialAxisKind::Rotation ? v.pivot + QPointF(side * v.px(kStopBeside), 0)
                                              : v.pivot + QPointF(-v.px(0.34), -side * v.px(kStopBeside));
    const QRectF box(middle.x() - half, middle.y() - half, 2 * half, 2 * half);
    block.shape << box.topLeft() << box.topRight() << box.bottomRight() << box.bottomLeft();
  }
  const double half = std::max(5.0, v.px(0.095));
  block.glyph = QRectF(middle.x() - half, middle.y() - half, 2 * half, 2 * half);
  return block;
}

void placeCommand(DialView& v) {
  if (!v.axis.command || !std::isfinite(v.axis.command->speed)) return;
  const double speed = std::clamp(v.axis.command->speed, -1.0, 1.0);
  if (speed == 0) return;
  const double side = speed > 0 ? 1 : -1;
  // The head alone is longer than the slowest speed, so the shaft carries it.
  const double head = 15, most = v.kind == DialAxisKind::Rotation ? 84 : 38;
  const double sweep = head + (most - head) * std::abs(speed);
  v.commandLength = v.px(kCommand) * sweep * std::numbers::pi / 180;
  if (v.needle) {
    const double start = v.bearing(shownDegrees(v)) + side * 10;
    const double neck = start + side * (sweep - head);
    appendArc(v.command, v, start, neck, kCommand + halfShaft(v));
    v.command << polar(v.pivot, neck, v.px(kCommand + halfHead(v)))
              << polar(v.pivot, neck + side * head, v.px(kCommand))
              << polar(v.pivot, neck, v.px(kCommand - halfHead(v)));
    appendArc(v.command, v, neck, start, kCommand - halfShaft(v));
    return;
  }
  // Without a position there is nothing to turn from: a straight arrow beside the hub.
  const bool plan = v.kind == DialAxisKind::Rotation;
  const QPointF along = plan ? QPointF(side, 0) : QPointF(0, -side);
  const QPointF across(-along.y(), along.x());
  const QPointF start =
      v.pivot + (plan ? QPointF(0, v.px(0.62)) : QPointF(-v.px(0.77), 0)) - along * (v.commandLength / 2);
  const QPointF tip = start + along * v.commandLength;
  const QPointF neck = tip - along * v.px(kCommand) * head * std::numbers::pi / 180;
  const QPointF shaft = across * v.px(halfShaft(v)), wide = across * v.px(halfHead(v));
  v.command << start + shaft << neck + shaft << neck + wide << tip << neck - wide << neck - shaft
            << start - shaft;
}

void placeTicks(DialView& v) {
  const auto [from, to] = v.scale();
  const int step = v.radius >= 85 ? 10 : v.radius >= 70 ? 30 : 45;
  const int numbered = v.kind == DialAxisKind::Rotation ? 90 : v.radius >= 150 ? 45 : 90;
  const bool wholeCircle = v.kind == DialAxisKind::Rotation;
  for (int d = static_cast<int>(from) + (wholeCircle ? step : 0); d <= static_cast<int>(to); d += step) {
    DialTick tick;
    tick.degrees = d;
    tick.major = d % 45 == 0 || (step == 10 && d % 30 == 0);
    const double inner = tick.major ? dial::kTickInner : (dial::kTickInner + dial::kTickOuter) / 2;
    tick.line = QLineF(v.at(d, inner), v.at(d, dial::kTickOuter));
    const double off = std::remainder(d - shownDegrees(v), 360);
    const bool covered = v.needle && std::abs(off) < 14;
    tick.numbered = v.radius >= 85 && d % numbered == 0 && !covered;
    v.ticks.push_back(tick);
  }
}

DialView viewOf(const DialAxis& axis, const DialViewLayout& place, const DialLayout& layout) {
  DialView v;
  static_cast<DialViewLayout&>(v) = place;
  v.axis = axis;
  if (v.radius <= 0) return v;
  placeNeedle(v);
  placeLimits(v, layout);
  v.plusStop = stopBlock(v, axis.plusStop, +1);
  v.minusStop = stopBlock(v, axis.minusStop, -1);
  placeCommand(v);
  placeTicks(v);
  return v;
}

}  // namespace

DialArc DialView::scale() const {
  return kind == DialAxisKind::Rotation ? DialArc{-180, 180} : DialArc{-90, 90};
}

double DialView::bearing(double degrees) const {
  return kind == DialAxisKind::Rotation ? degrees : degrees - 90;
}

QPointF DialView::at(double degrees, double fraction) const {
  return polar(pivot, bearing(degrees), px(fraction));
}

DialGeometry dialGeometry(const DialValues& values, const QRectF& bounds) {
  DialGeometry g;
  g.layout = layOutDial(bounds);
  g.rotation = viewOf(values.rotation, g.layout.rotation, g.layout);
  g.elevation = viewOf(values.elevation, g.layout.elevation, g.layout);
  return g;
}

}  // namespace deckpipe
