// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/joystick_6035.h"

#include <algorithm>

namespace deckpipe::simulator {
namespace {

// The manual names no 6035's numbers; these are the simulator's own.
constexpr PcodeVersion kJoystickPcode{6035, 1, 0x0103};
constexpr ConfigVersion kJoystickConfig{60350001, 0x0100};

}  // namespace

Joystick6035::Joystick6035(std::string_view pin, Address source, std::uint64_t seed)
    : Device(identityOf(pin, kJoystickPcode, kJoystickConfig), HandScript::kStep, seed),
      m_source(source),
      m_hand(seed + 2) {}

void Joystick6035::tick(Instant now) {
  broadcastFrom(now, MessageId::BasicJoystick, m_hand.next(m_released).encode(), m_source);
}

namespace {

// How far the stick moves in one step: half a second from neutral to full.
constexpr int kStickTravel = 40;

int towards(int from, int to) { return from + std::clamp(to - from, -kStickTravel, kStickTravel); }

}  // namespace

void HandScript::add(int shortest, int longest, Gesture gesture) {
  gesture.steps = std::max(1, m_random.between(shortest, longest) / static_cast<int>(kStep / 1ms));
  m_script.push_back(gesture);
}

void HandScript::rest(int shortest, int longest) { add(shortest, longest, {}); }

void HandScript::push(Function function, int shortest, int longest) {
  add(shortest, longest, {.pressed = static_cast<int>(function)});
}

// To one side and then to the other, so that it stays about the middle.
void HandScript::sweep() {
  const int side = m_nextRight ? 1 : -1;
  m_nextRight = !m_nextRight;
  const int speed = m_random.between(300, 900);
  add(1500, 5000, {.x = side * speed, .y = m_random.between(0, 3) == 0 ? m_random.between(-250, 250) : 0});
  rest(300, 1500);
  add(1500, 5000, {.x = -side * m_random.between(speed / 2, speed)});
}

void HandScript::elevate() {
  add(800, 3000, {.y = (m_nextUp ? 1 : -1) * m_random.between(250, 800)});
  m_nextUp = !m_nextUp;
}

void HandScript::compose() {
  if (!m_hasBegun) {
    m_hasBegun = true;
    rest(3000, 5000);
    push(Function::Deploy, 500, 800);
    rest(9000, 12000);
    push(Function::DischargeOn, 400, 800);
    return;
  }
  switch (m_random.between(0, 9)) {
    case 0:
    case 1:
    case 2: sweep(); break;
    case 3:
    case 4: elevate(); break;
    case 5: push(m_random.between(0, 1) == 0 ? Function::Fog : Function::Stream, 800, 3000); break;
    case 6:
      sweep();
      elevate();
      break;
    case 7: push(m_random.between(0, 1) == 0 ? Function::FlowHigh : Function::FlowLow, 800, 3000); break;
    case 8:
      push(Function::OscillateSet, 300, 700);
      rest(15000, 40000);
      sweep();  // a hand ends it
      break;
    default: rest(4000, 10000); break;
  }
  rest(500, 2500);
}

BasicJoystick HandScript::next(bool released) {
  Gesture now;
  if (!released) {
    while (m_script.empty()) compose();
    now = m_script.front();
    if (--m_script.front().steps <= 0) m_script.pop_front();
  }
  m_x = towards(m_x, now.x);
  m_y = towards(m_y, now.y);
  BasicJoystick stick;
  stick.x = StickAxis::at(m_x);
  stick.y = StickAxis::at(-m_y);  // back is minus
  if (now.pressed >= 0) stick.switches[static_cast<std::size_t>(now.pressed)] = Status2::On;
  return stick;
}

}  // namespace deckpipe::simulator
