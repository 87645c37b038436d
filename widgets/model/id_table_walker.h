// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the table of identifiers at a cursor on a thread of its own. It keeps a copy of the table every
// kEvery frames it passes, so that a cursor that goes back, or jumps, costs the walk from the copy before it:
// a few milliseconds, wherever in a log. The model asks on its tick and takes what is there.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "base/latest_request_worker.h"
#include "model/frame_test.h"
#include "model/id_table.h"
#include "state/log_view.h"

namespace deckpipe {

class IdTableWalker {
 public:
  static constexpr std::uint64_t kEvery = 131'072;

  explicit IdTableWalker(std::shared_ptr<const LogDocument> log, const TraceFilter& filter = {});

  // The table behind so many frames is wanted; the newest intent wins.
  void request(std::uint64_t frames);
  // The last table that was reached; never null.
  std::shared_ptr<const IdTable> latest() const { return m_worker.latest(); }

 private:
  // A table and the test that stands behind the same frame.
  struct Stand {
    IdTable table;
    std::optional<FrameTest> test;
  };
  using Worker = LatestRequestWorker<std::uint64_t, IdTable>;
  Stand begin() const;
  // Where the walk to `wanted` frames is shortest: where the table stands, or the nearest copy.
  void goToNearest(std::uint64_t wanted);
  void walk(std::uint64_t wanted, const Worker::Turn& turn);

  const std::shared_ptr<const LogDocument> m_log;
  const TraceFilter m_filter;
  std::pair<std::uint64_t, std::size_t> m_asked;  // frames, and notes where the filter needs them
  // The worker's own:
  Stand m_now;
  std::size_t m_notes = 0;  // of the log, that m_now knows
  std::map<std::uint64_t, std::shared_ptr<const Stand>> m_kept;
  Worker m_worker;  // last: it uses all of the above
};

}  // namespace deckpipe
