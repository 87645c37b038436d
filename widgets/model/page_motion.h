// SPDX-License-Identifier: GPL-3.0-or-later
// Of a monitor that somebody commands: the stick that does, and what in the log speaks against its moving that way.
// Sources: as in page_command.h; stops and soft limits are those of the dial.
#pragma once

#include "model/device_page_values.h"

namespace deckpipe {

// The joystick source that comes first among those that ask for something now; while none does, first among those
// that are heard. Nothing for a gateway's node, whose joysticks are on another bus.
std::optional<PageStick> leadingStick(const State& state, const Device& monitor);

// Sentences: the axis stands at a hard stop or within 1.0° of its soft limit on the commanded side; another joystick
// asks for an axis and comes later in rank. `dial` is the monitor's own.
std::vector<PageReason> motionReasons(const State& state, const Device& monitor, const DialValues& dial);

}  // namespace deckpipe
