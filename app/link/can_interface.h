// SPDX-License-Identifier: GPL-3.0-or-later
// What Linux knows about a CAN network interface: whether it is up, at which bit rate, whether it listens
// only, how its controller is. Qt's socketcan plugin tells none of that, and reports 'connected' on an
// interface that is down. Read over rtnetlink, which needs no privilege. On other systems every read fails.
//
// CanLink reads it before and after opening, the adapter list for what to offer, InterfaceWatch on changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "bus/controller.h"

namespace deckpipe {

struct CanInterface {
  int index = 0;
  std::string name;
  std::string kind;           // of the driver: "can", "vcan"; empty where it names none
  bool isCan = false;         // false for Ethernet and its like
  bool isUp = false;          // set up by the administrator
  bool isRemoved = false;     // this message says that it went away
  bool isListenOnly = false;  // the controller neither sends nor acknowledges
  bool hasFlexibleDataRate = false;
  std::uint32_t bitRate = 0;    // bit/s; 0: not known or none
  std::uint32_t restartMs = 0;  // after bus-off the driver starts again after so long; 0: by hand only
  std::uint16_t sendErrors = 0;
  std::uint16_t receiveErrors = 0;
  std::uint64_t receivedFrames = 0;  // since the interface was made, whoever listens
  std::uint64_t overruns =
      0;  // frames that controller and driver lost before any socket saw them; one may be several
  ControllerState controller = ControllerState::Unknown;
};

// The interface of that name, CAN or not. The error is a sentence of the system.
Result<CanInterface, std::string> readInterface(const std::string& name);

// Every CAN interface, up or down, by name. Empty where the system has none or cannot tell.
std::vector<CanInterface> readCanInterfaces();

// The links that a datagram of rtnetlink tells of; whatever else is in it, and what is cut short, is passed
// over. Bytes as the kernel writes them, native byte order.
std::vector<CanInterface> parseLinkMessages(std::span<const std::byte> datagram);

}  // namespace deckpipe
