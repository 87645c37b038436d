// SPDX-License-Identifier: GPL-3.0-or-later
// What a person wants of the demo's bench twin, and how its devices are. The twin panel makes a TwinIntent of
// every tick and button and shows each TwinStatus; BenchRunner takes the intents and publishes the status. Not
// an intent: it goes to the simulated truck, never to a bus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <variant>
#include <vector>

#include "base/enum_table.h"
#include "base/ids.h"
#include "base/time.h"

namespace deckpipe {

// How much of it there is: said by the panel, done by the twin.
struct TwinNumbers {
  static constexpr unsigned kAnswersLost = 2, kAnswersOf = 3;
  static constexpr unsigned kPipeLostOneOf = 10;  // acknowledgements, packets
  static constexpr Duration kAnswersLate = 800ms, kAcksLate = 400ms;
  static constexpr unsigned kVanishesAfter = 50;  // packets of the pipe, either way
  static constexpr Duration kVanishesFor = 3s;
};

// What can be wrong with a device.
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
template <>
inline constexpr TwinFault kLastOf<TwinFault> = TwinFault::VanishesInTransfer;

class TwinFaults {
 public:
  constexpr TwinFaults() = default;
  TwinFaults(std::initializer_list<TwinFault> faults) {
    for (const TwinFault fault : faults) set(fault);
  }
  static TwinFaults all() {
    TwinFaults faults;
    for (const TwinFault fault : kAllOf<TwinFault>) faults.set(fault);
    return faults;
  }
  bool has(TwinFault fault) const { return m_faults.has(fault); }
  void set(TwinFault fault, bool on = true) { on ? m_faults.add(fault) : m_faults.remove(fault); }
  bool isNone() const { return m_faults.isEmpty(); }
  friend bool operator==(const TwinFaults&, const TwinFaults&) = default;

 private:
  EnumSet<TwinFault> m_faults;
};

enum class TwinButton : std::uint8_t { PowerOff, PowerOn, Reset };

// One fault on or off: two that follow each other before the twin has answered do not undo each other.
struct TwinSwitch {
  TwinFault fault{};
  bool on = false;
  friend bool operator==(const TwinSwitch&, const TwinSwitch&) = default;
};
// No fault any more.
struct TwinAllWell {
  friend bool operator==(const TwinAllWell&, const TwinAllWell&) = default;
};

struct TwinIntent {
  std::size_t device = 0;  // as in TwinStatus
  std::variant<TwinSwitch, TwinAllWell, TwinButton> what;
  friend bool operator==(const TwinIntent&, const TwinIntent&) = default;
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
