// SPDX-License-Identifier: GPL-3.0-or-later
// The values of motion: how far a joystick is deflected, and why motion ended.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/enum_table.h"

namespace deckpipe {

// How far a joystick is deflected on one axis, in 0.1 %, right and forward positive. It holds no number beyond
// ±kFull, so none can be sent: 1022 and 1023 mean 'error' and 'not available' (design.md section 7, rule 3).
class Deflection {
 public:
  static constexpr int kFull = 1000;

  constexpr Deflection() = default;  // at rest
  static constexpr std::optional<Deflection> of(int tenths) {
    if (tenths < -kFull || tenths > kFull) return {};
    return Deflection(tenths);
  }
  constexpr int tenths() const { return m_tenths; }
  constexpr bool isAtRest() const { return m_tenths == 0; }
  // The same direction, `limit` at most, 0..kFull.
  constexpr Deflection within(int limit) const { return Deflection(std::clamp(m_tenths, -limit, limit)); }
  friend constexpr bool operator==(Deflection, Deflection) = default;

 private:
  explicit constexpr Deflection(int tenths) : m_tenths(tenths) {}
  int m_tenths = 0;
};

// Speed that is allowed until a person raises it, at each arming anew; 0.1 %.
inline constexpr int kSpeedLimit = 300;

// Why motion, or an arming, ended. Numbers stand in files: never renumber one, never use one again.
enum class MotionCause : std::uint8_t {
  None = 0,
  Released = 1,        // the hand let go
  Disarmed = 2,        // by the person
  HandNotSeen = 3,     // no fresh word that it is held
  Gap = 4,             // the thread that sends stood still
  HeldTooLong = 5,     // longer than is allowed without letting go
  NotHeldTooLong = 6,  // armed, and nobody held it
  Locked = 7,          // the transmit lock was set, or the link is closed
  LinkLost = 8,
  SourceTaken = 9,          // another node claims or uses the joystick's address
  ControllerAppeared = 10,  // or moved to another address, or lost its own
  MonitorGone = 11,         // one that was named is not heard any more, or its address is contested
  EnableOff = 12,           // of a monitor that was named
  MonitorChanged = 13,      // its enable, operational error or stowed bit did, since it was held
  StowAsked = 14,           // by another: stow or deploy
  NotOnBus = 15,            // our frames do not reach the bus
  WriteFailed = 16,         // the adapter did not take one
  BusTrouble = 17,          // bus-off, error-passive, or send errors of the adapter
  ClockJumped = 18,         // the computer was asleep
  WouldOutrank = 19,        // a joystick of lower priority is heard: a person at the truck
  WrongWay = 20,            // a monitor turned against the command
  NoMotion = 21,            // a monitor did not follow the command. The next four say why it did not
  AtStop = 22,
  AtSoftLimit = 23,
  Outranked = 24,  // a joystick of higher priority commands the same axis
  NoPermissive = 25,
};
template <>
inline constexpr MotionCause kLastOf<MotionCause> = MotionCause::NoPermissive;

// Whether it takes a new arming to move again; after the others the joystick is let go and held anew.
constexpr bool disarms(MotionCause cause) {
  switch (cause) {
    case MotionCause::Disarmed:
    case MotionCause::NotHeldTooLong:
    case MotionCause::Locked:
    case MotionCause::LinkLost:
    case MotionCause::SourceTaken:
    case MotionCause::ControllerAppeared:
    case MotionCause::MonitorGone:
    case MotionCause::NotOnBus:
    case MotionCause::WriteFailed:
    case MotionCause::BusTrouble:
    case MotionCause::ClockJumped:
    case MotionCause::WouldOutrank: return true;
    case MotionCause::None:
    case MotionCause::Released:
    case MotionCause::HandNotSeen:
    case MotionCause::Gap:
    case MotionCause::HeldTooLong:
    case MotionCause::EnableOff:
    case MotionCause::MonitorChanged:
    case MotionCause::StowAsked:
    case MotionCause::WrongWay:
    case MotionCause::NoMotion:
    case MotionCause::AtStop:
    case MotionCause::AtSoftLimit:
    case MotionCause::Outranked:
    case MotionCause::NoPermissive: return false;
  }
  return true;
}

}  // namespace deckpipe
