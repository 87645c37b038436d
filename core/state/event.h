// SPDX-License-Identifier: GPL-3.0-or-later
// One change of what is known of a log, found by state/event_walk.h.
#pragma once

#include "base/event_kind.h"
#include "base/ids.h"
#include "base/time.h"

namespace deckpipe {

struct Event {
  EventKind kind = EventKind::ClockJump;
  std::uint8_t axis = 0;  // 1 to 5; 0: it is about none
  bool isPlus = false;    // the side of a stop or soft limit: right, up
  // Changes of the same thing right before this one that were not told, as they came too fast for a reader.
  std::uint32_t folded = 0;
  std::uint64_t frame = 0;  // so many frames had happened, as in a cursor
  Instant time;
  Channel channel;
  // Whom it concerns: the PIN, where it is known, and the address or node at that time.
  Address address;  // null: none
  NodeId node;      // 0: none
  Pin pin;
  Pin other{};           // TwoAtOneAddress: the second one, where it said who it is
  std::int64_t was = 0;  // by kEvents[kind].detail
  std::int64_t now = 0;
  std::uint32_t bitRate = 0;   // LoadHigh, LoadNormal: the load is of so many bit/s
  bool isRateAssumed = false;  // the log does not say that rate
  // Silent, JoystickEnded: when it was heard last, or when the link came up, if that was later. Others: since when it holds, if it was told later.
  Instant since = kNotYet;
  friend bool operator==(const Event&, const Event&) = default;
};

}  // namespace deckpipe
