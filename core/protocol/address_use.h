// SPDX-License-Identifier: GPL-3.0-or-later
// Which addresses a program on the bus may choose for itself. On a joystick's address it would be obeyed as
// that joystick, on a monitor's it would push the monitor off: a NAME decides who keeps an address, and ours
// may be the lower one. The tool's option, the settings of the window and the claim service all ask this.
// Sources: CAN Messaging manual, Appendix A and B; SAE J1939-81.
#pragma once

#include "base/ids.h"

namespace deckpipe {

// Controllers obey joystick messages from these; the first has the highest priority.
inline constexpr Address kFirstJoystick{0x33}, kLastJoystick{0x38};
// Devices that may take any address claim theirs from these. Akron's begin at the first.
inline constexpr Address kFirstDynamic{0x80}, kLastDynamic{0xF7};
// Off-board service tools.
inline constexpr Address kServiceTool1{0xF9}, kServiceTool2{0xFA};
// What the NAME of such a tool, and so of every console of ours, has as its function.
inline constexpr std::uint32_t kServiceToolFunction = 129;

constexpr bool isJoystickAddress(Address a) { return a >= kFirstJoystick && a <= kLastJoystick; }
constexpr bool isDynamicAddress(Address a) { return a >= kFirstDynamic && a <= kLastDynamic; }

enum class AddressUse : std::uint8_t {
  Ok,
  Warn,     // below 80 hex: SAE gave it to a device, which may be on this bus
  Refused,  // a joystick's or a monitor's, or no address at all (FE, FF)
};

// What a person should know who wants this address for the console.
constexpr AddressUse addressUse(Address a) {
  if (isJoystickAddress(a) || isDynamicAddress(a) || a >= kNullAddress) return AddressUse::Refused;
  return a < kFirstDynamic ? AddressUse::Warn : AddressUse::Ok;
}

}  // namespace deckpipe
