// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/id_table.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "bus/j1939.h"
#include "model/frame_test.h"

namespace deckpipe {

// Channel, type byte of EF00 where there is one, identifier with its bits for extended, remote and error.
std::uint64_t IdTable::keyOf(const Frame& frame) {
  std::uint64_t key = frame.id | static_cast<std::uint64_t>(frame.channel) << 32;
  if (frame.isExtended() && !frame.isError() && !frame.isRemote() && frame.length > 0 &&
      J1939Id::of(frame.identifier()).pgn == pgn::kProprietaryA)
    key |= (std::uint64_t{0x100} | frame.data[0]) << 40;
  return key;
}

IdRow* IdTable::rowOf(std::uint64_t key) {
  constexpr std::size_t kSlots = 4 * kMax;
  if (m_slots.empty()) m_slots.resize(kSlots);
  std::size_t at = key * 0x9E37'79B9'7F4A'7C15 >> 51;
  static_assert(kSlots == std::size_t{1} << 13);
  for (;; at = (at + 1) % kSlots) {
    if (m_slots[at] == 0) break;
    IdRow& row = m_rows[m_slots[at] - 1u];
    if (row.key == key) return &row;
  }
  if (m_rows.size() == kMax) return nullptr;
  m_rows.push_back({.key = key});
  m_slots[at] = static_cast<std::uint16_t>(m_rows.size());
  return &m_rows.back();
}

void IdTable::walk(const FrameStore& frames, std::uint64_t end, FrameTest* test) {
  end = std::min(end, frames.count());
  LogTimes times(frames);
  for (; m_frames < end; ++m_frames) {
    const Frame& frame = frames[m_frames];
    const Instant now = times.at(m_frames);
    if (test != nullptr && !test->passes(m_frames, now)) continue;
    ++m_passed;
    IdRow* row = rowOf(keyOf(frame));
    if (row == nullptr) {
      ++m_others;
      continue;
    }
    if (row->count == 0) {
      row->begin = now;
    } else {
      const Frame& before = frames[row->lastFrame];
      row->before = before.data;
      row->lengthBefore = before.length;
      const Duration gap = now - row->last;
      const bool isPause = gap > 1s && row->periods > 0 && gap / kPause > *row->period();
      if (isPause) {
        row->begin = now;
        row->periods = 0;
        row->shortest = Duration::max();
        row->longest = Duration(0);
      } else {
        ++row->periods;
        row->shortest = std::min(row->shortest, gap);
        row->longest = std::max(row->longest, gap);
      }
    }
    ++row->count;
    row->last = now;
    row->lastFrame = m_frames;
  }
}

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
