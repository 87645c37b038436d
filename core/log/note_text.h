// SPDX-License-Identifier: GPL-3.0-or-later
// Notes as text, for files that a person may read and that outlive this version:
//
//   7 drive_said channel=0 address=0x5A is_drive=1
//
// The number of the kind, a word for people, and the fields by their names in the order of the layout
// (note_layout.h). The rules of note_codec.h hold here too.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "log/note.h"
#include "log/note_codec.h"

namespace deckpipe {

void appendNoteText(std::string& out, const NoteValue& value);

// The value; nothing if a newer version wrote it.
Result<std::optional<NoteValue>, NoteFault> noteOfText(std::string_view text);

}  // namespace deckpipe
