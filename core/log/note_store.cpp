// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/note_store.h"

#include <algorithm>
#include <utility>

namespace deckpipe {

void NoteStore::append(Note note) {
  if (std::holds_alternative<note::RanUntil>(note.value)) {
    m_ranUntil.store(std::max(ranUntil(), note.time).ns, std::memory_order_release);
    return;
  }
  const std::lock_guard lock(m_lock);
  m_places.emplace(std::pair(note.frame, note.time), m_notes.size());
  if (const auto* filtered = std::get_if<note::Filtered>(&note.value))
    m_filters.push_back(filtered->text.str());
  m_notes.push_back(std::move(note));
}

std::size_t NoteStore::count() const {
  const std::lock_guard lock(m_lock);
  return m_notes.size();
}

std::vector<Note> NoteStore::between(std::uint64_t from, std::uint64_t to) const {
  const std::lock_guard lock(m_lock);
  const auto first = m_places.lower_bound({from, kNotYet});
  const auto last = m_places.lower_bound({std::max(from, to), kNotYet});
  std::vector<Note> notes;
  std::for_each(first, last, [&](const auto& place) { notes.push_back(m_notes[place.second]); });
  return notes;
}

std::vector<Note> NoteStore::all() const {
  const std::lock_guard lock(m_lock);
  std::vector<Note> notes;
  notes.reserve(m_places.size());
  for (const auto& place : m_places) notes.push_back(m_notes[place.second]);
  return notes;
}

Instant NoteStore::lastTime() const {
  const std::lock_guard lock(m_lock);
  return m_places.empty() ? kNotYet : m_places.rbegin()->first.second;
}

std::uint64_t NoteStore::missedFrames() const {
  const std::lock_guard lock(m_lock);
  std::uint64_t frames = 0;
  for (const Note& note : m_notes) frames += framesMissed(note.value);
  return frames;
}

std::vector<std::string> NoteStore::filters() const {
  const std::lock_guard lock(m_lock);
  return m_filters;
}

std::vector<Note> NoteStore::appendedAfter(std::size_t count) const {
  const std::lock_guard lock(m_lock);
  const auto first = m_notes.begin() + static_cast<std::ptrdiff_t>(std::min(count, m_notes.size()));
  return {first, m_notes.end()};
}

}  // namespace deckpipe
