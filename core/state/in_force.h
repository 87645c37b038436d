// SPDX-License-Identifier: GPL-3.0-or-later
// What was said before a place of a log and still holds there: a part of the log that begins at that place
// needs it to show who is who. For whoever saves such a part.
#pragma once

#include <stop_token>
#include <vector>

#include "log/frame_store.h"
#include "log/note_store.h"

namespace deckpipe {

// Whether a frame tells who holds an address, or gives it up: a NAME or an address announcement.
bool tellsWhoIsWho(const Frame& frame);

// The last of each message of kIdentityMessages that holds when frame `at` comes, of each address, in their
// order; each with the stamp that its channel's clock shows when that frame comes. Walks the log up to there;
// may be stopped, with nothing.
std::vector<Frame> framesInForce(const FrameStore& frames, const NoteStore& notes, std::uint64_t at,
                                 const std::stop_token& stop);

// The last of the notes before frame `at` that hold until another one is said of the same thing: whether a link
// is up, the lock, our own address, where a drive is. In their order, each at that frame and its time.
std::vector<Note> notesInForce(const FrameStore& frames, const NoteStore& notes, std::uint64_t at);

}  // namespace deckpipe
