// SPDX-License-Identifier: GPL-3.0-or-later
// The port to hardware, as small as it can be: open, close, write, and what was received. The adapter
// (app/link) and the fake of the tests implement it; the bus thread owns it and calls it from one thread.
//
// 1. The listener is called from the port's own thread, never from inside write(): what a write leads to
//    (its echo, a lost link) comes later, so a service may write from wherever it likes.
// 2. Frames, losses and own frames come in one order, the order of arrival. A frame we wrote comes exactly
//    once: with kSent | kConfirmed where the port echoes, with kSent alone where it does not.
// 3. After close() returns, and while the port is destroyed, the listener is not called any more. It must
//    not destroy the port from inside a call.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "bus/frame.h"

namespace deckpipe {

enum class LinkState : std::uint8_t {
  Closed,      // not opened, closed by us, or never came up
  Connecting,  // the outcome is open
  Up,
  Lost,  // was up; the adapter, the driver or the other end went away. May come up again by itself
};

enum class WriteResult : std::uint8_t {
  Accepted,   // handed to the adapter; only an echo proves that it reached the bus
  QueueFull,  // not sent; counts as unconfirmed
  NotOpen,
  Failed,  // not sent, and not for want of room
};

// Why something that was on the bus is not among the frames.
enum class NotKept : std::uint8_t {
  FlexibleDataRate,  // a CAN FD frame
  Invalid,           // what the adapter handed over is no classic CAN frame
  Overflow,          // the kernel dropped it, as its receive buffer was full; echoes of own frames too
  Overrun,           // controller or driver lost it on its way from the bus; never an echo
};

class PortListener {
 public:
  virtual ~PortListener() = default;
  virtual void framesReceived(std::span<const Frame> frames) = 0;
  // `count` frames are missing at this place.
  virtual void framesNotKept(NotKept reason, std::uint32_t count) = 0;
  // Also with the state it had before, when the adapter reports a fault that leaves the link standing.
  // `reason` is the adapter's own words where it gives any, for showing beside our own sentence.
  virtual void linkChanged(LinkState state, const std::string& reason) = 0;
};

class Port {
 public:
  virtual ~Port() = default;
  // Starts opening; the outcome comes as linkChanged, perhaps within this call. An open port is closed first.
  virtual void open(PortListener& listener) = 0;
  // Hands over what has arrived, then says Closed, both within this call.
  virtual void close() = 0;
  virtual WriteResult write(const Frame& frame) = 0;
  // Whether frames we wrote come back once they were on the bus. Arming needs it.
  virtual bool echoes() const = 0;
};

}  // namespace deckpipe
