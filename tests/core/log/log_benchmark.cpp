// SPDX-License-Identifier: GPL-3.0-or-later
// How fast a candump log opens, against a bare parser in the same run that knows one layout, checks nothing
// and keeps nothing but the records; how fast the store is scanned and searched. Prints ratios; asserts
// nothing.
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "log/candump.h"
#include "log/frame_store.h"

namespace deckpipe {
namespace {

constexpr std::uint64_t kFrames = 10'000'000;

std::string benchmarkFile() {
  static const std::string path = [] {
    std::string name =
        std::string(std::getenv("TMPDIR") ? std::getenv("TMPDIR") : "/tmp") + "/log_benchmark.log";
    std::mt19937_64 random(1);
    std::string text;
    std::FILE* file = std::fopen(name.c_str(), "w");
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
    return name;
  }();
  return path;
}

// The floor: fixed columns, no checks, records side by side in fresh memory.
unsigned char g_hex[256];

void bareParse(const char* p, const char* end, Frame* to) {
  const auto pair = [](const char* c) {
    return static_cast<unsigned char>(g_hex[static_cast<unsigned char>(c[0])] << 4 |
                                      g_hex[static_cast<unsigned char>(c[1])]);
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

void bareFloor(benchmark::State& state) {
  const std::string path = benchmarkFile();
  for (unsigned char c = 0; c < 10; ++c) g_hex['0' + c] = c;
  for (unsigned char c = 0; c < 6; ++c) g_hex['A' + c] = static_cast<unsigned char>(10 + c);
  const auto threads = static_cast<std::size_t>(state.range(0));
  for (auto _ : state) {
    const int file = open(path.c_str(), O_RDONLY);
    const auto size = static_cast<std::size_t>(lseek(file, 0, SEEK_END));
    void* map = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    void* memory =
        mmap(nullptr, kFrames * sizeof(Frame), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    madvise(memory, kFrames * sizeof(Frame), MADV_HUGEPAGE);
    const char* text = static_cast<const char*>(map);
    const std::size_t line =
        static_cast<std::size_t>(static_cast<const char*>(std::memchr(text, '\n', size)) - text) + 1;
    std::vector<std::thread> workers;
    for (std::size_t t = 0; t < threads; ++t) {
      const std::uint64_t from = kFrames * t / threads, to = kFrames * (t + 1) / threads;
      const auto part = [=] {
        bareParse(text + from * line, text + to * line, static_cast<Frame*>(memory) + from);
      };
      if (t + 1 == threads) {
        part();
      } else {
        workers.emplace_back(part);
      }
    }
    for (std::thread& worker : workers) worker.join();
    benchmark::DoNotOptimize(static_cast<Frame*>(memory)[kFrames - 1].stamp);
    state.PauseTiming();
    munmap(memory, kFrames * sizeof(Frame));
    munmap(map, size);
    close(file);
    state.ResumeTiming();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kFrames));
}

void openCandump(benchmark::State& state) {
  const std::string path = benchmarkFile();
  for (auto _ : state) {
    auto store = std::make_unique<FrameStore>();
    UnkeptList unkept;
    ReadOptions options;
    options.threads = static_cast<unsigned>(state.range(0));
    if (!readCandump(path, *store, unkept, options)) state.SkipWithError("cannot be read");
    if (store->count() != kFrames) state.SkipWithError("frames missing");
    state.PauseTiming();
    store.reset();
    state.ResumeTiming();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kFrames));
}

BENCHMARK(bareFloor)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(2);
BENCHMARK(openCandump)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(2);

}  // namespace
}  // namespace deckpipe

BENCHMARK_MAIN();
