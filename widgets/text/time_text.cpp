// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/time_text.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace deckpipe {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kYear2000 = 946'684'800 * kSecond;

QString twoDigits(std::int64_t number) { return QString::number(number).rightJustified(2, QLatin1Char('0')); }

struct AgeWords {
  Q_DECLARE_TR_FUNCTIONS(AgeWords)
};

QString oneDecimal(double number) {
  return QString::number(number, 'f', 1).replace(QLatin1Char('.'), QLocale().decimalPoint());
}

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

QString briefAge(Duration age) {
  const double seconds = std::max(0.0, std::chrono::duration<double>(age).count());
  if (seconds < 9.95) return AgeWords::tr("%1 s").arg(oneDecimal(seconds));
  const auto whole = static_cast<qint64>(seconds);
  if (whole < 100) return AgeWords::tr("%1 s").arg(whole);
  if (whole < 100 * 60) return AgeWords::tr("%1 min").arg(whole / 60);
  if (whole < 48 * 3600) return AgeWords::tr("%1 h").arg(whole / 3600);
  return AgeWords::tr("%1 d").arg(whole / 86400);
}

QString agoText(Duration age) { return AgeWords::tr("%1 ago").arg(briefAge(age)); }

QString calmAge(Duration age) { return age < 1s ? AgeWords::tr("< 1 s") : briefAge(age); }

QString ageText(const Age& age, bool isStale) {
  switch (age.kind) {
    case Age::Kind::NotHeard: return AgeWords::tr("not heard");
    case Age::Kind::NoTimes: return {};
    case Age::Kind::Ago:
      return isStale ? AgeWords::tr("overdue, %1").arg(briefAge(age.length)) : calmAge(age.length);
    case Age::Kind::LinkDown: return AgeWords::tr("link down for %1").arg(briefAge(age.length));
  }
  return {};
}

QString periodText(Duration period) {
  const double ms = std::chrono::duration<double, std::milli>(period).count();
  return ms < 1000 ? AgeWords::tr("%1 ms").arg(std::lround(ms))
                   : AgeWords::tr("%1 s").arg(oneDecimal(ms / 1000));
}

}  // namespace deckpipe
