// SPDX-License-Identifier: GPL-3.0-or-later
// The notes that say something of who is who: where the person says a drive is, and the gaps of a link, behind which
// all that was known is former. For whoever walks a log with a RoleWalk.
#pragma once

#include <optional>

#include "log/note.h"
#include "protocol/role_walk.h"

namespace deckpipe {

struct RoleNote {
  enum class Kind : std::uint8_t { DriveSaid, DriveUnsaid, LinkUp, LinkDown };

  Kind kind = Kind::DriveSaid;
  Channel channel;
  Address address;  // of drives
};

// Nothing of a note that says nothing of roles.
inline std::optional<RoleNote> roleNoteOf(const NoteValue& value) {
  if (const auto* said = std::get_if<note::DriveSaid>(&value))
    return RoleNote{said->isDrive ? RoleNote::Kind::DriveSaid : RoleNote::Kind::DriveUnsaid, said->channel,
                    said->address};
  if (const auto* up = std::get_if<note::LinkUp>(&value))
    return RoleNote{RoleNote::Kind::LinkUp, up->channel, {}};
  if (const auto* down = std::get_if<note::LinkDown>(&value))
    return RoleNote{RoleNote::Kind::LinkDown, down->channel, {}};
  return {};
}

inline void teach(RoleWalk& walk, const RoleNote& note, Instant time) {
  switch (note.kind) {
    case RoleNote::Kind::DriveSaid: return walk.sayDrive(note.channel, note.address, true, time);
    case RoleNote::Kind::DriveUnsaid: return walk.sayDrive(note.channel, note.address, false, time);
    case RoleNote::Kind::LinkUp: return walk.linkIs(note.channel, true, time);
    case RoleNote::Kind::LinkDown: return walk.linkIs(note.channel, false, time);
  }
}
// Takes any note that stands before the next frame of the walk.
inline void teach(RoleWalk& walk, const Note& note) {
  if (const auto said = roleNoteOf(note.value)) teach(walk, *said, note.time);
}

}  // namespace deckpipe
