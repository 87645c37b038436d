// SPDX-License-Identifier: GPL-3.0-or-later
// From values to a frame, through the same catalogue that decodes. For services and the simulator.
#pragma once

#include <initializer_list>
#include <span>
#include <string_view>

#include "base/result.h"
#include "bus/frame.h"
#include "protocol/catalogue.h"
#include "protocol/value.h"

namespace deckpipe {

struct FieldValue {
  std::string_view key;
  Value value;
};

enum class EncodeError : std::uint8_t {
  UnknownKey,     // the message has no such field
  WrongType,      // e.g. a word for a number
  OutOfRange,     // does not fit the field's bits, or is no word of the field
  NotInvertible,  // null, or derived, where the bits do not follow from it
  WrongLength,    // a length that the message does not have
};

struct Encoded {
  Payload data{};
  std::uint8_t length = 0;
};

// Data bytes of a message. Fields that are not given are 0, reserved bits too, as in the manuals' examples; a
// null deflection or angle becomes 'not available'. `length` chooses among several (0 = the longest);
// `specifier` is byte 1 of an SDO.
Result<Encoded, EncodeError> encode(const Message& message, std::span<const FieldValue> values,
                                    unsigned length = 0, std::uint8_t specifier = 0);
inline Result<Encoded, EncodeError> encode(const Message& message,
                                           std::initializer_list<FieldValue> values = {},
                                           unsigned length = 0) {
  return encode(message, std::span(values.begin(), values.size()), length);
}

// A frame with the message's own PGN and priority; `destination` is ignored where the PGN is a broadcast.
Frame j1939Frame(const Message& message, const Encoded& data, Address source,
                 Address destination = kGlobalAddress);

}  // namespace deckpipe
