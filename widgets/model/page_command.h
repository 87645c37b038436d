// SPDX-License-Identifier: GPL-3.0-or-later
// Who moves a monitor's axes now. Source: CAN Messaging manual, Appendix B: of the joystick sources 33..38
// hex the lowest number wins, axis by axis, and only while it deflects that axis; a gateway's node has one
// command, RPDO1, whose sender is not known. A controller forgets an input after 200 ms.
#pragma once

#include "model/device_page_values.h"

namespace deckpipe {

struct PageCommands {
  std::optional<DialAxis::Command> rotation, elevation;
};
// What one joystick asks for, whoever comes before it.
PageCommands commandsOf(const Joystick& stick);
// What the joysticks of a channel command together.
PageCommands joystickCommands(const State& state, Channel channel);
// "right at 50 %", for the rotation; up and down for the elevation.
QString commandText(const DialAxis::Command& command, bool isRotation);
PageCommands commandsTo(const State& state, const Device& monitor);

}  // namespace deckpipe
