// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/catalogue_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "protocol/catalogue.h"

namespace deckpipe {
namespace {

QString asItIs(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString translated(const char* context, std::span<const char* const> texts, std::string_view name) {
  const auto found = std::ranges::find(texts, name, [](const char* text) { return std::string_view(text); });
  return found == texts.end() ? asItIs(name) : QCoreApplication::translate(context, *found);
}

struct SourceText {
  Q_DECLARE_TR_FUNCTIONS(SourceText)
};

}  // namespace

QString messageName(MessageId id) { return QCoreApplication::translate("Message", messageNameText(id)); }

QString fieldName(const Field& field) { return translated("Field", fieldNameTexts(), field.name); }

QString wordText(std::string_view key) {
  const auto found = std::ranges::find(wordTexts(), key, &WordText::key);
  return found == wordTexts().end() ? asItIs(key) : QCoreApplication::translate("Word", found->text);
}

QString numberName(std::span<const ValueName> names, std::int64_t number) {
  const std::string_view name = nameOf(names, number);
  return name.empty() ? QString() : translated("Numbers", numberNameTexts(), name);
}

QString abortText(std::uint32_t code) {
  const std::string_view reason = nameOf(sdo::kAbortCodes, code);
  if (!reason.empty()) return translated("SdoAbort", abortTexts(), reason);
  return QCoreApplication::translate("SdoAbort", "code %1 hex")
      .arg(QStringLiteral("%1").arg(code, 8, 16, QLatin1Char('0')).toUpper());
}

QString sourceText(MessageId id) {
  if (id == MessageId::Count) return {};
  const std::string_view source = messageOf(id).source;
  if (source.empty()) return {};
  return SourceText::tr("Source: %1")
      .arg(QString::fromUtf8(source.data(), static_cast<qsizetype>(source.size())));
}

}  // namespace deckpipe
