// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_sources.h"

#include <QStringList>
#include <algorithm>

#include "protocol/catalogue.h"
#include "text/catalogue_text.h"

namespace deckpipe {

QString pageGroupKey(PageGroup group) {
  const std::string_view key = kPageGroupKeys[group];
  return QString::fromLatin1(key.data(), static_cast<qsizetype>(key.size()));
}

QString pageSourceText(const QString& groupKey) {
  const auto group = std::ranges::find(kAllOf<PageGroup>, groupKey, pageGroupKey);
  if (group == kAllOf<PageGroup>.end()) return {};
  QStringList lines;
  for (const Message& message : kCatalogue) {
    if (message.page.has(*group)) lines.append(sourceText(message.id));
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace deckpipe
