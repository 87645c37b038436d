// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated truck as its panel gets it: a monitor on the bus, a riser without power, an I/O module that has
// no address yet, a joystick.
#pragma once

#include "control/simulator_control.h"

namespace deckpipe::test {

inline SimulatorStatus simulatorSample(const SimulatedFaults& ofMonitor = {SimulatedFault::AnswersLate}) {
  SimulatedFaults ofOthers = SimulatedFaults::all();
  for (const SimulatedFault own : {SimulatedFault::EnableOff, SimulatedFault::RotationSensorError,
                                   SimulatedFault::NotFitted, SimulatedFault::MotorAxis1})
    ofOthers.set(own, false);
  return {{{*Pin::parse("1032AE100801035"), 6032, {0x80}, true, ofMonitor, SimulatedFaults::all()},
           {*Pin::parse("1033AE100802117"), 6033, kNullAddress, false, {}, ofOthers},
           {{}, 6039, kNullAddress, true, {}, ofOthers},
           {*Pin::parse("1035AE100804442"), 6035, {0x83}, true, {}, ofOthers}}};
}

}  // namespace deckpipe::test
