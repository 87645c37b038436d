// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_dial.h"

#include "model/page_command.h"

namespace deckpipe {
namespace {

// One place for both axes: they differ in where they stand in the message only.
DialAxis axisOf(const Device& d, std::size_t axis, const PositionReading& reading, const auto& limits,
                bool areLimitsStale, Instant now) {
  DialAxis shown;
  shown.isStale = d.isStale(MessageId::PositionLimitStatus);
  if (d.position().isKnown()) {
    shown.reading = reading.state;
    shown.degrees = reading.tenths / 10.0;
    shown.age = ageAt(d.position().at, now);
    shown.plusStop = d.position().value().plusStop[axis];
    shown.minusStop = d.position().value().minusStop[axis];
  }
  if (limits.isKnown()) {
    shown.limitLow = limits.value().low / 10.0;
    shown.limitHigh = limits.value().high / 10.0;
    shown.isOscillating = limits.value().oscillating;
  }
  shown.areLimitsStale = areLimitsStale;
  return shown;
}

}  // namespace

DialValues dialOf(const State& state, const Device& d) {
  const Instant now = state.cursor().time;
  DialValues dial;
  const PositionLimitStatus position = d.position().value();
  dial.rotation =
      axisOf(d, 0, position.rotation, d.rotationLimits(), d.isStale(MessageId::RotationSoftLimits), now);
  dial.elevation =
      axisOf(d, 1, position.elevation, d.elevationLimits(), d.isStale(MessageId::ElevationSoftLimits), now);
  const PageCommands commands = commandsTo(state, d);
  dial.rotation.command = commands.rotation;
  dial.elevation.command = commands.elevation;
  if (d.outputs().isKnown() && !d.isStale(MessageId::DigitalOutputs)) {
    dial.enable = d.outputs().value().enable;
    dial.stowed = d.outputs().value().stowed;
  }
  return dial;
}

}  // namespace deckpipe
