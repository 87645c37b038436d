// SPDX-License-Identifier: GPL-3.0-or-later
// One motor-driven axis: a position between two hard stops, a speed, a small ramp. Integers in the axis' own
// unit (micro-degrees, or millionths of a valve's travel), moved in equal steps of the control loop, so that
// the same commands give the same positions on every machine.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace deckpipe::simulator {

// Oscillation between two ends of rotation. The manual names the switches (4 on | set, 7 pause | resume) and
// the status bit of message 81, and no more; how the ends are set is this simulator's own rule:
// pressing 4 takes the sweep made by hand since the last start as the ends, where it was 5 degrees or wider,
// and otherwise the ends it had; then it starts. Paused, the ends still count as the limits of message 81.
// Positions as the controller reports them, in micro-degrees.
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

class Axis {
 public:
  struct Mechanics {
    int low, high;  // hard stops
    int fullSpeed;  // per step
    int ramp;       // change of speed per step while starting; twice that while stopping
  };
  constexpr Axis(const Mechanics& mechanics, int position) : m_mechanics(mechanics), m_position(position) {}

  // Commands hold until the next one. Speed in 0.1 % of the full speed, plus towards the high end.
  constexpr void drive(int speed) {
    m_seeking = false;
    m_wanted = scaled(std::clamp(speed, -1000, 1000));
  }
  // Goes to a position at up to so much of the full speed, and stays there.
  constexpr void seek(int target, int speed) {
    m_seeking = true;
    m_target = std::clamp(target, m_mechanics.low, m_mechanics.high);
    m_cap = scaled(std::clamp(speed, 0, 1000));
  }
  // Soft limits. Outside of them the axis may only move back in.
  constexpr void limit(int low, int high) {
    m_softLow = low;
    m_softHigh = high;
  }
  constexpr void unlimit() { limit(m_mechanics.low, m_mechanics.high); }
  // Directions that may be moved in at all; a motion in another ends at once.
  constexpr void permit(bool plus, bool minus) {
    m_mayPlus = plus;
    m_mayMinus = minus;
  }
  // Power off the motor: it stands at once.
  constexpr void halt() {
    m_seeking = false;
    m_wanted = m_speed = 0;
  }

  constexpr void step() {
    const int wanted = m_seeking ? seekingSpeed() : m_wanted;
    const bool braking =
        std::abs(wanted) < std::abs(m_speed) || (m_speed != 0 && (wanted > 0) != (m_speed > 0));
    const int change = braking ? 2 * m_mechanics.ramp : m_mechanics.ramp;
    m_speed += std::clamp(wanted - m_speed, -change, change);
    if ((m_speed > 0 && !m_mayPlus) || (m_speed < 0 && !m_mayMinus)) m_speed = 0;
    int next = m_position + m_speed;
    if (m_speed > 0) next = std::min(next, std::max(m_position, std::min(m_softHigh, m_mechanics.high)));
    if (m_speed < 0) next = std::max(next, std::min(m_position, std::max(m_softLow, m_mechanics.low)));
    m_speed = next - m_position;
    m_position = next;
  }

  constexpr int position() const { return m_position; }
  constexpr int speed() const { return m_speed; }
  constexpr bool isAtLow() const { return m_position == m_mechanics.low; }
  constexpr bool isAtHigh() const { return m_position == m_mechanics.high; }
  // Millionths of the travel from the low end.
  constexpr int travelled() const {
    return static_cast<int>(1'000'000LL * (m_position - m_mechanics.low) /
                            (m_mechanics.high - m_mechanics.low));
  }

 private:
  constexpr int scaled(int tenths) const {
    return static_cast<int>(1LL * m_mechanics.fullSpeed * tenths / 1000);
  }
  // Slows down towards the target, and takes the last bit in one step.
  constexpr int seekingSpeed() const {
    constexpr int kSlowing = 16;
    const int left = m_target - m_position;
    if (std::abs(left) <= m_mechanics.fullSpeed / 50) return left;
    const int speed = std::max(std::abs(left) / kSlowing, 1);
    return left > 0 ? std::min(speed, m_cap) : -std::min(speed, m_cap);
  }

  Mechanics m_mechanics;
  int m_position;
  int m_speed = 0;
  int m_wanted = 0;
  bool m_seeking = false;
  int m_target = 0, m_cap = 0;
  int m_softLow = m_mechanics.low, m_softHigh = m_mechanics.high;
  bool m_mayPlus = true, m_mayMinus = true;
};

}  // namespace deckpipe::simulator
