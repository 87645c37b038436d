// SPDX-License-Identifier: GPL-3.0-or-later
// One field of a message as data: where its bits are and what they mean. The tables of the families
// (j1939.h, akron.h, gateway.h, copley.h) are made of these; decode, encode, the trace's detail and every
// export read them, and nothing else in the tree knows where a bit is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/bits.h"

namespace deckpipe {

enum class Kind : std::uint8_t {
  Number,    // unsigned, scaled by 10^-decimals
  Signed,    // two's complement, scaled by 10^-decimals
  Flag,      // one bit
  Status2,   // 0 off, 1 on, 2 error, 3 na
  Word,      // a number with names; unnamed numbers stay numbers, or become `otherwise`
  Version,   // 16 bits big-endian, "major.minor"
  Float32,   // IEEE 754; not finite is no value
  Bytes,     // opaque, from its offset to the end of the data
  Tail,      // unsigned little-endian, from its offset to the end of the data
  TailSize,  // number of bytes of the Tail at the same offset
  Reserved,  // written down, never shown as a value

  // Composed; `plus` and `minus` are the two status2 that give the sign.
  AxisPercent,    // joystick deflection, signed percent
  Position,       // angle in degrees, null unless its state is ok
  PositionState,  // ok, sensor_error, not_fitted, invalid
  Pin,            // the 15 characters of an address announcement
  FaultNames,     // keys of the fault bits that are set
  FaultNumbers,   // numbers of the set bits that have no name
  SdoValue,       // little-endian, as many bytes as the command specifier says
  SdoSize,        // that number of bytes
  AbortText,      // CiA 301's text of an abort code
};

enum class Unit : std::uint8_t { None, Degree, Percent, Ampere, CountsPerSecond, Count };

// What decoding gives for a field whose bytes the frame does not have.
enum class Missing : std::uint8_t { Null, LeaveOut };

struct ValueName {
  std::uint32_t value;
  std::string_view word;
};

// Empty where the number has no name.
constexpr std::string_view nameOf(std::span<const ValueName> names, std::int64_t number) {
  for (const ValueName& name : names) {
    if (name.value == number) return name.word;
  }
  return {};
}

struct Field {
  std::string_view key{};   // frozen contract
  std::string_view name{};  // for people, translatable
  Kind kind = Kind::Number;
  BitRange bits{};
  std::uint8_t decimals = 0;
  Unit unit = Unit::None;
  BitRange plus{}, minus{};            // AxisPercent, Position, PositionState
  std::span<const ValueName> words{};  // Word
  std::string_view otherwise{};        // Word: what an unnamed number is called, if not by its number
  std::span<const ValueName> names{};  // Number, SdoValue: for people, translatable; the value stays a number
  Missing missing = Missing::Null;
  std::uint16_t lengths = 0;    // only in frames of these lengths (bit n = n bytes); 0 = in all
  std::uint32_t sdoObject = 0;  // only for this object (index << 8 | sub-index); 0 = for all
  bool view = false;            // reads bits that another field already accounts for
  bool aside = false;           // says nothing of the device: a change of it alone is no news
};

// Builders, so that a table line reads like a line of the manual.
constexpr BitRange big(unsigned byte, unsigned bit, unsigned width) {
  return {ByteOrder::Big, static_cast<std::uint8_t>((byte - 1) * 8 + (8 - bit)),
          static_cast<std::uint8_t>(width)};
}
constexpr BitRange little(unsigned byte, unsigned width, unsigned bit = 1) {
  return {ByteOrder::Little, static_cast<std::uint8_t>((byte - 1) * 8 + (bit - 1)),
          static_cast<std::uint8_t>(width)};
}
constexpr Field number(std::string_view key, std::string_view name, BitRange bits) {
  return {.key = key, .name = name, .kind = Kind::Number, .bits = bits};
}
constexpr Field scaled(std::string_view key, std::string_view name, Kind kind, BitRange bits, int decimals,
                       Unit unit) {
  return {.key = key,
          .name = name,
          .kind = kind,
          .bits = bits,
          .decimals = static_cast<std::uint8_t>(decimals),
          .unit = unit};
}
// One bit, counted as the manuals do: byte from 1, bit 8 the most significant.
constexpr Field flag(std::string_view key, std::string_view name, unsigned byte, unsigned bit) {
  return {.key = key, .name = name, .kind = Kind::Flag, .bits = big(byte, bit, 1)};
}
// Two bits; `bit` is the upper one.
constexpr Field status2(std::string_view key, std::string_view name, unsigned byte, unsigned bit) {
  return {.key = key, .name = name, .kind = Kind::Status2, .bits = big(byte, bit, 2)};
}
constexpr Field version(std::string_view key, std::string_view name, unsigned byte) {
  return {.key = key, .name = name, .kind = Kind::Version, .bits = big(byte, 8, 16)};
}
constexpr Field named(std::span<const ValueName> names, Field field) {
  field.names = names;
  return field;
}
constexpr Field reserved(BitRange bits) { return {.kind = Kind::Reserved, .bits = bits}; }
constexpr Field onlyIn(std::uint16_t lengths, Field field) {
  field.lengths = lengths;
  return field;
}
constexpr Field orLeftOut(Field field) {
  field.missing = Missing::LeaveOut;
  return field;
}
constexpr Field viewOf(Field field) {
  field.view = true;
  return field;
}
constexpr Field aside(Field field) {
  field.aside = true;
  return field;
}
constexpr Field forObject(std::uint32_t object, Field field) {
  field.sdoObject = object;
  return viewOf(field);
}

template <std::size_t... N>
constexpr auto joinFields(const std::array<Field, N>&... parts) {
  std::array<Field, (N + ...)> all{};
  std::size_t at = 0;
  const auto append = [&](const auto& part) {
    for (const Field& field : part) all[at++] = field;
  };
  (append(parts), ...);
  return all;
}

}  // namespace deckpipe
