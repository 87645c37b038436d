// SPDX-License-Identifier: GPL-3.0-or-later
// The trace over ten million frames: filters against a bare scan of the same records in the same run, the
// step that the window takes on a tick, and the table by identifier after a jump of the cursor.
#include <benchmark/benchmark.h>

#include <chrono>
#include <thread>

#include "model/filter_worker.h"
#include "model/id_model.h"
#include "model/trace_model.h"

namespace deckpipe {
namespace {

constexpr std::uint64_t kFrames = 10'000'000;

std::shared_ptr<LogDocument> bigLog() {
  static const auto kLog = [] {
    auto log = std::make_shared<LogDocument>();
    log->frames.channel("can0");
    std::vector<Frame> block(100'000);
    for (std::uint64_t at = 0; at < kFrames; at += block.size()) {
      for (std::size_t i = 0; i < block.size(); ++i) {
        Frame& frame = block[i];
        const std::uint64_t n = at + i;
        frame.id = (n % 3 == 0 ? 0x0CFDD633u : 0x18EFFF80u + static_cast<unsigned>(n % 4)) | kExtendedBit;
        frame.data = {0x01, static_cast<std::uint8_t>(n >> 8), static_cast<std::uint8_t>(n & 0xF4), 3, 0x71};
        frame.length = 8;
        frame.stamp = static_cast<std::int64_t>(n) * 100'000;
      }
      if (!log->frames.append(block)) std::abort();
    }
    while (log->roles.build(kFrames)) {
    }
    return log;
  }();
  return kLog;
}

double bareScan() {
  const auto log = bigLog();
  const auto begin = std::chrono::steady_clock::now();
  std::uint64_t hits = 0;
  for (std::uint64_t i = 0; i < kFrames;) {
    const auto run = log->frames.run(i);
    for (const Frame& frame : run) hits += (frame.id & 0xFF) == 0x80 && frame.data[0] == 1 ? 1 : 0;
    i += run.size();
  }
  benchmark::DoNotOptimize(hits);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void filter(benchmark::State& state, const char* expression) {
  const auto log = bigLog();
  const double bare = bareScan();
  double taken = 0;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    const FilterWorker worker(log, TraceFilter::parse(QString::fromUtf8(expression)).value());
    while (worker.rows().scanned() < kFrames) std::this_thread::yield();
    taken += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  const double each = taken / static_cast<double>(state.iterations());
  state.counters["bare/filter"] = bare / each;
  state.counters["Mframes/s"] = static_cast<double>(kFrames) / each / 1e6;
}
BENCHMARK_CAPTURE(filter, bytes, "pgn=EF00 and sa=80")->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK_CAPTURE(filter, meaning, "rotation_deg>30")->Unit(benchmark::kMillisecond)->Iterations(3);

// A tick of the window: the log has grown, a page in sight, with or without a filter.
void tick(benchmark::State& state, const char* expression) {
  const auto log = bigLog();
  TraceModel model;
  LogView view;
  view.document = log;
  view.frameCount = kFrames;
  view.end = log->frames.lastTime();
  view.cursor = cursorAfter(log->frames, kFrames);
  model.setView(view);
  model.setFilter(TraceFilter::parse(QString::fromUtf8(expression)).value());
  while (model.isFiltering()) model.refresh();
  std::uint64_t row = 0;
  for (auto _ : state) {
    row = (row + 7'919) % (model.rows() - 100);  // scrolled far, so that every row is new
    model.setWindow(row, 100);
    model.refresh();
  }
}
BENCHMARK_CAPTURE(tick, all, "")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(tick, filtered, "rotation_deg>30")->Unit(benchmark::kMicrosecond);

// The walk from the copy before the cursor, at its longest.
void tableAfterSeek(benchmark::State& state) {
  const auto log = bigLog();
  for (auto _ : state) {
    IdTable table;
    table.walk(log->frames, 131'072);
    benchmark::DoNotOptimize(table);
  }
}
BENCHMARK(tableAfterSeek)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace deckpipe

BENCHMARK_MAIN();
