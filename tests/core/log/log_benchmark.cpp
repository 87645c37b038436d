// SPDX-License-Identifier: GPL-3.0-or-later
// How fast a candump log opens, beside a bare parser in the same run that knows one layout, checks nothing
// and keeps nothing but the records; how fast the store is scanned and searched. Asserts nothing.
//   of_bare_parse  best time of the bare parser / best time of ours, threads alike
//   first_rows_ms  until the first frames can be drawn
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "log/candump.h"
#include "log/frame_store.h"

namespace deckpipe {
namespace {

constexpr std::uint64_t kFrames = 10'000'000;

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// A log of lines of one length, two interfaces and 32 identifiers; removed at the end.
class LogFile {
 public:
  LogFile()
      : m_path(std::filesystem::temp_directory_path() /
               ("log_benchmark-" + std::to_string(getpid()) + ".log")) {
    std::mt19937_64 random(1);
    std::string text;
    std::FILE* file = std::fopen(m_path.c_str(), "w");
    Frame frame;
    frame.stamp = 1'700'000'000'000'000'000;
    frame.length = 8;
    for (std::uint64_t i = 0; i < kFrames; ++i) {
      const std::uint64_t bits = random();
      frame.stamp += static_cast<std::int64_t>(100 + bits % 100) * 1000;
      frame.id = kExtendedBit | (0x18EF'FF80 + static_cast<std::uint32_t>(bits >> 8 & 0x1F));
      frame.data = std::bit_cast<Payload>(bits);
      writeCandump(frame, bits >> 20 & 1 ? "can1" : "can0", text);
      if (text.size() > 1 << 20 || i + 1 == kFrames) {
        std::fwrite(text.data(), 1, text.size(), file);
        text.clear();
      }
    }
    std::fclose(file);
  }
  ~LogFile() { std::filesystem::remove(m_path); }
  const std::string& path() const { return m_path; }

 private:
  std::string m_path;
};

const std::string& logFile() {
  static const LogFile file;
  return file.path();
}

void bareLines(const char* p, const char* end, Frame* to) {
  static constexpr auto digits = [] {
    std::array<unsigned char, 256> values{};
    for (unsigned i = 0; i < 16; ++i)
      values[static_cast<unsigned char>("0123456789ABCDEF"[i])] = static_cast<unsigned char>(i);
    return values;
  }();
  const auto pair = [](const char* c) {
    return static_cast<std::uint8_t>(digits[static_cast<unsigned char>(c[0])] << 4 |
                                     digits[static_cast<unsigned char>(c[1])]);
  };
  for (; p < end; ++to) {
    std::int64_t second = 0, micro = 0;
    for (int i = 1; i < 11; ++i) second = second * 10 + (p[i] - '0');
    for (int i = 12; i < 18; ++i) micro = micro * 10 + (p[i] - '0');
    to->stamp = second * 1'000'000'000 + micro * 1000;
    to->channel = static_cast<std::uint8_t>(p[23] - '0');
    to->id = kExtendedBit | static_cast<std::uint32_t>(pair(p + 25)) << 24 |
             static_cast<std::uint32_t>(pair(p + 27)) << 16 | static_cast<std::uint32_t>(pair(p + 29)) << 8 |
             pair(p + 31);
    p += 34;
    unsigned n = 0;
    for (; *p != '\n'; p += 2) to->data[n++] = pair(p);
    to->length = static_cast<std::uint8_t>(n);
    ++p;
  }
}

double bareParse(std::size_t threads) {
  const double start = secondsNow();
  const int file = open(logFile().c_str(), O_RDONLY);
  const auto size = static_cast<std::size_t>(lseek(file, 0, SEEK_END));
  void* map = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  void* memory =
      mmap(nullptr, kFrames * sizeof(Frame), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  madvise(memory, kFrames * sizeof(Frame), MADV_HUGEPAGE);
  const auto* text = static_cast<const char*>(map);
  const std::size_t line = size / kFrames;  // all are of one length
  std::vector<std::thread> others;
  for (std::size_t t = 0; t < threads; ++t) {
    const std::uint64_t from = kFrames * t / threads, to = kFrames * (t + 1) / threads;
    const auto part = [=] {
      bareLines(text + from * line, text + to * line, static_cast<Frame*>(memory) + from);
    };
    if (t + 1 < threads) {
      others.emplace_back(part);
    } else {
      part();
    }
  }
  for (std::thread& other : others) other.join();
  benchmark::DoNotOptimize(static_cast<Frame*>(memory)[kFrames - 1].stamp);
  const double seconds = secondsNow() - start;
  munmap(memory, kFrames * sizeof(Frame));
  munmap(map, size);
  close(file);
  return seconds;
}

void openCandump(benchmark::State& state) {
  const std::string path = logFile();
  double bestBare = 1e9, best = 1e9, bestFirst = 1e9;
  for (auto _ : state) {
    bestBare = std::min(bestBare, bareParse(static_cast<std::size_t>(state.range(0))));
    const double start = secondsNow();
    double first = 0;
    const auto store = std::make_unique<FrameStore>();
    SkippedList skipped;
    ReadOptions options;
    options.threads = static_cast<unsigned>(state.range(0));
    options.onProgress = [&first](const ReadProgress&) {
      if (first == 0) first = secondsNow();
      return true;
    };
    if (!openLog(path, {*store, skipped}, options) || store->count() != kFrames)
      state.SkipWithError("not read");
    const double seconds = secondsNow() - start;
    state.SetIterationTime(seconds);
    best = std::min(best, seconds);
    bestFirst = std::min(bestFirst, first - start);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kFrames));
  state.counters["best_per_s"] = static_cast<double>(kFrames) / best;
  state.counters["bare_per_s"] = static_cast<double>(kFrames) / bestBare;
  state.counters["of_bare_parse"] = bestBare / best;
  state.counters["first_rows_ms"] = bestFirst * 1e3;
}

const FrameStore& filledStore() {
  static const std::unique_ptr<FrameStore> store = [] {
    auto filled = std::make_unique<FrameStore>();
    SkippedList skipped;
    if (!openLog(logFile(), {*filled, skipped})) std::abort();
    return filled;
  }();
  return *store;
}

std::uint64_t matches(std::span<const Frame> frames) {
  std::uint64_t found = 0;
  for (const Frame& frame : frames)
    found += (frame.id == (kExtendedBit | 0x18EF'FF85)) & (frame.data[0] == 1);
  return found;
}

void scanById(benchmark::State& state) {
  const FrameStore& store = filledStore();
  for (auto _ : state) {
    std::uint64_t found = 0;
    std::span<const Frame> run;
    for (std::uint64_t i = 0; i < store.count(); i += run.size()) found += matches(run = store.run(i));
    benchmark::DoNotOptimize(found);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kFrames));
}

// The floor of scanById: the same frames in one array.
void scanPlainArray(benchmark::State& state) {
  const FrameStore& store = filledStore();
  std::vector<Frame> frames(kFrames);
  for (std::uint64_t i = 0; i < kFrames; ++i) frames[i] = store[i];
  for (auto _ : state) benchmark::DoNotOptimize(matches(frames));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kFrames));
}

std::vector<Instant> randomTimes(const FrameStore& store) {
  std::mt19937_64 random(2);
  std::vector<Instant> all(4096);
  for (Instant& t : all) t = store.timeAt(random() % store.count()) + Duration{1};
  return all;
}

void lookUpByTime(benchmark::State& state) {
  const FrameStore& store = filledStore();
  const std::vector<Instant> asked = randomTimes(store);
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(store.firstAtOrAfter(asked[k++ % asked.size()]));
}

void timeOfAFrame(benchmark::State& state) {
  const FrameStore& store = filledStore();
  std::mt19937_64 random(3);
  for (auto _ : state) benchmark::DoNotOptimize(store.timeAt(random() % kFrames));
}

void timesInOrder(benchmark::State& state) {
  const FrameStore& store = filledStore();
  for (auto _ : state) {
    LogTimes times(store);
    for (std::uint64_t i = 0; i < kFrames; ++i) benchmark::DoNotOptimize(times.at(i));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kFrames));
}

BENCHMARK(openCandump)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(8);
BENCHMARK(scanById)->Unit(benchmark::kMillisecond);
BENCHMARK(scanPlainArray)->Unit(benchmark::kMillisecond);
BENCHMARK(lookUpByTime);
BENCHMARK(timeOfAFrame);
BENCHMARK(timesInOrder)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace deckpipe

BENCHMARK_MAIN();
