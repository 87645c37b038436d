// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/field_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <iterator>
#include <string>

#include "protocol/catalogue.h"
#include "protocol/device_types.h"
#include "text/catalogue_text.h"

namespace deckpipe {
namespace {

constexpr QChar kMinus(0x2212);

struct FieldText {
  Q_DECLARE_TR_FUNCTIONS(FieldText)
};

struct ObjectWords {
  std::uint32_t object;
  const char* text;
};
constexpr ObjectWords kObjects[] = {
    {0x100000, QT_TRANSLATE_NOOP("Objects", "device type")},
    {0x500001, QT_TRANSLATE_NOOP("Objects", "Akron device type")},
    {0x500101, QT_TRANSLATE_NOOP("Objects", "fault status")},
    {0x500102, QT_TRANSLATE_NOOP("Objects", "operational error code")},
    {0x500201, QT_TRANSLATE_NOOP("Objects", "zero axes")},
    {0x500202, QT_TRANSLATE_NOOP("Objects", "reset")},
    {0x500203, QT_TRANSLATE_NOOP("Objects", "setup mode")},
};

// Identifiers of things are written as their manuals write them: in hex, with so many digits, and said to be
// where one could take them for decimal.
struct HexKey {
  std::string_view key;
  int digits;
  bool said;
};
constexpr HexKey kHexKeys[] = {{"index", 4, false},    {"subindex", 2, false},  {"abort_code", 8, false},
                               {"specifier", 2, true}, {"parameter", 1, true},  {"command", 2, false},
                               {"node", 2, true},      {"record_type", 2, true}};

static_assert(std::ranges::all_of(kHexKeys, isFieldKey, &HexKey::key), "a key of no field");

QString unitText(Unit unit) {
  switch (unit) {
    case Unit::None:
    case Unit::Count: return {};
    case Unit::Degree: return QStringLiteral("°");
    case Unit::Percent: return QStringLiteral(" %");
    case Unit::Ampere: return QStringLiteral(" A");
    case Unit::CountsPerSecond: return FieldText::tr(" counts/s");
  }
  return {};
}

// As many decimals as the resolution has, so that figures stand under figures.
QString decimalText(std::int64_t number, unsigned decimals) {
  std::uint64_t rest =
      number < 0 ? 0 - static_cast<std::uint64_t>(number) : static_cast<std::uint64_t>(number);
  QString digits = QString::number(rest).rightJustified(static_cast<int>(decimals) + 1, QLatin1Char('0'));
  if (decimals > 0) digits.insert(digits.size() - static_cast<int>(decimals), QLocale().decimalPoint());
  return number < 0 ? kMinus + digits : digits;
}

QString numberText(const Field& field, std::int64_t number, unsigned decimals) {
  QString text;
  const auto* inHex = std::find_if(std::begin(kHexKeys), std::end(kHexKeys),
                                   [&field](const HexKey& k) { return k.key == field.key; });
  if (inHex != std::end(kHexKeys)) {
    text = hexText(static_cast<std::uint64_t>(number), inHex->digits);
    if (inHex->said) text = FieldText::tr("%1 hex").arg(text);
  } else if (field.key == "pgn") {
    text = FieldText::tr("%1 hex").arg(hexText(static_cast<std::uint64_t>(number), 4));
  } else {
    text = decimalText(number, decimals) + unitText(field.unit);
  }
  const QString name = numberName(field, number);
  return name.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, name);
}

// Characters as they are, others as programmers write them, so that a line's end can be seen in every font.
QString charactersText(std::span<const std::uint8_t> bytes) {
  QString text;
  for (const int byte : bytes) {
    if (byte == '\r') {
      text += QStringLiteral("\\r");
    } else if (byte == '\n') {
      text += QStringLiteral("\\n");
    } else if (byte < 0x20 || byte > 0x7E) {
      text += QStringLiteral("\\x") + hexText(static_cast<std::uint64_t>(byte), 2);
    } else {
      text += QChar(byte);
    }
  }
  return QStringLiteral("“%1”").arg(text);
}

}  // namespace

QString toQString(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString hexText(std::uint64_t number, int digits) {
  return QString::number(number, 16).toUpper().rightJustified(digits, QLatin1Char('0'));
}

QString numberName(const Field& field, std::int64_t number) {
  if (field.key == "device_type") return toQString(deviceTypeName(static_cast<unsigned>(number)));
  return numberName(field.names, number);
}

QString objectText(unsigned index, unsigned subindex) {
  return QStringLiteral("%1.%2").arg(hexText(index, 4), hexText(subindex, 2));
}

QString objectName(unsigned index, unsigned subindex) {
  const auto* found = std::find_if(std::begin(kObjects), std::end(kObjects), [&](const ObjectWords& words) {
    return words.object == (index << 8 | subindex);
  });
  return found == std::end(kObjects) ? QString() : QCoreApplication::translate("Objects", found->text);
}

QString valueText(const Field& field, const Value& value) {
  switch (value.type()) {
    case Value::Type::Null: return FieldText::tr("no value");
    case Value::Type::Integer:
    case Value::Type::Decimal: return numberText(field, value.number(), value.decimals());
    case Value::Type::Real: {
      QString text = QLocale().toString(value.real(), 'g', 7);
      return text.replace(QLatin1Char('-'), kMinus) + unitText(field.unit);
    }
    case Value::Type::Flag: return wordText(value.flag() ? "on" : "off");
    case Value::Type::Word:
      return field.kind == Kind::AbortText
                 ? QCoreApplication::translate("SdoAbort", std::string(value.text()).c_str())
                 : wordText(value.text());
    case Value::Type::Text: return toQString(value.text());
    case Value::Type::Bytes:
      return field.key == "text" ? charactersText(value.bytes()) : toQString(toText(value));
    case Value::Type::Names: {
      QStringList names;
      for (const ValueName& name : value.words()) {
        if ((value.mask() >> name.value & 1u) != 0) names += wordText(name.word);
      }
      return names.isEmpty() ? FieldText::tr("none") : names.join(QStringLiteral(", "));
    }
    case Value::Type::Numbers: return value.mask() == 0 ? FieldText::tr("none") : toQString(toText(value));
  }
  return {};
}

}  // namespace deckpipe
