// SPDX-License-Identifier: GPL-3.0-or-later
// The lamps of a page: hard stops by axis, outputs of each kind of device, inputs, the permissive.
#pragma once

#include "model/device_page_values.h"

namespace deckpipe {

PageStops stopsOf(const Device& device, Instant now);
std::vector<PageLampGroup> lampsOf(const Device& device, Instant now);
// The switches that a joystick message carries.
std::vector<PageLampGroup> switchesOf(const Joystick& stick, Instant now);

}  // namespace deckpipe
