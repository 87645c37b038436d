// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/role_index.h"

#include <algorithm>
#include <utility>

namespace deckpipe {

void RoleIndex::take(RoleWalk& walk, const Change& change) const {
  switch (change.kind) {
    case Change::Kind::Time: walk.timeCame(change.time); break;
    case Change::Kind::Note: teach(walk, change.said, change.time); break;
    case Change::Kind::Frame: walk.next(m_frames[change.frame], change.time); break;
  }
}

// Only the worker builds, so that nothing but invalidating can come between the two locks.
bool RoleIndex::build(std::uint64_t atMost) {
  const std::uint64_t count = m_frames.count();
  std::unique_lock lock(m_lock);
  if (m_built >= count) return false;
  const std::uint64_t begin = m_built, end = std::min(count, begin + atMost), generation = m_generation;
  const std::size_t before = m_changes.size();
  RoleWalk walk = m_end;
  lock.unlock();

  const std::vector<Note> notes = m_notes.between(begin, end);
  std::vector<Change> changes;
  std::vector<RoleWalk> kept;
  const auto record = [&](const Change& change) {
    changes.push_back(change);
    if ((before + changes.size()) % kKeepEvery == 0) kept.push_back(walk);
  };
  LogTimes times(m_frames);
  std::size_t nextNote = 0;
  for (std::uint64_t i = begin; i < end;) {
    for (const Frame& frame : m_frames.run(i)) {
      if (i == end) break;
      for (; nextNote < notes.size() && notes[nextNote].frame <= i; ++nextNote) {
        const Note& note = notes[nextNote];
        const std::optional<RoleNote> said = roleNoteOf(note.value);
        if (!said) continue;
        if (walk.timeCame(note.time)) record({i, note.time, Change::Kind::Time, {}});
        const Change change{i, note.time, Change::Kind::Note, *said};
        take(walk, change);
        record(change);
      }
      const Instant time = times.at(i);
      if (walk.timeCame(time)) record({i, time, Change::Kind::Time, {}});
      walk.next(frame, time);
      if (walk.learned()) record({i, time, Change::Kind::Frame, {}});
      ++i;
    }
  }

  lock.lock();
  if (m_generation != generation) return true;  // once more, from where it is now
  m_changes.insert(m_changes.end(), changes.begin(), changes.end());
  m_kept.insert(m_kept.end(), kept.begin(), kept.end());
  m_end = std::move(walk);
  m_built = end;
  return true;
}

std::uint64_t RoleIndex::built() const {
  const std::lock_guard lock(m_lock);
  return m_built;
}

std::size_t RoleIndex::changesBefore(std::uint64_t i) const {
  const auto end = std::partition_point(m_changes.begin(), m_changes.end(), [i](const Change& change) {
    return change.frame < i || (change.frame == i && change.kind != Change::Kind::Frame);
  });
  return static_cast<std::size_t>(end - m_changes.begin());
}

std::size_t RoleIndex::changesAfter(std::uint64_t i) const {
  const auto end = std::ranges::partition_point(m_changes, [i](const Change& c) { return c.frame <= i; });
  return static_cast<std::size_t>(end - m_changes.begin());
}

// From where it stands, or from the copy before, if that is nearer.
void RoleIndex::walkTo(std::size_t changes, Stand& stand) const {
  const std::size_t kept = changes / kKeepEvery;
  if (stand.generation != m_generation || stand.changes > changes || stand.changes < kept * kKeepEvery)
    stand = {kept == 0 ? RoleWalk() : m_kept[kept - 1], kept * kKeepEvery, m_generation};
  for (; stand.changes < changes; ++stand.changes) take(stand.walk, m_changes[stand.changes]);
}

RoleWalk RoleIndex::walk(std::uint64_t i) const {
  const std::lock_guard lock(m_lock);
  const std::size_t changes = changesBefore(i);
  if (changes == m_changes.size()) return m_end;
  Stand stand;
  walkTo(changes, stand);
  return stand.walk;
}

Classified RoleIndex::classify(std::uint64_t i, const Frame& frame, Instant time, Stand& stand) const {
  const std::lock_guard lock(m_lock);
  walkTo(changesBefore(i), stand);
  return stand.walk.peek(frame, time);
}

const AddressBook& RoleIndex::bookBefore(std::uint64_t i, Channel channel, Stand& stand) const {
  const std::lock_guard lock(m_lock);
  walkTo(changesBefore(i), stand);
  return stand.walk.book(channel);
}

const AddressBook& RoleIndex::bookAfter(std::uint64_t i, Channel channel, Stand& stand) const {
  const std::lock_guard lock(m_lock);
  walkTo(changesAfter(i), stand);
  return stand.walk.book(channel);
}

void RoleIndex::invalidateAfter(std::uint64_t frame) {
  const std::lock_guard lock(m_lock);
  ++m_generation;
  if (m_built <= frame) return;
  std::erase_if(m_changes, [frame](const Change& change) { return change.frame >= frame; });
  m_kept.resize(m_changes.size() / kKeepEvery);
  m_end = m_kept.empty() ? RoleWalk() : m_kept.back();
  for (std::size_t k = m_kept.size() * kKeepEvery; k < m_changes.size(); ++k) take(m_end, m_changes[k]);
  m_built = frame;
}

}  // namespace deckpipe
