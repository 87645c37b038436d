// SPDX-License-Identifier: GPL-3.0-or-later
// The facts of a page: faults and versions as answered, with their ages; who the node is and how its claims
// went; what a joystick's timing is.
#pragma once

#include "model/device_page_values.h"

namespace deckpipe {

// Answers are drawn as old if the device restarted or fell silent after them, or the link went down.
PageFactGroup faultsOf(const State& state, const Device& device);
PageFactGroup versionsOf(const State& state, const Device& device);
// NMT state of a CANopen node.
PageFactGroup nodeOf(const State& state, const Device& device);
PageFactGroup joystickOf(const State& state, Channel channel, const Joystick& stick);
// Address, claim, contests and the NAME's parts of whatever has a J1939 address or lost it. `device` null: a
// node that is no Akron device.
PageFactGroup addressOf(const State& state, Channel channel, Address address, const Device* device);

}  // namespace deckpipe
