// SPDX-License-Identifier: GPL-3.0-or-later
// What Linux knows about a CAN network interface: whether it is up, at which bit rate, whether it listens
// only, how its controller is. Qt's socketcan plugin tells none of that, and reports 'connected' on an
// interface that is down. Read over rtnetlink, which needs no privilege. On other systems every read fails.
//
// A read asks the kernel and may wait for its network lock, for hundreds of milliseconds where somebody
// sets up a network. So it is made on a worker thread (InterfaceReader), never on the bus thread.
// parseLinkMessages() asks nothing and never waits.
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
  bool isRemoved = false;     // this message says that the interface was removed
  bool isListenOnly = false;  // the controller neither sends nor acknowledges
  bool hasFlexibleDataRate = false;
  // The driver itself loops sent frames back (IFF_ECHO). Where it does not, as with slcan and vcan, the
  // kernel does it when the frame is queued, and the echo says nothing about the bus.
  bool echoesInDriver = false;
  std::uint32_t bitRate = 0;     // bit/s; 0: not known or none
  std::uint32_t restartMs = 0;   // the driver restarts so long after bus-off; 0: by hand only
  std::uint16_t sendErrors = 0;  // the controller's counters
  std::uint16_t receiveErrors = 0;
  std::uint64_t receivedFrames = 0;  // since the interface was made, for all programs together
  // Losses in controller and driver, before any socket. One count may stand for several frames.
  std::uint64_t overruns = 0;
  ControllerState controller = ControllerState::Unknown;
};

// The interface of that name, CAN or not. The error is a sentence of the system.
Result<CanInterface, std::string> readInterface(const std::string& name);

// Every CAN interface, up or down, by name. Empty where the system has none or cannot tell.
std::vector<CanInterface> readCanInterfaces();

// The links in one datagram of rtnetlink, whose bytes are in native order. Other messages, and those cut
// short, are skipped.
std::vector<CanInterface> parseLinkMessages(std::span<const std::byte> datagram);

}  // namespace deckpipe
