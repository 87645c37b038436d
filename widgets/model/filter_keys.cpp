// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/filter_keys.h"

#include <QCoreApplication>
#include <algorithm>

#include "model/field_text.h"
#include "protocol/catalogue.h"
#include "protocol/decode.h"
#include "text/catalogue_text.h"
#include "text/j1939_text.h"

namespace deckpipe {
namespace {

struct FilterKeys {
  Q_DECLARE_TR_FUNCTIONS(FilterKeys)
};

constexpr FilterKeyWord kWords[] = {
    {"id", FilterKey::Id, QT_TRANSLATE_NOOP("FilterKeys", "identifier, hex; x is any digit")},
    {"pgn", FilterKey::Pgn, QT_TRANSLATE_NOOP("FilterKeys", "parameter group, hex")},
    {"sa", FilterKey::Source, QT_TRANSLATE_NOOP("FilterKeys", "source address, hex")},
    {"da", FilterKey::Destination, QT_TRANSLATE_NOOP("FilterKeys", "destination address, hex")},
    {"node", FilterKey::Node, QT_TRANSLATE_NOOP("FilterKeys", "CANopen node, hex")},
    {"type", FilterKey::Type, QT_TRANSLATE_NOOP("FilterKeys", "message type of PGN EF00, hex")},
    {"data", FilterKey::Data, QT_TRANSLATE_NOOP("FilterKeys", "data bytes, hex; xx is any byte")},
    {"b1", FilterKey::Byte, QT_TRANSLATE_NOOP("FilterKeys", "data byte 1, hex")},
    {"b2", FilterKey::Byte, QT_TRANSLATE_NOOP("FilterKeys", "data byte 2, hex")},
    {"b3", FilterKey::Byte, QT_TRANSLATE_NOOP("FilterKeys", "data byte 3, hex")},
    {"b4", FilterKey::Byte, QT_TRANSLATE_NOOP("FilterKeys", "data byte 4, hex")},
    {"b5", FilterKey::Byte, QT_TRANSLATE_NOOP("FilterKeys", "data byte 5, hex")},
    {"b6", FilterKey::Byte, QT_TRANSLATE_NOOP("FilterKeys", "data byte 6, hex")},
    {"b7", FilterKey::Byte, QT_TRANSLATE_NOOP("FilterKeys", "data byte 7, hex")},
    {"b8", FilterKey::Byte, QT_TRANSLATE_NOOP("FilterKeys", "data byte 8, hex")},
    {"prio", FilterKey::Priority, QT_TRANSLATE_NOOP("FilterKeys", "J1939 priority, 0 to 7")},
    {"len", FilterKey::Length, QT_TRANSLATE_NOOP("FilterKeys", "number of data bytes")},
    {"frame", FilterKey::FrameNumber, QT_TRANSLATE_NOOP("FilterKeys", "number of the frame, from 1")},
    {"t", FilterKey::Seconds, QT_TRANSLATE_NOOP("FilterKeys", "seconds since the log's begin")},
    {"ch", FilterKey::ChannelName, QT_TRANSLATE_NOOP("FilterKeys", "channel")},
    {"dir", FilterKey::Direction, QT_TRANSLATE_NOOP("FilterKeys", "rx received, tx sent")},
    {"name", FilterKey::Name, QT_TRANSLATE_NOOP("FilterKeys", "name of the message")},
    {"family", FilterKey::Family, QT_TRANSLATE_NOOP("FilterKeys", "akron, j1939, canopen, copley …")},
    {"err", FilterKey::Error, QT_TRANSLATE_NOOP("FilterKeys", "error frames")},
    {"remote", FilterKey::Remote, QT_TRANSLATE_NOOP("FilterKeys", "remote frames")},
    {"malformed", FilterKey::Malformed, QT_TRANSLATE_NOOP("FilterKeys", "known, and of a wrong length")},
    {"presumed", FilterKey::Presumed, QT_TRANSLATE_NOOP("FilterKeys", "decoded on a presumption")},
    {"ambiguous", FilterKey::Ambiguous, QT_TRANSLATE_NOOP("FilterKeys", "several readings, none decided")},
    {"decoded", FilterKey::Decoded, QT_TRANSLATE_NOOP("FilterKeys", "messages that are known")},
    {"jump", FilterKey::TimeJump, QT_TRANSLATE_NOOP("FilterKeys", "where the clock jumps")},
};

constexpr const char* kFamilies[] = {"j1939", "akron", "copley", "canopen", "presumed", "ambiguous", "other"};

bool isWordEnd(QChar c) { return c.isSpace() || QStringLiteral("()=!<>~,\"&|").contains(c); }

// Fields by key, each once, in the catalogue's order.
std::vector<const Field*> fieldsOnce() {
  std::vector<const Field*> fields;
  for (const Message& message : kCatalogue) {
    for (const Field& field : message.fields) {
      if (field.kind == Kind::Reserved) continue;
      const bool isNew = std::none_of(fields.begin(), fields.end(),
                                      [&field](const Field* other) { return other->key == field.key; });
      if (isNew) fields.push_back(&field);
    }
  }
  return fields;
}

// What stands before the place: the key and operator that a value is typed for, or nothing.
QString keyBefore(const QString& text, int at) {
  int i = at - 1;
  while (i >= 0 && (text[i].isSpace() || text[i] == u'"')) --i;
  if (i < 0 || !QStringLiteral("=<>~").contains(text[i])) return {};
  while (i >= 0 && QStringLiteral("=<>~! ").contains(text[i])) --i;
  const int end = i + 1;
  while (i >= 0 && !isWordEnd(text[i])) --i;
  return text.mid(i + 1, end - i - 1);
}

void addValues(FilterCompletions& completions, const QString& key, const QStringList& channels) {
  const auto add = [&](const QString& word, const QString& help = {}) {
    completions.entries.push_back({word, help});
  };
  if (key == QLatin1String("ch")) {
    for (const QString& channel : channels) add(channel);
  } else if (key == QLatin1String("dir")) {
    add(QStringLiteral("rx"), FilterKeys::tr("received"));
    add(QStringLiteral("tx"), FilterKeys::tr("sent"));
  } else if (key == QLatin1String("name")) {
    for (const Message& message : kCatalogue) add(toQString(message.key), messageName(message.id));
    for (const j1939::StandardGroup& group : j1939::kStandardGroups) {
      if (!group.acronym.empty()) add(toQString(group.acronym), groupText(group));
    }
  } else if (key == QLatin1String("pgn")) {
    for (const Message& message : kCatalogue) {
      if (message.family == Family::J1939) add(hexText(message.selector, 4), messageName(message.id));
    }
    for (const j1939::StandardGroup& group : j1939::kStandardGroups) {
      const QString first = hexText(group.first, 4);
      add(group.first == group.last ? first : QStringLiteral("%1-%2").arg(first, hexText(group.last, 4)),
          groupText(group));
    }
  } else if (key == QLatin1String("sa") || key == QLatin1String("da")) {
    for (const j1939::PreferredAddress& preferred : j1939::kPreferredAddresses)
      add(hexText(preferred.address, 2), usualUse({preferred.address}));
  } else if (key == QLatin1String("family")) {
    for (const char* family : kFamilies) add(QLatin1String(family));
  } else {
    QStringList words;
    for (const Message& message : kCatalogue) {
      for (const Field& field : message.fields) {
        if (toQString(field.key) == key) words += wordsOf(field);
      }
    }
    words.removeDuplicates();
    for (const QString& word : std::as_const(words)) add(word, wordText(word.toStdString()));
  }
}

QStringList toQStrings(const auto& keys) {
  QStringList texts;
  for (const std::string_view key : keys) texts += toQString(key);
  return texts;
}

}  // namespace

std::span<const FilterKeyWord> filterKeyWords() { return kWords; }

QStringList wordsOf(const Field& field) {
  switch (field.kind) {
    case Kind::Flag: return {QStringLiteral("off"), QStringLiteral("on")};
    case Kind::Status2: return toQStrings(kStatus2Keys);
    case Kind::PositionState: return toQStrings(kPositionStateKeys);
    case Kind::Word:
    case Kind::FaultNames: {
      QStringList words;
      for (const ValueName& name : field.words) words += toQString(name.word);
      if (!field.otherwise.empty()) words += toQString(field.otherwise);
      return words;
    }
    default: return {};
  }
}

FilterCompletions filterCompletions(const QString& text, int cursor, const QStringList& channels) {
  FilterCompletions completions;
  int from = std::clamp(cursor, 0, static_cast<int>(text.size()));
  cursor = from;
  while (from > 0 && !isWordEnd(text[from - 1])) --from;
  completions.from = from;
  const QString begun = text.mid(from, cursor - from);
  if (const QString key = keyBefore(text, from); !key.isEmpty()) {
    addValues(completions, key, channels);
  } else {
    for (const FilterKeyWord& word : kWords)
      completions.entries.push_back({QLatin1String(word.word), FilterKeys::tr(word.help)});
    for (const char* word : {"and", "or", "not"}) completions.entries.push_back({QLatin1String(word), {}});
    for (const Field* field : fieldsOnce()) {
      const bool isTaken =
          std::any_of(std::begin(kWords), std::end(kWords),
                      [field](const FilterKeyWord& word) { return field->key == word.word; });
      const QString name = toQString(field->key);
      completions.entries.push_back({isTaken ? u'.' + name : name, fieldName(*field)});
    }
  }
  std::erase_if(completions.entries, [&begun](const FilterCompletions::Entry& entry) {
    return !entry.word.startsWith(begun, Qt::CaseInsensitive) ||
           entry.word.compare(begun, Qt::CaseInsensitive) == 0;
  });
  return completions;
}

QString filterHelp() {
  QString text;
  const auto add = [&text](const QString& example, const QString& means) {
    text += QStringLiteral("<tr><td style='padding-right:16px'><code>%1</code></td><td>%2</td></tr>")
                .arg(example.toHtmlEscaped(), means.toHtmlEscaped());
  };
  text += QStringLiteral("<table>");
  add(QStringLiteral("soft limits"), FilterKeys::tr("some cell contains each of these words"));
  add(QStringLiteral("pgn=EF00 and sa=80"), FilterKeys::tr("and, or, not, parentheses"));
  add(QStringLiteral("id=18EFxx80"), FilterKeys::tr("x is any digit"));
  add(QStringLiteral("id=100-1FF"), FilterKeys::tr("a range"));
  add(QStringLiteral("type=01,83"), FilterKeys::tr("any of several"));
  add(QStringLiteral("data~\"01 1D\""), FilterKeys::tr("contains these bytes"));
  add(QStringLiteral("name~\"soft limits\""), FilterKeys::tr("the name contains this"));
  add(QStringLiteral("rotation_deg>30"), FilterKeys::tr("a decoded field, by its key"));
  add(QStringLiteral("t>=12.5 t<20"), FilterKeys::tr("seconds since the log's begin"));
  add(QStringLiteral("not malformed"), FilterKeys::tr("= != < <= > >= ~ !~ compare"));
  text += QStringLiteral("</table><hr><table>");
  for (const FilterKeyWord& word : kWords) {
    if (word.key == FilterKey::Byte && word.word != std::string_view("b1")) continue;
    add(word.key == FilterKey::Byte ? QStringLiteral("b1 … b8") : QLatin1String(word.word),
        word.key == FilterKey::Byte ? FilterKeys::tr("one data byte, hex") : FilterKeys::tr(word.help));
  }
  return text + QStringLiteral("</table>");
}

}  // namespace deckpipe
