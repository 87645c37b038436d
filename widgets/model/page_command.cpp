// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_command.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

#include "state/current.h"
#include "text/device_text.h"

namespace deckpipe {
namespace {

struct Command {
  Q_DECLARE_TR_FUNCTIONS(Command)
};

bool deflects(const StickAxis& axis) { return axis.tenths.value_or(0) != 0; }

double speed(const StickAxis& axis) { return axis.tenths.value_or(0) / 1000.0; }

void take(PageCommands& commands, const BasicJoystick& stick, const QString& source, Address from) {
  if (!commands.rotation && deflects(stick.x)) commands.rotation = {speed(stick.x), source, from};
  // The stick back elevates up.
  if (!commands.elevation && deflects(stick.y)) commands.elevation = {-speed(stick.y), source, from};
}

}  // namespace

PageCommands commandsOf(const Joystick& stick) {
  PageCommands commands;
  take(commands, stick.basic.value(), joystickName(stick.source), stick.source);
  return commands;
}

PageCommands joystickCommands(const State& state, Channel channel) {
  PageCommands commands;
  const Joysticks& joysticks = state.channel(channel).joysticks;
  for (std::uint8_t a = kFirstJoystick.value; a <= kLastJoystick.value; ++a) {
    const Joystick* stick = joysticks.find(Address{a});
    if (stick != nullptr && isInForce(state, channel, *stick))
      take(commands, stick->basic.value(), joystickName(stick->source), stick->source);
  }
  return commands;
}

PageCommands commandsTo(const State& state, const Device& monitor) {
  if (monitor.kind != Device::Kind::Node) return joystickCommands(state, monitor.channel);
  PageCommands commands;
  const bool isFresh = monitor.commanded.isKnown() &&
                       !isCutOff(state, monitor.channel, monitor.commanded.at) &&
                       state.cursor().time - monitor.commanded.at < kInputTimeout + state.slack();
  if (isFresh) {
    take(commands, monitor.commanded.value(),
         Command::tr("Gateway joystick", "commands by way of the CAN gateway"), kNullAddress);
  }
  return commands;
}

QString commandText(const DialAxis::Command& command, bool isRotation) {
  const QString percent = QLocale().toString(std::abs(command.speed) * 100, 'f', 0);
  const bool isPlus = command.speed > 0;
  if (isRotation)
    return isPlus ? Command::tr("right at %1 %").arg(percent) : Command::tr("left at %1 %").arg(percent);
  return isPlus ? Command::tr("up at %1 %").arg(percent) : Command::tr("down at %1 %").arg(percent);
}

}  // namespace deckpipe
