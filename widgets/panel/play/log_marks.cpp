// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/play/log_marks.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "log/link_gaps.h"
#include "model/event_text.h"
#include "panel/play/log_scale.h"

namespace deckpipe {
namespace {

struct LogMarksText {
  Q_DECLARE_TR_FUNCTIONS(LogMarks)
};

// "Roof monitor: Stowed"
QString named(const DeviceKey& device, const QString& text, const DeviceLabels& labels) {
  const QString name = deviceNameText(device, labels);
  return name.isEmpty() ? text : LogMarksText::tr("%1: %2").arg(name, text);
}

}  // namespace

void LogMarks::take(const LogView& view, TimelineSpan shown, int bins) {
  if (view.document != m_log || view.hasTimes() != m_hasTimes) {
    const DeviceLabels labels = m_labels;
    *this = {};
    m_labels = labels;
    m_log = view.document;
    m_hasTimes = view.hasTimes();
  }
  if (!m_log || view.frameCount == 0) return;
  const bool isCounted = takeDensity(view, shown, bins);
  const bool isJumped = takeJumps(view);
  const bool isNoted = takeNotes(view);
  if (isCounted || isNoted) findGaps(view);
  const bool isEventful = takeEvents(view);
  if (!isNoted && !isJumped && !isEventful) return;
  m_marks = m_jumps;
  m_marks.insert(m_marks.end(), m_notes.begin(), m_notes.end());
  m_marks.insert(m_marks.end(), m_events.begin(), m_events.end());
  std::stable_sort(m_marks.begin(), m_marks.end(),
                   [](const TimelineMark& a, const TimelineMark& b) { return a.time < b.time; });
}

// Counted exactly, a look-up a bin; anew only once the span has moved or grown by more than can be seen.
bool LogMarks::takeDensity(const LogView& view, TimelineSpan shown, int bins) {
  bins = std::max(bins, 1);
  const double span = static_cast<double>(shown.end.ns) - static_cast<double>(shown.begin.ns);
  const double grown = std::abs(static_cast<double>(shown.end.ns) - static_cast<double>(m_span.end.ns));
  const auto wanted = static_cast<std::size_t>(bins);
  if (m_density.size() == wanted && shown.begin == m_span.begin && grown * bins <= span) return false;
  m_span = shown;
  if (!m_hasTimes) {
    m_density.assign(wanted, 1.0F);
    return true;
  }
  const FrameStore& frames = m_log->frames;
  std::vector<std::uint64_t> counts(wanted);
  std::uint64_t before = std::min(view.frameCount, frames.firstAtOrAfter(shown.begin)), most = 1;
  for (int i = 0; i < bins; ++i) {
    const Instant edge{shown.begin.ns + std::llround(span / bins * (i + 1))};
    const bool isLast = i + 1 == bins && shown.end >= view.end;
    const std::uint64_t until =
        isLast ? view.frameCount : std::min(view.frameCount, frames.firstAtOrAfter(edge));
    counts[static_cast<std::size_t>(i)] = until - std::min(before, until);
    most = std::max(most, counts[static_cast<std::size_t>(i)]);
    before = std::max(before, until);
  }
  m_density.resize(wanted);
  // By the root, so that what is rare can be seen beside what is busy.
  std::transform(counts.begin(), counts.end(), m_density.begin(), [most](std::uint64_t n) {
    return static_cast<float>(std::sqrt(static_cast<double>(n) / static_cast<double>(most)));
  });
  return true;
}

bool LogMarks::takeJumps(const LogView& view) {
  const FrameStore& frames = m_log->frames;
  const StableList<std::uint64_t>& jumps = frames.jumps();
  const std::size_t before = m_jumps.size();
  const std::size_t count = std::min(jumps.size(), kMaxJumps);
  while (m_jumps.size() < count && jumps[m_jumps.size()] < view.frameCount) {
    m_jumps.push_back({TimelineMark::Kind::TimeJump, frames.timeAt(jumps[m_jumps.size()]),
                       LogMarksText::tr("The clock jumps here")});
  }
  return m_jumps.size() != before;
}

void LogMarks::setLabels(const DeviceLabels& labels) {
  if (labels == m_labels) return;
  m_labels = labels;
  m_notesTaken = m_eventsTaken = 0;
  m_events.clear();
}

// A jump of the clock has its line.
bool LogMarks::takeEvents(const LogView& view) {
  const bool isAnew = m_log->events.generation() != m_generation;
  if (isAnew) {
    m_generation = m_log->events.generation();
    m_eventsTaken = 0;
    m_events.clear();
  }
  if (m_log->events.count() == m_eventsTaken) return isAnew;
  const std::vector<Event> more = m_log->events.after(m_eventsTaken);
  m_eventsTaken += more.size();
  for (const Event& event : more) {
    if (event.kind == EventKind::ClockJump) continue;
    const EventFacts& facts = kEvents[event.kind];
    m_events.push_back({TimelineMark::Kind::Event, onScale(view, {event.frame, event.time}),
                        named(keyOf(event), eventText(event, view.begin), m_labels), facts.group,
                        facts.weight});
  }
  return true;
}

bool LogMarks::takeNotes(const LogView& view) {
  if (m_log->notes.count() == m_notesTaken) return false;
  const std::vector<Note> notes = m_log->notes.all();
  m_notesTaken = notes.size();
  m_notes.clear();
  m_lost.clear();
  for (const Note& note : notes) {
    if (!isEvent(note.value)) continue;
    m_notes.push_back({TimelineMark::Kind::Event, onScale(view, {note.frame, note.time}),
                       named(keyOf(note), noteText(*m_log, note), m_labels), EventGroup::Note,
                       noteWeight(note.value)});
  }
  if (!m_hasTimes) return true;
  for (const LinkGap& gap : linkGaps(notes))
    m_lost.push_back({TimelineGap::Kind::LinkLost, {gap.begin, gap.end}});
  return true;
}

// Silence is where no part of the span has a frame, from the last frame before to the first one behind.
void LogMarks::findGaps(const LogView& view) {
  m_gaps = m_lost;
  if (!m_log->notes.filters().empty()) return;  // the bus may have been busy there
  const FrameStore& frames = m_log->frames;
  const double bin = (static_cast<double>(m_span.end.ns) - static_cast<double>(m_span.begin.ns)) /
                     static_cast<double>(std::max<std::size_t>(m_density.size(), 1));
  for (std::size_t i = 0; i < m_density.size();) {
    std::size_t end = i;
    while (end < m_density.size() && m_density[end] <= 0) ++end;
    if (end - i >= 2) {
      const auto timeOf = [&](std::size_t edge) {
        return Instant{m_span.begin.ns + std::llround(bin * static_cast<double>(edge))};
      };
      const std::uint64_t next = frames.firstAtOrAfter(timeOf(i));
      const Instant from = next == 0 ? view.begin : frames.timeAt(std::min(next, view.frameCount) - 1);
      const Instant to = next < view.frameCount ? frames.timeAt(next) : view.end;
      if (to - from >= kSilence) m_gaps.push_back({TimelineGap::Kind::Silence, {from, to}});
    }
    i = end + 1;
  }
}

}  // namespace deckpipe
