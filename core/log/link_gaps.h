// SPDX-License-Identifier: GPL-3.0-or-later
// Where a log has a hole: the link of a channel went down and came up again. Taken from the notes, so it is
// the same of a live log and of a file.
#pragma once

#include <vector>

#include "log/note.h"

namespace deckpipe {

struct LinkGap {
  Channel channel;
  Instant begin;
  Instant end = kNever;               // kNever: not up again in this log
  LinkFault fault = LinkFault::None;  // why it went down; None: closed by us
  NoteText words{};                   // the adapter's own; may be empty

  bool isOpen() const { return end == kNever; }
};

// `notes` in the log's order; the gaps in the order in which they begin.
std::vector<LinkGap> linkGaps(const std::vector<Note>& notes);

}  // namespace deckpipe
