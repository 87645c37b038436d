// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the bus a frame takes, for the load shown in the status strip and for send budgets.
#pragma once

#include "bus/frame.h"

namespace deckpipe {

// Akron's J1939 buses run at this rate, in bit/s. It is assumed where a log does not say the rate of a bus.
inline constexpr std::uint32_t kAssumedBitRate = 250'000;

// Bits a classic data frame takes on the wire, interframe space included and stuff bits at half of the worst
// case (ISO 11898-1: one after every five equal bits; 34 or 54 bits of the header are subject to stuffing).
constexpr unsigned estimatedBits(const Frame& frame) {
  const unsigned data = frame.isRemote() ? 0u : 8u * frame.length;
  const unsigned fixed = frame.isExtended() ? 67u : 47u;
  const unsigned stuffable = (frame.isExtended() ? 54u : 34u) + data;
  return fixed + data + (stuffable - 1) / 8;
}

}  // namespace deckpipe
