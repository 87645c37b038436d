// SPDX-License-Identifier: GPL-3.0-or-later
// Who moves a monitor's axes now. Source: CAN Messaging manual, Appendix B: of the joystick sources 33..38
// hex the lowest number wins, axis by axis, and only while it deflects that axis; a gateway's node has one
// command, RPDO1, whose sender is not known. A controller forgets an input after 200 ms.
#pragma once

#include "model/monitor_page_values.h"

namespace deckpipe {

struct PageCommands {
  std::optional<PageAxis::Command> rotation, elevation;
};
PageCommands commandsTo(const State& state, const Device& monitor);

}  // namespace deckpipe
