// SPDX-License-Identifier: GPL-3.0-or-later
// Where a field stands in its frame, as the manuals count it (bytes from 1, bits 8..1) and as a set of bits
// to be drawn. For the decode detail.
#pragma once

#include <QString>
#include <cstdint>

#include "bus/frame.h"
#include "protocol/field.h"

namespace deckpipe {

// The bits of a payload as a set: byte 1 in the lowest eight, its bit 8 the highest of them.
using BitSet64 = std::uint64_t;

// The range that a field takes in this frame: open-ended ones end with the data. Width 0 where a value is not
// read from bits (the size of a value).
BitRange rangeOf(const Field& field, const Frame& frame);

BitSet64 bitsOf(BitRange range);
// The status bits that give a field its sign.
BitSet64 signBitsOf(const Field& field);

// "B2.8–B3.5", "B6.8–7", "B2–B3", "B1.8–7, B2" (low byte first: the low bits' byte first).
QString placeText(BitRange range);
// Up to 16 bits in binary, by four; more in hex.
QString rawText(BitRange range, const Payload& data);

}  // namespace deckpipe
