// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/trace_rows.h"

#include "model/message_text.h"

namespace deckpipe {
namespace {

// Classifies frames from one on. The index knows the roles before the first, notes behind it are taken here.
class Walk {
 public:
  Walk(const LogDocument& log, std::uint64_t first, std::size_t count)
      : m_log(log),
        m_walk(log.roles.walk(first)),
        m_notes(log.notes.between(first + 1, first + count)),
        m_times(log.frames) {}

  Classified next(std::uint64_t index, Instant time) {
    for (; m_nextNote < m_notes.size() && m_notes[m_nextNote].frame <= index; ++m_nextNote) {
      const Note& note = m_notes[m_nextNote];
      if (note.kind == NoteKind::DriveSaid || note.kind == NoteKind::DriveUnsaid)
        m_walk.sayDrive(note.channel, note.address, note.kind == NoteKind::DriveSaid);
    }
    return m_walk.next(m_log.frames[index], time);
  }
  Instant time(std::uint64_t index) { return m_times.at(index); }

 private:
  const LogDocument& m_log;
  RoleWalk m_walk;
  std::vector<Note> m_notes;
  std::size_t m_nextNote = 0;
  LogTimes m_times;
};

}  // namespace

std::vector<TraceRow> readTraceRows(const LogDocument& log, std::uint64_t first, std::size_t count,
                                    std::span<const TraceRow> known) {
  std::vector<TraceRow> rows;
  if (count == 0) return rows;
  rows.reserve(count);
  Walk walk(log, first, count);
  std::optional<Instant> before;
  if (first > 0) before = walk.time(first - 1);
  for (std::uint64_t i = first; i < first + count; ++i) {
    TraceRow row;
    row.index = i;
    row.frame = log.frames[i];
    const Instant time = walk.time(i);
    if (before) row.delta = time - *before;
    before = time;
    row.what = walk.next(i, time);
    const TraceRow* old = nullptr;
    if (!known.empty() && i >= known.front().index && i - known.front().index < known.size())
      old = &known[i - known.front().index];
    if (old != nullptr && old->what == row.what) {
      row.title = old->title;
      row.summary = old->summary;
    } else {
      row.title = frameTitle(row.frame, row.what);
      row.summary = summaryText(row.frame, row.what);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Classified classifyAt(const LogDocument& log, std::uint64_t index) {
  Walk walk(log, index, 1);
  return walk.next(index, walk.time(index));
}

}  // namespace deckpipe
