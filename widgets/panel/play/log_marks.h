// SPDX-License-Identifier: GPL-3.0-or-later
// What the timeline shows of a log beside the cursor: how dense the span in sight is, where nothing came,
// where a link was lost, where the clock jumped, what was noted, what happened. Held by the transport bar and
// brought up to date with each view; everything comes from indexes, so a log of any size costs the same.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "model/device_labels.h"
#include "paint/timeline.h"
#include "state/log_view.h"

namespace deckpipe {

class LogMarks {
 public:
  // No strip has room for more.
  static constexpr std::size_t kMaxJumps = 2'000;
  // Shortest silence that is drawn as a gap. In a long span the limit is the width of one bin.
  static constexpr Duration kSilence = 1s;

  // What devices are called in the marks of events.
  void setLabels(const DeviceLabels& labels);
  // Of `shown`, which is a part of the scale (log_scale.h); `bins`: equal parts of it, about one every few pixels.
  void take(const LogView& view, TimelineSpan shown, int bins);

  const std::vector<float>& density() const { return m_density; }
  const std::vector<TimelineMark>& marks() const { return m_marks; }
  const std::vector<TimelineGap>& gaps() const { return m_gaps; }

 private:
  bool takeDensity(const LogView& view, TimelineSpan shown, int bins);
  bool takeJumps(const LogView& view);
  bool takeNotes(const LogView& view);
  bool takeEvents(const LogView& view);
  void findGaps(const LogView& view);

  std::shared_ptr<const LogDocument> m_log;
  bool m_hasTimes = true;
  TimelineSpan m_span;  // of the density
  std::vector<float> m_density;
  std::vector<TimelineMark> m_jumps;
  std::size_t m_notesTaken = 0;
  std::vector<TimelineMark> m_notes;
  DeviceLabels m_labels;
  std::size_t m_eventsTaken = 0;
  unsigned m_generation = 0;  // of the log's events
  std::vector<TimelineMark> m_events;
  std::vector<TimelineGap> m_lost;    // from one link-down to the next link-up of its channel
  std::vector<TimelineMark> m_marks;  // jumps, notes and events, by time
  std::vector<TimelineGap> m_gaps;
};

}  // namespace deckpipe
