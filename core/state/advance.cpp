// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/advance.h"

namespace deckpipe {

void advance(State& state, const FrameStore& frames, const NoteStore& notes, Cursor to) {
  walkLog(state, frames, notes, to);
}

Cursor cursorAfter(const FrameStore& frames, std::uint64_t count) {
  return {count, count == 0 ? kNotYet : frames.timeAt(count - 1)};
}

Cursor endOf(const FrameStore& frames, const NoteStore& notes) {
  Cursor end = cursorAfter(frames, frames.count());
  if (end.frames > 0) end.time = endAfter(end.time, notes.ranUntil(), notes.lastTime());
  return end;
}

Cursor cursorAt(const FrameStore& frames, Instant time) { return {frames.firstAfter(time), time}; }

}  // namespace deckpipe
