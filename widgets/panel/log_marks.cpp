// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/log_marks.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "model/event_text.h"

namespace deckpipe {
namespace {

struct LogMarksText {
  Q_DECLARE_TR_FUNCTIONS(LogMarks)
};

}  // namespace

bool LogMarks::take(const LogView& view, int bins) {
  if (view.document != m_log) {
    *this = {};
    m_log = view.document;
  }
  if (!m_log || view.frameCount == 0) return true;
  takeDensity(view, bins);
  const std::size_t jumps = m_jumps.size();
  const bool isDone = takeJumps(view);
  const bool isNoted = takeNotes(view);
  if (isNoted || m_jumps.size() != jumps) {
    m_marks = m_jumps;
    m_marks.insert(m_marks.end(), m_notes.begin(), m_notes.end());
    std::stable_sort(m_marks.begin(), m_marks.end(),
                     [](const TimelineMark& a, const TimelineMark& b) { return a.time < b.time; });
  }
  return isDone;
}

// Counted exactly, a look-up a bin; anew only once the span has grown by more than can be seen.
void LogMarks::takeDensity(const LogView& view, int bins) {
  bins = std::max(bins, 1);
  const double span = static_cast<double>(view.end.ns) - static_cast<double>(view.begin.ns);
  const double grown = std::abs(static_cast<double>(view.end.ns) - static_cast<double>(m_end.ns));
  const auto wanted = static_cast<std::size_t>(bins);
  if (m_density.size() == wanted && view.begin == m_begin && grown * bins <= span) return;
  m_begin = view.begin;
  m_end = view.end;
  const FrameStore& frames = m_log->frames;
  std::vector<std::uint64_t> counts(wanted);
  std::uint64_t before = 0, most = 1;
  for (int i = 0; i < bins; ++i) {
    const Instant edge{view.begin.ns + std::llround(span / bins * (i + 1))};
    const std::uint64_t until =
        i + 1 == bins ? view.frameCount : std::min(view.frameCount, frames.firstAtOrAfter(edge));
    counts[static_cast<std::size_t>(i)] = until - std::min(before, until);
    most = std::max(most, counts[static_cast<std::size_t>(i)]);
    before = until;
  }
  m_density.resize(wanted);
  // By the root, so that what is rare can be seen beside what is busy.
  std::transform(counts.begin(), counts.end(), m_density.begin(), [most](std::uint64_t n) {
    return static_cast<float>(std::sqrt(static_cast<double>(n) / static_cast<double>(most)));
  });
}

bool LogMarks::takeJumps(const LogView& view) {
  const FrameStore& frames = m_log->frames;
  const std::uint64_t count = std::min(view.frameCount, frames.count());
  const std::uint64_t end = std::min(count, m_looked + kFramesAtOnce);
  while (m_looked < end) {
    for (const Frame& frame : frames.run(m_looked)) {
      if (m_looked == end) break;
      if ((frame.flags & Frame::kTimeJump) != 0 && m_jumps.size() < kMostJumps) {
        m_jumps.push_back({TimelineMark::Kind::TimeJump, frames.timeAt(m_looked),
                           LogMarksText::tr("The clock jumps here")});
      }
      ++m_looked;
    }
  }
  return m_looked == count;
}

bool LogMarks::takeNotes(const LogView& view) {
  if (view.document->notes.count() == m_notesTaken) return false;
  const std::vector<Note> notes = m_log->notes.all();
  m_notesTaken = notes.size();
  m_notes.clear();
  for (const Note& note : notes) {
    const bool isLoss = note.kind == NoteKind::LinkDown || note.kind == NoteKind::Dropped;
    m_notes.push_back(
        {isLoss ? TimelineMark::Kind::Attend : TimelineMark::Kind::Note, note.time, noteText(*m_log, note)});
  }
  return true;
}

}  // namespace deckpipe
