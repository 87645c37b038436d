// SPDX-License-Identifier: GPL-3.0-or-later
// What the dial shows, as plain values. A panel fills it from a snapshot of the state at the cursor; nothing
// here knows a message. Degrees throughout: rotation 0 ahead, right positive; elevation 0 level, up positive.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>

#include "base/time.h"

namespace deckpipe {

struct DialAxis {
  enum class Reading : std::uint8_t {
    NoData,       // no such message was ever seen
    Ok,           // `degrees` holds what the sensor said
    SensorError,  // the controller says that its sensor failed
    NotFitted,    // the controller says that it has no sensor
    Invalid,      // the bits contradict one another
  };
  enum class Stop : std::uint8_t { Unknown, Off, On, Error, NotAvailable };

  // Who moves this axis and how fast: −1 (left, down) .. +1 (right, up).
  struct Command {
    double speed = 0;
    QString source;  // as people call it: "Joystick 33"
    friend bool operator==(const Command&, const Command&) = default;
  };

  Reading reading = Reading::NoData;
  double degrees = 0;           // from feedback only; read only where reading is Ok
  bool stale = false;           // the message that carries reading and stops is overdue
  std::optional<Duration> age;  // of that message
  Stop plusStop = Stop::Unknown;
  Stop minusStop = Stop::Unknown;

  std::optional<double> limitLow;  // soft limits: left or down end, right or up end
  std::optional<double> limitHigh;
  bool limitsStale = false;
  bool oscillating = false;  // rotation only: the limits are then the oscillation's ends

  std::optional<Command> command;

  friend bool operator==(const DialAxis&, const DialAxis&) = default;
};

struct DialValues {
  enum class Flag : std::uint8_t { Unknown, Off, On };

  DialAxis rotation;
  DialAxis elevation;
  Flag enable = Flag::Unknown;  // motion allowed
  Flag stowed = Flag::Unknown;

  friend bool operator==(const DialValues&, const DialValues&) = default;
};

}  // namespace deckpipe
