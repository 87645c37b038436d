// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/standard_simulator.h"

#include <algorithm>
#include <numeric>

namespace deckpipe::simulator {
namespace {

// When the n-th of so many more monitors is ready, so that their statuses share each 100 ms evenly: steps of
// about a fifth of the period, over a count that they have no divisor in common with.
Duration bootOf(unsigned n, unsigned count) {
  unsigned step = std::max(1u, count / 5);
  while (std::gcd(step, count) != 1) ++step;
  return 1600ms + Monitor6032::kStatusPeriod * (n * step) / count;
}

}  // namespace

StandardSimulator standardSimulator(std::uint64_t seed, const MonitorSettings& settings, unsigned monitors) {
  Random random(seed);
  const auto boot = [&] { return random.between(300, 1500) * Duration(1ms); };
  StandardSimulator s;
  s.monitor = &s.simulator.add<Monitor6032>(boot(), "1032AE100801035", settings, random.next());
  s.riser = &s.simulator.add<MiniUniversal6033>(boot(), "1033AE100802117", random.next());
  s.ioModule = &s.simulator.add<IoModule6039>(boot(), 0x0F3A21u, random.next());
  s.joystick = &s.simulator.add<Joystick6035>(boot(), "1035AE100804442", Address{0x33}, random.next());
  for (unsigned n = 1; n < std::min(monitors, kMaxMonitors); ++n) {
    const Pin pin = *Pin::make(1032, 'A', 'E', 100'801'100 + n);
    s.others.push_back(
        &s.simulator.add<Monitor6032>(bootOf(n, monitors), pin.text(), settings, random.next()));
  }
  return s;
}

}  // namespace deckpipe::simulator
