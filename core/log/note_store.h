// SPDX-License-Identifier: GPL-3.0-or-later
// NoteStore: the notes of a log (note.h), ordered by the frame they stand before, and then by time. What a person sees is a
// function of frames, notes and cursor, so whatever else changes the picture is written down here. One writer
// at a time, readers on any thread; notes are few, so a lock is all it takes.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "log/note.h"

namespace deckpipe {

class NoteStore {
 public:
  // Behind the notes of the same place; earlier places are allowed (marks in a replay). Of note::RanUntil the time alone
  // is kept.
  void append(Note note);
  std::size_t count() const;
  // The notes that stand before a frame in [from, to), in order.
  std::vector<Note> between(std::uint64_t from, std::uint64_t to) const;
  std::vector<Note> all() const;
  // Those of some kinds alone, in order.
  template <typename... Kinds>
  std::vector<Note> of() const {
    const std::lock_guard lock(m_lock);
    std::vector<Note> notes;
    for (const auto& place : m_places) {
      const Note& note = m_notes[place.second];
      if ((std::holds_alternative<Kinds>(note.value) || ...)) notes.push_back(note);
    }
    return notes;
  }
  // Until when the log says that it ran; kNotYet if it does not say so. endOf() (state/advance.h) tells when it ends.
  Instant ranUntil() const { return {m_ranUntil.load(std::memory_order_acquire)}; }
  // Of the last note in order; kNotYet if there is none.
  Instant lastTime() const;
  // All that framesMissed() says of them.
  std::uint64_t missedFrames() const;
  // The filters through which the log was saved (note::Filtered), as persons wrote them.
  std::vector<std::string> filters() const;
  // The notes that were appended after the first `count` ones, as they were appended.
  std::vector<Note> appendedAfter(std::size_t count) const;

 private:
  mutable std::mutex m_lock;
  std::vector<Note> m_notes;  // as they were appended
  std::vector<std::string>
      m_filters;  // of those that are note::Filtered; they are asked for with every frame drawn
  // Frame and time of each note, and its index in m_notes. A file may hold a million notes in any order: to put one at
  // its place costs log n. Notes of equal places keep the order in which they came.
  std::multimap<std::pair<std::uint64_t, Instant>, std::size_t> m_places;
  std::atomic<std::int64_t> m_ranUntil{kNotYet.ns};  // told with every picture of a live log: no lock for it
};

}  // namespace deckpipe
