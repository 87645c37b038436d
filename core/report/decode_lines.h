// SPDX-License-Identifier: GPL-3.0-or-later
// The machine-readable output of `deckpipectl decode`: one line a frame, as JSON lines, CSV or text. The JSON
// keys are a frozen contract (protocol.md section 5). Whoever walks a log classifies each frame and hands
// both over; nothing is kept between lines.
#pragma once

#include <string>
#include <string_view>

#include "bus/frame.h"
#include "protocol/classify.h"

namespace deckpipe {

enum class DecodeFormat : std::uint8_t { JsonLines, Csv, Text };

// The word of a family in output; empty for None.
std::string_view familyKey(Family family);
// "8 bytes wanted, 7 came"; for a malformed frame.
std::string malformedReason(const Classified& what, unsigned length);

// The line that CSV begins with, with its line feed; empty for the others.
std::string_view decodeHeader(DecodeFormat format);
// Appends one line with its line feed.
void appendDecoded(std::string& out, DecodeFormat format, const Frame& frame, std::string_view channel,
                   const Classified& what);

}  // namespace deckpipe
