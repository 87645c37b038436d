// SPDX-License-Identifier: GPL-3.0-or-later
// The truck of the demo: a 6032 on a Trident, a 6033 riser, a 6039 I/O module and a 6035 joystick whose hand
// follows a script. They power up together and are ready after a boot time each, contending for addresses
// from 80 hex up. More 6032s can be on the bus, to see what a console does with many; a real bus of 250
// kbit/s is full with forty.
#pragma once

#include "simulator/axis.h"
#include "simulator/device.h"
#include "simulator/joystick_6035.h"
#include "simulator/joystick_inputs.h"
#include "simulator/monitor_6032.h"
#include "simulator/simulator.h"

namespace deckpipe::simulator {

// The simulated 6033 Mini Universal: a riser that takes six seconds between retracted and extended, and
// message 84. It obeys the joysticks' deploy and stow switches; the riser command bits of message 83 have no
// meaning given, so it does not obey those.
// Source: CAN Messaging manual, message type 84.
class MiniUniversal6033 : public Device {
 public:
  static constexpr Duration kStatusPeriod = 100ms;
  static constexpr Duration kTravelTime = 6s;

  MiniUniversal6033(std::string_view pin, std::uint64_t seed);

  bool isRetracted() const { return m_riser.isAtLow(); }
  bool isExtended() const { return m_riser.isAtHigh(); }
  // Millionths of the travel.
  int extended() const { return m_riser.travelled(); }

 protected:
  void started(Instant now) override;
  void tick(Instant now) override;
  void heard(Instant now, const J1939Id& id, const Frame& frame) override;

 private:
  JoystickInputs m_inputs;
  Axis m_riser;
  Functions m_before;
};

// The simulated 6039 CAN I/O module: message 85 with its three inputs. There is no 6039 among the device
// types of a PIN, so it has a NAME and makes no announcement. Its collision-zone input follows a seeded
// script until somebody sets the inputs. Source: CAN Messaging manual, message type 85 and Appendix A.
class IoModule6039 : public Device {
 public:
  static constexpr Duration kStatusPeriod = 100ms;

  IoModule6039(std::uint32_t identityNumber, std::uint64_t seed);

  const DigitalInputs& inputs() const { return m_inputs; }
  // From now on the inputs are these, and the script is over.
  void setInputs(const DigitalInputs& inputs);

 protected:
  void started(Instant now) override;
  void tick(Instant now) override;

 private:
  DigitalInputs m_inputs;
  Random m_random;
  Instant m_changeAt = kNever;
  bool m_scripted = true;
};

// The devices belong to the simulator; index them in Simulator::misbehave in this order.
struct StandardSimulator {
  Simulator simulator;
  Monitor6032* monitor = nullptr;
  MiniUniversal6033* riser = nullptr;
  IoModule6039* ioModule = nullptr;
  Joystick6035* joystick = nullptr;
  std::vector<Monitor6032*> others;  // more monitors, after the four
};

inline constexpr unsigned kMaxMonitors = 60;
StandardSimulator standardSimulator(std::uint64_t seed, const MonitorSettings& settings = {},
                                    unsigned monitors = 1);

}  // namespace deckpipe::simulator
