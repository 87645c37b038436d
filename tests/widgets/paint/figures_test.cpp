// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/figures.h"

#include <gtest/gtest.h>

#include <QFont>
#include <QFontMetricsF>
#include <QImage>
#include <QPainter>

namespace deckpipe {
namespace {

TEST(DegreesText, HasOneDecimalAndTheTrueMinusSign) {
  EXPECT_EQ(degreesText(47.3), QStringLiteral("47.3"));
  EXPECT_EQ(degreesText(-5.5), QStringLiteral("\u22125.5"));
  EXPECT_EQ(degreesText(90), QStringLiteral("90.0"));
  EXPECT_EQ(degreesText(-180), QStringLiteral("\u2212180.0"));
}

TEST(DegreesText, NeverSaysMinusZero) {
  EXPECT_EQ(degreesText(0), QStringLiteral("0.0"));
  EXPECT_EQ(degreesText(-0.0), QStringLiteral("0.0"));
  EXPECT_EQ(degreesText(-0.04), QStringLiteral("0.0"));
}

TEST(DegreesText, KeepsTenthsThatBinaryCannotHold) {
  EXPECT_EQ(degreesText(0.1 + 0.2), QStringLiteral("0.3"));
  EXPECT_EQ(degreesText(-47.300000001), QStringLiteral("\u221247.3"));
}

TEST(AgeText, GrowsCoarserWithAge) {
  EXPECT_EQ(ageText(0s), QStringLiteral("0.0 s"));
  EXPECT_EQ(ageText(2400ms), QStringLiteral("2.4 s"));
  EXPECT_EQ(ageText(9960ms), QStringLiteral("9.9 s"));
  EXPECT_EQ(ageText(99s), QStringLiteral("99 s"));
  EXPECT_EQ(ageText(105s), QStringLiteral("1 min 45 s"));
  EXPECT_EQ(ageText(65min), QStringLiteral("1 h 05 min"));
  EXPECT_EQ(ageText(75h), QStringLiteral("3 d 03 h"));
  EXPECT_EQ(ageText(-1s), QStringLiteral("0.0 s"));
}

TEST(ElidedPin, KeepsTypeAndEndByWhichTheFleetDiffers) {
  const QFontMetricsF metrics{QFont()};
  const QString pin = QStringLiteral("1032AE100801035");
  const double whole = metrics.horizontalAdvance(pin);
  EXPECT_EQ(elidedPin(pin, metrics, whole), pin);
  EXPECT_EQ(elidedPin(pin, metrics, whole - 1), QStringLiteral("1032…801035"));
  const double both = metrics.horizontalAdvance(QStringLiteral("1032…801035"));
  for (double room = 1; room < both; room += 3) {
    const QString text = elidedPin(pin, metrics, room);
    EXPECT_LE(metrics.horizontalAdvance(text), std::max(room, metrics.horizontalAdvance(QChar(0x2026))));
    EXPECT_TRUE(text.startsWith(QChar(0x2026)) || text.isEmpty()) << text.toStdString();
    EXPECT_TRUE(pin.endsWith(text.mid(1))) << text.toStdString();
  }
}

TEST(ElidedPin, ElidesOtherNamesInTheMiddle) {
  const QFontMetricsF metrics{QFont()};
  const QString name = QStringLiteral("Front bumper turret, the one of the left side");
  const QString text = elidedPin(name, metrics, metrics.horizontalAdvance(name) / 2);
  EXPECT_TRUE(text.startsWith(QStringLiteral("Front"))) << text.toStdString();
  EXPECT_TRUE(text.endsWith(QStringLiteral("side"))) << text.toStdString();
}

// What is written of an age, read back in seconds.
double secondsIn(const QString& text) {
  double seconds = 0;
  const QStringList words = text.split(QLatin1Char(' '));
  for (qsizetype i = 0; i + 1 < words.size(); i += 2) {
    const QString unit = words[i + 1];
    const double factor = unit == QStringLiteral("s")     ? 1
                          : unit == QStringLiteral("min") ? 60
                          : unit == QStringLiteral("h")   ? 3600
                                                          : 86400;
    seconds += words[i].toDouble() * factor;
  }
  return seconds;
}

TEST(AgeText, NeverRunsBackwardsNorAheadInThreeDays) {
  double last = 0;
  Duration step = 7ms;
  for (Duration age{0}; age < 72h; age += step) {
    if (age > 20s) step = 193ms;
    if (age > 200s) step = 7s;
    const double written = secondsIn(ageText(age));
    ASSERT_GE(written, last) << ageText(age).toStdString();
    ASSERT_LE(written, std::chrono::duration<double>(age).count() + 1e-9) << ageText(age).toStdString();
    last = written;
  }
  EXPECT_GE(last, 71 * 3600);
}

QFont sized(int pixels) {
  QFont font;
  font.setPixelSize(pixels);
  return font;
}

TEST(Figures, AllDigitsAndTheSignAreEquallyWide) {
  const QFont font = sized(40);
  const double width = figuresWidth(font, QStringLiteral("888.8"));
  for (int digit = 0; digit <= 9; ++digit) {
    const QString d = QString::number(digit);
    EXPECT_DOUBLE_EQ(figuresWidth(font, d + d + d + QLatin1Char('.') + d), width) << digit;
  }
  EXPECT_DOUBLE_EQ(figuresWidth(font, QStringLiteral("\u221288.8")), width);
}

QImage drawn(const QString& number) {
  QImage image(200, 60, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  drawFigures(painter, QRectF(10, 5, 180, 50),
              {number, QStringLiteral("°"), sized(40), sized(30), Qt::black, Qt::black});
  return image;
}

TEST(Figures, NothingMovesWhenTheNumberGrows) {
  // The last figure and the unit, in all three, stand on the same pixels.
  const QRect tail(190 - 55, 0, 55, 60);
  EXPECT_EQ(drawn(QStringLiteral("1.3")).copy(tail), drawn(QStringLiteral("\u2212118.3")).copy(tail));
  EXPECT_EQ(drawn(QStringLiteral("47.3")).copy(tail), drawn(QStringLiteral("0.3")).copy(tail));
}

TEST(Figures, ShrinkToTheWidthButNotBelowTheLeastSize) {
  const QString widest = QStringLiteral("\u2212888.8");
  EXPECT_EQ(fittedFont(QFont(), 40, widest, 1000, 9).pixelSize(), 40);
  const QFont narrow = fittedFont(QFont(), 40, widest, 60, 9);
  EXPECT_LT(narrow.pixelSize(), 40);
  EXPECT_LE(figuresWidth(narrow, widest), 60);
  EXPECT_EQ(fittedFont(QFont(), 40, widest, 5, 9).pixelSize(), 9);
}

}  // namespace
}  // namespace deckpipe
