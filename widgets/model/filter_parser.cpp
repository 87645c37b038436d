// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/filter_parser.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "model/field_text.h"
#include "model/message_text.h"

namespace deckpipe {
namespace {

struct FilterText {
  Q_DECLARE_TR_FUNCTIONS(TraceFilter)
};

constexpr int kNone = -1;

bool isWordPart(QChar c) { return !c.isSpace() && !QStringLiteral("()=!<>~,\"&|").contains(c); }

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

std::optional<std::uint64_t> hexNumber(QString text) {
  if (text.startsWith(QLatin1String("0x"), Qt::CaseInsensitive)) text = text.mid(2);
  bool isNumber = false;
  const std::uint64_t number = text.toULongLong(&isNumber, 16);
  return isNumber ? std::optional(number) : std::nullopt;
}

// The highest number that a hex key can have.
std::uint64_t highest(FilterKey key) {
  switch (key) {
    case FilterKey::Pgn: return 0x3FFFF;
    case FilterKey::Node: return 0x7F;
    default: return 0xFF;
  }
}

FilterTitles titlesWith(const QString& text, bool whole) {
  const auto fits = [&](const QString& title, std::string_view key = {}) {
    const QString keyText = toQString(key);
    return whole ? title.compare(text, Qt::CaseInsensitive) == 0 ||
                       keyText.compare(text, Qt::CaseInsensitive) == 0
                 : title.contains(text, Qt::CaseInsensitive) || keyText.contains(text, Qt::CaseInsensitive);
  };
  FilterTitles titles;
  Frame frame;
  for (std::size_t i = 0; i < kMessageCount; ++i) {
    Classified what{.message = static_cast<MessageId>(i)};
    titles.messages[i] = fits(frameTitle(frame, what), kCatalogue[i].key);
    what.malformed = true;
    titles.malformed[i] = fits(frameTitle(frame, what), kCatalogue[i].key);
  }
  for (std::size_t i = 0; i < titles.families.size(); ++i)
    titles.families[i] = fits(frameTitle(frame, {.family = static_cast<Family>(i)}));
  frame.id = kErrorBit;
  titles.error = fits(frameTitle(frame, {}));
  frame.id = kRemoteBit;
  titles.remote = fits(frameTitle(frame, {}));
  return titles;
}

}  // namespace

FilterParser::Token FilterParser::read(int at) const {
  const int end = static_cast<int>(m_text.size());
  while (at < end && m_text[at].isSpace()) ++at;
  if (at >= end) return {Kind::End, end, 0, {}};
  const QChar c = m_text[at];
  const QChar after = at + 1 < end ? m_text[at + 1] : QChar();
  const auto token = [&](Kind kind, int length) { return Token{kind, at, length, m_text.mid(at, length)}; };
  if (c == u'(') return token(Kind::Open, 1);
  if (c == u')') return token(Kind::Close, 1);
  if (c == u',') return token(Kind::Comma, 1);
  if (c == u'"') {
    const auto close = static_cast<int>(m_text.indexOf(u'"', at + 1));
    if (close < 0) return token(Kind::Unclosed, end - at);
    return {Kind::Quoted, at, close + 1 - at, m_text.mid(at + 1, close - at - 1)};
  }
  if (c == u'&') return token(Kind::And, after == u'&' ? 2 : 1);
  if (c == u'|') return token(Kind::Or, after == u'|' ? 2 : 1);
  if (c == u'!' && after != u'=' && after != u'~') return token(Kind::Not, 1);
  if (!isWordPart(c)) {
    const bool isTwo = (c == u'!' || c == u'<' || c == u'>' || c == u'=') && (after == u'=' || after == u'~');
    return token(Kind::Operator, isTwo ? 2 : 1);
  }
  int length = 1;
  while (at + length < end && isWordPart(m_text[at + length])) ++length;
  Token word = token(Kind::Word, length);
  if (word.text.compare(QLatin1String("and"), Qt::CaseInsensitive) == 0) word.kind = Kind::And;
  if (word.text.compare(QLatin1String("or"), Qt::CaseInsensitive) == 0) word.kind = Kind::Or;
  if (word.text.compare(QLatin1String("not"), Qt::CaseInsensitive) == 0) word.kind = Kind::Not;
  return word;
}

void FilterParser::next() { m_token = read(m_token.at + m_token.length); }

int FilterParser::fail(const Token& token, const QString& text) {
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
    if (node.kind == FilterNode::Kind::Field) return true;
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
    } else if (m_token.kind != Kind::Word && m_token.kind != Kind::Open && m_token.kind != Kind::Not) {
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
    const Token open = m_token;
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
  const Token word = m_token;
  if (word.kind == Kind::Unclosed) return fail(word, FilterText::tr("These quotes are never closed."));
  if (word.kind != Kind::Word)
    return fail(word, FilterText::tr("A key such as id, pgn or name was expected here."));
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
  } else if (isFieldKey(field)) {
    node.kind = FilterNode::Kind::Field;
    node.field = field;
    for (std::size_t i = 0; i < kMessageCount; ++i) {
      const auto fields = kCatalogue[i].fields;
      node.messages[i] =
          std::any_of(fields.begin(), fields.end(), [&field](const Field& f) { return f.key == field; });
    }
  } else if (hexNumber(word.text)) {
    return fail(word, FilterText::tr("A key was expected here, for instance id=%1.").arg(word.text));
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
    if (!takeValue(node)) return false;
    next();
    const bool isOrder = node.op != FilterOp::Equal && node.op != FilterOp::Contains;
    if (isOrder && m_token.kind == Kind::Comma) {
      fail(m_token, FilterText::tr("Only = and ~ take several values."));
      return false;
    }
  } while (m_token.kind == Kind::Comma);
  return true;
}

