// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/trace_sieve.h"

#include <algorithm>
#include <utility>

namespace deckpipe {

TraceSieve::TraceSieve(std::shared_ptr<const LogDocument> log, TraceFilter filter)
    : m_log(std::move(log)),
      m_filter(std::move(filter)),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

TraceSieve::~TraceSieve() = default;

void TraceSieve::wake() {
  {
    const std::lock_guard lock(m_lock);
    m_isWoken = true;
  }
  m_wake.notify_one();
}

void TraceSieve::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(m_lock);
      if (!m_wake.wait(lock, stop, [this] { return m_isWoken; })) return;
      m_isWoken = false;
    }
    scan(stop);
  }
}

void TraceSieve::scan(const std::stop_token& stop) {
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
  while (!stop.stop_requested()) {
    const auto run = frames.run(at);
    if (run.empty()) return;
    matches.clear();
    for (const Frame& frame : run) {
      if (at % 4096 == 0 && stop.stop_requested()) return;
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
