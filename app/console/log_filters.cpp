// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_filters.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace deckpipe {
namespace {

struct LogFilters {
  Q_DECLARE_TR_FUNCTIONS(LogFilters)
};

QString latin1(std::string_view text) {
  return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace

QString filterOf(const LogFormat& format) {
  return LogFilters::tr("%1 (%2)", "format, patterns").arg(latin1(format.name), latin1(format.patterns));
}

QStringList filtersForOpening() {
  QStringList filters, patterns;
  for (const LogFormat& format : logFormats()) {
    filters += filterOf(format);
    patterns += latin1(format.patterns);
  }
  if (filters.size() > 1)
    filters.prepend(LogFilters::tr("All logs (%1)").arg(patterns.join(QLatin1Char(' '))));
  return filters << LogFilters::tr("All files (*)");
}

QStringList filtersForSaving() {
  const LogFormat& usual = formatToWrite({});
  QStringList filters{filterOf(usual)};
  for (const LogFormat& format : logFormats()) {
    if (format.makeWriter != nullptr && format.name != usual.name) filters += filterOf(format);
  }
  return filters << LogFilters::tr("All files (*)");
}

QString suffixOf(const QString& filter) {
  const qsizetype dot = filter.indexOf(QLatin1String("(*."));
  return dot < 0 ? QString() : filter.mid(dot + 3).section(QRegularExpression(QStringLiteral("[ )]")), 0, 0);
}

}  // namespace deckpipe
