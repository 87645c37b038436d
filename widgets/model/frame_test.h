// SPDX-License-Identifier: GPL-3.0-or-later
// Whether frames of a log pass a filter, asked one after another from the log's first on: for the traffic by
// identifier, and for a saving of the trace. Copyable, so that a walk can go on from a copy of it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "model/log_walk.h"
#include "model/trace_filter.h"
#include "state/log_view.h"

namespace deckpipe {

class FrameTest {
 public:
  FrameTest(std::shared_ptr<const LogDocument> log, const TraceFilter& filter);

  // The log may have further channels now.
  void bind() { m_filter.bind(m_log->frames); }
  // Meanings come from the frames and notes themselves, as in the trace's sieve; `time` is log time.
  bool passes(std::uint64_t index, Instant time);

 private:
  std::shared_ptr<const LogDocument> m_log;
  TraceFilter m_filter;
  std::optional<LogWalk> m_walk;
};

// The same as a function that asks for the times itself; empty where everything passes.
std::function<bool(std::uint64_t frame)> frameTest(std::shared_ptr<const LogDocument> log,
                                                   const TraceFilter& filter);

}  // namespace deckpipe
