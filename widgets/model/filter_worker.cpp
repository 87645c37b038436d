// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/filter_worker.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace deckpipe {
namespace {

constexpr std::size_t kAtOnce = 4096;  // frames between two glances at whether it shall go on

}  // namespace

FilterWorker::FilterWorker(std::shared_ptr<const LogDocument> log, TraceFilter filter)
    : m_log(std::move(log)),
      m_filter(std::move(filter)),
      m_worker([this](LookOn, const Worker::Turn& turn) { scan(turn); }) {
  wake();
}

void FilterWorker::scan(const Worker::Turn& turn) {
  if (m_filter.needsRoles() && isPastChanged(*m_log, m_notes, m_rows.scanned())) {
    m_rows.clear();
    m_walk.reset();
  }
  const FrameStore& frames = m_log->frames;
  m_filter.bind(frames);
  LogTimes times(frames);
  std::vector<std::uint16_t> matches;
  std::uint64_t at = m_rows.scanned();
  if (m_filter.needsRoles() && !m_walk) m_walk.emplace(*m_log, at);
  while (!turn.isGivenUp()) {
    const auto run = frames.run(at);
    if (run.empty()) return;
    matches.clear();
    for (const Frame& frame : run.first(std::min(run.size(), kAtOnce))) {
      const Instant time = times.at(at);
      const Classified what = m_walk ? m_walk->take(frame, time) : Classified{};
      if (m_filter.matches({frame, at, time, what}))
        matches.push_back(static_cast<std::uint16_t>(at % MatchedRows::kBlock));
      ++at;
    }
    m_rows.append(matches, at);
  }
}

}  // namespace deckpipe
