// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/id_table_walker.h"

#include <algorithm>
#include <utility>

namespace deckpipe {

IdTableWalker::IdTableWalker(std::shared_ptr<const LogDocument> log, const TraceFilter& filter)
    : m_log(std::move(log)),
      m_filter(filter),
      m_latest(std::make_shared<const IdTable>()),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

IdTableWalker::~IdTableWalker() = default;

void IdTableWalker::request(std::uint64_t frames) {
  {
    const std::lock_guard lock(m_lock);
    const bool isCurrent = !m_filter.needsRoles() || m_notes == m_log->notes.count();
    if (m_latest->frames() == frames && isCurrent && !m_request) return;
    m_request = frames;
  }
  m_wake.notify_one();
}

std::shared_ptr<const IdTable> IdTableWalker::latest() const {
  const std::lock_guard lock(m_lock);
  return m_latest;
}

bool IdTableWalker::isSuperseded() const {
  const std::lock_guard lock(m_lock);
  return m_request.has_value();
}

IdTableWalker::Stand IdTableWalker::begin() const {
  Stand stand;
  if (!m_filter.isEmpty()) stand.test.emplace(m_log, m_filter);
  return stand;
}

void IdTableWalker::run(const std::stop_token& stop) {
  Stand now = begin();
  while (!stop.stop_requested()) {
    std::uint64_t wanted = 0;
    {
      std::unique_lock lock(m_lock);
      if (!m_wake.wait(lock, stop, [this] { return m_request.has_value(); })) return;
      wanted = std::min(*std::exchange(m_request, std::nullopt), m_log->frames.count());
      if (m_filter.needsRoles() && isPastChanged(*m_log, m_notes, m_log->frames.count())) {
        m_kept.clear();
        now = begin();
      }
    }
    // From the nearest copy, unless the table stands nearer already.
    const auto after = m_kept.upper_bound(wanted);
    const auto* kept = after == m_kept.begin() ? nullptr : std::prev(after)->second.get();
    if (now.table.frames() > wanted || (kept != nullptr && kept->table.frames() > now.table.frames()))
      now = kept != nullptr ? *kept : begin();
    if (now.test) now.test->bind();
    // A far way is left for a newer wish; what was walked of it is kept.
    while (now.table.frames() < wanted && !stop.stop_requested() && !isSuperseded()) {
      const std::uint64_t next = (now.table.frames() / kEvery + 1) * kEvery;
      now.table.walk(m_log->frames, std::min(wanted, next), now.test ? &*now.test : nullptr);
      if (now.table.frames() == next && !m_kept.contains(next))
        m_kept.emplace(next, std::make_shared<const Stand>(now));
    }
    auto reached = std::make_shared<const IdTable>(now.table);
    const std::lock_guard lock(m_lock);
    if (now.table.frames() == wanted || reached->frames() > m_latest->frames()) m_latest = std::move(reached);
  }
}

}  // namespace deckpipe
