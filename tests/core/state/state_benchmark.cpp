// SPDX-License-Identifier: GPL-3.0-or-later
// How fast frames become state, values and lines, each against a floor measured in the same run: a walk over
// the same frames that only looks at their identifiers.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <random>

#include "protocol/role_walk.h"
#include "protocol/typed.h"
#include "report/decode_lines.h"
#include "simulator/standard_simulator.h"
#include "state/events.h"
#include "state/keyframes.h"
#include "state/role_index.h"

namespace deckpipe {
namespace {

constexpr std::uint64_t kFrames = 10'000'000;

// Ten million frames of a working truck: a simulated quarter of an hour, over and over.
struct Log {
  FrameStore frames{{.memoryBytes = std::uint64_t{4} << 30, .spillFolder = "/var/tmp"}};
  NoteStore notes;
  Keyframes keyframes{frames, notes};
  RoleIndex roles{frames, notes};

  Log() {
    simulator::StandardSimulator simulator = simulator::standardSimulator(1);
    std::vector<simulator::DueFrame> due;
    simulator.simulator.powerOn({});
    const Instant end{900'000'000'000};
    while (simulator.simulator.nextTime() < end) {
      simulator.simulator.timeCame(simulator.simulator.nextTime());
      simulator.simulator.takeFrames(due);
    }
    std::vector<Frame> batch;
    for (std::uint64_t n = 0, round = 0; n < kFrames; ++round) {
      batch.clear();
      for (const simulator::DueFrame& frame : due) {
        if (n++ >= kFrames) break;
        batch.push_back(frame.frame);
        batch.back().stamp = frame.time.ns + static_cast<std::int64_t>(round) * end.ns;
      }
      if (!frames.append(batch)) std::abort();
    }
  }
};

Log& log() {
  static Log all;
  return all;
}

template <typename Each>
void walk(Each each) {
  const FrameStore& frames = log().frames;
  for (std::uint64_t i = 0; i < frames.count();) {
    for (const Frame& frame : frames.run(i)) each(i++, frame);
  }
}

void count(benchmark::State& state, std::uint64_t frames = kFrames) {
  state.counters["frames/s"] =
      benchmark::Counter(static_cast<double>(frames), benchmark::Counter::kIsIterationInvariantRate);
}

void floorScanByIdAndByte(benchmark::State& state) {
  log();
  for (auto _ : state) {
    std::uint64_t found = 0;
    walk([&](std::uint64_t, const Frame& frame) {
      found += (frame.identifier() & 0xFFFF00) == 0xEFFF00 && frame.data[0] == 1;
    });
    benchmark::DoNotOptimize(found);
  }
  count(state);
}
BENCHMARK(floorScanByIdAndByte)->Unit(benchmark::kMillisecond);

void typedDecodeOfPositions(benchmark::State& state) {
  std::vector<Frame> positions;
  walk([&](std::uint64_t, const Frame& frame) {
    if ((frame.identifier() & 0xFFFF00) == 0xEFFF00 && frame.data[0] == 1 && positions.size() < 100'000)
      positions.push_back(frame);
  });
  for (auto _ : state) {
    std::int64_t sum = 0;
    for (const Frame& frame : positions) {
      const PositionLimitStatus status = PositionLimitStatus::of(frame);
      sum += status.rotation.tenths + status.elevation.tenths + static_cast<int>(status.plusStop[4]);
    }
    benchmark::DoNotOptimize(sum);
  }
  count(state, positions.size());
}
BENCHMARK(typedDecodeOfPositions)->Unit(benchmark::kMillisecond);

void classifyEveryFrame(benchmark::State& state) {
  for (auto _ : state) {
    RoleWalk roles;
    LogTimes times(log().frames);
    std::uint64_t decoded = 0;
    walk([&](std::uint64_t i, const Frame& frame) { decoded += roles.next(frame, times.at(i)).isDecoded(); });
    benchmark::DoNotOptimize(decoded);
  }
  count(state);
}
BENCHMARK(classifyEveryFrame)->Unit(benchmark::kMillisecond);

void indexRoles(benchmark::State& state) {
  for (auto _ : state) {
    RoleIndex index(log().frames, log().notes);
    while (index.build(Keyframes::kEvery)) {
    }
  }
  count(state);
}
BENCHMARK(indexRoles)->Unit(benchmark::kMillisecond);

void advanceThroughEveryFrame(benchmark::State& state) {
  for (auto _ : state) {
    State s;
    advance(s, log().frames, log().notes, cursorAfter(log().frames, kFrames));
    benchmark::DoNotOptimize(s.cursor().frames);
  }
  count(state);
}
BENCHMARK(advanceThroughEveryFrame)->Unit(benchmark::kMillisecond);

// With keyframes on the way, as the console does while it reads a log. Its floor is the walk of a state alone, with
// the same keyframes.
void findEvents(benchmark::State& state) {
  const Cursor end = cursorAfter(log().frames, kFrames);
  std::clock_t plain = 0, withEvents = 0;  // of the processor: others may use the machine
  for (auto _ : state) {
    const std::clock_t start = std::clock();
    {
      Keyframes keyframes(log().frames, log().notes);
      while (keyframes.build()) {
      }
      benchmark::DoNotOptimize(keyframes.at(end).cursor().frames);
    }
    const std::clock_t between = std::clock();
    Keyframes keyframes(log().frames, log().notes);
    Events events(log().frames, log().notes, keyframes);
    while (events.build(end)) {
    }
    plain += between - start;
    withEvents += std::clock() - between;
    state.counters["events"] = static_cast<double>(events.count());
  }
  state.counters["of a plain walk"] = static_cast<double>(withEvents) / static_cast<double>(plain);
}
BENCHMARK(findEvents)->Unit(benchmark::kMillisecond)->Iterations(3);

void stateAtAnyInstant(benchmark::State& state) {
  while (log().keyframes.build()) {
  }
  std::mt19937_64 random(1);
  std::vector<double> milliseconds;
  for (auto _ : state) {
    const std::uint64_t n = random() % kFrames + 1;
    const auto start = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(log().keyframes.at(cursorAfter(log().frames, n)).cursor());
    milliseconds.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  std::ranges::sort(milliseconds);
  state.counters["p99 ms"] = milliseconds[milliseconds.size() * 99 / 100];
}
BENCHMARK(stateAtAnyInstant)->Iterations(1000)->Unit(benchmark::kMillisecond);

void jsonLines(benchmark::State& state) {
  constexpr std::uint64_t kSome = 1'000'000;
  for (auto _ : state) {
    RoleWalk roles;
    LogTimes times(log().frames);
    std::string out;
    std::uint64_t bytes = 0;
    for (std::uint64_t i = 0; i < kSome; ++i) {
      const Frame& frame = log().frames[i];
      appendDecoded(out, DecodeFormat::JsonLines, frame, "can0", roles.next(frame, times.at(i)));
      if (out.size() < 256 * 1024) continue;
      bytes += out.size();
      out.clear();
    }
    benchmark::DoNotOptimize(bytes);
  }
  count(state, kSome);
}
BENCHMARK(jsonLines)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace deckpipe

BENCHMARK_MAIN();
