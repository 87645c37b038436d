// SPDX-License-Identifier: GPL-3.0-or-later
// How much faster than the real truck the simulated one is.
#include <benchmark/benchmark.h>

#include "simulator/standard_simulator.h"

namespace deckpipe::simulator {
namespace {

void standardTruckFromDeadlineToDeadline(benchmark::State& state) {
  constexpr Duration kRun = 600s;
  for (auto _ : state) {
    StandardSimulator s = standardSimulator(1);
    s.simulator.powerOn({});
    for (Instant t = s.simulator.nextTime(); t <= Instant{} + kRun; t = s.simulator.nextTime())
      s.simulator.timeCame(t);
    std::vector<DueFrame> frames;
    s.simulator.takeFrames(frames);
    benchmark::DoNotOptimize(frames.data());
  }
  state.counters["times_real"] = benchmark::Counter(
      static_cast<double>(kRun / 1s) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(standardTruckFromDeadlineToDeadline)->Unit(benchmark::kMillisecond);

void sixtyMonitorsEveryMillisecond(benchmark::State& state) {
  constexpr Duration kRun = 20s;
  for (auto _ : state) {
    StandardSimulator s = standardSimulator(1, {}, 60);
    s.simulator.powerOn({});
    for (Instant t{}; t <= Instant{} + kRun; t = t + 1ms) s.simulator.timeCame(t);
  }
  state.counters["times_real"] = benchmark::Counter(
      static_cast<double>(kRun / 1s) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(sixtyMonitorsEveryMillisecond)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace deckpipe::simulator

BENCHMARK_MAIN();
