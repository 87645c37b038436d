// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a CAN controller, and what an error frame says of it: SocketCAN's error frames carry it as
// class and bytes (linux/can/error.h), and candump logs keep them. The state of a log takes it from its error
// frames, the link from the driver.
#pragma once

#include <optional>

#include "bus/frame.h"

namespace deckpipe {

// Unknown: never told, or no controller is there (vcan).
enum class ControllerState : std::uint8_t {
  Unknown,
  ErrorActive,
  ErrorWarning,
  ErrorPassive,
  BusOff,
  Stopped,
  Sleeping
};

// The controller as its driver described it when it was read last.
struct ControllerReading {
  ControllerState state = ControllerState::Unknown;
  std::uint16_t sendErrors = 0;  // the controller's own counter
  friend bool operator==(const ControllerReading&, const ControllerReading&) = default;
};

inline constexpr std::uint32_t kRestartedClass = 0x100;

// The controller has left bus-off. Frames that it held then were thrown away, without an echo.
constexpr bool isRestart(const Frame& frame) { return frame.isError() && (frame.id & kRestartedClass) != 0; }

// Nothing where the frame is no error frame or speaks of something else. Where it speaks of several, the
// worst.
constexpr std::optional<ControllerState> controllerStateOf(const Frame& frame) {
  constexpr std::uint32_t kController = 0x04, kBusOff = 0x40;      // classes
  constexpr int kWarning = 0x0C, kPassive = 0x30, kActive = 0x40;  // of data[1]: to receive, to send
  if (!frame.isError()) return {};
  if ((frame.id & kBusOff) != 0) return ControllerState::BusOff;
  if (isRestart(frame)) return ControllerState::ErrorActive;
  if ((frame.id & kController) == 0 || frame.length < 2) return {};
  if ((frame.data[1] & kPassive) != 0) return ControllerState::ErrorPassive;
  if ((frame.data[1] & kWarning) != 0) return ControllerState::ErrorWarning;
  if ((frame.data[1] & kActive) != 0) return ControllerState::ErrorActive;
  return {};
}

}  // namespace deckpipe
