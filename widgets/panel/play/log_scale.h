// SPDX-License-Identifier: GPL-3.0-or-later
// Where the places of a log stand on the timeline: at their log time. In a log without times all log times are 0; there
// a place stands at the number of frames before it, as if each took kFrameOnScale.
#pragma once

#include "paint/timeline_scale.h"
#include "state/log_view.h"

namespace deckpipe {

inline Instant onScale(std::uint64_t frames) {
  return {static_cast<std::int64_t>(frames) * kFrameOnScale.count()};
}
inline Instant onScale(const LogView& view, Cursor at) {
  return view.hasTimes() ? at.time : onScale(at.frames);
}

// The whole log.
inline TimelineSpan scaleOf(const LogView& view) {
  if (!view.hasTimes()) return {{}, onScale(view.frameCount)};
  return {view.begin, view.end};
}

// The frames before a place of the scale.
inline std::uint64_t framesBefore(const LogView& view, Instant at) {
  if (view.hasTimes()) return view.document->frames.firstAtOrAfter(at);
  return static_cast<std::uint64_t>(std::max<std::int64_t>(0, at.ns + kFrameOnScale.count() / 2) /
                                    kFrameOnScale.count());
}

}  // namespace deckpipe
