// SPDX-License-Identifier: GPL-3.0-or-later
// The life of a link as a table: stage × event → stage. CanLink feeds it what the owner, the device and the
// network interface do, and carries out what the new stage asks for. No Qt, no device, no time in here.
//
// A stage says all there is to do on entering or leaving it:
// 1. shown() is what the listener is told, whenever it changes.
// 2. hasDevice(): a device is made and connected on entering such a stage, and dropped on leaving it.
// 3. isWaiting(): the stage ends by DeviceFailed when nobody answers in time.
#pragma once

#include <cstdint>

#include "base/enum_table.h"
#include "bus/port.h"

namespace deckpipe {

enum class LinkStage : std::uint8_t {
  Closed,
  Asking,   // first opening: it is asked how the network interface is
  Opening,  // first opening: the device connects
  Up,
  Down,       // was up. The interface is down; the socket stays bound to it, so that no frame is missed later
  Away,       // was up. There is no device, as the interface was removed or does not fit
  Returning,  // was up. The interface is back, and a new device connects
};
template <>
inline constexpr LinkStage kLastOf<LinkStage> = LinkStage::Returning;

enum class LinkEvent : std::uint8_t {
  Open,
  Close,
  Fits,     // the interface is up, at the bit rate asked for. Adapters without one fit at once
  IsDown,   // the interface is down
  Unfit,    // the interface is no CAN, or runs at another bit rate
  Missing,  // the interface was removed, or there never was one
  DeviceConnected,
  DeviceFailed,  // it could not be made or connected, nobody answered in time, or its other end went away
};
template <>
inline constexpr LinkEvent kLastOf<LinkEvent> = LinkEvent::DeviceFailed;

LinkStage next(LinkStage stage, LinkEvent event);

LinkState shown(LinkStage stage);
bool hasDevice(LinkStage stage);
bool isWaiting(LinkStage stage);

}  // namespace deckpipe
