// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/age_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace deckpipe {
namespace {

struct Age {
  Q_DECLARE_TR_FUNCTIONS(Age)
};

QString oneDecimal(double number) {
  return QString::number(number, 'f', 1).replace(QLatin1Char('.'), QLocale().decimalPoint());
}

}  // namespace

QString briefAge(Duration age) {
  const double seconds = std::max(0.0, std::chrono::duration<double>(age).count());
  if (seconds < 9.95) return Age::tr("%1 s").arg(oneDecimal(seconds));
  const auto whole = static_cast<qint64>(seconds);
  if (whole < 100) return Age::tr("%1 s").arg(whole);
  if (whole < 100 * 60) return Age::tr("%1 min").arg(whole / 60);
  if (whole < 48 * 3600) return Age::tr("%1 h").arg(whole / 3600);
  return Age::tr("%1 d").arg(whole / 86400);
}

QString agoText(Duration age) { return Age::tr("%1 ago").arg(briefAge(age)); }

QString calmAge(Duration age) { return age < 1s ? Age::tr("< 1 s") : briefAge(age); }

QString periodText(Duration period) {
  const double ms = std::chrono::duration<double, std::milli>(period).count();
  return ms < 1000 ? Age::tr("%1 ms").arg(std::lround(ms)) : Age::tr("%1 s").arg(oneDecimal(ms / 1000));
}

}  // namespace deckpipe
