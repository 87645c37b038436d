// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame is, in the words of people: its name, what it says on one line, how sure that is. The trace
// asks for names and summaries once for each row it shows, the decode detail for the sentence.
#pragma once

#include <QString>

#include "bus/frame.h"
#include "protocol/classify.h"
#include "protocol/j1939_names.h"

namespace deckpipe {

// "Position / limit status", "Malformed: …", "Ambiguous", "Remote request", "Ambient conditions (AMB)"; empty where nothing
// is known.
QString frameTitle(const Frame& frame, const Classified& what);

// The standard's name for the group of a frame that is not decoded and whose title is that name; null for any other.
const j1939::StandardGroup* standardGroup(const Frame& frame, const Classified& what);

// What matters of it first, and nothing that is only off: "Rotation 47.3°, Elevation −5.5°, Axis 5 (+) hard
// stop". The lengths wanted of a malformed one, the classes of an error frame.
QString summaryText(const Frame& frame, const Classified& what);

// Why a frame is taken for what it is, where that is not plain: malformed, presumed, ambiguous, not decoded.
// Empty where it is plain.
QString certaintyText(const Frame& frame, const Classified& what);

// "8 bytes wanted, 7 came".
QString malformedText(const Classified& what, unsigned length);
// The classes of an error frame as SocketCAN numbers them.
QString errorText(const Frame& frame);

}  // namespace deckpipe
