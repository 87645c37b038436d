// SPDX-License-Identifier: GPL-3.0-or-later
// Walks a state through a log: frames in order, notes before the frame they stand before, and time-outs
// between.
#pragma once

#include "log/frame_store.h"
#include "log/note_store.h"
#include "state/state.h"

namespace deckpipe {

// From where the state is to `to`, which must not lie before it (take an earlier keyframe, or State(), then).
// At `to` every frame below to.frames has happened, every note before them, and every note and time-out up to
// to.time.
void advance(State& state, const FrameStore& frames, const NoteStore& notes, Cursor to);

// The cursor that stands behind the first `frames` frames, at the time of the last of them.
Cursor cursorAfter(const FrameStore& frames, std::uint64_t count);
// The cursor at a time: every frame up to and at it has happened.
Cursor cursorAt(const FrameStore& frames, Instant time);

}  // namespace deckpipe
