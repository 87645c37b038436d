// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/dial_labels.h"

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

}  // namespace

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

}  // namespace deckpipe