bool FilterParser::takeValue(FilterNode& node) {
  if (node.kind == FilterNode::Kind::Field) return takeFieldValue(node);
  switch (node.key) {
    case FilterKey::Id: return takeIdentifier(node);
    case FilterKey::Data: return takeBytes(node);
    case FilterKey::Priority:
    case FilterKey::Length:
    case FilterKey::FrameNumber:
    case FilterKey::Seconds: return takeNumber(node);
    case FilterKey::ChannelName:
    case FilterKey::Direction:
    case FilterKey::Name:
    case FilterKey::Family: return takeWord(node);
    default: return takeHex(node);
  }
}

bool FilterParser::takeHex(FilterNode& node) {
  const qsizetype dash = m_token.text.indexOf(u'-');
  const auto low = hexNumber(dash < 0 ? m_token.text : m_token.text.left(dash));
  const auto high = dash < 0 ? low : hexNumber(m_token.text.mid(dash + 1));
  if (!low || !high) {
    fail(m_token, FilterText::tr("A number in hex was expected here."));
    return false;
  }
  if (*high > highest(node.key)) {
    fail(m_token, FilterText::tr("At most %1 in hex.").arg(hexText(highest(node.key), 2)));
    return false;
  }
  node.numbers.push_back({*low, *high});
  return true;
}

// With the bit that tells 29-bit identifiers from 11-bit ones, so that 5A4 and 000005A4 differ.
bool FilterParser::takeIdentifier(FilterNode& node) {
  const auto numberOf = [](const QString& text) -> std::optional<FilterNumber> {
    if (text.isEmpty() || text.size() > 8) return {};
    const bool isExtended = text.size() > 3;
    FilterNumber number;
    std::uint64_t digits = 0;
    number.mask = kExtendedBit | (isExtended ? 0x0u : ~std::uint64_t{0x7FF} & kIdMask);
    number.low = isExtended ? kExtendedBit : 0u;
    for (qsizetype i = 0; i < text.size(); ++i) {
      const auto shift = static_cast<unsigned>(4 * (text.size() - 1 - i));
      if (text[i].toLower() == u'x') continue;
      bool isDigit = false;
      const std::uint64_t digit = QString(text[i]).toULongLong(&isDigit, 16);
      if (!isDigit) return {};
      digits |= digit << shift;
      number.mask |= std::uint64_t{0xF} << shift;
    }
    // Leading digits that were not written are 0.
    if (isExtended && text.size() < 8) number.mask |= ~std::uint64_t{0} << 4 * text.size() & kIdMask;
    if (digits > (isExtended ? kIdMask : 0x7FFu)) return {};
    number.low |= digits;
    return number;
  };
  const qsizetype dash = m_token.text.indexOf(u'-');
  auto low = numberOf(dash < 0 ? m_token.text : m_token.text.left(dash));
  if (low && dash >= 0) {
    const auto high = numberOf(m_token.text.mid(dash + 1));
    if (!high || m_token.text.contains(u'x', Qt::CaseInsensitive)) {
      low.reset();
    } else {
      low->high = high->low;
      low->mask = ~std::uint64_t{0};
    }
  }
  if (!low) {
    fail(m_token, FilterText::tr("An identifier in hex was expected here: 18EFFF80, 18EFxx80, 5A4 or "
                                 "100-1FF."));
    return false;
  }
  if (node.op != FilterOp::Equal && low->mask != ~std::uint64_t{0}) {
    low->high = low->low;
    low->mask = ~std::uint64_t{0};
  }
  node.numbers.push_back(*low);
  return true;
}

