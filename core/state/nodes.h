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

// Whether an address broadcasts something by itself: it did in each of four seconds in a row.
class Broadcasts {
 public:
  void heard(Instant time) {
    const std::uint32_t second = static_cast<std::uint32_t>(time.ns / 1'000'000'000) & kSeconds;
    const std::uint32_t since = (second - m_second) & kSeconds;
    if (m_inRow == 0 || since > 1) {
      m_inRow = 1;
    } else if (since == 1 && m_inRow < kSteady) {
      ++m_inRow;
    }
    m_second = second & kSeconds;
  }
  bool isSteady() const { return m_inRow == kSteady; }
  friend bool operator==(const Broadcasts&, const Broadcasts&) = default;

 private:
  static constexpr std::uint32_t kSeconds = (1u << 29) - 1;  // 17 years
  static constexpr std::uint32_t kSteady = 4;

  std::uint32_t m_second : 29 = 0;  // of the last broadcast
  std::uint32_t m_inRow : 3 = 0;    // seconds with one, up to that; 0: there was none
};

struct Node {
  Instant lastHeard = kNotYet;
  std::uint32_t frames = 0;
  FrameRate rate;
  bool isSteady = false;        // something of it comes by itself
  std::uint16_t malformed = 0;  // stays at its most

  bool isHeard() const { return lastHeard != kNotYet; }
};

class Nodes {
 public:
  Node operator[](Address a) const {
    const Heard& heard = m_heard[a.value];
    return {heard.last, heard.frames, heard.rate, m_broadcasts[a.value].isSteady(), m_malformed[a.value]};
  }
  void heard(Address source, Instant time) {
    Heard& heard = m_heard[source.value];
    heard.rate.count(time, heard.last);
    heard.last = time;
    ++heard.frames;
  }
  // It sent to all, of its own accord.
  void broadcast(Address source, Instant time) { m_broadcasts[source.value].heard(time); }
  // Whoever was there is not there any more.
  void left(Address address) {
    m_broadcasts[address.value] = {};
    m_malformed[address.value] = 0;
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
  std::array<Broadcasts, 256> m_broadcasts{};
  std::array<std::uint16_t, 256> m_malformed{};
};

}  // namespace deckpipe
