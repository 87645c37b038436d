// SPDX-License-Identifier: GPL-3.0-or-later
// How much something asks to be looked at: the health of a device, an event, a lamp that is on, a line of a page, a
// notice. The sign and the colour of each stand in paint/glyph.h.
#pragma once

#include <cstdint>

#include "base/enum_table.h"

namespace deckpipe {

// The gravest last.
enum class Severity : std::uint8_t {
  Plain,  // neither good nor bad
  Fine,
  Unknown,  // nothing is known to be wrong: not asked, not heard, or too long ago
  Busy,     // under way
  Warning,  // worth a look
  Fault,    // something does not work
  Silent,   // a device that stopped sending
  Count,
};

}  // namespace deckpipe
