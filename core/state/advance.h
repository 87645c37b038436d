// SPDX-License-Identifier: GPL-3.0-or-later
// Walks a state through a log: frames in order, notes before the frame they stand before, and time-outs
// between.
#pragma once

#include <algorithm>
#include <vector>

#include "log/frame_store.h"
#include "log/note_store.h"
#include "log/time_grain.h"
#include "state/state.h"

namespace deckpipe {

// Walks whatever takes frames, notes, time and how fine it is as a State does from where it is to `to`.
template <typename Walk>
void walkLog(Walk& walk, const FrameStore& frames, const NoteStore& notes, Cursor to) {
  const Cursor from = walk.cursor();
  if (from.frames == 0) walk.timesAre(timeGrainOf(frames));
  std::vector<Note> pending = notes.between(from.frames, to.frames + 1);
  // Of the notes before the very next frame, those up to the cursor's time have been applied.
  std::erase_if(pending, [&](const Note& note) {
    return (note.frame == from.frames && note.time <= from.time) ||
           (note.frame == to.frames && note.time > to.time);
  });
  LogTimes times(frames);
  std::size_t nextNote = 0;
  std::uint64_t i = from.frames;
  while (i < to.frames) {
    const auto run = frames.run(i);
    const std::uint64_t end = std::min(to.frames, i + run.size());
    const std::uint64_t start = i;
    for (; i < end; ++i) {
      while (nextNote < pending.size() && pending[nextNote].frame <= i) walk.apply(pending[nextNote++]);
      walk.apply(run[i - start], times.at(i));
    }
  }
  while (nextNote < pending.size()) walk.apply(pending[nextNote++]);
  walk.timeCame(to.time);
}

// From where the state is to `to`, which must not lie before it (take an earlier keyframe, or State(), then).
// At `to` every frame below to.frames has happened, every note before them, and every note and time-out up to
// to.time.
void advance(State& state, const FrameStore& frames, const NoteStore& notes, Cursor to);

// The cursor that stands behind the first `frames` frames, at the time of the last of them.
Cursor cursorAfter(const FrameStore& frames, std::uint64_t count);
// The end of a log at rest: behind its last frame, at the time until which it says that it ran, or of its last note, if
// that is later. A note that claims to stand later than all that stretches the log by no more than kMaxBehind.
inline constexpr Duration kMaxBehind = std::chrono::hours(24);
constexpr Instant endAfter(Instant lastFrame, Instant ranUntil, Instant lastNoted) {
  const Instant end = std::max(lastFrame, ranUntil);
  return std::max(end, std::min(lastNoted, end + kMaxBehind));
}
Cursor endOf(const FrameStore& frames, const NoteStore& notes);
// The cursor at a time: every frame up to and at it has happened.
Cursor cursorAt(const FrameStore& frames, Instant time);

}  // namespace deckpipe
