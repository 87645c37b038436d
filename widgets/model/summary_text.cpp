// SPDX-License-Identifier: GPL-3.0-or-later
// summaryText(): a frame's fields on one line. What is an error stands first, then measured values, then what
// is on; what is off, not fitted or merely a part of another value is left out, for a person looks for what
// differs.
#include <QCoreApplication>
#include <algorithm>
#include <vector>

#include "model/field_text.h"
#include "model/message_text.h"
#include "protocol/decode.h"
#include "text/catalogue_text.h"

namespace deckpipe {
namespace {

struct SummaryText {
  Q_DECLARE_TR_FUNCTIONS(SummaryText)
};

enum class Rank : std::uint8_t { Error, Value, On, Aside };

struct Part {
  Rank rank = Rank::Value;
  QString text;
};

// How fields are said that are not said by the rules of their kind.
enum class Say : std::uint8_t {
  Skip,       // another part says it, or it is of no use here
  SkipZero,   // said where it is not 0
  ValueOnly,  // the value needs no name beside it
  ShortName,  // `name` instead of the field's own
  OffIsNews,  // `name` where it is off, nothing where it is on
  OnIsError,  // its name, first, where it is on
  Aside,      // by the rules of its kind, but last
};
struct Rule {
  std::string_view key;
  Say say;
  const char* name = nullptr;
};
constexpr Rule kRules[] = {
    {"x_percent", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "X")},
    {"y_percent", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Y")},
    {"left_deg", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Left")},
    {"right_deg", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Right")},
    {"down_deg", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Down")},
    {"up_deg", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Up")},
    {"rotation_raw", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Rotation raw")},
    {"elevation_raw", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Elevation raw")},
    {"system_voltage_raw", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Voltage raw")},
    {"fixed_boot", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Boot")},
    {"bootloader", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Loader")},
    {"system", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "System")},
    {"config_type", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Config")},
    {"version", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Version")},
    {"style", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Style")},
    {"subtype", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Subtype")},
    {"pgn", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "PGN")},
    {"calibrated", Say::OffIsNews, QT_TRANSLATE_NOOP("Summary", "Not calibrated")},
    {"enable", Say::OffIsNews, QT_TRANSLATE_NOOP("Summary", "Motion not allowed")},
    {"operational_error", Say::OnIsError},
    {"device_faulted", Say::OnIsError},
    {"toggle", Say::Skip},
    {"size", Say::Skip},
    {"subindex", Say::Skip},
    {"abort_code", Say::Skip},
    {"identity_number", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Identity")},
    {"manufacturer_code", Say::ShortName, QT_TRANSLATE_NOOP("Summary", "Maker")},
    {"ecu_instance", Say::SkipZero},
    {"function_instance", Say::SkipZero},
    {"vehicle_system", Say::SkipZero},
    {"system_instance", Say::SkipZero},
    {"industry_group", Say::SkipZero},
    {"arbitrary_address_capable", Say::Aside},
    {"riser_command", Say::SkipZero},
    {"pcode_error", Say::SkipZero},
    {"state", Say::ValueOnly},
    {"command", Say::ValueOnly},
    {"text", Say::ValueOnly},
    {"bank", Say::ValueOnly},
    {"action", Say::ValueOnly},
    {"abort_text", Say::ValueOnly},
};

static_assert(std::ranges::all_of(kRules, isFieldKey, &Rule::key), "a rule for a field that there is not");

const Rule* ruleOf(std::string_view key) {
  const auto* found =
      std::find_if(std::begin(kRules), std::end(kRules), [key](const Rule& rule) { return rule.key == key; });
  return found == std::end(kRules) ? nullptr : found;
}

bool sameBits(BitRange a, BitRange b) {
  return a.order == b.order && a.offset == b.offset && a.width == b.width;
}

// A direction's status2 is the sign of a value that stands beside it.
bool isSign(const Message& message, const Field& field) {
  return std::any_of(message.fields.begin(), message.fields.end(), [&field](const Field& other) {
    const bool isSigned = other.kind == Kind::Position || other.kind == Kind::AxisPercent;
    return isSigned && (sameBits(other.plus, field.bits) || sameBits(other.minus, field.bits));
  });
}

QString capitalised(QString text) {
  if (!text.isEmpty()) text[0] = text.at(0).toUpper();
  return text;
}

// "Switch 2: fog" is the fog switch.
QString shortName(const Field& field) {
  if (const Rule* rule = ruleOf(field.key); rule != nullptr && rule->name != nullptr)
    return QCoreApplication::translate("Summary", rule->name);
  const QString name = fieldName(field);
  const qsizetype colon = name.indexOf(QStringLiteral(": "));
  if (colon < 0) return name;
  return capitalised(name.mid(colon + 2));
}

QString named(const Field& field, const QString& value) {
  return QStringLiteral("%1 %2").arg(shortName(field), value);
}

class Summary {
 public:
  Summary(const Frame& frame, const Message& message) : m_frame(frame), m_message(message) {}

  QString text() {
    for (const Field& field : m_message.fields) {
      if (isPresent(field, m_frame)) add(field, valueOf(field, m_frame));
    }
    std::stable_sort(m_parts.begin(), m_parts.end(),
                     [](const Part& a, const Part& b) { return a.rank < b.rank; });
    QString text;
    for (const Part& part : m_parts) {
      if (!text.isEmpty()) text += QStringLiteral(", ");
      text += part.text;
    }
    return capitalised(text);
  }

 private:
  void say(Rank rank, const QString& text) { m_parts.push_back({rank, text}); }
  QString words(const Field& field, const Value& value) const { return valueText(field, value); }

  void add(const Field& field, const Value& value) {
    if (addSpecial(field, value)) return;
    const Rule* rule = ruleOf(field.key);
    const Say how = rule == nullptr ? Say::ShortName : rule->say;
    switch (how) {
      case Say::Skip: return;
      case Say::SkipZero:
        if (value.number() == 0) return;
        break;
      case Say::ValueOnly:
        if (value.isNull()) return;
        // A number without a name of its own says nothing alone.
        say(Rank::Value,
            value.type() == Value::Type::Integer ? named(field, words(field, value)) : words(field, value));
        return;
      case Say::ShortName:
      case Say::OffIsNews:
      case Say::OnIsError:
      case Say::Aside: break;
    }
    switch (value.type()) {
      case Value::Type::Null: return;
      case Value::Type::Flag: addSwitch(field, value.flag() ? "on" : "off", how); return;
      case Value::Type::Word: addSwitch(field, value.text(), how); return;
      case Value::Type::Names:
        if (value.mask() == 0) {
          say(Rank::Value, SummaryText::tr("No faults"));
        } else {
          say(Rank::Error, SummaryText::tr("Faults: %1").arg(words(field, value)));
        }
        return;
      case Value::Type::Numbers:
        if (value.mask() != 0) say(Rank::Error, named(field, words(field, value)));
        return;
      default: say(Rank::Value, named(field, words(field, value)));
    }
  }

  void addSwitch(const Field& field, std::string_view word, Say how) {
    if (word == "error" || word == "sensor_error") {
      say(Rank::Error, named(field, wordText("error")));  // a field of sensors has "sensor" in its name
    } else if (word == "invalid" || (field.kind == Kind::PositionState && word == "not_fitted")) {
      say(Rank::Value, named(field, wordText(word)));
    } else if (how == Say::OffIsNews) {
      if (word == "off") say(Rank::On, shortName(field));
    } else if (word == "on" && !isSign(m_message, field) && !field.key.ends_with("_neutral")) {
      const bool aside = how == Say::Aside || field.key.ends_with("_detent");
      say(how == Say::OnIsError ? Rank::Error : aside ? Rank::Aside : Rank::On, shortName(field));
    }
  }

  // Fields that only make sense together.
  bool addSpecial(const Field& field, const Value& value) {
    if (field.key == "index") {
      const auto index = static_cast<unsigned>(value.number());
      const auto sub = static_cast<unsigned>(readBits(m_frame.data, gateway::kSubindex.bits));
      const QString name = objectName(index, sub);
      say(Rank::Value, name.isEmpty() ? objectText(index, sub)
                                      : QStringLiteral("%1 %2").arg(objectText(index, sub), name));
      m_object = index << 8 | sub;
      return true;
    }
    if (field.kind == Kind::SdoValue) {
      // The same four bytes are said better by the fault map and by the error code.
      const bool better = m_object == sdo::kFaultStatus || m_object == sdo::kOperationalError;
      if (!(better && field.key == "value") && !value.isNull() && !m_parts.empty())
        m_parts.back().text += QStringLiteral(" = ") + words(field, value);
      return true;
    }
    if (field.key == "abort_text" && value.isNull()) {
      const QString code = hexText(readBits(m_frame.data, field.bits), 8);
      say(Rank::Error, SummaryText::tr("abort code %1").arg(code));
      return true;
    }
    if (field.key == "device_type") {
      const QString name = numberName(field, value.number());
      if (!name.isEmpty()) say(Rank::Value, name);
      return true;
    }
    if (m_message.id == MessageId::NmtCommand) {
      const QString name = numberName(field, value.number());
      const bool isNode = field.key == "node";
      if (name.isEmpty() && !isNode) return false;
      say(Rank::Value, name.isEmpty() ? SummaryText::tr("node %1").arg(words(field, value)) : name);
      return true;
    }
    if (m_message.family == Family::Copley && field.key == "error_code") {
      say(value.number() == 0 ? Rank::Value : Rank::Error,
          value.number() == 0 ? SummaryText::tr("Success") : named(field, words(field, value)));
      return true;
    }
    return false;
  }

  const Frame& m_frame;
  const Message& m_message;
  std::vector<Part> m_parts;
  unsigned m_object = 0;
};

}  // namespace

QString summaryText(const Frame& frame, const Classified& what) {
  if (frame.isError()) return capitalised(errorText(frame));
  if (what.malformed) return malformedText(what, frame.length);
  if (!what.isDecoded()) return {};
  return Summary(frame, messageOf(what.message)).text();
}

}  // namespace deckpipe
