// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/joystick_6035.h"

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

}  // namespace deckpipe::simulator
