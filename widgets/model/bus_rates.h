// SPDX-License-Identifier: GPL-3.0-or-later
// How busy a log's buses are at the cursor: what came in the second before it. A pure function of log and
// cursor, so that load and rates are the same live and in a replay.
#pragma once

#include <array>
#include <cstdint>

#include "state/bus_watch.h"
#include "state/log_view.h"

namespace deckpipe {

struct BusRates {
  enum class Basis : std::uint8_t {
    Times,     // known
    TooShort,  // too little of the log lies before the cursor
    NoTimes,   // the log has no times (FrameStore::hasTimes)
    Coarse,    // its times are good to the second only (time_grain.h): no second can be told from the next
    Filtered,  // it was saved through a filter: what else was on the bus is missing
  };
  Basis basis = Basis::TooShort;
  double framesASecond = 0;
  std::array<double, kMaxChannels> bitsASecond{};
  // Among the frames of that second, error frames apart.
  std::uint64_t extended = 0, standard = 0;

  bool isKnown() const { return basis == Basis::Times; }
  friend bool operator==(const BusRates&, const BusRates&) = default;
};

BusRates ratesAt(const LogView& view);

// The share that was taken of one bus.
struct BusLoad {
  double percent = 0;
  std::uint32_t bitRate = 0;  // of this, in bit/s
  bool isAssumed = false;     // neither link nor log says that rate

  // A bus that carried more than an assumed rate allows has another one.
  bool isKnown() const { return !isAssumed || percent <= static_cast<double>(BusWatch::kFaster); }
};

// `linkRate` is that of the link, in bit/s; 0 of a log, which may say it itself.
BusLoad loadOf(const BusRates& rates, const State& state, Channel channel, int linkRate);
// Of the channel that takes most of its own.
BusLoad busiestLoad(const BusRates& rates, const State& state, int linkRate);

}  // namespace deckpipe
