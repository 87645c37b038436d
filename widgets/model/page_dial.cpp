// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_dial.h"

#include "model/page_command.h"
#include "state/current.h"

namespace deckpipe {
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
