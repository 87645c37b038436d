// SPDX-License-Identifier: GPL-3.0-or-later
// JSON, written: the few shapes that reports need, straight into a string.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "protocol/value.h"

namespace deckpipe {

// A string literal with its quotes. Bytes that are no UTF-8 are read as Latin-1, so the output always is
// UTF-8.
void appendJsonString(std::string& out, std::string_view text);
void appendJsonNumber(std::string& out, std::int64_t number);
// protocol.md section 5: flags true or false, words and texts strings, opaque bytes upper-case hex, named
// bits a list of keys, unnamed bits a list of numbers, no value null.
void appendJsonValue(std::string& out, const Value& value);

// Seconds with six decimals of a stamp in nanoseconds; null where the log has none.
void appendJsonSeconds(std::string& out, std::int64_t stampNs);

void appendHex(std::string& out, std::uint64_t value, unsigned digits);

}  // namespace deckpipe
