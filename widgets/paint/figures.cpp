// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/figures.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace deckpipe {
namespace {

constexpr QChar kMinus(0x2212);

struct Units {
  Q_DECLARE_TR_FUNCTIONS(Units)
};

double cellWidth(const QFontMetricsF& metrics) {
  double widest = 0;
  for (char16_t digit = u'0'; digit <= u'9'; ++digit)
    widest = std::max(widest, metrics.horizontalAdvance(QChar(digit)));
  return widest;
}

// The sign takes a digit's cell too: a full minus of some fonts is half as wide again and tears the number.
bool inCell(QChar c) { return c.isDigit() || c == kMinus; }

int rounded(double pixels) { return std::max(1, static_cast<int>(std::lround(std::floor(pixels)))); }

}  // namespace

QString degreesText(double degrees) {
  const double tenths = std::round(degrees * 10);
  QString text = QString::number(std::abs(tenths) / 10, 'f', 1);
  text.replace(QLatin1Char('.'), QLocale().decimalPoint());
  return tenths < 0 ? kMinus + text : text;
}

QString ageText(Duration age) {
  const AgeFigures figures = ageFigures(age);
  const QString rest = QString::number(figures.rest), whole = QString::number(figures.whole);
  const QString padded = rest.rightJustified(2, QLatin1Char('0'));
  switch (figures.form) {
    case AgeFigures::Form::Tenths: return Units::tr("%1 s").arg(whole + QLocale().decimalPoint() + rest);
    case AgeFigures::Form::Seconds: return Units::tr("%1 s").arg(whole);
    case AgeFigures::Form::Minutes: return Units::tr("%1 min %2 s").arg(whole, padded);
    case AgeFigures::Form::Hours: return Units::tr("%1 h %2 min").arg(whole, padded);
    case AgeFigures::Form::Days: return Units::tr("%1 d %2 h").arg(whole, padded);
  }
  return {};
}

QString elidedPin(const QString& name, const QFontMetricsF& metrics, double room) {
  if (metrics.horizontalAdvance(name) <= room) return name;
  constexpr qsizetype kFirst = 4, kLast = 6;
  if (name.contains(QLatin1Char(' ')) || name.size() <= kFirst + kLast)
    return metrics.elidedText(name, Qt::ElideMiddle, room);
  const QString end = QChar(0x2026) + name.last(kLast);
  const QString both = name.first(kFirst) + end;
  if (metrics.horizontalAdvance(both) <= room) return both;
  return metrics.elidedText(end, Qt::ElideLeft, room);
}

double figuresWidth(const QFont& font, const QString& text) {
  const QFontMetricsF metrics(font);
  const double cell = cellWidth(metrics);
  double width = 0;
  for (const QChar c : text) width += inCell(c) ? cell : metrics.horizontalAdvance(c);
  return width;
}

void drawFigures(QPainter& p, const QRectF& slot, const Figures& f) {
  const QFontMetricsF metrics(f.numberFont);
  const double cell = cellWidth(metrics);
  const double baseline = slot.center().y() + metrics.capHeight() / 2;
  double right = slot.right();
  if (!f.unit.isEmpty()) {
    right -= QFontMetricsF(f.unitFont).horizontalAdvance(f.unit);
    p.setFont(f.unitFont);
    p.setPen(f.unitColour);
    // A degree sign hangs from the top of the figures, a letter stands on their baseline.
    const bool hangs = f.unit == QStringLiteral("°");
    const double rise = hangs ? metrics.capHeight() - QFontMetricsF(f.unitFont).capHeight() : 0;
    p.drawText(QPointF(right, baseline - rise), f.unit);
  }
  QFont font = f.numberFont;
  font.setKerning(false);
  p.setFont(font);
  p.setPen(f.numberColour);
  const auto draw = [&](double x, const QString& text) {
    if (!text.isEmpty()) p.drawText(QPointF(x, baseline), text);
  };
  QString together;  // neighbours that fill their cells: each drawing lays its text out, which takes long
  for (auto i = f.number.size(); i-- > 0;) {
    const QChar c = f.number.at(i);
    const double advance = metrics.horizontalAdvance(c);
    const double width = inCell(c) ? cell : advance;
    if (width == advance) {
      together.prepend(c);
    } else {
      draw(right, std::exchange(together, {}));
      draw(right - (width + advance) / 2, c);
    }
    right -= width;
  }
  draw(right, together);
}

QFont fittedFont(QFont font, double pixels, const QString& widest, double width, double least) {
  font.setPixelSize(rounded(pixels));
  const double needed = figuresWidth(font, widest);
  if (needed > width) font.setPixelSize(rounded(std::max(least, std::floor(pixels) * width / needed)));
  return font;
}

}  // namespace deckpipe
