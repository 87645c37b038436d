// SPDX-License-Identifier: GPL-3.0-or-later
// What the switches and sources of a joystick are called. Source: CAN Messaging manual, Appendix B.
#pragma once

#include <QString>

#include "base/ids.h"

namespace deckpipe {

// What a monitor does on switch 1..16: "Stream"; "Switch 13, reserved".
QString switchName(int number);
// "Joystick 33": how a source is called where it commands.
QString joystickName(Address source);
// "Priority 1 of 6, the highest CAN source"; `priority` 0 for 33 hex .. 5 for 38 hex.
QString priorityText(int priority);

}  // namespace deckpipe
