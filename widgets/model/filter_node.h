// SPDX-License-Identifier: GPL-3.0-or-later
// One test or connective of a parsed filter. The parser fills it in, TraceFilter evaluates it; nobody else
// sees it.
#pragma once

#include <QStringList>
#include <array>
#include <bitset>
#include <cstdint>
#include <string>
#include <vector>

#include "base/time.h"
#include "bus/frame.h"
#include "model/filter_keys.h"
#include "protocol/catalogue.h"
#include "protocol/classify.h"

namespace deckpipe {

enum class FilterOp : std::uint8_t { Equal, Less, LessEqual, Greater, GreaterEqual, Contains };

struct FilterNumber {
  std::uint64_t low = 0, high = 0;
  std::uint64_t mask = ~std::uint64_t{0};  // id=18EFxx80: the bits that count, of `low`
  bool has(std::uint64_t value) const {
    return mask == ~std::uint64_t{0} ? low <= value && value <= high : (value & mask) == low;
  }
};

struct FilterBytes {
  std::array<std::uint8_t, 8> bytes{}, mask{};
  std::size_t length = 0;
};

// Which titles of the trace satisfy a test on the name: they are few, so it is asked of each once.
struct FilterTitles {
  EnumSet<MessageId> messages, malformed;
  EnumSet<Family> families;
  bool error = false, remote = false;
};

// What contains(text) has found out: traffic repeats itself.
struct FilterMemory {
  struct Entry {
    Frame frame;
    Classified what;
    bool isKnown = false, isMatch = false;
  };
  std::vector<Entry> entries;
};

struct FilterNode {
  enum class Kind : std::uint8_t { And, Or, Not, Key, Field, Text };
  // Kind::Text: a frame whose cells contain this.
  static FilterNode containing(const QString& text);

  Kind kind = Kind::Key;
  int left = -1, right = -1;
  FilterKey key = FilterKey::Id;
  FilterOp op = FilterOp::Equal;
  unsigned byte = 0;                  // Byte: 1 … 8
  std::vector<FilterNumber> numbers;  // any of them
  std::vector<FilterBytes> patterns;
  QStringList words;
  FilterTitles titles;
  bool mayBeStamp = true;  // Text: may stand in the Time column
  std::bitset<256> channels;
  Instant begin;  // of the log, for Seconds
  // Field: which messages have it, and with what it is compared.
  std::string field;
  EnumSet<MessageId> messages;
  std::vector<double> values;
  bool wantsNone = false;
  mutable FilterMemory memory;  // one worker a filter
};

}  // namespace deckpipe
