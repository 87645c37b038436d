// SPDX-License-Identifier: GPL-3.0-or-later
// The truck of the demo: a 6032 on a Trident, a 6033 riser, a 6039 I/O module and a 6035 joystick whose hand
// follows a script. They power up together and are ready after a boot time each, contending for addresses
// from 80 hex up. More 6032s can be on the bus, to see what a console does with many; a real bus of 250
// kbit/s is full with forty.
#pragma once

#include "simulator/io_module_6039.h"
#include "simulator/joystick_6035.h"
#include "simulator/mini_universal_6033.h"
#include "simulator/monitor_6032.h"
#include "simulator/simulator.h"

namespace deckpipe::simulator {

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
