// SPDX-License-Identifier: GPL-3.0-or-later
// Between what the simulator panel says (core/control) and what the simulator understands (core/simulator), which
// know nothing of each other. SimulatorRunner uses these.
#pragma once

#include "control/simulator_control.h"
#include "simulator/standard_simulator.h"

namespace deckpipe {

simulator::Misbehaviour misbehaviourOf(const SimulatedFaults& faults);
// Without any fault.
SimulatorStatus simulatorStatus(const simulator::StandardSimulator& simulator);

}  // namespace deckpipe
