// SPDX-License-Identifier: GPL-3.0-or-later
// Reads an expression of the filter language (trace_filter.h) into nodes, or says where it went wrong and
// what was expected there. Used by TraceFilter::parse() alone.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "model/filter_token.h"
#include "model/trace_filter.h"

namespace deckpipe {

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
