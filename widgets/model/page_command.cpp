// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_command.h"

#include <QCoreApplication>

#include "text/joystick_text.h"

namespace deckpipe {
namespace {

bool deflects(const StickAxis& axis) { return axis.tenths.value_or(0) != 0; }

double speed(const StickAxis& axis) { return axis.tenths.value_or(0) / 1000.0; }

void take(PageCommands& commands, const BasicJoystick& stick, const QString& source) {
  if (!commands.rotation && deflects(stick.x)) commands.rotation = {speed(stick.x), source};
  // The stick back elevates up.
  if (!commands.elevation && deflects(stick.y)) commands.elevation = {-speed(stick.y), source};
}

}  // namespace

PageCommands commandsTo(const State& state, const Device& monitor) {
  PageCommands commands;
  if (monitor.kind == Device::Kind::Node) {
    const bool isFresh =
        monitor.commanded.isKnown() && state.cursor().time - monitor.commanded.at < kInputTimeout;
    if (isFresh) {
      take(commands, monitor.commanded.value(),
           QCoreApplication::translate("Command", "Gateway joystick", "commands by way of the CAN gateway"));
    }
    return commands;
  }
  const Joysticks& joysticks = state.channel(monitor.channel).joysticks;
  for (std::uint8_t a = kFirstJoystick.value; a <= kLastJoystick.value; ++a) {
    const Joystick* stick = joysticks.find(Address{a});
    if (stick != nullptr && stick->isActive())
      take(commands, stick->basic.value(), joystickName(stick->source));
  }
  return commands;
}

}  // namespace deckpipe
