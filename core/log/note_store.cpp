// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/note_store.h"

#include <algorithm>
#include <utility>

namespace deckpipe {

void NoteStore::append(Note note) {
  const std::lock_guard lock(m_lock);
  const auto place = std::upper_bound(m_notes.begin(), m_notes.end(), note.frame,
                                      [](std::uint64_t frame, const Note& n) { return frame < n.frame; });
  m_notes.insert(place, std::move(note));
}

std::size_t NoteStore::count() const {
  const std::lock_guard lock(m_lock);
  return m_notes.size();
}

std::vector<Note> NoteStore::between(std::uint64_t from, std::uint64_t to) const {
  const auto before = [](const Note& n, std::uint64_t frame) { return n.frame < frame; };
  const std::lock_guard lock(m_lock);
  const auto first = std::lower_bound(m_notes.begin(), m_notes.end(), from, before);
  const auto last = std::lower_bound(first, m_notes.end(), std::max(from, to), before);
  return {first, last};
}

std::vector<Note> NoteStore::all() const {
  const std::lock_guard lock(m_lock);
  return m_notes;
}

}  // namespace deckpipe
