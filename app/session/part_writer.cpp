// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/part_writer.h"

#include <algorithm>
#include <utility>

#include "protocol/lists.h"
#include "protocol/typed.h"
#include "state/in_force.h"

namespace deckpipe {
namespace {

bool isNotedAnew(const NoteValue& value) {
  return std::holds_alternative<note::Added>(value) || std::holds_alternative<note::Label>(value) ||
         std::holds_alternative<note::Filtered>(value);
}

}  // namespace

PartWriter::PartWriter(const LogDocument& log, const Span& span, const LabelsByPin& labels, LogWriter& writer,
                       std::string& out)
    : m_log(log),
      m_span(span),
      m_labels(labels),
      m_writer(writer),
      m_out(out),
      m_notes(log.notes.all()),
      m_times(log.frames) {
  m_writer.begin(m_out);
}

bool PartWriter::frame(std::uint64_t i, const std::stop_token& stop) {
  if (m_written == 0) noteFilters(m_log.frames.timeAt(i));
  const bool isBegin = m_written == 0 && i > 0;
  if (isBegin) noteInForce();
  passNotes(i);  // the gaps among them make former what was said before
  if (isBegin && !addInForce(i, stop)) return false;
  const Instant time = m_times.at(i);
  addedUntil(i);
  write(m_log.frames[i], time);
  ++m_written;
  return true;
}

// The writer waits for the first frame that passes: frame() adds what is in force there.
void PartWriter::heldBack(std::uint64_t i) {
  const Frame& frame = m_log.frames[i];
  if (m_written == 0 || !tellsWhoIsWho(frame)) return;
  passNotes(i);
  const Instant time = m_times.at(i);
  write(note::Added{1}, time);
  write(frame, time);
  ++m_added;
}

void PartWriter::noteFilters(Instant time) {
  for (const Note& note : m_notes) {
    if (std::holds_alternative<note::Filtered>(note.value)) write(note.value, time);
  }
  if (m_span.isFiltered) write(note::Filtered{m_span.filter}, time);
}

void PartWriter::noteInForce() {
  if (m_span.begin == 0) return;
  for (Note& note : notesInForce(m_log.frames, m_log.notes, m_span.begin))
    write(std::move(note.value), note.time);
}

bool PartWriter::addInForce(std::uint64_t i, const std::stop_token& stop) {
  const std::vector<Frame> inForce = framesInForce(m_log.frames, m_log.notes, i, stop);
  if (stop.stop_requested()) return false;
  const Instant time = m_times.at(i);
  if (!inForce.empty()) write(note::Added{inForce.size()}, time);
  for (const Frame& frame : inForce) {
    write(frame, time);
    ++m_added;
  }
  return true;
}

void PartWriter::passNotes(std::uint64_t before) {
  for (; m_nextNote < m_notes.size() && m_notes[m_nextNote].frame <= before; ++m_nextNote) {
    const Note& note = m_notes[m_nextNote];
    if (const auto* added = std::get_if<note::Added>(&note.value)) {
      m_wereAdded = std::max(m_wereAdded, note.frame + added->count);
    } else if (note.frame >= m_span.begin && !isNotedAnew(note.value)) {
      write(note.value, note.time);
    }
  }
}

void PartWriter::addedUntil(std::uint64_t i) {
  if (i >= m_wereAdded || i < m_saidAdded) return;
  const std::uint64_t end = m_span.isFiltered ? i + 1 : std::min(m_wereAdded, m_span.end);
  write(note::Added{end - i}, m_times.at(i));
  m_saidAdded = end;
}

void PartWriter::end() {
  const std::uint64_t end = m_span.end;
  if (m_written == 0) noteFilters(m_log.frames.lastTime());
  if (end > 0) passNotes(end - 1);
  for (; m_nextNote < m_notes.size() && m_notes[m_nextNote].frame == end; ++m_nextNote) {
    const Note& note = m_notes[m_nextNote];
    // A mark at the part's last frame stands behind it.
    const bool isOfPart = m_span.isToEnd || (end > m_span.begin && note.time <= m_log.frames.timeAt(end - 1));
    if (isOfPart && !isNotedAnew(note.value)) write(note.value, note.time);
  }
  if (m_span.begin == 0 && m_span.isToEnd && !m_span.isFiltered) noteLeftOut();
  if (m_span.missing > 0 && end > 0 && !m_channels.empty())
    write(note::LeftOut{{m_channels.begin()->first}, note::LeftOut::Why::NotWhole, m_span.missing},
          m_log.frames.timeAt(end - 1));
  if (m_span.isToEnd && end > 0 && m_span.ranUntil > m_log.frames.timeAt(end - 1))
    write(note::RanUntil{}, m_span.ranUntil);
  m_writer.end(m_out);
}

// What the log's own file had and the store does not hold; what a live log left out is noted where it came.
// The lines of a file are no places in the log, so a part of it cannot say which of them are missing there.
void PartWriter::noteLeftOut() {
  using Why = note::LeftOut::Why;
  if (m_channels.empty()) return;
  const SkippedPlaces skipped = m_log.skipped.content();
  const std::uint64_t count = m_log.frames.count();
  const Instant time = count > 0 ? m_log.frames.timeAt(count - 1) : Instant{};
  for (const auto& [why, leftOut] : {std::pair(Why::CanFd, skipped.count(Skipped::CanFd)),
                                     std::pair(Why::CanXl, skipped.count(Skipped::CanXl)),
                                     std::pair(Why::Unreadable, skipped.unreadable()),
                                     std::pair(Why::RecorderLost, skipped.count(Skipped::RecorderDropped))}) {
    if (leftOut > 0) write(note::LeftOut{{m_channels.begin()->first}, why, leftOut}, time);
  }
}

void PartWriter::write(const Frame& frame, Instant time) {
  if (hasTypeOf(frame, MessageId::AddressAnnouncement)) {
    const auto pin = announcedPin(frame);
    const auto label = pin ? m_labels.find(*pin) : m_labels.end();
    if (label != m_labels.end() && m_labelled.insert(*pin).second)
      write(note::Label{*pin, label->second}, time);
  }
  Frame own = frame;
  own.channel = channel(frame.channel);
  m_writer.frame(own, time, m_out);
}

void PartWriter::write(NoteValue value, Instant time) {
  if (const auto about = channelOf(value)) setChannel(value, {channel(about->value)});
  m_writer.note({.frame = m_written + m_added, .time = time, .value = std::move(value)}, m_out);
}

std::uint8_t PartWriter::channel(std::uint8_t of) {
  const auto [known, isNew] = m_channels.try_emplace(of, static_cast<std::uint8_t>(m_channels.size()));
  if (isNew) m_writer.channel(m_log.frames.channelName(of), m_out);
  return known->second;
}

}  // namespace deckpipe
