// SPDX-License-Identifier: GPL-3.0-or-later
// What the joysticks at 33..38 hex ask of a controller, put together as the CAN Messaging manual's Appendix B
// says. Owned by each simulated controller: it passes in every frame, and asks for the demand on every pass
// of its control loop.
//
// 1. A source's input is cleared 200 ms after its last joystick message.
// 2. Where two sources ask for the same axis, or for opposite functions, the lower address has it, whatever
//    its speed; everything else is honoured together.
// 3. A deflection that is not valid (above 100 %, both directions, error, not available) asks for nothing.
#pragma once

#include <array>
#include <optional>

#include "base/enum_table.h"
#include "base/time.h"
#include "bus/j1939.h"
#include "protocol/address_book.h"
#include "protocol/typed.h"

namespace deckpipe::simulator {

// Switches 1..12 of the basic joystick message, in their order.
enum class Function : std::uint8_t {
  Stream,
  Fog,
  DischargeOn,
  OscillateSet,
  FlowHigh,
  FlowLow,
  OscillatePause,
  Deploy,
  Stow,
  DischargeOff,
  CafsDry,
  CafsWet,
  Count,
};
using Functions = EnumSet<Function>;

struct Demand {
  int rotation = 0, elevation = 0;  // speed in 0.1 %, right and up positive
  // Point aim, 0.1 % of 175 and of 90 degrees. Only where no deflection asks for the same axis.
  std::optional<int> aimRotation, aimElevation;
  Functions functions;
};

class JoystickInputs {
 public:
  static constexpr Duration kTimeout = 200ms;

  // `aimAtNeutral`: a grip at zero without a direction is the target 0 as well. The manual does not say; off,
  // only a grip with a direction on is a target.
  explicit JoystickInputs(bool aimAtNeutral = false) : m_aimAtNeutral(aimAtNeutral) {}

  void received(Instant now, const J1939Id& id, const Frame& frame);
  // Clears what is 200 ms old.
  void expire(Instant now);
  void clear() { m_sources.fill({}); }

  Demand demand() const;

 private:
  struct Source {
    Instant heard = kNotYet;  // last message; kNotYet: nothing asked for
    int rotation = 0, elevation = 0;
    std::optional<int> aimRotation, aimElevation;
    Functions functions;
  };
  std::optional<int> aimOf(const StickAxis& grip) const;

  bool m_aimAtNeutral;
  // By address: the highest priority first.
  std::array<Source, kLastJoystick.value - kFirstJoystick.value + 1> m_sources{};
};

}  // namespace deckpipe::simulator
