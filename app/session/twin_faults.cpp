// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/twin_faults.h"

namespace deckpipe {
namespace {

using simulator::Misbehaviour;
using N = TwinNumbers;

void put(Misbehaviour& m, TwinFault fault) {
  switch (fault) {
    case TwinFault::Silent: m.silent = true; break;
    case TwinFault::AddressTaken: m.addressTaken = true; break;
    case TwinFault::ReturnsElsewhere: m.elsewhere = true; break;
    case TwinFault::EnableOff: m.enableOff = true; break;
    case TwinFault::RotationSensorError: m.rotationSensorError = true; break;
    case TwinFault::NotFitted: m.feedbackNotFitted = true; break;
    case TwinFault::ResetNever: m.resetTakes = Misbehaviour::kForever; break;
    case TwinFault::InternalFuse: m.faultBits |= simulator::faultBit("internal_fuse"); break;
    case TwinFault::MotorAxis1: m.faultBits |= simulator::faultBit("motor_axis_1"); break;
    case TwinFault::OlderFaults: m.faultBits |= simulator::kOlderFaultBits; break;
    case TwinFault::OlderFirmware: m.answers.shortFault = true; break;
    case TwinFault::AnswersLost: m.answers.lost = {N::kAnswersLost, N::kAnswersOf}; break;
    case TwinFault::AnswersLate: m.answers.late = N::kAnswersLate; break;
    case TwinFault::AnswersTwice: m.answers.twice = true; break;
    case TwinFault::AnswersWrongLength: m.answers.wrongLength = true; break;
    case TwinFault::AnswersWrongSource: m.answers.wrongSource = true; break;
    case TwinFault::AcksLost: m.pipe.acksLost = {1, N::kPipeLostOneOf}; break;
    case TwinFault::AcksLate: m.pipe.ackLate = N::kAcksLate; break;
    case TwinFault::AcksTwice: m.pipe.ackTwice = true; break;
    case TwinFault::PacketsLost: m.pipe.packetsLost = {1, N::kPipeLostOneOf}; break;
    case TwinFault::VanishesInTransfer:
      m.pipe.vanishAfter = N::kVanishesAfter;
      m.pipe.returnAfter = N::kVanishesFor;
      break;
  }
}

TwinFaults possibleFor(unsigned model) {
  TwinFaults faults = TwinFaults::all();
  const bool isMonitor = model == 6032;
  faults.set(TwinFault::EnableOff, isMonitor || model == 6033);
  for (const TwinFault own : {TwinFault::RotationSensorError, TwinFault::NotFitted, TwinFault::MotorAxis1})
    faults.set(own, isMonitor);
  return faults;
}

}  // namespace

Misbehaviour misbehaviourOf(const TwinFaults& faults) {
  Misbehaviour result;
  for (const TwinFault fault : kAllOf<TwinFault>) {
    if (faults.has(fault)) put(result, fault);
  }
  return result;
}

simulator::Bench::Button buttonOf(TwinButton button) {
  using Button = simulator::Bench::Button;
  switch (button) {
    case TwinButton::PowerOff: return Button::PowerOff;
    case TwinButton::PowerOn: return Button::PowerOn;
    case TwinButton::Reset: break;
  }
  return Button::Reset;
}

TwinStatus twinStatus(const simulator::StandardBench& bench, const std::vector<TwinFaults>& intended) {
  TwinStatus status;
  for (std::size_t i = 0; i < bench.bench.size(); ++i) {
    const simulator::Device& device = bench.bench.device(i);
    TwinDevice d;
    d.pin = device.identity().pin.value_or(Pin());
    // Digits 1-4 of a PIN are 1032 for a 6032; the one without a PIN is the 6039.
    d.model = d.pin.isNull() ? 6039 : d.pin.deviceType() + 5000;
    d.address = device.address();
    d.isPowered = device.isPowered();
    d.faults = intended[i];
    d.possible = possibleFor(d.model);
    status.devices.push_back(d);
  }
  return status;
}

}  // namespace deckpipe
