// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/elapsed_text.h"

#include <QDateTime>
#include <QLocale>
#include <algorithm>

namespace deckpipe {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kYear2000 = 946'684'800 * kSecond;

QString twoDigits(std::int64_t number) { return QString::number(number).rightJustified(2, QLatin1Char('0')); }

}  // namespace

bool isDate(std::int64_t stampNs) { return stampNs >= kYear2000; }

QString clockText(std::int64_t stampNs) {
  return QDateTime::fromMSecsSinceEpoch(stampNs / 1'000'000).toString(QStringLiteral("HH:mm:ss")) +
         QLocale().decimalPoint() +
         QString::number(stampNs % kSecond / 1'000).rightJustified(6, QLatin1Char('0'));
}

QString millisecondsText(std::int64_t ns) {
  return QLocale().decimalPoint() +
         QString::number(ns % kSecond / 1'000'000).rightJustified(3, QLatin1Char('0'));
}

QString elapsedText(Duration elapsed) {
  const std::int64_t ns = std::max<std::int64_t>(0, elapsed.count());
  const std::int64_t seconds = ns / kSecond;
  return QStringLiteral("%1:%2:%3%4")
      .arg(seconds / 3600)
      .arg(twoDigits(seconds / 60 % 60), twoDigits(seconds % 60), millisecondsText(ns));
}

}  // namespace deckpipe
