// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/journal_writer.h"

#include <algorithm>
#include <utility>

namespace deckpipe {

void JournalWriter::timeCame(Instant now) {
  if (m_isEnded || (m_fault && now < m_retryAt)) return;
  const bool hadFile = m_file != nullptr;
  m_fault = write(now >= m_syncAt);
  if (!hadFile && m_file != nullptr) {
    m_madeAt = now;
    m_isAnew = bool(m_givenUp);
  }
  if (!m_fault && m_file != nullptr && now >= m_syncAt) {
    if (m_written.bytes != m_safe.bytes) m_fault = sync();
    if (!m_fault) m_fault = check();
    m_syncAt = now + kSync;
  }
  if (!m_fault) return;
  const bool isGivenUp = m_file == nullptr && m_givenUp == m_fault;
  m_retryAt = !isGivenUp ? now + kRetry : m_isAnew ? m_madeAt + kRetry : now;
}

void JournalWriter::end() {
  if (m_isEnded) return;
  tryEnd();
  if (m_fault && m_fault == m_givenUp) tryEnd();
}

void JournalWriter::tryEnd() {
  m_fault = write(true);
  if (!m_fault && m_file != nullptr) m_fault = writeEnd();
  m_isEnded = !m_fault;
}

JournalFault JournalWriter::writeEnd() {
  m_buffer.clear();
  appendEndBlock(m_buffer);
  if (JournalFault fault = m_file->append(m_written.bytes, m_buffer)) return fault;
  m_written.bytes += m_buffer.size();
  if (JournalFault fault = sync()) return fault;
  return check();
}

JournalStatus JournalWriter::status() const {
  return {m_file != nullptr ? m_file->path() : std::string(),
          m_written.frames,
          m_written.bytes,
          m_fault,
          m_isEnded,
          m_givenUp};
}

JournalFault JournalWriter::write(bool tellsSilence) {
  if (m_file == nullptr) {
    if (m_frames.count() == 0) return {};
    if (JournalFault fault = create()) return fault;
  }
  // First: all that came before this time is written before it is told.
  const Instant ranUntil = m_notes.ranUntil();
  // Then notes: the frame of each note that is taken here is below the count that is asked for after it, or
  // is the next one.
  const std::vector<Note> newNotes = m_notes.appendedAfter(m_written.notes);
  const std::uint64_t count = m_frames.count();
  std::span<const Note> notes(newNotes);
  for (bool isMore = true; isMore;) {
    Place place = m_written;
    m_buffer.clear();
    if (place.bytes == 0) appendJournalHead(m_buffer, m_head);
    isMore = collect(place, count, notes);
    if (m_buffer.empty()) break;
    place.bytes += m_buffer.size();
    if (JournalFault fault = m_file->append(m_written.bytes, m_buffer)) return fault;
    m_written = place;
  }
  const Instant told =
      std::max({m_frames.timeAt(m_written.frames - 1), m_notes.lastTime(), m_written.ranUntil});
  return tellsSilence && ranUntil > told ? writeRanUntil(ranUntil) : JournalFault{};
}

JournalFault JournalWriter::writeRanUntil(Instant time) {
  const Note note{.frame = m_written.frames, .time = time, .value = note::RanUntil{}};
  m_buffer.clear();
  appendNoteBlocks(m_buffer, {&note, 1});
  if (JournalFault fault = m_file->append(m_written.bytes, m_buffer)) return fault;
  m_written.bytes += m_buffer.size();
  m_written.ranUntil = time;
  return {};
}

JournalFault JournalWriter::create() {
  MadeJournalFile made = m_makeFile();
  if (!made) return made.error();
  m_file = std::move(made.value());
  if (!m_givenUp) m_head = m_makeHead();  // otherwise the recording began with the file before
  return {};
}

bool JournalWriter::collect(Place& place, std::uint64_t count, std::span<const Note>& notes) {
  for (const std::size_t channels = m_frames.channelCount(); place.channels < channels; ++place.channels) {
    const auto index = static_cast<std::uint8_t>(place.channels);
    appendChannelBlock(m_buffer, index, m_frames.channelName(index));
  }
  std::span<const Frame> frames = m_frames.run(place.frames);
  frames = frames.first(std::min<std::uint64_t>({frames.size(), kMaxJournalFrames, count - place.frames}));
  // In the order in which they came, so that those before the same frame keep theirs.
  const auto isLater = [end = place.frames + frames.size()](const Note& note) { return note.frame > end; };
  const auto n = static_cast<std::size_t>(std::ranges::find_if(notes, isLater) - notes.begin());
  appendNoteBlocks(m_buffer, notes.first(n));
  notes = notes.subspan(n);
  place.notes += n;
  collectOffsets(place, frames);
  appendFrameBlock(m_buffer, place.frames, frames);
  place.frames += frames.size();
  return place.frames < count;
}

// Those of each channel are in order; those of all are put in order.
void JournalWriter::collectOffsets(Place& place, std::span<const Frame> frames) {
  m_offsets.clear();
  const std::uint64_t end = place.frames + frames.size();
  for (std::size_t channel = 0; channel < place.offsets.size(); ++channel) {
    const auto index = static_cast<std::uint8_t>(channel);
    const StableList<ClockOffset>* list = m_frames.offsets(index);
    if (list == nullptr) continue;
    std::size_t& next = place.offsets[channel];
    for (; next < list->size() && (*list)[next].frame < end; ++next)
      m_offsets.push_back({index, (*list)[next]});
  }
  std::ranges::sort(m_offsets, {}, [](const ChannelOffset& o) { return o.offset.frame; });
  appendClockBlocks(m_buffer, m_offsets);
}

// What was not on the disk before may be lost, for the system forgets it after a fault: it is written again.
JournalFault JournalWriter::sync() {
  JournalFault fault = m_file->sync();
  (fault ? m_written : m_safe) = fault ? m_safe : m_written;
  return fault;
}

// Nothing of a file that is gone or not ours any more is safe.
JournalFault JournalWriter::check() {
  JournalFault fault = m_file->check();
  if (fault.kind != JournalFault::Kind::Removed && fault.kind != JournalFault::Kind::Changed) return fault;
  m_givenUp = fault;
  m_file.reset();
  m_written = m_safe = {};
  return fault;
}

}  // namespace deckpipe
