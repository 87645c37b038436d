// SPDX-License-Identifier: GPL-3.0-or-later
// Oscillation between two ends of rotation. The manual names the switches (4 on | set, 7 pause | resume) and
// the status bit of message 81, and no more; how the ends are set is this simulator's own rule:
// pressing 4 takes the sweep made by hand since the last start as the ends, where it was 5 degrees or wider,
// and otherwise the ends it had; then it starts. Paused, the ends still count as the limits of message 81.
// Positions as the controller reports them, in micro-degrees.
#pragma once

#include <algorithm>

namespace deckpipe::simulator {

class Oscillation {
 public:
  static constexpr int kNarrowest = 5'000'000;

  constexpr Oscillation(int left, int right) : m_left(left), m_right(right) {}

  constexpr bool isOn() const { return m_on; }
  constexpr bool isPaused() const { return m_paused; }
  constexpr int left() const { return m_left; }
  constexpr int right() const { return m_right; }

  // Where a hand has moved it.
  constexpr void swept(int position) {
    m_sweptLeft = m_hasSwept ? std::min(m_sweptLeft, position) : position;
    m_sweptRight = m_hasSwept ? std::max(m_sweptRight, position) : position;
    m_hasSwept = true;
  }
  // Switch 4, with the soft limits that hold.
  constexpr void set(int softLow, int softHigh) {
    if (m_hasSwept && m_sweptRight - m_sweptLeft >= kNarrowest) {
      m_left = m_sweptLeft;
      m_right = m_sweptRight;
    }
    m_left = std::clamp(m_left, softLow, softHigh);
    m_right = std::clamp(m_right, softLow, softHigh);
    m_hasSwept = false;
    m_on = true;
    m_paused = false;
  }
  // Switch 7.
  constexpr void pauseOrResume() { m_paused = m_on && !m_paused; }
  constexpr void stop() { m_on = m_paused = false; }
  // Which end it is on the way to.
  constexpr int target(int position) {
    if (position <= m_left) m_toRight = true;
    if (position >= m_right) m_toRight = false;
    return m_toRight ? m_right : m_left;
  }

 private:
  int m_left, m_right;
  int m_sweptLeft = 0, m_sweptRight = 0;
  bool m_hasSwept = false;
  bool m_on = false, m_paused = false, m_toRight = true;
};

}  // namespace deckpipe::simulator