bool FilterParser::takeBytes(FilterNode& node) {
  QString digits = m_token.text;
  digits.remove(u' ');
  FilterBytes pattern;
  bool isGood = digits.size() % 2 == 0 && digits.size() <= 16;
  for (qsizetype i = 0; isGood && i + 1 < digits.size(); i += 2) {
    const QString two = digits.mid(i, 2);
    bool isByte = two.compare(QLatin1String("xx"), Qt::CaseInsensitive) == 0;
    if (!isByte) {
      pattern.mask[pattern.length] = 0xFF;
      pattern.bytes[pattern.length] = static_cast<std::uint8_t>(two.toUInt(&isByte, 16));
    }
    ++pattern.length;
    isGood = isByte;
  }
  if (!isGood) {
    fail(m_token, FilterText::tr("Up to eight bytes in hex were expected here: \"01 1D\"; xx is any byte."));
    return false;
  }
  node.patterns.push_back(pattern);
  return true;
}

bool FilterParser::takeNumber(FilterNode& node) {
  const QString text = m_token.text;
  bool isNumber = false;
  if (node.key == FilterKey::Seconds) {
    const double seconds = text.toDouble(&isNumber);
    isNumber = isNumber && std::isfinite(seconds) && std::abs(seconds) < 9e9;
    if (isNumber) node.values.push_back(std::round(seconds * 1e9));
  } else {
    const qsizetype dash = text.indexOf(u'-', 1);
    const std::uint64_t low = (dash < 0 ? text : text.left(dash)).toULongLong(&isNumber);
    bool isHighNumber = true;
    const std::uint64_t high = dash < 0 ? low : text.mid(dash + 1).toULongLong(&isHighNumber);
    isNumber = isNumber && isHighNumber;
    node.numbers.push_back({low, high});
  }
  if (!isNumber) fail(m_token, FilterText::tr("A number was expected here."));
  return isNumber;
}

bool FilterParser::takeWord(FilterNode& node) {
  const QString text = m_token.text;
  if (node.key == FilterKey::Name) {
    const FilterTitles titles = titlesWith(text, node.op == FilterOp::Equal);
    node.titles.messages |= titles.messages;
    node.titles.malformed |= titles.malformed;
    node.titles.families |= titles.families;
    node.titles.error |= titles.error;
    node.titles.remote |= titles.remote;
  } else if (node.key == FilterKey::Direction) {
    const bool isRx = text.compare(QLatin1String("rx"), Qt::CaseInsensitive) == 0;
    if (!isRx && text.compare(QLatin1String("tx"), Qt::CaseInsensitive) != 0) {
      fail(m_token, FilterText::tr("rx or tx was expected here."));
      return false;
    }
    node.numbers.push_back({isRx ? 0u : 1u, isRx ? 0u : 1u});
  } else if (node.key == FilterKey::Family) {
    constexpr const char* kNames[] = {"",        "j1939",    "akron",     "copley",
                                      "canopen", "presumed", "ambiguous", "other"};
    bool isKnown = false;
    for (std::size_t i = 1; i < std::size(kNames); ++i) {
      if (text.compare(QLatin1String(kNames[i]), Qt::CaseInsensitive) != 0) continue;
      node.titles.families.set(i);
      isKnown = true;
    }
    if (!isKnown) {
      fail(m_token,
           FilterText::tr("j1939, akron, copley, canopen, presumed, ambiguous or other was expected here."));
      return false;
    }
  } else {
    node.words += text;
  }
  return true;
}

bool FilterParser::takeFieldValue(FilterNode& node) {
  const QString text = m_token.text;
  if (node.op == FilterOp::Contains) {
    node.words += text;
    return true;
  }
  bool isNumber = false;
  double number = text.toDouble(&isNumber);
  if (!isNumber && text.startsWith(QLatin1String("0x"), Qt::CaseInsensitive))
    number = static_cast<double>(text.mid(2).toULongLong(&isNumber, 16));
  if (isNumber) node.values.push_back(number);
  if (node.op != FilterOp::Equal) {
    if (!isNumber) fail(m_token, FilterText::tr("A number was expected here."));
    return isNumber;
  }
  if (text.compare(QLatin1String("none"), Qt::CaseInsensitive) == 0) {
    node.wantsNone = true;
    return true;
  }
  QStringList words;
  bool isText = false;
  for (const Message& message : kCatalogue) {
    for (const Field& field : message.fields) {
      if (field.key != node.field) continue;
      words += wordsOf(field);
      isText = isText || field.kind == deckpipe::Kind::Pin || field.kind == deckpipe::Kind::Version ||
               field.kind == deckpipe::Kind::Bytes || field.kind == deckpipe::Kind::AbortText;
    }
  }
  words.removeDuplicates();
  if (!isNumber && !isText && !words.contains(text, Qt::CaseInsensitive)) {
    fail(m_token, words.isEmpty() || words.size() > 12
                      ? FilterText::tr("A number, or none, was expected here.")
                      : FilterText::tr("One of %1, none was expected here.").arg(words.join(u", ")));
    return false;
  }
  node.words += text;
  return true;
}

}  // namespace deckpipe
