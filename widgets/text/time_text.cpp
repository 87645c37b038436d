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
  const AgeFigures figures = ageFigures(age);
  const QString rest = QString::number(figures.rest), whole = QString::number(figures.whole);
  const QString padded = rest.rightJustified(2, QLatin1Char('0'));
  switch (figures.form) {
    case AgeFigures::Form::Tenths: return AgeWords::tr("%1 s").arg(whole + QLocale().decimalPoint() + rest);
    case AgeFigures::Form::Seconds: return AgeWords::tr("%1 s").arg(whole);
    case AgeFigures::Form::Minutes: return AgeWords::tr("%1 min %2 s").arg(whole, padded);
    case AgeFigures::Form::Hours: return AgeWords::tr("%1 h %2 min").arg(whole, padded);
    case AgeFigures::Form::Days: return AgeWords::tr("%1 d %2 h").arg(whole, padded);
  }
  return {};
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
