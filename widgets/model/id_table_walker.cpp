// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/id_table_walker.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace deckpipe {

IdTableWalker::IdTableWalker(std::shared_ptr<const LogDocument> log, const TraceFilter& filter)
    : m_log(std::move(log)),
      m_filter(filter),
      m_now(begin()),
      m_worker([this](std::uint64_t wanted, const Worker::Turn& turn) { walk(wanted, turn); },
               std::make_shared<const IdTable>()) {}

void IdTableWalker::request(std::uint64_t frames) {
  const std::pair asked(frames, m_filter.needsRoles() ? m_log->notes.count() : 0);
  if (std::exchange(m_asked, asked) != asked || latest()->frames() != frames) m_worker.request(frames);
}

IdTableWalker::Stand IdTableWalker::begin() const {
  Stand stand;
  if (!m_filter.isEmpty()) stand.test.emplace(m_log, m_filter);
  return stand;
}

void IdTableWalker::goToNearest(std::uint64_t wanted) {
  const auto after = m_kept.upper_bound(wanted);
  const auto* kept = after == m_kept.begin() ? nullptr : std::prev(after)->second.get();
  if (m_now.table.frames() > wanted || (kept != nullptr && kept->table.frames() > m_now.table.frames()))
    m_now = kept != nullptr ? *kept : begin();
}

void IdTableWalker::walk(std::uint64_t wanted, const Worker::Turn& turn) {
  wanted = std::min(wanted, m_log->frames.count());
  if (m_filter.needsRoles() && isPastChanged(*m_log, m_notes, m_log->frames.count())) {
    m_kept.clear();
    m_now = begin();
  }
  goToNearest(wanted);
  if (m_now.test) m_now.test->bind();
  // A far way is left for a newer intent; what was walked of it is kept.
  while (m_now.table.frames() < wanted && !turn.isGivenUp()) {
    const std::uint64_t next = (m_now.table.frames() / kEvery + 1) * kEvery;
    m_now.table.walk(m_log->frames, std::min(wanted, next), m_now.test ? &*m_now.test : nullptr);
    if (m_now.table.frames() == next && !m_kept.contains(next))
      m_kept.emplace(next, std::make_shared<const Stand>(m_now));
  }
  if (m_now.table.frames() == wanted || m_now.table.frames() > latest()->frames())
    turn.handOver(std::make_shared<const IdTable>(m_now.table));
}

}  // namespace deckpipe
