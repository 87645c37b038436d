// SPDX-License-Identifier: GPL-3.0-or-later
// Notes as bytes, for files that outlive this version. All numbers are little-endian:
//
//   2 bytes  length of what follows
//   1 byte   kind, from 1 on
//   8 bytes  the frame before which the note stands
//   8 bytes  log time in ns, signed
//   …        the fields of the kind, in the order of its layout (note_layout.h)
//
// 1. The number of a kind, and of a value of its enums, is never changed and never used again.
// 2. Fields are only ever added at the end: what follows the known ones is skipped, and what a later version
//    added may be missing.
// 3. A kind, or a value of an enum, that this version does not know is from a newer one. It is told as unknown
//    and skipped; what follows is read.
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "base/result.h"
#include "log/note.h"

namespace deckpipe {

void appendNote(std::vector<std::uint8_t>& out, const Note& note);

// A note that a newer version wrote.
struct UnknownNote {
  std::uint64_t frame = 0;
  Instant time{};
  std::uint8_t kind = 0;
  friend bool operator==(const UnknownNote&, const UnknownNote&) = default;
};

enum class NoteFault : std::uint8_t {
  Cut,      // the bytes end within the note: its file is still being written, or its end is lost
  Damaged,  // no version writes this
};

// Takes one note from the front of `bytes`, which then begin behind it. After a fault they are as before.
Result<std::variant<Note, UnknownNote>, NoteFault> takeNote(std::span<const std::uint8_t>& bytes);

}  // namespace deckpipe
