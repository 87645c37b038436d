// SPDX-License-Identifier: GPL-3.0-or-later
// The scale of a timeline: where its ticks stand and what is written under them. Pure; the caller says how wide a text
// is. A log without times is measured in frames, each of which takes kFrameOnScale of the strip's time.
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "paint/timeline_geometry.h"

namespace deckpipe {

enum class TimelineUnit : std::uint8_t { Time, Frames };

inline constexpr Duration kFrameOnScale = 1s;

struct TimelineTick {
  double x = 0;     // pixel
  double left = 0;  // pixel where the text begins
  QString text{};   // empty: a tick between two with text, or one whose text would be cut
};

// From left to right. `zero` is where the scale is 0. Steps with a text are 1, 2 or 5 times a power of ten of seconds
// or frames; from 10 s on 10 or 30 s, 1, 2, 5, 10 or 30 min, 1, 3, 6 or 12 h, then days.
std::vector<TimelineTick> timelineTicks(const TimelineGeometry& geometry, Instant zero, TimelineUnit unit,
                                        const std::function<double(const QString&)>& widthOf);

}  // namespace deckpipe
