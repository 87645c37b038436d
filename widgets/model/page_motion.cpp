// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_motion.h"

#include <QCoreApplication>

#include "model/page_command.h"
#include "model/page_stick.h"
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

}  // namespace deckpipe
