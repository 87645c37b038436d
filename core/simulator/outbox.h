// SPDX-License-Identifier: GPL-3.0-or-later
// What one device wants to send, in order, each frame with the instant at which it is due. A real controller
// hands its frames to one transmit buffer, so two of its frames are never on the bus at the same instant.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "base/time.h"
#include "bus/frame.h"

namespace deckpipe::simulator {

struct DueFrame {
  Instant time;
  Frame frame;
  friend bool operator==(const DueFrame&, const DueFrame&) = default;
};

class Outbox {
 public:
  // From the start of one frame to the start of the next: 8 data bytes take 0.58 ms at 250 kbit/s.
  static constexpr Duration kGap = 600us;
  // More than this many waiting frames do not fit; those that do not are counted (fault 'CAN output
  // overrun').
  static constexpr std::size_t kCapacity = 128;

  // Due at `earliest`, or as soon after the frame posted before it as the bus allows.
  void post(Instant earliest, const Frame& frame) {
    if (m_queue.size() >= kCapacity) {
      ++m_dropped;
      return;
    }
    const Instant due = std::max(earliest, m_free);
    m_free = due + kGap;
    m_queue.push_back({due, frame});
  }
  Instant nextTime() const { return m_queue.empty() ? kNever : m_queue.front().time; }
  // Appends what is due by `now`.
  void takeDue(Instant now, std::vector<DueFrame>& out) {
    for (; nextTime() <= now && !m_queue.empty(); m_queue.pop_front()) out.push_back(m_queue.front());
  }
  // Forgets what waits: after a reset, or once the address it would go out from is lost.
  void clear() {
    m_queue.clear();
    m_free = kNotYet;
  }
  std::uint64_t dropped() const { return m_dropped; }

 private:
  std::deque<DueFrame> m_queue;
  Instant m_free = kNotYet;
  std::uint64_t m_dropped = 0;
};

}  // namespace deckpipe::simulator
