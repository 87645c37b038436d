// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/standard_bench.h"

namespace deckpipe::simulator {

StandardBench standardBench(std::uint64_t seed, const MonitorSettings& settings) {
  Random random(seed);
  const auto boot = [&] { return random.between(300, 1500) * Duration(1ms); };
  StandardBench s;
  s.monitor = &s.bench.add<Monitor6032>(boot(), "1032AE100801035", settings, random.next());
  s.riser = &s.bench.add<MiniUniversal6033>(boot(), "1033AE100802117", random.next());
  s.ioModule = &s.bench.add<IoModule6039>(boot(), 0x0F3A21u, random.next());
  s.joystick = &s.bench.add<Joystick6035>(boot(), "1035AE100804442", Address{0x33}, random.next());
  return s;
}

}  // namespace deckpipe::simulator
