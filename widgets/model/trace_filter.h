// SPDX-License-Identifier: GPL-3.0-or-later
// The filter language of the trace: which frames are shown, and what is searched for. Parsed once in the
// window, where a mistake is said with its place; matched by the sieve and the search on their workers.
//
//   expression = term { "or" term }            also ||
//   term       = factor { ["and"] factor }     also &&; tests side by side are both wanted
//   factor     = "not" factor | "(" expression ")" | flag | test | text   also !
//   test       = key operator value { "," value }
//   operator   = "=" | "!=" | "<" | "<=" | ">" | ">=" | "~" | "!~"        ~ contains, !~ does not
//   value      = word | "words in quotes"
//   text       = value                     that is no key: some cell of the frame contains it
//
// soft limits, 18EFFF80         frames whose cells contain these words
// pgn=EF00 and sa=80            hex keys: id, pgn, sa, da, node, type, data, b1 … b8
// id=18EFFF80, id=18EFxx80      x is any digit; up to three digits are an 11-bit identifier
// id=100-1FF, len=2,8           ranges, and any of several
// data~"01 1D"                  these bytes one after another; data=… the whole, xx any byte
// name~"soft limits"            the name shown, or the catalogue's key
// rotation_deg>30, enable=off   fields of the catalogue by key, as decoded; rotation_deg=none has no value
// t>=12.5 and t<20              seconds of log time since the log's begin
// err, remote, malformed, …     flags; filter_keys.h lists all
//
// "!=" and "!~" are the exact opposite of "=" and "~": a frame without the thing asked for passes them, and
// never passes the others.
#pragma once

#include <QString>
#include <QStringList>
#include <array>
#include <bitset>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/time.h"
#include "bus/frame.h"
#include "log/frame_store.h"
#include "model/filter_keys.h"
#include "protocol/catalogue.h"
#include "protocol/classify.h"
#include "protocol/j1939_names.h"

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
  std::vector<const j1939::StandardGroup*> groups;
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

// One test or connective of a parsed filter. The parser fills it in, TraceFilter evaluates it; nobody else
// sees it.
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

struct FilterError {
  int at = 0;  // in the expression, in characters
  int length = 0;
  QString text;  // what was expected there, a sentence
};

struct FilterFrame {
  const Frame& frame;
  std::uint64_t index;
  Instant time;
  const Classified& what;  // only looked at where needsRoles()
};

class TraceFilter {
 public:
  // Lets everything through, as does an expression of blanks.
  TraceFilter() = default;
  static Result<TraceFilter, FilterError> parse(const QString& expression);
  // Frames whose cells contain this text, whatever it is. Slower than an expression: words are made.
  static TraceFilter containing(const QString& text);

  bool isEmpty() const { return m_nodes.empty(); }
  // What it was made of.
  const QString& text() const { return m_text; }
  // Whether a frame's meaning decides, not its bytes alone.
  bool needsRoles() const { return m_needsRoles; }
  // Names of channels and the begin of time are those of this log from now on; again when it has grown.
  void bind(const FrameStore& frames);
  bool matches(const FilterFrame& frame) const;

 private:
  friend class FilterParser;
  bool matches(int node, const FilterFrame& frame) const;

  QString m_text;
  std::vector<FilterNode> m_nodes;  // children before parents, the root last
  bool m_needsRoles = false;
};

}  // namespace deckpipe
