// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated 6035 joystick. It has a claimed address from which it announces its PIN and answers polls,
// as all Akron's devices do, and besides sends the basic joystick message every 20 ms from a fixed source
// address in 33..38 hex, as the manual has every control device appear. Its hand follows HandScript;
// released, it goes on sending neutral. Source: CAN Messaging manual, PGN 64982 and Appendices A and B.
#pragma once

#include <deque>

#include "protocol/typed.h"
#include "simulator/device.h"
#include "simulator/joystick_inputs.h"
#include "simulator/random.h"

namespace deckpipe::simulator {

// A hand on a joystick that nobody holds: a seeded, endless sequence of gestures as somebody tries out a
// monitor. Deploys it first, then sweeps, elevates, changes the pattern, rests at neutral, and now and then
// lets it oscillate. Joystick6035 asks for the stick every 20 ms.
class HandScript {
 public:
  static constexpr Duration kStep = 20ms;

  explicit HandScript(std::uint64_t seed) : m_random(seed) {}

  // The stick one step on. Released, it goes back to neutral and stays there, and the script stands still.
  BasicJoystick next(bool released);

 private:
  struct Gesture {
    int steps = 0;
    int x = 0, y = 0;  // 0.1 %, right and back (up) positive
    int pressed = -1;  // index of a switch, none below 0
  };
  void compose();
  void rest(int shortest, int longest);  // milliseconds
  void push(Function function, int shortest, int longest);
  void sweep();
  void elevate();
  void add(int shortest, int longest, Gesture gesture);

  Random m_random;
  std::deque<Gesture> m_script;
  bool m_hasBegun = false;
  bool m_nextRight = true, m_nextUp = true;
  int m_x = 0, m_y = 0;  // where the stick is: a hand needs time to move it
};

class Joystick6035 : public Device {
 public:
  // `source` is one of kFirstJoystick..kLastJoystick.
  Joystick6035(std::string_view pin, Address source, std::uint64_t seed);

  // Whether the scripted hand holds it (at first it does).
  void release() { m_released = true; }
  void take() { m_released = false; }
  Address source() const { return m_source; }

 protected:
  void tick(Instant now) override;

 private:
  Address m_source;
  HandScript m_hand;
  bool m_released = false;
};

}  // namespace deckpipe::simulator
