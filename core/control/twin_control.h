// SPDX-License-Identifier: GPL-3.0-or-later
// What a person wants of the demo's bench twin, and how its devices are. The twin panel makes a TwinWish of
// every tick and button and shows each TwinStatus; BenchRunner takes the wishes and publishes the status. Not
// an intent: it goes to the simulated truck, never to a bus.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <variant>
#include <vector>

#include "base/ids.h"

namespace deckpipe {

// What can be wrong with a device. The numbers in it (every third, 800 ms) are BenchRunner's own.
enum class TwinFault : std::uint8_t {
  // The device as a whole.
  Silent,
  AddressTaken,
  ReturnsElsewhere,
  EnableOff,
  RotationSensorError,
  NotFitted,
  ResetNever,
  // What it answers to a fault poll.
  InternalFuse,
  MotorAxis1,
  OlderFaults,
  OlderFirmware,
  // Its answers.
  AnswersLost,
  AnswersLate,
  AnswersTwice,
  AnswersWrongLength,
  AnswersWrongSource,
  // Its end of the data pipe.
  AcksLost,
  AcksLate,
  AcksTwice,
  PacketsLost,
  VanishesInTransfer,
};
inline constexpr std::size_t kTwinFaults = static_cast<std::size_t>(TwinFault::VanishesInTransfer) + 1;

class TwinFaults {
 public:
  constexpr TwinFaults() = default;
  TwinFaults(std::initializer_list<TwinFault> faults) {
    for (const TwinFault fault : faults) set(fault);
  }
  static TwinFaults all() {
    TwinFaults faults;
    faults.m_bits.set();
    return faults;
  }
  bool has(TwinFault fault) const { return m_bits[static_cast<std::size_t>(fault)]; }
  void set(TwinFault fault, bool on = true) { m_bits[static_cast<std::size_t>(fault)] = on; }
  bool isNone() const { return m_bits.none(); }
  friend bool operator==(const TwinFaults&, const TwinFaults&) = default;

 private:
  std::bitset<kTwinFaults> m_bits;
};

enum class TwinButton : std::uint8_t { PowerOff, PowerOn, Reset };

struct TwinWish {
  std::size_t device = 0;  // as in TwinStatus
  std::variant<TwinFaults, TwinButton> what;
  friend bool operator==(const TwinWish&, const TwinWish&) = default;
};

struct TwinDevice {
  Pin pin;             // null: it has none
  unsigned model = 0;  // 6032
  Address address{};   // null while it has none
  bool isPowered = false;
  TwinFaults faults;
  TwinFaults possible;  // those that mean something to such a device
  friend bool operator==(const TwinDevice&, const TwinDevice&) = default;
};

// In the order in which the twin has them; none: no twin runs.
struct TwinStatus {
  std::vector<TwinDevice> devices;
  friend bool operator==(const TwinStatus&, const TwinStatus&) = default;
};

}  // namespace deckpipe
