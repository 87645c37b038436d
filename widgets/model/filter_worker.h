// SPDX-License-Identifier: GPL-3.0-or-later
// Looks through a log for the frames that a filter lets through, on a thread of its own: first matches are
// there at once, and a log that grows is looked through as it grows. Made by the trace's model for each
// filter; destroying it gives up what is not looked at yet.
#pragma once

#include <memory>
#include <optional>

#include "base/latest_request_worker.h"
#include "model/log_walk.h"
#include "model/matched_rows.h"
#include "model/trace_filter.h"
#include "state/log_view.h"

namespace deckpipe {

class FilterWorker {
 public:
  FilterWorker(std::shared_ptr<const LogDocument> log, TraceFilter filter);

  // The log may have grown, or notes in its past may have changed what frames are.
  void wake() { m_worker.request({}); }
  const MatchedRows& rows() const { return m_rows; }

 private:
  struct LookOn {};  // from the first frame that was not looked at
  using Worker = LatestRequestWorker<LookOn>;
  void scan(const Worker::Turn& turn);

  const std::shared_ptr<const LogDocument> m_log;
  TraceFilter m_filter;
  MatchedRows m_rows;
  // From the first frame on, never by the index of roles, which may be built later than frames come.
  std::optional<LogWalk> m_walk;
  std::size_t m_notes = 0;  // of the log, when its roles were last looked up
  Worker m_worker;          // last: it uses all of the above
};

}  // namespace deckpipe
