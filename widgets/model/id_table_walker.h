// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the table of identifiers at a cursor on a thread of its own. It keeps a copy of the table every
// kEvery frames it passes, so that a cursor that goes back, or jumps, costs the walk from the copy before it:
// a few milliseconds, wherever in a log. The model asks on its tick and takes what is there.
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "model/frame_test.h"
#include "model/id_table.h"
#include "state/log_view.h"

namespace deckpipe {

class IdTableWalker {
 public:
  static constexpr std::uint64_t kEvery = 131'072;

  explicit IdTableWalker(std::shared_ptr<const LogDocument> log, const TraceFilter& filter = {});
  ~IdTableWalker();
  IdTableWalker(const IdTableWalker&) = delete;
  IdTableWalker& operator=(const IdTableWalker&) = delete;

  // The table behind so many frames is wanted; the newest wish wins.
  void request(std::uint64_t frames);
  // The last table that was reached; never null.
  std::shared_ptr<const IdTable> latest() const;

 private:
  // A table and the test that stands behind the same frame.
  struct Stand {
    IdTable table;
    std::optional<FrameTest> test;
  };
  Stand begin() const;
  void run(const std::stop_token& stop);
  bool isSuperseded() const;

  const std::shared_ptr<const LogDocument> m_log;
  const TraceFilter m_filter;
  mutable std::mutex m_lock;
  std::condition_variable_any m_wake;
  std::optional<std::uint64_t> m_request;
  std::shared_ptr<const IdTable> m_latest;
  std::size_t m_notes = 0;                                       // of the log, that the filter knows
  std::map<std::uint64_t, std::shared_ptr<const Stand>> m_kept;  // the worker's own
  std::jthread m_thread;                                         // last: it uses all of the above
};

}  // namespace deckpipe
