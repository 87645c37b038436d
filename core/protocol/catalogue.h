// SPDX-License-Identifier: GPL-3.0-or-later
// The whole catalogue: every message the console knows, in the order of MessageId, checked at compile time.
// To add a message: give it a MessageId, a line in its family's table with its fields, and a sample
// (samples.h). The compiler then asks for its words (text/catalogue_words.cpp, text/number_words.cpp) and, if it
// stands in a new group of the page, for its drawing (model/page_lamps.cpp).
#pragma once

#include "base/enum_table.h"
#include "protocol/akron.h"
#include "protocol/copley.h"
#include "protocol/gateway.h"
#include "protocol/j1939.h"

namespace deckpipe {

inline constexpr EnumArray<MessageId, Message> kCatalogue = [] {
  EnumArray<MessageId, Message> all;
  auto at = all.begin();
  const auto append = [&](const auto& family) {
    for (const Message& message : family) *at++ = message;
  };
  append(j1939::kMessages);
  append(akron::kMessages);
  append(gateway::kMessages);
  append(copley::kMessages);
  return all;
}();

constexpr const Message& messageOf(MessageId id) { return kCatalogue[id]; }

// Null where no message has that key.
constexpr const Message* messageByKey(std::string_view key) {
  for (const Message& message : kCatalogue) {
    if (message.key == key) return &message;
  }
  return nullptr;
}

// Whether any message has such a field.
constexpr bool isFieldKey(std::string_view key) {
  for (const Message& message : kCatalogue) {
    for (const Field& field : message.fields) {
      if (field.kind != Kind::Reserved && field.key == key) return true;
    }
  }
  return false;
}

namespace checks {

// The payload bits of a range as a set, byte 1 in the lowest eight.
constexpr std::uint64_t bitSet(BitRange r) {
  Payload bytes{};
  writeBits(bytes, r, ~0ull);
  return loadLittle(bytes);
}

constexpr bool isOpenEnded(Kind kind) {
  return kind == Kind::Bytes || kind == Kind::Tail || kind == Kind::SdoValue;
}

// Every bit of a frame of this length belongs to exactly one field, reserved ones included.
constexpr bool coversExactly(const Message& message, unsigned length) {
  const std::uint64_t wanted = length == 8 ? ~0ull : (1ull << 8 * length) - 1;
  std::uint64_t seen = (1ull << message.selectedBits()) - 1;
  for (const Field& field : message.fields) {
    if (field.view || (field.lengths != 0 && !allows(field.lengths, length))) continue;
    std::uint64_t bits = bitSet(field.bits);
    if (field.kind == Kind::Reserved) {
      bits &= wanted;  // as much of it as the frame has
    } else if (isOpenEnded(field.kind)) {
      bits = ~0ull << field.bits.offset & wanted;
    } else if (field.bits.bytesNeeded() > length) {
      continue;  // missing in so short a frame
    }
    if ((bits & ~wanted) != 0 || (bits & seen) != 0) return false;
    seen |= bits;
  }
  return seen == wanted;
}

constexpr bool everyBitIsAccountedFor() {
  for (const Message& message : kCatalogue) {
    for (unsigned length = 0; length <= 8; ++length) {
      if (allows(message.lengths, length) && !coversExactly(message, length)) return false;
    }
  }
  return true;
}
constexpr bool idsAreInOrder() {
  for (const MessageId id : kAllOf<MessageId>) {
    if (messageOf(id).id != id) return false;
  }
  return true;
}
constexpr bool keysAreUnique() {
  for (const Message& message : kCatalogue) {
    if (message.key.empty() || message.name.empty() || message.source.empty()) return false;
    if (messageByKey(message.key) != &message) return false;
    const auto fields = message.fields;
    for (std::size_t a = 0; a < fields.size(); ++a) {
      if (fields[a].kind == Kind::Reserved) continue;
      if (fields[a].key.empty() || fields[a].name.empty()) return false;
      for (std::size_t b = 0; b < a; ++b) {
        // The same key twice is one value at two places, for frames of different lengths.
        const bool apart =
            fields[a].lengths != 0 && fields[b].lengths != 0 && (fields[a].lengths & fields[b].lengths) == 0;
        if (fields[a].key == fields[b].key && !apart) return false;
      }
    }
  }
  return true;
}

constexpr bool namesAreOfNumbers() {
  for (const Message& message : kCatalogue) {
    for (const Field& field : message.fields) {
      if (field.names.empty()) continue;
      if (field.kind != Kind::Number && field.kind != Kind::SdoValue) return false;
      for (const ValueName& name : field.names) {
        if (name.word.empty() || nameOf(field.names, name.value) != name.word) return false;
      }
    }
  }
  return true;
}

static_assert(namesAreOfNumbers(), "a number has one name, and only numbers have them");
static_assert(idsAreInOrder(), "every MessageId has its line in a family's table, in the order of MessageId");
static_assert(keysAreUnique(), "a key names one thing");
static_assert(everyBitIsAccountedFor(), "fields overlap, leave the payload, or leave bits unsaid");

}  // namespace checks
}  // namespace deckpipe
