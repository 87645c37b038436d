// SPDX-License-Identifier: GPL-3.0-or-later
// The facts of a page: faults and versions as answered, with their ages; who the node is and how its claims
// went; what a joystick's timing is.
#pragma once

#include "model/monitor_page_values.h"

namespace deckpipe {

PageFactGroup faultsOf(const Device& device, Instant now);
PageFactGroup versionsOf(const Device& device, Instant now);
// NMT state of a CANopen node.
PageFactGroup nodeOf(const Device& device, Instant now);
PageFactGroup joystickOf(const Joystick& stick, Instant now);
// Address, claim, contests and the NAME's parts of whatever has a J1939 address or lost it. `device` null: a
// node that is no Akron device.
PageFactGroup addressOf(const State& state, Channel channel, Address address, const Device* device);

}  // namespace deckpipe
