// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated 6035 joystick. It has a claimed address from which it announces its PIN and answers polls,
// as all Akron's devices do, and besides sends the basic joystick message every 20 ms from a fixed source
// address in 33..38 hex, as the manual has every control device appear. Its hand follows HandScript;
// released, it goes on sending neutral. Source: CAN Messaging manual, PGN 64982 and Appendices A and B.
#pragma once

#include "simulator/device.h"
#include "simulator/hand_script.h"

namespace deckpipe::simulator {

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
