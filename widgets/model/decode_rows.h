// SPDX-License-Identifier: GPL-3.0-or-later
// The detail of one frame as lines: its identifier taken apart, how sure its reading is, its fields, and as
// bytes whatever is no field. Plain values, made once for the frame that a person looks at.
#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "bus/frame.h"
#include "model/bit_place.h"
#include "protocol/classify.h"

namespace deckpipe {

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
