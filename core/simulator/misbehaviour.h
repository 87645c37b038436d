// SPDX-License-Identifier: GPL-3.0-or-later
// What a device of the simulator does wrong, on request: switched with Device::misbehave at any time, or for
// later with Simulator::misbehave. All off = a healthy device. What a device has no part for it leaves out (an
// I/O module has no position sensors). Words for all of it: misbehaviour_words.h.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/time.h"
#include "protocol/akron.h"

namespace deckpipe::simulator {

// Which of many alike go wrong, counted from 1 since the misbehaviour was set: the last `lost` of every `of`,
// or with `once` of the first `of` only. {1, 3} is every third.
struct Losses {
  unsigned lost = 0, of = 0;
  bool once = false;

  constexpr bool hits(unsigned number) const {
    if (of == 0 || number == 0 || (once && number > of)) return false;
    return (number - 1) % of + lost >= of;
  }
  friend bool operator==(const Losses&, const Losses&) = default;
};

// Answers to polls 02-05 and 21, acknowledgements of 41 and 46.
struct AnswerFaults {
  Losses lost{};
  Duration late{0};
  bool twice = false;
  bool wrongLength = false;
  bool wrongSource = false;  // they come from the next address, whosever that is
  bool shortFault = false;   // 02 is answered with 5 bytes, without a pCode error code: older firmware
  friend bool operator==(const AnswerFaults&, const AnswerFaults&) = default;
};

// The data pipe, message FE.
struct PipeFaults {
  Losses acksLost{};        // of packets that were taken
  Losses packetsUnheard{};  // packets to the device: neither taken nor acknowledged
  Losses packetsLost{};     // packets of the device: never on the bus, and so never acknowledged
  Duration ackLate{0};
  bool ackTwice = false;
  unsigned vanishAfter = 0;  // after so many data packets, either way, its power goes off, once; 0 = never
  Duration returnAfter{0};   // … and comes back so much later; 0 = never
  friend bool operator==(const PipeFaults&, const PipeFaults&) = default;
};

struct Misbehaviour {
  // From a reset to the new claim; ours, the manual does not say.
  static constexpr Duration kReset = 1500ms;
  static constexpr Duration kForever = Duration::max();

  bool silent = false;        // sends nothing, but hears and moves on: a broken transmitter
  bool wrongLengths = false;  // Akron and joystick messages are a byte short, or one too long at one byte
  bool rotationSensorError = false;   // 6032
  bool elevationSensorError = false;  // 6032
  bool feedbackNotFitted = false;     // 6032: positions not fitted, no 81 and 82, no stow, oscillation or aim
  bool addressTaken = false;  // a foreign controller with a lower NAME claims its address (done by Simulator)
  bool elsewhere = false;     // whenever it starts anew it claims another address than before
  bool enableOff = false;     // 6032, 6033: the enable input is off; CAN goes on and nothing moves
  Duration late{0};           // periodic frames come this much later
  Duration jitter{0};         // … and up to this much later still, seeded
  Duration resetTakes{kReset};   // kForever: it never comes back
  std::uint32_t faultBits = 0;   // fault map of type 02, see faultBit(); a motor's fault also stops its axis
  std::uint16_t pcodeError = 0;  // instead of the code of what is really wrong
  AnswerFaults answers{};
  PipeFaults pipe{};

  friend bool operator==(const Misbehaviour&, const Misbehaviour&) = default;
};

// The bit of a fault by its key in the catalogue, e.g. faultBit("motor_axis_1").
consteval std::uint32_t faultBit(std::string_view key) {
  for (const ValueName& fault : akron::kFaultBits) {
    if (fault.word == key) return 1u << fault.value;
  }
  throw "no fault of that key";
}

// Bits that only older 6032 manuals name: pCode faults 1-4 and the real-time clock.
inline constexpr std::uint32_t kOlderFaultBits = 0xFu << 17 | 1u << 22;

}  // namespace deckpipe::simulator
