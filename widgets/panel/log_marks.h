// SPDX-License-Identifier: GPL-3.0-or-later
// What the timeline shows of a log beside the cursor: how dense it is, where its clock jumped, what was
// noted. Held by the transport bar and brought up to date with each view, a bounded piece of work at a time,
// so that a log of any size costs the window nothing that can be felt.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "paint/timeline.h"
#include "state/log_view.h"

namespace deckpipe {

class LogMarks {
 public:
  // A look at so many frames takes about a millisecond.
  static constexpr std::uint64_t kFramesAtOnce = 250'000;
  // No strip has room for more.
  static constexpr std::size_t kMostJumps = 2'000;

  // `bins`: equal parts of the span, about one every few pixels. False while frames remain to be looked at
  // for jumps: come again soon.
  bool take(const LogView& view, int bins);

  const std::vector<float>& density() const { return m_density; }
  const std::vector<TimelineMark>& marks() const { return m_marks; }

 private:
  void takeDensity(const LogView& view, int bins);
  bool takeJumps(const LogView& view);
  bool takeNotes(const LogView& view);

  std::shared_ptr<const LogDocument> m_log;
  Instant m_begin, m_end;  // of the density
  std::vector<float> m_density;
  std::uint64_t m_looked = 0;  // frames looked at for jumps
  std::vector<TimelineMark> m_jumps;
  std::size_t m_notesTaken = 0;
  std::vector<TimelineMark> m_notes;
  std::vector<TimelineMark> m_marks;  // both, by time
};

}  // namespace deckpipe
