// SPDX-License-Identifier: GPL-3.0-or-later
// What a device of the bench twin does wrong, on request: switched with Device::misbehave at any time, or for
// later with Bench::misbehave. All off = a healthy device. What a device has no part for it leaves out (an
// I/O module has no position sensors).
#pragma once

#include <cstdint>
#include <string_view>

#include "base/time.h"
#include "protocol/akron.h"

namespace deckpipe::simulator {

struct Misbehaviour {
  bool silent = false;        // sends nothing, but hears and moves on: a broken transmitter
  bool wrongLengths = false;  // Akron and joystick messages are a byte short, or one too long at one byte
  bool rotationSensorError = false;   // 6032
  bool elevationSensorError = false;  // 6032
  bool feedbackNotFitted = false;     // 6032: positions not fitted, no 81 and 82, no stow, oscillation or aim
  bool addressTaken = false;    // a foreign controller with a lower NAME claims its address (done by Bench)
  bool enableOff = false;       // 6032, 6033: the enable input is off; CAN goes on and nothing moves
  Duration late{0};             // periodic frames come this much later
  Duration jitter{0};           // … and up to this much later still, seeded
  std::uint32_t faultBits = 0;  // fault map of type 02, see faultBit(); a motor's fault also stops its axis

  friend bool operator==(const Misbehaviour&, const Misbehaviour&) = default;
};

// The bit of a fault by its key in the catalogue, e.g. faultBit("motor_axis_1").
consteval std::uint32_t faultBit(std::string_view key) {
  for (const ValueName& fault : akron::kFaultBits) {
    if (fault.word == key) return 1u << fault.value;
  }
  throw "no fault of that key";
}

}  // namespace deckpipe::simulator
