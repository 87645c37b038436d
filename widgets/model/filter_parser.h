// SPDX-License-Identifier: GPL-3.0-or-later
// Reads an expression of the filter language (trace_filter.h) into nodes, or says where it went wrong and
// what was expected there. Used by TraceFilter::parse() alone.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/trace_filter.h"

namespace deckpipe {

// What an expression of the filter language is made of: read one by one by the parser.
struct FilterToken {
  enum class Kind : std::uint8_t { End, Open, Close, Operator, Comma, Word, Quoted, And, Or, Not, Unclosed };
  Kind kind = Kind::End;
  int at = 0, length = 0;  // in the expression, in characters
  QString text{};          // without quotes
};

// The one that begins at a character, or behind the blanks there.
FilterToken readFilterToken(const QString& text, int at);

class FilterParser {
 public:
  explicit FilterParser(const QString& text) : m_text(text) {}
  Result<TraceFilter, FilterError> parse();

 private:
  using Kind = FilterToken::Kind;
  // Deeper nesting is a mistake, or an attack on the stack.
  static constexpr int kDeepest = 100;

  void next();
  int expression(int depth);
  int term(int depth);
  int factor(int depth);
  int test();
  int connect(FilterNode::Kind kind, int left, int right);
  int add(FilterNode node);
  bool takeOperator(FilterNode& node, bool& isNot);
  bool takeValues(FilterNode& node);
  int fail(const FilterToken& token, const QString& text);

  const QString m_text;
  FilterToken m_token;
  std::vector<FilterNode> m_nodes;
  std::optional<FilterError> m_error;
};

}  // namespace deckpipe
