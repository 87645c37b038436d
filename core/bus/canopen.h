// SPDX-License-Identifier: GPL-3.0-or-later
// The 11-bit identifier (COB-ID) of CANopen's predefined connection set, CiA 301.
#pragma once

#include <cstdint>

#include "base/ids.h"

namespace deckpipe {

// Function code with a node id of zero: COB-ID = function + node.
enum class CobFunction : std::uint16_t {
  Nmt = 0x000,
  Emergency = 0x080,
  Tpdo1 = 0x180,
  Rpdo1 = 0x200,
  Tpdo2 = 0x280,
  SdoResponse = 0x580,
  SdoRequest = 0x600,
  Heartbeat = 0x700,
};

// TPDO1, RPDO1 .. TPDO4, RPDO4.
constexpr bool isPdo(std::uint32_t function) { return function >= 0x180 && function <= 0x500; }

struct CobId {
  std::uint16_t function = 0;  // identifier with the node id masked out
  NodeId node;                 // 0 where the message is for nobody in particular

  static constexpr CobId of(std::uint32_t identifier) {
    return {static_cast<std::uint16_t>(identifier & 0x780), {static_cast<std::uint8_t>(identifier & 0x7F)}};
  }
  // In the predefined connection set a node's COB-IDs are EMCY, the PDOs, the SDOs and NMT error control.
  constexpr bool hasNode() const {
    return node.value != 0 && function != 0 && function != 0x100 && function != 0x680 && function != 0x780;
  }
};

}  // namespace deckpipe
