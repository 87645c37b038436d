// SPDX-License-Identifier: GPL-3.0-or-later
// What happened to a data pipe, for notes of the log. Numbers stand in files: never renumber one, never use
// one again.
#pragma once

#include <cstdint>

#include "base/enum_table.h"

namespace deckpipe {

enum class PipeEvent : std::uint8_t {
  FileBegan = 0,
  FileDone = 1,
  FileCancelled = 2,
  FileAborted = 3,
  Stalled = 4,  // no ack
  AckLate = 5,  // it came after all
  Resent = 6,   // by the person, or as the person said for the rest
  Skipped = 7,  // …
  Dropped = 8,  // what was typed and not sent
  DeviceRestarted = 9,
};
template <>
inline constexpr PipeEvent kLastOf<PipeEvent> = PipeEvent::DeviceRestarted;

}  // namespace deckpipe
