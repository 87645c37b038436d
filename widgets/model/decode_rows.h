// SPDX-License-Identifier: GPL-3.0-or-later
// The detail of one frame as lines: how sure its reading is, its fields, its identifier taken apart, and as bytes
// whatever is no field. Plain values, made once for the frame that a person looks at. Where a field
// stands is said as the manuals count (bytes from 1, bits 8..1), and as a set of bits to be drawn.
#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "bus/frame.h"
#include "protocol/classify.h"
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

struct DecodeRow {
  enum class Line : std::uint8_t {
    Title,       // the message's name
    Certainty,   // a sentence: why it is not plain what this is
    Identifier,  // a part of the identifier
    Type,        // the byte that selects the message
    Field,
    Byte,  // not decoded
  };
  Line kind = Line::Field;
  QString name;
  QString value;
  QString raw;
  QString place;
  QString tip;
  BitSet64 bits = 0;      // of the payload
  BitSet64 signBits = 0;  // further bits that the value is read from
  bool isQuiet = false;   // off, or no value: drawn lighter

  friend bool operator==(const DecodeRow&, const DecodeRow&) = default;
};

std::vector<DecodeRow> decodeRows(const Frame& frame, const Classified& what);

}  // namespace deckpipe
