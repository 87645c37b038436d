// SPDX-License-Identifier: GPL-3.0-or-later
// The port to hardware, as small as it can be: open, close, write, and what was received. The adapter
// (app/link) and the fake of the tests implement it; the bus thread owns it and calls it from one thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "bus/frame.h"

namespace deckpipe {

enum class LinkState : std::uint8_t { Closed, Connecting, Up, Lost };

enum class WriteResult : std::uint8_t {
  Accepted,   // handed to the adapter; only an echo proves that it reached the bus
  QueueFull,  // not sent; counts as unconfirmed
  NotOpen,
  Failed,
};

class PortListener {
 public:
  virtual ~PortListener() = default;
  // In arrival order. Own frames come back here with kSent | kConfirmed where the port echoes.
  virtual void framesReceived(std::span<const Frame> frames) = 0;
  // `reason` is the adapter's own words where it gives any, for showing beside our own sentence.
  virtual void linkChanged(LinkState state, const std::string& reason) = 0;
};

class Port {
 public:
  virtual ~Port() = default;
  // Starts opening; the outcome comes as linkChanged, perhaps within this call.
  virtual void open(PortListener& listener) = 0;
  virtual void close() = 0;
  virtual WriteResult write(const Frame& frame) = 0;
  // Whether frames we wrote come back once they were on the bus. Arming needs it.
  virtual bool echoes() const = 0;
};

}  // namespace deckpipe
