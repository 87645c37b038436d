// SPDX-License-Identifier: GPL-3.0-or-later
// Copies of the state every so many frames, so that the state at any cursor is a short walk away. A worker
// calls build() while the log is read; views ask for at() on any thread.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "state/advance.h"

namespace deckpipe {

class Keyframes {
 public:
  static constexpr std::uint64_t kEvery = 131'072;

  Keyframes(const FrameStore& frames, const NoteStore& notes) : m_frames(frames), m_notes(notes) {}

  // Adds the next keyframe if the store has that many frames. False where it has not: nothing to do for now.
  bool build();
  // The same from a state that somebody else has walked to kEvery frames more than the last keyframe has. Any
  // other is left alone.
  void offer(const State& state);
  // The state at a cursor, from the nearest keyframe before it.
  State at(Cursor cursor) const;
  // Keyframes hold notes: forget those behind a note that was added or taken back in the past.
  void invalidateAfter(std::uint64_t frame);
  std::size_t count() const;

 private:
  std::shared_ptr<const State> nearest(Cursor cursor) const;

  const FrameStore& m_frames;
  const NoteStore& m_notes;
  mutable std::mutex m_lock;
  std::vector<std::shared_ptr<const State>> m_states;  // [i] is after (i + 1) * kEvery frames
};

}  // namespace deckpipe
