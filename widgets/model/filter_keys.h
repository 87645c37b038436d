// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the filter language (trace_filter.h): keys of the frame itself and flags, with what they mean.
// For the parser, the completion and the help.
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <span>
#include <string_view>

#include "protocol/field.h"

namespace deckpipe {

enum class FilterKey : std::uint8_t {
  // hex
  Id,
  Pgn,
  Source,
  Destination,
  Node,
  Type,
  Byte,  // b1 … b8
  Data,
  // decimal
  Priority,
  Length,
  FrameNumber,
  Seconds,
  // words
  ChannelName,
  Direction,
  Name,
  Family,
  // flags
  Error,
  Remote,
  Malformed,
  Presumed,
  Ambiguous,
  Decoded,
  TimeJump,
};

struct FilterKeyWord {
  const char* word;
  FilterKey key;
  const char* help;  // for people, translatable
};

std::span<const FilterKeyWord> filterKeyWords();
constexpr bool isFlag(FilterKey key) { return key >= FilterKey::Error; }

// The words that a field may be compared with, "off", "on", …; empty where it has none.
QStringList wordsOf(const Field& field);

// What could stand where a person is typing.
struct FilterCompletions {
  int from = 0;  // the characters from here to the cursor are replaced
  struct Entry {
    QString word;
    QString help;
  };
  std::vector<Entry> entries;  // that begin with what is there, alphabetically after their rank
};
FilterCompletions filterCompletions(const QString& text, int cursor, const QStringList& channels);

// Every key and operator with an example, as lines of rich text.
QString filterHelp();

}  // namespace deckpipe
