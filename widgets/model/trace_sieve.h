// SPDX-License-Identifier: GPL-3.0-or-later
// Looks through a log for the frames that a filter lets through, on a thread of its own: first matches are
// there at once, and a log that grows is looked through as it grows. Made by the trace's model for each
// filter; destroying it gives up what is not looked at yet.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "model/log_walk.h"
#include "model/matched_rows.h"
#include "model/trace_filter.h"
#include "state/log_view.h"

namespace deckpipe {

class TraceSieve {
 public:
  TraceSieve(std::shared_ptr<const LogDocument> log, TraceFilter filter);
  ~TraceSieve();
  TraceSieve(const TraceSieve&) = delete;
  TraceSieve& operator=(const TraceSieve&) = delete;

  // The log may have grown, or notes in its past may have changed what frames are.
  void wake();
  const MatchedRows& rows() const { return m_rows; }

 private:
  void run(const std::stop_token& stop);
  void scan(const std::stop_token& stop);

  const std::shared_ptr<const LogDocument> m_log;
  TraceFilter m_filter;
  MatchedRows m_rows;
  // From the first frame on, never by the index of roles, which may be built later than frames come.
  std::optional<LogWalk> m_walk;
  std::size_t m_notes = 0;  // of the log, when its roles were last looked up
  std::mutex m_lock;
  std::condition_variable_any m_wake;
  bool m_isWoken = true;
  std::jthread m_thread;  // last: it uses all of the above
};

}  // namespace deckpipe
