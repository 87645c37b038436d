// SPDX-License-Identifier: GPL-3.0-or-later
// The NAME of a J1939 node, and how an Akron PIN goes into it. Only this file knows how many bits an identity
// number has. Source: SAE J1939-81; CAN Messaging manual, Name Field.
#pragma once

#include <bit>
#include <cstdint>

#include "base/ids.h"
#include "bus/frame.h"
#include "protocol/j1939.h"

namespace deckpipe {

// The 64-bit NAME of PGN 60928 and its parts; 0 = none.
struct Name {
  std::uint64_t value = 0;

  static constexpr Name of(const Frame& frame) { return {loadLittle(frame.data)}; }
  constexpr std::uint32_t part(BitRange bits) const {
    return static_cast<std::uint32_t>(readBits(std::bit_cast<Payload>(value), bits));
  }
  constexpr std::uint32_t identityNumber() const {
    return part(fieldOf(j1939::kNameFields, "identity_number").bits);
  }
  constexpr std::uint32_t manufacturerCode() const {
    return part(fieldOf(j1939::kNameFields, "manufacturer_code").bits);
  }
  constexpr std::uint32_t function() const { return part(fieldOf(j1939::kNameFields, "function").bits); }
  constexpr bool isNull() const { return value == 0; }
  constexpr bool isAkron() const { return manufacturerCode() == j1939::kAkronManufacturer; }
  friend constexpr bool operator==(Name, Name) = default;
};

inline constexpr auto kLargestIdentity =
    static_cast<std::uint32_t>(fieldOf(j1939::kNameFields, "identity_number").bits.mask());

// The identity number in the NAME of the device with this PIN: the low bits of its digits 7-15.
constexpr std::uint32_t identityOf(const Pin& pin) { return pin.serial() & kLargestIdentity; }
// Whether the device with this PIN may have this NAME.
constexpr bool isNameOf(Name name, const Pin& pin) {
  return name.isAkron() && name.identityNumber() == identityOf(pin);
}

}  // namespace deckpipe
