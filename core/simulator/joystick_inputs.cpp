// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/joystick_inputs.h"

#include <tuple>

namespace deckpipe::simulator {
namespace {

static_assert(kCountOf<Function> == std::tuple_size_v<decltype(BasicJoystick::switches)>);

// Functions of which only one can be had at a time.
constexpr Functions kConflicts[] = {
    Functions(Function::Stream, Function::Fog),
    Functions(Function::DischargeOn, Function::DischargeOff),
    Functions(Function::FlowHigh, Function::FlowLow),
    Functions(Function::Deploy, Function::Stow),
    Functions(Function::CafsDry, Function::CafsWet),
    Functions(Function::OscillateSet),
    Functions(Function::OscillatePause),
};

}  // namespace

std::optional<int> JoystickInputs::aimOf(const StickAxis& grip) const {
  if (!grip.tenths) return {};
  const bool directed = grip.plus == Status2::On || grip.minus == Status2::On;
  return directed || m_aimAtNeutral ? std::optional<int>(*grip.tenths) : std::nullopt;
}

void JoystickInputs::received(Instant now, const J1939Id& id, const Frame& frame) {
  if (!isJoystickAddress(id.source) || frame.length != 8) return;
  Source& source = m_sources[static_cast<std::size_t>(id.source.value - kFirstJoystick.value)];
  if (id.pgn == pgn::kBasicJoystick) {
    const BasicJoystick stick = BasicJoystick::of(frame);
    source.heard = now;
    source.rotation = stick.x.tenths.value_or(0);
    source.elevation = -stick.y.tenths.value_or(0);  // back is up
    source.functions = {};
    for (const Function f : kAllOf<Function>) {
      if (stick.switches[static_cast<std::size_t>(f)] == Status2::On) source.functions.add(f);
    }
  } else if (id.pgn == pgn::kExtendedJoystick) {
    const ExtendedJoystick stick = ExtendedJoystick::of(frame);
    source.heard = now;
    source.aimRotation = aimOf(stick.gripX);
    source.aimElevation = aimOf(stick.gripY);
  }
}

void JoystickInputs::expire(Instant now) {
  for (Source& source : m_sources) {
    if (source.heard != kNotYet && now - source.heard >= kTimeout) source = {};
  }
}

Demand JoystickInputs::demand() const {
  Demand demand;
  Functions decided;  // a source of a higher priority has asked for one of the same group
  const auto axis = [](int deflection, const std::optional<int>& aim, int& speed,
                       std::optional<int>& target) {
    if (speed != 0 || target) return;
    speed = deflection;
    if (deflection == 0) target = aim;
  };
  for (const Source& source : m_sources) {
    axis(source.rotation, source.aimRotation, demand.rotation, demand.aimRotation);
    axis(source.elevation, source.aimElevation, demand.elevation, demand.aimElevation);
    for (const Functions& group : kConflicts) {
      const Functions asked = source.functions & group;
      if (asked.isEmpty() || !(decided & group).isEmpty()) continue;
      decided |= group;
      if (asked.count() == 1) demand.functions |= asked;
    }
  }
  return demand;
}

}  // namespace deckpipe::simulator
