// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/filter_values.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <optional>

#include "model/field_text.h"
#include "model/message_text.h"
#include "report/decode_lines.h"
#include "text/j1939_text.h"

namespace deckpipe {
namespace {

struct ValueText {
  Q_DECLARE_TR_FUNCTIONS(TraceFilter)
};

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
  for (const Message& message : kCatalogue) {
    Classified what{.message = message.id};
    if (fits(frameTitle(frame, what), message.key)) titles.messages.add(message.id);
    what.malformed = true;
    if (fits(frameTitle(frame, what), message.key)) titles.malformed.add(message.id);
  }
  for (const Family family : kAllOf<Family>) {
    if (fits(frameTitle(frame, {.family = family}))) titles.families.add(family);
  }
  for (const j1939::StandardGroup& group : j1939::kStandardGroups) {
    if (fits(groupText(group), group.acronym)) titles.groups.push_back(&group);
  }
  frame.id = kErrorBit;
  titles.error = fits(frameTitle(frame, {}));
  frame.id = kRemoteBit;
  titles.remote = fits(frameTitle(frame, {}));
  return titles;
}

QString takeHex(FilterNode& node, const QString& text) {
  const qsizetype dash = text.indexOf(u'-');
  const auto low = filterHexNumber(dash < 0 ? text : text.left(dash));
  const auto high = dash < 0 ? low : filterHexNumber(text.mid(dash + 1));
  if (!low || !high) {
    return ValueText::tr("A number in hex was expected here.");
  }
  if (*high > highest(node.key)) {
    return ValueText::tr("At most %1 in hex.").arg(hexText(highest(node.key), 2));
  }
  node.numbers.push_back({*low, *high});
  return {};
}

// With the bit that tells 29-bit identifiers from 11-bit ones, so that 5A4 and 000005A4 differ.
QString takeIdentifier(FilterNode& node, const QString& text) {
  const auto numberOf = [](const QString& word) -> std::optional<FilterNumber> {
    if (word.isEmpty() || word.size() > 8) return {};
    const bool isExtended = word.size() > 3;
    FilterNumber number;
    std::uint64_t digits = 0;
    number.mask = kExtendedBit | (isExtended ? 0x0u : ~std::uint64_t{0x7FF} & kIdMask);
    number.low = isExtended ? kExtendedBit : 0u;
    for (qsizetype i = 0; i < word.size(); ++i) {
      const auto shift = static_cast<unsigned>(4 * (word.size() - 1 - i));
      if (word[i].toLower() == u'x') continue;
      bool isDigit = false;
      const std::uint64_t digit = QString(word[i]).toULongLong(&isDigit, 16);
      if (!isDigit) return {};
      digits |= digit << shift;
      number.mask |= std::uint64_t{0xF} << shift;
    }
    // Leading digits that were not written are 0.
    if (isExtended && word.size() < 8) number.mask |= ~std::uint64_t{0} << 4 * word.size() & kIdMask;
    if (digits > (isExtended ? kIdMask : 0x7FFu)) return {};
    number.low |= digits;
    return number;
  };
  const qsizetype dash = text.indexOf(u'-');
  auto low = numberOf(dash < 0 ? text : text.left(dash));
  if (low && dash >= 0) {
    const auto high = numberOf(text.mid(dash + 1));
    if (!high || text.contains(u'x', Qt::CaseInsensitive)) {
      low.reset();
    } else {
      low->high = high->low;
      low->mask = ~std::uint64_t{0};
    }
  }
  if (!low) {
    return ValueText::tr(
        "An identifier in hex was expected here: 18EFFF80, 18EFxx80, 5A4 or "
        "100-1FF.");
  }
  if (node.op != FilterOp::Equal && low->mask != ~std::uint64_t{0}) {
    low->high = low->low;
    low->mask = ~std::uint64_t{0};
  }
  node.numbers.push_back(*low);
  return {};
}

QString takeBytes(FilterNode& node, const QString& text) {
  QString digits = text;
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
    return ValueText::tr("Up to eight bytes in hex were expected here: \"01 1D\"; xx is any byte.");
  }
  node.patterns.push_back(pattern);
  return {};
}

