// SPDX-License-Identifier: GPL-3.0-or-later
// Between what the twin panel says (core/control) and what the bench twin understands (core/simulator), which
// know nothing of each other. BenchRunner uses these.
#pragma once

#include "control/twin_control.h"
#include "simulator/standard_bench.h"

namespace deckpipe {

simulator::Misbehaviour misbehaviourOf(const TwinFaults& faults);
simulator::Bench::Button buttonOf(TwinButton button);
// `wished` has the faults of each device of the bench.
TwinStatus twinStatus(const simulator::StandardBench& bench, const std::vector<TwinFaults>& intended);

}  // namespace deckpipe
