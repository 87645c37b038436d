// SPDX-License-Identifier: GPL-3.0-or-later
// What an expression of the filter language (trace_filter.h) is made of: read one by one by the parser.
#pragma once

#include <QString>
#include <cstdint>

namespace deckpipe {

struct FilterToken {
  enum class Kind : std::uint8_t { End, Open, Close, Operator, Comma, Word, Quoted, And, Or, Not, Unclosed };
  Kind kind = Kind::End;
  int at = 0, length = 0;  // in the expression, in characters
  QString text{};          // without quotes
};

// The one that begins at a character, or behind the blanks there.
FilterToken readFilterToken(const QString& text, int at);

}  // namespace deckpipe
