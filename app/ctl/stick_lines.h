// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of `deckpipectl info --devices` on the joystick sources of a log: what each asks for at the end, whether
// that still holds, and who goes before it.
#pragma once

#include <string>
#include <string_view>

#include "state/state.h"

namespace deckpipe::ctl {

// One source as a JSON object. `hasTimes`: ages are known.
std::string stickJson(const State& state, Channel channel, const Joystick& stick,
                      std::string_view channelName, bool hasTimes);
// One source as a line, without its end.
std::string stickText(const State& state, Channel channel, const Joystick& stick,
                      std::string_view channelName, bool hasTimes);

}  // namespace deckpipe::ctl
