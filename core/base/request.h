// SPDX-License-Identifier: GPL-3.0-or-later
// What can be asked of an Akron device (CAN Messaging manual, message types 02-05, 21, 41, 45, 46). The
// catalogue names the messages of each (protocol/akron.h), control/ask.h says how it is asked.
#pragma once

#include <cstdint>

namespace deckpipe {

// Numbers stand in files (core/log/note_codec.h): never renumber one, never use one again. They count from 0
// without a gap, as tables are indexed by them.
enum class Request : std::uint8_t {
  Fault = 0,
  Firmware = 1,
  Pcode = 2,
  Config = 3,
  Vista = 4,
  ZeroAxes = 5,
  Reset = 6,
  SetupMode = 7,
  Count,
};

}  // namespace deckpipe
