// SPDX-License-Identifier: GPL-3.0-or-later
// A frame in words, for people: the line of the text output and of what is copied from the trace.
#pragma once

#include <string>
#include <string_view>

#include "bus/frame.h"
#include "protocol/classify.h"

namespace deckpipe {

// 8 upper-case hex digits for a 29-bit identifier, 3 for an 11-bit one; an error frame's as candump writes
// it.
void appendIdentifier(std::string& out, const Frame& frame);

// What SAE J1939 calls the parameter group of a frame that nobody here decodes: "Vehicle position (VP)". Nothing for
// one without a name (protocol/j1939_names.h).
void appendGroupName(std::string& out, const Frame& frame, const Classified& what);

// What a frame says, on one line: "rotation_deg 47.3, rotation_plus on, …"; the reason of a malformed one,
// and empty where nothing is decoded.
void appendSummary(std::string& out, const Frame& frame, const Classified& what);

// Time, channel, identifier, length, bytes, family, message and summary, with a line feed.
void appendTraceLine(std::string& out, const Frame& frame, std::string_view channel, const Classified& what);

}  // namespace deckpipe
