// SPDX-License-Identifier: GPL-3.0-or-later
// What the dial shows, as plain values. The page of a monitor fills it from the state at the cursor
// (dialOf() of the model room); nothing here knows a message. Degrees throughout: rotation 0 ahead, right positive;
// elevation 0 level, up positive.
#pragma once

#include <QString>
#include <optional>

#include "base/ids.h"
#include "base/part_state.h"
#include "base/time.h"

namespace deckpipe {

struct DialAxis {
  // Who moves this axis and how fast: −1 (left, down) .. +1 (right, up).
  struct Command {
    double speed = 0;
    QString source;               // as people call it: "Joystick 33"
    Address from = kNullAddress;  // null: not known, by way of the gateway
    friend bool operator==(const Command&, const Command&) = default;
  };

  std::optional<PositionState> reading;  // nothing: no such message ever came
  double degrees = 0;                    // from feedback only; read only where reading is Ok
  bool isStale = false;  // the message that carries reading and stops is overdue, or its link down
  Age age;               // of that message
  std::optional<Status2> plusStop, minusStop;

  std::optional<double> limitLow;  // soft limits: left or down end, right or up end
  std::optional<double> limitHigh;
  bool areLimitsStale = false;
  bool isOscillating = false;  // rotation only: the limits are then the oscillation's ends

  std::optional<Command> command;

  friend bool operator==(const DialAxis&, const DialAxis&) = default;
};

struct DialValues {
  DialAxis rotation;
  DialAxis elevation;
  std::optional<bool> enable, stowed;  // nothing: the outputs never came, or are stale

  friend bool operator==(const DialValues&, const DialValues&) = default;
};

}  // namespace deckpipe
