// SPDX-License-Identifier: GPL-3.0-or-later
// Classifies the frames of a log from one on, with the roles that hold at each: what the index knows before
// the first, then what frames and notes teach. For the trace's rows, its filter and its search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "state/log_view.h"
#include "state/role_notes.h"

namespace deckpipe {

// Whether more notes are there than were `seen`, and any says that a drive is, or is not, at an address: what
// frames before `end` are must be looked up again.
inline bool isPastChanged(const LogDocument& log, std::size_t& seen, std::uint64_t end) {
  const std::size_t notes = log.notes.count();
  if (notes == std::exchange(seen, notes)) return false;
  const std::vector<Note> past = log.notes.between(0, end);
  return std::any_of(past.begin(), past.end(),
                     [](const Note& note) { return std::holds_alternative<note::DriveSaid>(note.value); });
}

class LogWalk {
 public:
  // Stands before frame `first`.
  LogWalk(const LogDocument& log, std::uint64_t first)
      : m_log(&log), m_walk(log.roles.walk(first)), m_next(first), m_noted(first + 1) {}

  std::uint64_t next() const { return m_next; }
  // What frame next() is; `time` its log time. Notes are looked up for some frames at once.
  Classified take(const Frame& frame, Instant time) {
    if (m_next >= m_noted) fetchNotes();
    for (; m_nextNote < m_notes.size() && m_notes[m_nextNote].frame <= m_next; ++m_nextNote)
      teach(m_walk, m_notes[m_nextNote]);
    ++m_next;
    return m_walk.next(frame, time);
  }

 private:
  static constexpr std::uint64_t kNotesOf = 4096;

  void fetchNotes() {
    // Notes of frames that are still to come may still come as well.
    const std::uint64_t end = std::max(m_next + 1, std::min(m_next + kNotesOf, m_log->frames.count()));
    m_notes = m_log->notes.between(m_noted, end);
    m_nextNote = 0;
    m_noted = end;
  }

  const LogDocument* m_log;
  RoleWalk m_walk;
  std::uint64_t m_next;
  std::uint64_t m_noted;  // notes of frames below are in the walk or in m_notes
  std::vector<Note> m_notes;
  std::size_t m_nextNote = 0;
};

}  // namespace deckpipe
