// SPDX-License-Identifier: GPL-3.0-or-later
// The lamps of a page: hard stops by axis, outputs of each kind of device, inputs, the permissive.
#pragma once

#include "model/device_page_values.h"

namespace deckpipe {

PageStops stopsOf(const State& state, const Device& device);
std::vector<PageLampGroup> lampsOf(const State& state, const Device& device);
// The switches that a joystick message carries.
std::vector<PageLampGroup> switchesOf(const State& state, Channel channel, const Joystick& stick);

}  // namespace deckpipe
