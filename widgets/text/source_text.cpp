// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/source_text.h"

#include <QCoreApplication>

#include "protocol/catalogue.h"

namespace deckpipe {
namespace {

struct SourceText {
  Q_DECLARE_TR_FUNCTIONS(SourceText)
};

}  // namespace

QString sourceText(MessageId id) {
  if (id == MessageId::Count) return {};
  const std::string_view source = messageOf(id).source;
  if (source.empty()) return {};
  return SourceText::tr("Source: %1")
      .arg(QString::fromUtf8(source.data(), static_cast<qsizetype>(source.size())));
}

}  // namespace deckpipe
