// SPDX-License-Identifier: GPL-3.0-or-later
// Whom a joystick message moves, and what on the bus forbids it: the parts of design.md section 7 that are about
// others. The joystick service (joystick_service.h) asks it at arming, at each frame and at each of its own.
//
// 1. A joystick message has no addressee. Arming names every monitor that is heard, and no other (rule 1).
// 2. A controller that appears, moves or loses its address disarms, and so does a named monitor that is not
//    heard within kHeardWithin (rule 1). Silent controllers cannot be known.
// 3. While it is held no named monitor may report enable off, and none of its enable, operational error and stowed
//    bits may change; nobody else may ask for stow or deploy (rule 6). What is not heard is no cause.
// 4. With a measured position the first move of each axis is looked at (rule 9).
#pragma once

#include <array>
#include <vector>

#include "control/motion.h"
#include "service/service.h"

namespace deckpipe {

// Every device of a channel that may be a monitor: by its type, or as it sends what monitors do. Also one that
// was heard long ago, or lost its address: it may still listen.
std::vector<const Device*> monitorsHeard(const State& state, Channel channel);

class MotionWatch {
 public:
  static constexpr int kWrongWay = 10, kMoved = 3;  // 0.1 degree
  static constexpr int kStrongCommand = 100;        // 0.1 %
  static constexpr Duration kMovesWithin = 1s;

  // Arming, from a joystick's address; refused where the monitors that are heard are not exactly these.
  Refusal arm(Instant now, const Live& live, Address source, const std::vector<Pin>& moves);
  // It is held from now on. Why it must not be; None if it may.
  MotionCause press(Instant now, const Live& live);
  // A frame of another node, which the State has already.
  void heard(const Live& live, const Frame& frame);
  // Why it must not stay armed; None if it may.
  MotionCause whyNotArmed(Instant now, const Live& live) const;
  // Why it must not be held so far; None if it may.
  MotionCause whyNotHeld(Instant now, const Live& live, Deflection x, Deflection y);

 private:
  struct Controller {
    DeviceKey key;
    Address address;
    friend bool operator==(const Controller&, const Controller&) = default;
  };
  // The bits that must not change; nothing where they were not heard.
  struct Bits {
    std::optional<bool> isEnabled, isStowed;
    std::optional<Status2> operationalError;
  };
  struct FirstMove {
    int direction = 0;        // of the command
    std::optional<int> from;  // where the monitor stood when the command began
    Instant since = kNotYet;  // when a strong command began
    bool isDone = false;
  };
  struct Monitor {
    Pin pin;
    Bits atPress;
    std::array<FirstMove, 2> moves;  // rotation, elevation
  };
  static std::vector<Controller> controllers(const Live& live);
  static Bits bitsOf(const Device& device);
  const Device* find(const Live& live, const Pin& pin) const {
    return live.find(DeviceKey::of(pin, live.channel));
  }
  MotionCause followMove(Instant now, const Live& live, const Device& device, FirstMove& move,
                         std::size_t axis, int command) const;
  MotionCause whyNoMotion(const Live& live, const Device& device, std::size_t axis, int direction) const;

  Address m_source = kNullAddress;
  std::vector<Monitor> m_monitors;
  std::vector<Controller> m_controllers;
  bool m_newcomer = false;   // an Akron NAME that no known PIN has
  bool m_stowAsked = false;  // since the press
};

}  // namespace deckpipe
