// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/bus_rates.h"

#include <algorithm>

#include "bus/load.h"
#include "log/time_grain.h"

namespace deckpipe {
namespace {

constexpr Duration kSpan = 1s;
constexpr Duration kMinSpan = 100ms;           // before that a rate says nothing
constexpr std::uint64_t kMaxFrames = 100'000;  // four full buses send 36,000; a log without times has more

}  // namespace

BusRates ratesAt(const LogView& view) {
  BusRates rates;
  if (!view.document) return rates;
  const FrameStore& frames = view.document->frames;
  const std::uint64_t end = std::min(view.cursor.frames, frames.count());
  const Duration span = std::min(kSpan, view.cursor.time - view.begin);
  if (!frames.hasTimes()) {
    rates.basis = BusRates::Basis::NoTimes;
  } else if (view.state != nullptr && view.state->isFiltered()) {
    rates.basis = BusRates::Basis::Filtered;
  } else if (timeGrainOf(frames) == TimeGrain::Seconds) {
    rates.basis = BusRates::Basis::Coarse;
  } else if (end == 0 || span >= kMinSpan) {
    rates.basis = BusRates::Basis::Times;
  }
  if (end == 0 || !rates.isKnown() || view.cursor.time < view.begin) return rates;
  const std::uint64_t earliest = end > kMaxFrames ? end - kMaxFrames : 0;
  std::uint64_t i = std::max(earliest, frames.firstAfter(view.cursor.time - span));
  std::uint64_t count = 0;
  while (i < end) {
    for (const Frame& frame : frames.run(i)) {
      ++i;
      ++count;
      if (frame.isError()) continue;
      ++(frame.isExtended() ? rates.extended : rates.standard);
      if (frame.channel < kMaxChannels) rates.bitsASecond[frame.channel] += estimatedBits(frame);
      if (i == end) break;
    }
  }
  const double seconds = std::chrono::duration<double>(span).count();
  rates.framesASecond = static_cast<double>(count) / seconds;
  for (double& bits : rates.bitsASecond) bits /= seconds;
  return rates;
}

BusLoad loadOf(const BusRates& rates, const State& state, Channel channel, int linkRate) {
  BusLoad load{.bitRate = state.channel(channel).bitRate};
  if (load.bitRate == 0 && linkRate > 0) load.bitRate = static_cast<std::uint32_t>(linkRate);
  load.isAssumed = load.bitRate == 0;
  if (load.isAssumed) load.bitRate = kAssumedBitRate;
  load.percent = 100 * rates.bitsASecond[channel.value] / load.bitRate;
  return load;
}

BusLoad busiestLoad(const BusRates& rates, const State& state, int linkRate) {
  BusLoad busiest = loadOf(rates, state, {0}, linkRate);
  for (std::uint8_t i = 1; i < kMaxChannels; ++i) {
    const BusLoad load = loadOf(rates, state, {i}, linkRate);
    if (load.percent > busiest.percent) busiest = load;
  }
  return busiest;
}

}  // namespace deckpipe
