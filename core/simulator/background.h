// SPDX-License-Identifier: GPL-3.0-or-later
// What others say on the simulator's bus all day: engine, transmission, body. Frames of the lowest priority at
// even distances that fill a given share of a bus, so that claims, polls and the pipe can be tried where
// there is little room. Simulator owns one; the four verbs of a service. Whose they are is made up: proprietary B
// messages of one foreign address without a NAME.
#pragma once

#include <algorithm>
#include <vector>

#include "base/bits.h"
#include "bus/j1939.h"
#include "bus/load.h"
#include "simulator/outbox.h"

namespace deckpipe::simulator {

class Background {
 public:
  static constexpr double kMax = 0.95;  // of the bus
  static constexpr Address kSource{0x27};
  static constexpr std::uint32_t kFirstPgn = 0xFF00, kPgns = 16;

  // From `begin` on; a share of 0 is silence.
  void set(Instant begin, double share, int bitRate) {
    m_period = share > 0 ? Duration(static_cast<std::int64_t>(estimatedBits(made(0)) /
                                                              (std::min(share, kMax) * bitRate) * 1e9))
                         : Duration{0};
    m_next = share > 0 ? begin : kNever;
  }
  Instant nextTime() const { return m_next; }
  // Appends what is due by `now`.
  void takeDue(Instant now, std::vector<DueFrame>& out) {
    for (; m_next <= now; m_next = m_next + m_period) out.push_back({m_next, made(m_count++)});
  }

 private:
  static Frame made(std::uint64_t count) {
    Frame frame;
    frame.id = J1939Id{7, kFirstPgn + static_cast<std::uint32_t>(count % kPgns), kSource}.frameId();
    frame.length = 8;
    for (unsigned i = 0; i < 8; ++i) frame.data[i] = static_cast<std::uint8_t>(count >> 8 * i);
    return frame;
  }

  Duration m_period{0};
  Instant m_next = kNever;
  std::uint64_t m_count = 0;
};

}  // namespace deckpipe::simulator
