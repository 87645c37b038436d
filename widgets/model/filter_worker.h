// SPDX-License-Identifier: GPL-3.0-or-later
// Looks through a log for the frames that a filter lets through, on a thread of its own: first matches are
// there at once, and a log that grows is looked through as it grows. Made by the trace's model for each
// filter; destroying it gives up what is not looked at yet.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "base/latest_request_worker.h"
#include "model/log_walk.h"
#include "model/trace_filter.h"
#include "state/log_view.h"

namespace deckpipe {

// The frames of a log that a filter lets through, in order: two bytes each, for every 65,536 frames have a
// list of their own. One worker appends, the window reads meanwhile.
class MatchedRows {
 public:
  static constexpr std::uint64_t kBlock = 65'536;

  // Frames [scanned(), end) were looked at; `matches` of them, less the begin of their block, passed. All of
  // them lie in one block.
  void append(std::span<const std::uint16_t> matches, std::uint64_t end) {
    const std::lock_guard lock(m_lock);
    const auto block = static_cast<std::size_t>(m_scanned / kBlock);
    if (m_blocks.size() <= block) m_blocks.resize(block + 1, {{}, m_rows});
    auto& frames = m_blocks[block].frames;
    frames.insert(frames.end(), matches.begin(), matches.end());
    m_rows += matches.size();
    m_scanned = end;
  }
  void clear() {
    const std::lock_guard lock(m_lock);
    m_blocks.clear();
    m_rows = m_scanned = 0;
  }

  std::uint64_t rows() const {
    const std::lock_guard lock(m_lock);
    return m_rows;
  }
  std::uint64_t scanned() const {
    const std::lock_guard lock(m_lock);
    return m_scanned;
  }
  // How many rows stand before this frame; the frame's own row where it is one.
  std::uint64_t rowOf(std::uint64_t frame) const {
    const std::lock_guard lock(m_lock);
    const auto block = static_cast<std::size_t>(frame / kBlock);
    if (block >= m_blocks.size()) return m_rows;
    const auto& frames = m_blocks[block].frames;
    const auto at = std::lower_bound(frames.begin(), frames.end(), frame % kBlock);
    return m_blocks[block].before + static_cast<std::uint64_t>(at - frames.begin());
  }
  // The frames of rows [first, first + count), fewer where there are not so many.
  std::vector<std::uint64_t> frames(std::uint64_t first, std::size_t count) const {
    std::vector<std::uint64_t> found;
    const std::lock_guard lock(m_lock);
    if (first >= m_rows) return found;
    count = static_cast<std::size_t>(std::min<std::uint64_t>(count, m_rows - first));
    found.reserve(count);
    auto block = std::upper_bound(m_blocks.begin(), m_blocks.end(), first,
                                  [](std::uint64_t row, const Block& b) { return row < b.before; }) -
                 1;
    auto at = static_cast<std::size_t>(first - block->before);
    while (found.size() < count) {
      if (at == block->frames.size()) {
        ++block;
        at = 0;
        continue;
      }
      const auto begin = static_cast<std::uint64_t>(block - m_blocks.begin()) * kBlock;
      found.push_back(begin + block->frames[at++]);
    }
    return found;
  }

 private:
  struct Block {
    std::vector<std::uint16_t> frames;
    std::uint64_t before = 0;  // rows in the blocks before
  };
  mutable std::mutex m_lock;
  std::vector<Block> m_blocks;
  std::uint64_t m_rows = 0;
  std::uint64_t m_scanned = 0;
};

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
