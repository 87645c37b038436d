// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/filter_token.h"

namespace deckpipe {
namespace {

bool isWordPart(QChar c) { return !c.isSpace() && !QStringLiteral("()=!<>~,\"&|").contains(c); }

}  // namespace

FilterToken readFilterToken(const QString& text, int at) {
  using Kind = FilterToken::Kind;
  const int end = static_cast<int>(text.size());
  while (at < end && text[at].isSpace()) ++at;
  if (at >= end) return {Kind::End, end, 0, {}};
  const QChar c = text[at];
  const QChar after = at + 1 < end ? text[at + 1] : QChar();
  const auto token = [&](Kind kind, int length) {
    return FilterToken{kind, at, length, text.mid(at, length)};
  };
  if (c == u'(') return token(Kind::Open, 1);
  if (c == u')') return token(Kind::Close, 1);
  if (c == u',') return token(Kind::Comma, 1);
  if (c == u'"') {
    const auto close = static_cast<int>(text.indexOf(u'"', at + 1));
    if (close < 0) return token(Kind::Unclosed, end - at);
    return {Kind::Quoted, at, close + 1 - at, text.mid(at + 1, close - at - 1)};
  }
  if (c == u'&') return token(Kind::And, after == u'&' ? 2 : 1);
  if (c == u'|') return token(Kind::Or, after == u'|' ? 2 : 1);
  if (c == u'!' && after != u'=' && after != u'~') return token(Kind::Not, 1);
  if (!isWordPart(c)) {
    const bool isTwo = (c == u'!' || c == u'<' || c == u'>' || c == u'=') && (after == u'=' || after == u'~');
    return token(Kind::Operator, isTwo ? 2 : 1);
  }
  int length = 1;
  while (at + length < end && isWordPart(text[at + length])) ++length;
  FilterToken word = token(Kind::Word, length);
  if (word.text.compare(QLatin1String("and"), Qt::CaseInsensitive) == 0) word.kind = Kind::And;
  if (word.text.compare(QLatin1String("or"), Qt::CaseInsensitive) == 0) word.kind = Kind::Or;
  if (word.text.compare(QLatin1String("not"), Qt::CaseInsensitive) == 0) word.kind = Kind::Not;
  return word;
}

}  // namespace deckpipe
