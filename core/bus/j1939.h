// SPDX-License-Identifier: GPL-3.0-or-later
// The 29-bit identifier of SAE J1939 taken apart and put together.
#pragma once

#include <cstdint>

#include "base/ids.h"
#include "bus/frame.h"

namespace deckpipe {

struct J1939Id {
  std::uint8_t priority = 6;  // 0 highest .. 7; never part of what a message means
  std::uint32_t pgn = 0;      // 18 bits with both data pages; PDU specific is part of it above PDU format EF
  Address source = kNullAddress;
  Address destination = kGlobalAddress;  // global for PDU2

  static constexpr J1939Id of(std::uint32_t identifier) {
    const std::uint32_t format = (identifier >> 16) & 0xFF;
    const std::uint32_t specific = (identifier >> 8) & 0xFF;
    const std::uint32_t pages = (identifier >> 8) & 0x3'0000;
    J1939Id id;
    id.priority = static_cast<std::uint8_t>((identifier >> 26) & 7);
    id.source = {static_cast<std::uint8_t>(identifier)};
    id.pgn = pages | format << 8 | (format >= 240 ? specific : 0);
    id.destination = format >= 240 ? kGlobalAddress : Address{static_cast<std::uint8_t>(specific)};
    return id;
  }
  // PDU1: the message has a destination. PDU2 messages are broadcasts without one.
  constexpr bool hasDestination() const { return (pgn >> 8 & 0xFF) < 240; }
  // The identifier as Frame::id has it, kExtendedBit set.
  constexpr std::uint32_t frameId() const {
    return kExtendedBit | static_cast<std::uint32_t>(priority & 7) << 26 | pgn << 8 |
           (hasDestination() ? static_cast<std::uint32_t>(destination.value) << 8 : 0u) | source.value;
  }
};

namespace pgn {
inline constexpr std::uint32_t kAcknowledgement = 0xE800;   // 59392
inline constexpr std::uint32_t kRequest = 0xEA00;           // 59904
inline constexpr std::uint32_t kTransport = 0xEC00;         // 60416, announces what is longer than a frame
inline constexpr std::uint32_t kCommandedAddress = 0xFED8;  // 65240, over transport
inline constexpr std::uint32_t kAddressClaimed = 0xEE00;    // 60928, the NAME
inline constexpr std::uint32_t kProprietaryA = 0xEF00;      // 61184, Akron's and Copley's messages
inline constexpr std::uint32_t kBasicJoystick = 0xFDD6;     // 64982
inline constexpr std::uint32_t kExtendedJoystick = 0xFDD7;  // 64983
}  // namespace pgn

}  // namespace deckpipe
