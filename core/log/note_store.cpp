// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/note_store.h"

#include <algorithm>
#include <utility>

namespace deckpipe {

void NoteStore::append(Note note) {
  const std::lock_guard lock(m_lock);
  const auto place = std::upper_bound(
      m_places.begin(), m_places.end(), std::pair(note.frame, note.time),
      [this](const auto& at, std::size_t n) { return at < std::pair(m_notes[n].frame, m_notes[n].time); });
  m_places.insert(place, m_notes.size());
  m_notes.push_back(std::move(note));
}

std::size_t NoteStore::count() const {
  const std::lock_guard lock(m_lock);
  return m_notes.size();
}

std::vector<Note> NoteStore::between(std::uint64_t from, std::uint64_t to) const {
  const std::lock_guard lock(m_lock);
  const auto before = [this](std::size_t n, std::uint64_t frame) { return m_notes[n].frame < frame; };
  const auto first = std::lower_bound(m_places.begin(), m_places.end(), from, before);
  const auto last = std::lower_bound(first, m_places.end(), std::max(from, to), before);
  std::vector<Note> notes;
  notes.reserve(static_cast<std::size_t>(last - first));
  std::for_each(first, last, [&](std::size_t n) { notes.push_back(m_notes[n]); });
  return notes;
}

std::vector<Note> NoteStore::all() const {
  const std::lock_guard lock(m_lock);
  std::vector<Note> notes;
  notes.reserve(m_places.size());
  for (const std::size_t n : m_places) notes.push_back(m_notes[n]);
  return notes;
}

Instant NoteStore::lastTime() const {
  const std::lock_guard lock(m_lock);
  return m_places.empty() ? kNotYet : m_notes[m_places.back()].time;
}

std::uint64_t NoteStore::missedFrames() const {
  const std::lock_guard lock(m_lock);
  std::uint64_t frames = 0;
  for (const Note& note : m_notes) frames += framesMissed(note.value);
  return frames;
}

std::vector<Note> NoteStore::appendedAfter(std::size_t count) const {
  const std::lock_guard lock(m_lock);
  const auto first = m_notes.begin() + static_cast<std::ptrdiff_t>(std::min(count, m_notes.size()));
  return {first, m_notes.end()};
}

}  // namespace deckpipe
