// SPDX-License-Identifier: GPL-3.0-or-later
// What a device is, as far as the state tells: its PIN says it, or its part number, or what it sends. The window and
// the headless tool have their own words for it.
#pragma once

#include <optional>

#include "state/state.h"

namespace deckpipe {

// What a device is, from the best that is known of it.
struct DeviceType {
  enum class From : std::uint8_t {
    Pin,            // number: PIN digits 1-4
    Part,           // number: part number of SDO 5000.01
    Messages83,     // sends what only monitors send
    Messages84,     // … only the 6033
    Messages85,     // … only the 6039 CAN I/O module
    AkronMessages,  // … only Akron devices
    AkronName,      // has a NAME of Akron's, has not announced itself
    OtherName,      // number: manufacturer code
    Drive,          // a person said that a Copley drive is there
    Own,            // the console itself
    NoName,
    GatewayNode,  // the 6051's default node number; nothing else known
    MonitorNode,  // a CANopen node that sends a monitor's PDOs
    CanopenNode,
  };
  From from = From::NoName;
  std::uint32_t number = 0;

  // As PIN digits 1-4, where that is known.
  std::optional<unsigned> pinDigits() const;
  friend bool operator==(const DeviceType&, const DeviceType&) = default;
};

DeviceType typeOf(const Device& device);
// Of a J1939 address at which there is no device of Akron's.
DeviceType typeOf(const State& state, Channel channel, Address address);
bool isMonitor(const Device& device);

}  // namespace deckpipe
