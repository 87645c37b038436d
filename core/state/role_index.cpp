// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/role_index.h"

#include <algorithm>

namespace deckpipe {

void RoleIndex::take(RoleWalk& walk, const Change& change) const {
  if (change.isNote) {
    walk.sayDrive(change.channel, change.address, change.isDrive);
  } else {
    walk.next(m_frames[change.frame], m_frames.timeAt(change.frame));
  }
}

void RoleIndex::record(const Change& change) {
  m_changes.push_back(change);
  if (m_changes.size() % kKeepEvery == 0) m_kept.push_back(m_end);
}

bool RoleIndex::build(std::uint64_t atMost) {
  const std::uint64_t count = m_frames.count();
  const std::lock_guard lock(m_lock);
  if (m_built >= count) return false;
  const std::uint64_t end = std::min(count, m_built + atMost);
  std::vector<Note> notes = m_notes.between(m_built, end);
  std::erase_if(notes, [](const Note& note) {
    return note.kind != NoteKind::DriveSaid && note.kind != NoteKind::DriveUnsaid;
  });
  LogTimes times(m_frames);
  std::size_t nextNote = 0;
  for (std::uint64_t i = m_built; i < end;) {
    for (const Frame& frame : m_frames.run(i)) {
      if (i == end) break;
      for (; nextNote < notes.size() && notes[nextNote].frame <= i; ++nextNote) {
        const Note& note = notes[nextNote];
        const Change change{i, true, note.kind == NoteKind::DriveSaid, note.channel, note.address};
        take(m_end, change);
        record(change);
      }
      m_end.next(frame, times.at(i));
      if (m_end.learned()) record({i, false, false, {}, {}});
      ++i;
    }
  }
  m_built = end;
  return true;
}

std::uint64_t RoleIndex::built() const {
  const std::lock_guard lock(m_lock);
  return m_built;
}

RoleWalk RoleIndex::walk(std::uint64_t i) const {
  const std::lock_guard lock(m_lock);
  // Changes that happened before frame i: its own notes did, its own lesson did not.
  const auto end = std::partition_point(m_changes.begin(), m_changes.end(), [i](const Change& change) {
    return change.frame < i || (change.frame == i && change.isNote);
  });
  if (end == m_changes.end()) return m_end;
  const auto before = static_cast<std::size_t>(end - m_changes.begin());
  const std::size_t kept = before / kKeepEvery;
  RoleWalk walk = kept == 0 ? RoleWalk() : m_kept[kept - 1];
  for (std::size_t k = kept * kKeepEvery; k < before; ++k) take(walk, m_changes[k]);
  return walk;
}

void RoleIndex::invalidateAfter(std::uint64_t frame) {
  const std::lock_guard lock(m_lock);
  if (m_built <= frame) return;
  std::erase_if(m_changes, [frame](const Change& change) { return change.frame >= frame; });
  m_kept.resize(m_changes.size() / kKeepEvery);
  m_end = m_kept.empty() ? RoleWalk() : m_kept.back();
  for (std::size_t k = m_kept.size() * kKeepEvery; k < m_changes.size(); ++k) take(m_end, m_changes[k]);
  m_built = frame;
}

}  // namespace deckpipe
