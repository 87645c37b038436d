// SPDX-License-Identifier: GPL-3.0-or-later
// A joystick's stick as a page shows it, with words for what its message says.
#pragma once

#include "model/device_page_values.h"

namespace deckpipe {

// "45.0 % right", "neutral", "error", "not fitted"; `plus` and `minus` name the directions.
QString deflectionText(const StickAxis& axis, const QString& plus, const QString& minus);
PageStick stickOf(const State& state, Channel channel, const Joystick& stick);
// Of its extended message.
PageStick gripOf(const State& state, Channel channel, const Joystick& stick);

}  // namespace deckpipe