QString takeNumber(FilterNode& node, const QString& text) {
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
  return isNumber ? QString() : ValueText::tr("A number was expected here.");
}

QString takeWord(FilterNode& node, const QString& text) {
  if (node.key == FilterKey::Name) {
    const FilterTitles titles = titlesWith(text, node.op == FilterOp::Equal);
    node.titles.messages |= titles.messages;
    node.titles.malformed |= titles.malformed;
    node.titles.families |= titles.families;
    node.titles.groups.insert(node.titles.groups.end(), titles.groups.begin(), titles.groups.end());
    node.titles.error |= titles.error;
    node.titles.remote |= titles.remote;
  } else if (node.key == FilterKey::Direction) {
    const bool isRx = text.compare(QLatin1String("rx"), Qt::CaseInsensitive) == 0;
    if (!isRx && text.compare(QLatin1String("tx"), Qt::CaseInsensitive) != 0) {
      return ValueText::tr("rx or tx was expected here.");
    }
    node.numbers.push_back({isRx ? 0u : 1u, isRx ? 0u : 1u});
  } else if (node.key == FilterKey::Family) {
    const auto known = std::ranges::find_if(kAllOf<Family>, [&text](Family family) {
      return family != Family::None && text.compare(toQString(familyKey(family)), Qt::CaseInsensitive) == 0;
    });
    if (known != kAllOf<Family>.end()) {
      node.titles.families.add(*known);
    } else {
      return ValueText::tr("j1939, akron, copley, canopen, presumed, ambiguous or other was expected here.");
    }
  } else {
    node.words += text;
  }
  return {};
}

QString takeFieldValue(FilterNode& node, const QString& text) {
  if (node.op == FilterOp::Contains) {
    node.words += text;
    return {};
  }
  bool isNumber = false;
  double number = text.toDouble(&isNumber);
  if (!isNumber && text.startsWith(QLatin1String("0x"), Qt::CaseInsensitive))
    number = static_cast<double>(text.mid(2).toULongLong(&isNumber, 16));
  if (isNumber) node.values.push_back(number);
  if (node.op != FilterOp::Equal) {
    return isNumber ? QString() : ValueText::tr("A number was expected here.");
  }
  if (text.compare(QLatin1String("none"), Qt::CaseInsensitive) == 0) {
    node.wantsNone = true;
    return {};
  }
  QStringList words;
  bool isText = false;
  for (const Message& message : kCatalogue) {
    for (const Field& field : message.fields) {
      if (field.key != node.field) continue;
      words += wordsOf(field);
      isText = isText || field.kind == Kind::Pin || field.kind == Kind::Version ||
               field.kind == Kind::Bytes || field.kind == Kind::AbortText;
    }
  }
  words.removeDuplicates();
  if (!isNumber && !isText && !words.contains(text, Qt::CaseInsensitive)) {
    return words.isEmpty() || words.size() > 12
               ? ValueText::tr("A number, or none, was expected here.")
               : ValueText::tr("One of %1, none was expected here.").arg(words.join(u", "));
  }
  node.words += text;
  return {};
}

}  // namespace

std::optional<std::uint64_t> filterHexNumber(QString text) {
  if (text.startsWith(QLatin1String("0x"), Qt::CaseInsensitive)) text = text.mid(2);
  bool isNumber = false;
  const std::uint64_t number = text.toULongLong(&isNumber, 16);
  return isNumber ? std::optional(number) : std::nullopt;
}

QString takeFilterValue(FilterNode& node, const QString& text) {
  if (node.kind == FilterNode::Kind::Field) return takeFieldValue(node, text);
  switch (node.key) {
    case FilterKey::Id: return takeIdentifier(node, text);
    case FilterKey::Data: return takeBytes(node, text);
    case FilterKey::Priority:
    case FilterKey::Length:
    case FilterKey::FrameNumber:
    case FilterKey::Seconds: return takeNumber(node, text);
    case FilterKey::ChannelName:
    case FilterKey::Direction:
    case FilterKey::Name:
    case FilterKey::Family: return takeWord(node, text);
    default: return takeHex(node, text);
  }
}

}  // namespace deckpipe
