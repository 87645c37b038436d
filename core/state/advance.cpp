// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/advance.h"

#include <algorithm>

namespace deckpipe {

void advance(State& state, const FrameStore& frames, const NoteStore& notes, Cursor to) {
  std::vector<Note> pending = notes.between(state.cursor().frames, to.frames + 1);
  // Of the notes before the very next frame, those up to the cursor's time have been applied.
  const Cursor from = state.cursor();
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
      while (nextNote < pending.size() && pending[nextNote].frame <= i) state.apply(pending[nextNote++]);
      state.apply(run[i - start], times.at(i));
    }
  }
  while (nextNote < pending.size()) state.apply(pending[nextNote++]);
  state.timeCame(to.time);
}

Cursor cursorAfter(const FrameStore& frames, std::uint64_t count) {
  return {count, count == 0 ? kNotYet : frames.timeAt(count - 1)};
}

Cursor cursorAt(const FrameStore& frames, Instant time) { return {frames.firstAfter(time), time}; }

}  // namespace deckpipe
