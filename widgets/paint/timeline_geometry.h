// SPDX-License-Identifier: GPL-3.0-or-later
// The timeline's numbers: which instant is at which pixel. Pure, tested without a window. Spans of years and
// of microseconds, of one instant and hostile ones all have an answer.
#pragma once

#include <QRectF>
#include <algorithm>
#include <cmath>

#include "base/time.h"

namespace deckpipe {

struct TimelineSpan {
  Instant begin, end;

  double ns() const { return static_cast<double>(end.ns) - static_cast<double>(begin.ns); }
  bool has(Instant t) const { return begin <= t && t <= end; }
  friend bool operator==(const TimelineSpan&, const TimelineSpan&) = default;
};

// Closer than this nothing is to be seen.
inline constexpr double kMinSpanNs = 1e6;

// As long as `span`, but within `whole`.
inline TimelineSpan spanWithin(TimelineSpan span, TimelineSpan whole) {
  if (span.ns() >= whole.ns()) return whole;
  if (span.begin < whole.begin) return {whole.begin, whole.begin + (span.end - span.begin)};
  if (span.end > whole.end) return {whole.end - (span.end - span.begin), whole.end};
  return span;
}
// Closer by `factor`, no closer than `least` ns, with the instant `around` where it is; the whole where that is not
// longer.
inline TimelineSpan spanZoomed(TimelineSpan span, TimelineSpan whole, Instant around, double factor,
                               double least = kMinSpanNs) {
  const double length = std::max(span.ns() / factor, least);
  if (length >= whole.ns() || span.ns() <= 0) return whole;
  const double share =
      std::clamp((static_cast<double>(around.ns) - static_cast<double>(span.begin.ns)) / span.ns(), 0.0, 1.0);
  const Instant begin = around - Duration(std::llround(share * length));
  return spanWithin({begin, begin + Duration(std::llround(length))}, whole);
}
inline TimelineSpan spanMoved(TimelineSpan span, TimelineSpan whole, double share) {
  const Duration by(std::llround(share * span.ns()));
  return spanWithin({span.begin + by, span.end + by}, whole);
}

struct TimelineGeometry {
  static constexpr double kInset = 10;  // so that the cursor's handle is whole at either end

  double width = 0;
  Instant begin, end;

  double left() const { return kInset; }
  double right() const { return std::max(kInset + 1, width - kInset); }

  double xOf(Instant t) const {
    const double span = spanNs();
    if (span <= 0) return right();  // one instant: the log's end is what there is
    const double share = (static_cast<double>(t.ns) - static_cast<double>(begin.ns)) / span;
    return left() + std::clamp(share, 0.0, 1.0) * (right() - left());
  }
  // The ends exactly; between them to the pixel.
  Instant timeAt(double x) const {
    if (x <= left()) return begin;
    if (x >= right() || spanNs() <= 0) return end;
    const double share = (x - left()) / (right() - left());
    return std::clamp(Instant{begin.ns + std::llround(share * spanNs())}, begin, end);
  }

 private:
  double spanNs() const { return static_cast<double>(end.ns) - static_cast<double>(begin.ns); }
};

}  // namespace deckpipe
