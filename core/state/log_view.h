// SPDX-License-Identifier: GPL-3.0-or-later
// What views are given: a log with everything kept beside it, a cursor in it, and the state there. Nothing in
// it says whether the log still grows from a bus or came from a file; no view needs to know.
#pragma once

#include <memory>

#include "log/frame_store.h"
#include "log/note_store.h"
#include "log/skipped.h"
#include "state/events.h"
#include "state/exchanges.h"
#include "state/keyframes.h"
#include "state/role_index.h"

namespace deckpipe {

// Held by shared pointer, so that it outlives the source that filled it.
struct LogDocument {
  explicit LogDocument(const StoreLimits& limits = {}) : frames(limits) {}

  FrameStore frames;
  NoteStore notes;
  SkippedList skipped;
  Keyframes keyframes{frames, notes};
  RoleIndex roles{frames, notes};
  Events events{frames, notes, keyframes};
  Exchanges exchanges{frames, roles};
};

// Immutable once made; a new one comes at most 30 times a second.
struct LogView {
  std::shared_ptr<const LogDocument> document;  // null while nothing is open
  std::shared_ptr<const State> state;           // never null; may lag behind the cursor for some ticks
  Cursor cursor;
  std::uint64_t frameCount = 0;  // of the log
  Instant begin, end;            // of the log, in log time
  bool atEnd = true;             // the cursor stands at the end and goes with it
  std::uint64_t found = 0;       // moves on as events and exchanges of the log are found

  // False of a log whose frames have none: then all its log times are 0, and nothing is known of ages and order.
  bool hasTimes() const { return document == nullptr || document->frames.hasTimes(); }
};

}  // namespace deckpipe
