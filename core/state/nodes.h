// SPDX-License-Identifier: GPL-3.0-or-later
// What was heard from the J1939 addresses of one channel: when, how much, how often. Who is there is the
// address book's business.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "base/ids.h"
#include "base/time.h"
#include "state/pace.h"

namespace deckpipe {

// Whether an address broadcasts something by itself, and how often. It does if the seconds in which it broadcast came at
// even gaps: four in a row if these are one second, as of whoever sends every second or faster, five if they are longer.
class Broadcasts {
 public:
  void heard(Instant time) {
    const std::uint32_t second = static_cast<std::uint32_t>(time.ns / 1'000'000'000) & kSeconds;
    if (m_isCut != 0) {
      m_isCut = 0;
      m_second = second & kSeconds;
      return;
    }
    const std::uint32_t gap = (second - m_second) & kSeconds;
    if (m_inRow != 0 && gap == 0) return;
    m_second = second & kSeconds;
    if (m_inRow == 0 || gap > kLongest) {
      m_inRow = 1;
      m_gap = 0;
    } else if (m_gap != 0 && !isAlike(gap)) {
      m_inRow = 2;
      m_gap = gap & kLongest;
    } else {
      if (m_inRow < kSteady) ++m_inRow;
      takeAlike(gap);
    }
  }
  // The link was down: the gap to the next one says nothing.
  void linkCameBack() { m_isCut = m_inRow != 0 ? 1 : 0; }
  bool isSteady() const { return m_inRow >= (m_gap == 1 ? kSteadyFast : kSteady); }
  // The longest pause between two broadcasts that is no surprise.
  Duration period() const { return m_gap * Duration(1s); }
  friend bool operator==(const Broadcasts&, const Broadcasts&) = default;

 private:
  static constexpr std::uint32_t kSeconds = (1u << 19) - 1;  // 6 days
  static constexpr std::uint32_t kLongest = 63;
  static constexpr std::uint32_t kSteadyFast = 4, kSteady = 5;
  static constexpr std::uint32_t kShorter = 7;

  // A gap is counted in whole seconds, so that it errs by one.
  bool isAlike(std::uint32_t gap) const {
    const std::uint32_t slack = 1 + m_gap / 8;
    return gap <= m_gap + slack && m_gap <= gap + slack;
  }
  // It falls once several were shorter.
  void takeAlike(std::uint32_t gap) {
    m_shorter = gap < m_gap ? (m_shorter + 1) & kShorter : 0;
    if (gap > m_gap || m_shorter == kShorter) {
      m_gap = gap & kLongest;
      m_shorter = 0;
    }
  }

  std::uint32_t m_second : 19 = 0;  // of the last broadcast
  std::uint32_t m_isCut : 1 = 0;    // the link was down since then
  std::uint32_t m_inRow : 3 = 0;    // seconds with one, at even gaps, up to kSteady; 0: there was none
  std::uint32_t m_gap : 6 = 0;      // the longest of these gaps; 0: there was none
  std::uint32_t m_shorter : 3 = 0;  // gaps in a row that were shorter
};
static_assert(sizeof(Broadcasts) == 4, "State holds one for every address of every channel");

struct Node {
  Instant lastHeard = kNotYet;
  std::uint32_t frames = 0;
  FrameRate rate;
  bool isSteady = false;        // something of it comes by itself
  Duration period{0};           // of that
  std::uint16_t malformed = 0;  // stays at its most

  bool isHeard() const { return lastHeard != kNotYet; }
};

class Nodes {
 public:
  Node operator[](Address a) const {
    const Heard& heard = m_heard[a.value];
    const Broadcasts& broadcasts = m_broadcasts[a.value];
    return {heard.last,          heard.frames,        heard.rate, broadcasts.isSteady(),
            broadcasts.period(), m_malformed[a.value]};
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
  // Frames come again after the link was down: whose messages had a wrong length may not be there any more.
  void linkCameBack() {
    for (Broadcasts& broadcasts : m_broadcasts) broadcasts.linkCameBack();
    m_malformed.fill(0);
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
