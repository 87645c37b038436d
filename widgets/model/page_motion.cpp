// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_parts.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

#include "paint/figures.h"
#include "state/current.h"
#include "text/device_text.h"

namespace deckpipe {
namespace {

struct Motion {
  Q_DECLARE_TR_FUNCTIONS(Motion)
};

constexpr double kAtLimit = 1.0;  // degrees

// `take` gets those whose input is in force, the first in rank first.
template <typename Take>
void eachInForce(const State& state, Channel channel, Take take) {
  for (std::uint8_t a = kFirstJoystick.value; a <= kLastJoystick.value; ++a) {
    const Joystick* stick = state.channel(channel).joysticks.find(Address{a});
    if (stick != nullptr && isInForce(state, channel, *stick)) take(*stick);
  }
}

// Why an axis may stand still although it is commanded; empty if nothing is known to speak against it.
QString hindrance(const DialAxis& axis, bool isRotation) {
  if (!axis.command) return {};
  const bool isPlus = axis.command->speed > 0;
  const QString what = commandText(*axis.command, isRotation);
  if (!axis.isStale && (isPlus ? axis.plusStop : axis.minusStop) == Status2::On)
    return Motion::tr("Commanded %1: it stands at its hard stop on that side.").arg(what);
  const std::optional<double> limit = isPlus ? axis.limitHigh : axis.limitLow;
  if (!limit || axis.areLimitsStale || axis.isStale || axis.reading != PositionState::Ok) return {};
  const double left = isPlus ? *limit - axis.degrees : axis.degrees - *limit;
  if (left > kAtLimit) return {};
  return Motion::tr("Commanded %1: its soft limit on that side is at %2°, it stands at %3°.")
      .arg(what, degreesText(*limit), degreesText(axis.degrees));
}

}  // namespace

std::optional<PageStick> leadingStick(const State& state, const Device& monitor) {
  if (monitor.kind == Device::Kind::Node) return {};
  const PageCommands commands = joystickCommands(state, monitor.channel);
  const auto& command = commands.rotation ? commands.rotation : commands.elevation;
  const Joystick* leading = nullptr;
  eachInForce(state, monitor.channel, [&](const Joystick& stick) {
    if (leading == nullptr && (!command || command->from == stick.source)) leading = &stick;
  });
  if (leading == nullptr) return {};
  PageStick page = stickOf(state, monitor.channel, *leading);
  page.title = joystickName(leading->source);
  return page;
}

std::vector<PageReason> motionReasons(const State& state, const Device& monitor, const DialValues& dial) {
  std::vector<PageReason> reasons;
  for (const bool isRotation : {true, false}) {
    const QString text = hindrance(isRotation ? dial.rotation : dial.elevation, isRotation);
    if (!text.isEmpty()) reasons.push_back({text, Severity::Warning});
  }
  if (monitor.kind == Device::Kind::Node) return reasons;
  eachInForce(state, monitor.channel, [&](const Joystick& stick) {
    const PageCommands asked = commandsOf(stick);
    for (const bool isRotation : {true, false}) {
      const auto& wanted = isRotation ? asked.rotation : asked.elevation;
      const auto& taken = isRotation ? dial.rotation.command : dial.elevation.command;
      if (!wanted || !taken || taken->from == stick.source) continue;
      const QString what = commandText(*wanted, isRotation);
      reasons.push_back(
          {Motion::tr("%1 asks for %2 in vain: %3 comes first.").arg(wanted->source, what, taken->source),
           Severity::Warning});
    }
  });
  return reasons;
}

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

namespace {

// One place for both axes: they differ in where they stand in the message only.
DialAxis axisOf(const State& state, const Device& d, std::size_t axis, const PositionReading& reading,
                const auto& limits, MessageId limitsId) {
  DialAxis shown;
  shown.isStale = isStale(state, d, MessageId::PositionLimitStatus);
  if (d.position().isKnown()) {
    shown.reading = reading.state;
    shown.degrees = reading.tenths / 10.0;
    shown.age = ageOf(state, d.channel, d.position().at);
    shown.plusStop = d.position().value().plusStop[axis];
    shown.minusStop = d.position().value().minusStop[axis];
  }
  if (limits.isKnown()) {
    shown.limitLow = limits.value().low / 10.0;
    shown.limitHigh = limits.value().high / 10.0;
    shown.isOscillating = limits.value().oscillating;
  }
  shown.areLimitsStale = isStale(state, d, limitsId);
  return shown;
}

}  // namespace

DialValues dialOf(const State& state, const Device& d) {
  DialValues dial;
  const PositionLimitStatus position = d.position().value();
  dial.rotation = axisOf(state, d, 0, position.rotation, d.rotationLimits(), MessageId::RotationSoftLimits);
  dial.elevation =
      axisOf(state, d, 1, position.elevation, d.elevationLimits(), MessageId::ElevationSoftLimits);
  const PageCommands commands = commandsTo(state, d);
  dial.rotation.command = commands.rotation;
  dial.elevation.command = commands.elevation;
  if (d.outputs().isKnown() && !isStale(state, d, MessageId::DigitalOutputs)) {
    dial.enable = d.outputs().value().enable;
    dial.stowed = d.outputs().value().stowed;
  }
  return dial;
}

}  // namespace deckpipe
