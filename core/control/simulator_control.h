// SPDX-License-Identifier: GPL-3.0-or-later
// The values between the simulator's panel and the simulator. The panel makes a SimulatorIntent of every tick and button
// and shows each SimulatorStatus; SimulatorRunner takes the intents and publishes the status. A SimulatorIntent goes to
// the simulated truck alone; an Intent (control/intent.h) goes to a bus.
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

// How much of it there is: said by the panel, done by the simulator.
struct SimulatorNumbers {
  static constexpr unsigned kAnswersLost = 2, kAnswersOf = 3;
  static constexpr unsigned kPipeLostOneOf = 10;  // acknowledgements, packets
  static constexpr Duration kAnswersLate = 800ms, kAcksLate = 400ms;
  static constexpr unsigned kVanishesAfter = 50;  // packets of the pipe, either way
  static constexpr Duration kVanishesFor = 3s;
};

// The faults that the simulator can give a device.
enum class SimulatedFault : std::uint8_t {
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
inline constexpr SimulatedFault kLastOf<SimulatedFault> = SimulatedFault::VanishesInTransfer;

class SimulatedFaults {
 public:
  constexpr SimulatedFaults() = default;
  SimulatedFaults(std::initializer_list<SimulatedFault> faults) {
    for (const SimulatedFault fault : faults) set(fault);
  }
  static SimulatedFaults all() {
    SimulatedFaults faults;
    for (const SimulatedFault fault : kAllOf<SimulatedFault>) faults.set(fault);
    return faults;
  }
  bool has(SimulatedFault fault) const { return m_faults.has(fault); }
  void set(SimulatedFault fault, bool on = true) { on ? m_faults.add(fault) : m_faults.remove(fault); }
  bool isNone() const { return m_faults.isEmpty(); }
  friend bool operator==(const SimulatedFaults&, const SimulatedFaults&) = default;

 private:
  EnumSet<SimulatedFault> m_faults;
};

enum class SimulatorButton : std::uint8_t { PowerOff, PowerOn, Reset };

// One fault on or off: two that follow each other before the simulator has answered do not undo each other.
struct SimulatorSwitch {
  SimulatedFault fault{};
  bool on = false;
  friend bool operator==(const SimulatorSwitch&, const SimulatorSwitch&) = default;
};
// No fault any more.
struct SimulatorAllWell {
  friend bool operator==(const SimulatorAllWell&, const SimulatorAllWell&) = default;
};

struct SimulatorIntent {
  std::size_t device = 0;  // as in SimulatorStatus
  std::variant<SimulatorSwitch, SimulatorAllWell, SimulatorButton> what;
  friend bool operator==(const SimulatorIntent&, const SimulatorIntent&) = default;
};

struct SimulatedDevice {
  Pin pin;             // null: it has none
  unsigned model = 0;  // 6032
  Address address{};   // null while it has none
  bool isPowered = false;
  SimulatedFaults faults;
  SimulatedFaults possible;  // those that mean something to such a device
  friend bool operator==(const SimulatedDevice&, const SimulatedDevice&) = default;
};

// In the order in which the simulator has them; none: no simulator runs.
struct SimulatorStatus {
  std::vector<SimulatedDevice> devices;
  friend bool operator==(const SimulatorStatus&, const SimulatorStatus&) = default;
};

}  // namespace deckpipe
