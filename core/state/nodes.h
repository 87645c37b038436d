// SPDX-License-Identifier: GPL-3.0-or-later
// What was heard from the J1939 addresses of one channel: when, how much, how often. Who is there is the
// address book's business.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "base/ids.h"
#include "base/time.h"
#include "state/frame_rate.h"

namespace deckpipe {

struct Node {
  Instant lastHeard = kNotYet;
  std::uint32_t frames = 0;
  FrameRate rate;
  std::uint16_t malformed = 0;  // stays at its most

  bool isHeard() const { return lastHeard != kNotYet; }
};

class Nodes {
 public:
  Node operator[](Address a) const {
    const Heard& heard = m_heard[a.value];
    return {heard.last, heard.frames, heard.rate, m_malformed[a.value]};
  }
  void heard(Address source, Instant time) {
    Heard& heard = m_heard[source.value];
    heard.rate.count(time, heard.last);
    heard.last = time;
    ++heard.frames;
  }
  void countMalformed(Address source) {
    std::uint16_t& count = m_malformed[source.value];
    if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
  }

  friend bool operator==(const Nodes&, const Nodes&) = default;

 private:
  struct Heard {
    Instant last = kNotYet;
    std::uint32_t frames = 0;
    FrameRate rate;
    friend bool operator==(const Heard&, const Heard&) = default;
  };
  static_assert(sizeof(Heard) == 16, "State holds one for every address of every channel");

  std::array<Heard, 256> m_heard{};
  std::array<std::uint16_t, 256> m_malformed{};
};

}  // namespace deckpipe
