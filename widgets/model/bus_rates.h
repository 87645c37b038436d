// SPDX-License-Identifier: GPL-3.0-or-later
// How busy a log's buses are at the cursor: what came in the second before it. A pure function of log and
// cursor, so that load and rates are the same live and in a replay.
#pragma once

#include <array>
#include <cstdint>

#include "state/log_view.h"

namespace deckpipe {

struct BusRates {
  enum class Basis : std::uint8_t {
    Times,     // known
    TooShort,  // too little of the log lies before the cursor
    NoTimes,   // the log has no times (FrameStore::hasTimes)
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

// The share of a bus that its busiest channel takes, in percent; 0 for a bit rate of 0.
double loadPercent(const BusRates& rates, int bitRate);

}  // namespace deckpipe
