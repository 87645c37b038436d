// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/filter_parser.h"

#include <QCoreApplication>
#include <algorithm>

#include "model/filter_values.h"

namespace deckpipe {
namespace {

struct FilterText {
  Q_DECLARE_TR_FUNCTIONS(TraceFilter)
};

constexpr int kNone = -1;

std::optional<FilterOp> opOf(const QString& text) {
  if (text == QLatin1String("=") || text == QLatin1String("==") || text == QLatin1String("!="))
    return FilterOp::Equal;
  if (text == QLatin1String("<")) return FilterOp::Less;
  if (text == QLatin1String("<=")) return FilterOp::LessEqual;
  if (text == QLatin1String(">")) return FilterOp::Greater;
  if (text == QLatin1String(">=")) return FilterOp::GreaterEqual;
  if (text == QLatin1String("~") || text == QLatin1String("!~")) return FilterOp::Contains;
  return {};
}

bool isWordPart(QChar c) { return !c.isSpace() && !QStringLiteral("()=!<>~,\"&|").contains(c); }

}  // namespace

void FilterParser::next() { m_token = readFilterToken(m_text, m_token.at + m_token.length); }

int FilterParser::fail(const FilterToken& token, const QString& text) {
  if (!m_error) m_error = FilterError{token.at, token.length, text};
  return kNone;
}

int FilterParser::add(FilterNode node) {
  m_nodes.push_back(std::move(node));
  return static_cast<int>(m_nodes.size()) - 1;
}

int FilterParser::connect(FilterNode::Kind kind, int left, int right) {
  FilterNode node;
  node.kind = kind;
  node.left = left;
  node.right = right;
  return add(std::move(node));
}

Result<TraceFilter, FilterError> FilterParser::parse() {
  next();
  if (m_token.kind == Kind::End) return TraceFilter();
  const int root = expression(0);
  if (root != kNone && m_token.kind != Kind::End)
    fail(m_token, m_token.kind == Kind::Close ? FilterText::tr("This parenthesis was never opened.")
                                              : FilterText::tr("“and”, “or” or the end was expected here."));
  if (m_error) return Failure{*m_error};
  TraceFilter filter;
  filter.m_nodes = std::move(m_nodes);
  filter.m_needsRoles = std::any_of(filter.m_nodes.begin(), filter.m_nodes.end(), [](const FilterNode& node) {
    if (node.kind == FilterNode::Kind::Field || node.kind == FilterNode::Kind::Text) return true;
    if (node.kind != FilterNode::Kind::Key) return false;
    switch (node.key) {
      case FilterKey::Name:
      case FilterKey::Family:
      case FilterKey::Malformed:
      case FilterKey::Presumed:
      case FilterKey::Ambiguous:
      case FilterKey::Decoded: return true;
      default: return false;
    }
  });
  return filter;
}

int FilterParser::expression(int depth) {
  if (depth > kDeepest) return fail(m_token, FilterText::tr("Nested too deeply."));
  int left = term(depth);
  while (left != kNone && m_token.kind == Kind::Or) {
    next();
    const int right = term(depth);
    left = right == kNone ? kNone : connect(FilterNode::Kind::Or, left, right);
  }
  return left;
}

int FilterParser::term(int depth) {
  int left = factor(depth);
  while (left != kNone) {
    if (m_token.kind == Kind::And) {
      next();
    } else if (m_token.kind != Kind::Word && m_token.kind != Kind::Quoted && m_token.kind != Kind::Open &&
               m_token.kind != Kind::Not) {
      break;
    }
    const int right = factor(depth);
    left = right == kNone ? kNone : connect(FilterNode::Kind::And, left, right);
  }
  return left;
}

int FilterParser::factor(int depth) {
  if (depth > kDeepest) return fail(m_token, FilterText::tr("Nested too deeply."));
  if (m_token.kind == Kind::Not) {
    next();
    const int of = factor(depth + 1);
    return of == kNone ? kNone : connect(FilterNode::Kind::Not, of, kNone);
  }
  if (m_token.kind == Kind::Open) {
    const FilterToken open = m_token;
    next();
    const int inside = expression(depth + 1);
    if (inside == kNone) return kNone;
    if (m_token.kind != Kind::Close) return fail(open, FilterText::tr("This parenthesis is never closed."));
    next();
    return inside;
  }
  return test();
}

int FilterParser::test() {
  const FilterToken word = m_token;
  if (word.kind == Kind::Quoted && !word.text.isEmpty()) {
    next();
    return add(FilterNode::containing(word.text));
  }
  if (word.kind == Kind::Unclosed) return fail(word, FilterText::tr("These quotes are never closed."));
  if (word.kind != Kind::Word)
    return fail(word,
                FilterText::tr("A key such as id, pgn or name, or a word to look for, was expected here."));
  next();
  FilterNode node;
  const auto words = filterKeyWords();
  const auto known = std::find_if(words.begin(), words.end(), [&word](const FilterKeyWord& entry) {
    return word.text.compare(QLatin1String(entry.word), Qt::CaseInsensitive) == 0;
  });
  // A leading dot means the catalogue's field where both have the same key: .node, .data.
  const std::string field = (word.text.startsWith(u'.') ? word.text.mid(1) : word.text).toStdString();
  if (known != words.end()) {
    node.key = known->key;
    if (isFlag(node.key)) return add(std::move(node));
    if (node.key == FilterKey::Byte) node.byte = static_cast<unsigned>(known->word[1] - '0');
  } else if (m_token.kind != Kind::Operator) {
    return add(FilterNode::containing(word.text));
  } else if (isFieldKey(field)) {
    node.kind = FilterNode::Kind::Field;
    node.field = field;
    for (const Message& message : kCatalogue) {
      const auto hasKey = [&field](const Field& f) { return f.key == field; };
      if (std::any_of(message.fields.begin(), message.fields.end(), hasKey)) node.messages.add(message.id);
    }
  } else {
    return fail(word, FilterText::tr("“%1” is no key.").arg(word.text));
  }
  bool isNot = false;
  if (!takeOperator(node, isNot) || !takeValues(node)) return kNone;
  const int made = add(std::move(node));
  return isNot ? connect(FilterNode::Kind::Not, made, kNone) : made;
}

bool FilterParser::takeOperator(FilterNode& node, bool& isNot) {
  const auto op = m_token.kind == Kind::Operator ? opOf(m_token.text) : std::nullopt;
  if (!op) {
    fail(m_token, FilterText::tr("One of = != < <= > >= ~ !~ was expected here."));
    return false;
  }
  const bool isKey = node.kind == FilterNode::Kind::Key;
  const bool isText = isKey && (node.key == FilterKey::Name || node.key == FilterKey::ChannelName ||
                                node.key == FilterKey::Direction || node.key == FilterKey::Family);
  const bool isData = isKey && node.key == FilterKey::Data;
  if (*op == FilterOp::Contains && isKey && !isText && !isData) {
    fail(m_token, FilterText::tr("A number is compared with = != < <= > >=."));
    return false;
  }
  if (*op != FilterOp::Contains && *op != FilterOp::Equal && (isText || isData)) {
    fail(m_token, FilterText::tr("Text and bytes are compared with = != ~ !~."));
    return false;
  }
  node.op = *op;
  isNot = m_token.text.startsWith(u'!');
  next();
  return true;
}

bool FilterParser::takeValues(FilterNode& node) {
  do {
    if (m_token.kind == Kind::Comma) next();
    if (m_token.kind == Kind::Unclosed) {
      fail(m_token, FilterText::tr("These quotes are never closed."));
      return false;
    }
    if (m_token.kind != Kind::Word && m_token.kind != Kind::Quoted) {
      fail(m_token, FilterText::tr("A value was expected here."));
      return false;
    }
    if (const QString wrong = takeFilterValue(node, m_token.text); !wrong.isEmpty()) {
      fail(m_token, wrong);
      return false;
    }
    next();
    const bool isOrder = node.op != FilterOp::Equal && node.op != FilterOp::Contains;
    if (isOrder && m_token.kind == Kind::Comma) {
      fail(m_token, FilterText::tr("Only = and ~ take several values."));
      return false;
    }
  } while (m_token.kind == Kind::Comma);
  return true;
}

FilterToken readFilterToken(const QString& text, int at) {
  using TokenKind = FilterToken::Kind;
  const int end = static_cast<int>(text.size());
  while (at < end && text[at].isSpace()) ++at;
  if (at >= end) return {TokenKind::End, end, 0, {}};
  const QChar c = text[at];
  const QChar after = at + 1 < end ? text[at + 1] : QChar();
  const auto token = [&](TokenKind kind, int length) {
    return FilterToken{kind, at, length, text.mid(at, length)};
  };
  if (c == u'(') return token(TokenKind::Open, 1);
  if (c == u')') return token(TokenKind::Close, 1);
  if (c == u',') return token(TokenKind::Comma, 1);
  if (c == u'"') {
    const auto close = static_cast<int>(text.indexOf(u'"', at + 1));
    if (close < 0) return token(TokenKind::Unclosed, end - at);
    return {TokenKind::Quoted, at, close + 1 - at, text.mid(at + 1, close - at - 1)};
  }
  if (c == u'&') return token(TokenKind::And, after == u'&' ? 2 : 1);
  if (c == u'|') return token(TokenKind::Or, after == u'|' ? 2 : 1);
  if (c == u'!' && after != u'=' && after != u'~') return token(TokenKind::Not, 1);
  if (!isWordPart(c)) {
    const bool isTwo = (c == u'!' || c == u'<' || c == u'>' || c == u'=') && (after == u'=' || after == u'~');
    return token(TokenKind::Operator, isTwo ? 2 : 1);
  }
  int length = 1;
  while (at + length < end && isWordPart(text[at + length])) ++length;
  FilterToken word = token(TokenKind::Word, length);
  if (word.text.compare(QLatin1String("and"), Qt::CaseInsensitive) == 0) word.kind = TokenKind::And;
  if (word.text.compare(QLatin1String("or"), Qt::CaseInsensitive) == 0) word.kind = TokenKind::Or;
  if (word.text.compare(QLatin1String("not"), Qt::CaseInsensitive) == 0) word.kind = TokenKind::Not;
  return word;
}

}  // namespace deckpipe
