// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated 6033 Mini Universal: a riser that takes six seconds between retracted and extended, and
// message 84. It obeys the joysticks' deploy and stow switches; the riser command bits of message 83 have no
// meaning given, so it does not obey those.
// Source: CAN Messaging manual, message type 84.
#pragma once

#include "simulator/axis.h"
#include "simulator/device.h"
#include "simulator/joystick_inputs.h"

namespace deckpipe::simulator {

class MiniUniversal6033 : public Device {
 public:
  static constexpr Duration kStatusPeriod = 100ms;
  static constexpr Duration kTravelTime = 6s;

  MiniUniversal6033(std::string_view pin, std::uint64_t seed);

  bool isRetracted() const { return m_riser.isAtLow(); }
  bool isExtended() const { return m_riser.isAtHigh(); }
  // Millionths of the travel.
  int extended() const { return m_riser.travelled(); }

 protected:
  void started(Instant now) override;
  void tick(Instant now) override;
  void heard(Instant now, const J1939Id& id, const Frame& frame) override;

 private:
  JoystickInputs m_inputs;
  Axis m_riser;
  Functions m_before;
};

}  // namespace deckpipe::simulator
