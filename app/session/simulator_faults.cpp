// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/simulator_faults.h"

namespace deckpipe {
namespace {

using simulator::Misbehaviour;
using N = SimulatorNumbers;

void put(Misbehaviour& m, SimulatedFault fault) {
  switch (fault) {
    case SimulatedFault::Silent: m.silent = true; break;
    case SimulatedFault::AddressTaken: m.addressTaken = true; break;
    case SimulatedFault::ReturnsElsewhere: m.elsewhere = true; break;
    case SimulatedFault::EnableOff: m.enableOff = true; break;
    case SimulatedFault::RotationSensorError: m.rotationSensorError = true; break;
    case SimulatedFault::NotFitted: m.feedbackNotFitted = true; break;
    case SimulatedFault::ResetNever: m.resetTakes = Misbehaviour::kForever; break;
    case SimulatedFault::InternalFuse: m.faultBits |= simulator::faultBit("internal_fuse"); break;
    case SimulatedFault::MotorAxis1: m.faultBits |= simulator::faultBit("motor_axis_1"); break;
    case SimulatedFault::OlderFaults: m.faultBits |= simulator::kOlderFaultBits; break;
    case SimulatedFault::OlderFirmware: m.answers.shortFault = true; break;
    case SimulatedFault::AnswersLost: m.answers.lost = {N::kAnswersLost, N::kAnswersOf}; break;
    case SimulatedFault::AnswersLate: m.answers.late = N::kAnswersLate; break;
    case SimulatedFault::AnswersTwice: m.answers.twice = true; break;
    case SimulatedFault::AnswersWrongLength: m.answers.wrongLength = true; break;
    case SimulatedFault::AnswersWrongSource: m.answers.wrongSource = true; break;
    case SimulatedFault::AcksLost: m.pipe.acksLost = {1, N::kPipeLostOneOf}; break;
    case SimulatedFault::AcksLate: m.pipe.ackLate = N::kAcksLate; break;
    case SimulatedFault::AcksTwice: m.pipe.ackTwice = true; break;
    case SimulatedFault::PacketsLost: m.pipe.packetsLost = {1, N::kPipeLostOneOf}; break;
    case SimulatedFault::VanishesInTransfer:
      m.pipe.vanishAfter = N::kVanishesAfter;
      m.pipe.returnAfter = N::kVanishesFor;
      break;
  }
}

SimulatedFaults possibleFor(unsigned model) {
  SimulatedFaults faults = SimulatedFaults::all();
  const bool isMonitor = model == 6032;
  faults.set(SimulatedFault::EnableOff, isMonitor || model == 6033);
  for (const SimulatedFault own :
       {SimulatedFault::RotationSensorError, SimulatedFault::NotFitted, SimulatedFault::MotorAxis1})
    faults.set(own, isMonitor);
  return faults;
}

}  // namespace

Misbehaviour misbehaviourOf(const SimulatedFaults& faults) {
  Misbehaviour result;
  for (const SimulatedFault fault : kAllOf<SimulatedFault>) {
    if (faults.has(fault)) put(result, fault);
  }
  return result;
}

SimulatorStatus simulatorStatus(const simulator::StandardSimulator& simulator) {
  SimulatorStatus status;
  for (std::size_t i = 0; i < simulator.simulator.size(); ++i) {
    const simulator::Device& device = simulator.simulator.device(i);
    SimulatedDevice d;
    d.pin = device.identity().pin.value_or(Pin());
    // Digits 1-4 of a PIN are 1032 for a 6032; the one without a PIN is the 6039.
    d.model = d.pin.isNull() ? 6039 : d.pin.deviceType() + 5000;
    d.address = device.address();
    d.isPowered = device.isPowered();
    d.possible = possibleFor(d.model);
    status.devices.push_back(d);
  }
  return status;
}

}  // namespace deckpipe
