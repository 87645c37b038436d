// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_dial.h"

#include "model/page_command.h"

namespace deckpipe {
namespace {

// One place for both axes: they differ in where they stand in the message only.
PageAxis axisOf(const Device& d, std::size_t axis, const PositionReading& reading, const auto& limits,
                bool areLimitsStale, Instant now) {
  PageAxis page;
  page.isStale = d.isStale(MessageId::PositionLimitStatus);
  if (d.position().isKnown()) {
    page.reading = reading;
    page.age = now - d.position().at;
    page.plusStop = d.position().value().plusStop[axis];
    page.minusStop = d.position().value().minusStop[axis];
  }
  if (limits.isKnown()) page.limits = limits.value();
  page.areLimitsStale = areLimitsStale;
  return page;
}

}  // namespace

PageDial dialOf(const State& state, const Device& d) {
  const Instant now = state.cursor().time;
  PageDial dial;
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
