// SPDX-License-Identifier: GPL-3.0-or-later
// The events of a log (state/event_walk.h), found by a worker while the log is read or grows, and read by views on
// any thread. The walk makes keyframes on its way, so that a log is walked once for both.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "state/event.h"

namespace deckpipe {

class EventWalk;
class FrameStore;
class Keyframes;
class NoteStore;
struct Cursor;

class Events {
 public:
  // A person reads no longer list: what happens later is not listed.
  static constexpr std::size_t kMax = 20'000;

  Events(const FrameStore& frames, const NoteStore& notes, Keyframes& keyframes);
  ~Events();

  // Walks on towards `to`, to the next keyframe at most. One thread at a time. False where it is there already.
  bool build(const Cursor& to);

  // Notes came at places that were walked already: everything is found anew. On the thread of build().
  void restart();

  // Readers, on any thread. What was read of an earlier generation is void.
  unsigned generation() const;
  std::size_t count() const;
  // All but the first so many, which never change.
  std::vector<Event> after(std::size_t first) const;
  bool isFull() const { return count() >= kMax; }

 private:
  const FrameStore& m_frames;
  const NoteStore& m_notes;
  Keyframes& m_keyframes;
  std::unique_ptr<EventWalk> m_walk;  // null before the first build()
  std::vector<Event> m_found;         // by the walk, not listed yet

  mutable std::mutex m_lock;
  std::vector<Event> m_list;
  unsigned m_generation = 0;
};

}  // namespace deckpipe
