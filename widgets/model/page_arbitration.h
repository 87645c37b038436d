// SPDX-License-Identifier: GPL-3.0-or-later
// Where a joystick source stands among those that are heard on its channel, and what it moves. Source: CAN
// Messaging manual, Appendix B: 33 hex comes first, 38 hex last, all after a 6032's own switches; a source
// overrides the others only where it asks for something.
#pragma once

#include "model/device_page_values.h"

namespace deckpipe {

PageFactGroup arbitrationOf(const State& state, Channel channel, const Joystick& stick,
                            const DeviceLabels& labels);
// For a control that is known by its PIN alone: which sources are heard on its channel, one of which may be
// its own.
PageFactGroup sourcesOf(const State& state, Channel channel);

}  // namespace deckpipe
