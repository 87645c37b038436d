// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/palette.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include "paint/glyph.h"
#include "support/enums.h"

namespace deckpipe {
namespace {

double linear(float channel) {
  const double c = static_cast<double>(channel);
  return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& c) {
  return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

// Contrast by WCAG 2.1 (1.4.3, 1.4.11): 1 (the same) .. 21 (black on white). Both colours opaque.
double contrastRatio(const QColor& a, const QColor& b) {
  const auto [dark, bright] = std::minmax({luminance(a), luminance(b)});
  return (bright + 0.05) / (dark + 0.05);
}

constexpr double kTextContrast = 4.5;
constexpr double kGraphicsContrast = 3.0;

struct ContrastPair {
  std::string what;
  QColor front;
  QColor back;
  double atLeast;
};
// Every pair of colours that the rooms put one on the other. Whoever paints with a new pair adds it here.
std::vector<ContrastPair> contrastPairs(const Colours& c) {
  std::vector<ContrastPair> pairs;
  const std::pair<const char*, QColor> grounds[] = {
      {"window", c.window}, {"surface", c.surface}, {"alternate surface", c.surfaceAlternate}};
  const std::pair<const char*, const Tone&> tones[] = {
      {"accent", c.accent}, {"attend", c.warning}, {"fault", c.fault}, {"fine", c.fine}, {"stale", c.stale}};
  for (const auto& [ground, back] : grounds) {
    const std::string on = std::string(" on ") + ground;
    pairs.push_back({"text" + on, c.text, back, kTextContrast});
    pairs.push_back({"secondary text" + on, c.textSecondary, back, kTextContrast});
    pairs.push_back({"outline" + on, c.outline, back, kGraphicsContrast});
    pairs.push_back({"travel" + on, c.travel, back, kGraphicsContrast});
    for (const auto& [name, tone] : tones) pairs.push_back({name + on, tone.ink, back, kTextContrast});
  }
  for (const auto& [name, tone] : tones)
    pairs.push_back({std::string("on ") + name, tone.onFill, tone.fill, kTextContrast});
  pairs.push_back({"stale text on stale fill", c.stale.onFill, c.stale.fill, kTextContrast});
  // The timeline after its cursor.
  pairs.push_back({"density on stale fill", c.textSecondary, c.stale.fill, kGraphicsContrast});
  pairs.push_back({"attend on stale fill", c.warning.ink, c.stale.fill, kGraphicsContrast});
  pairs.push_back({"accent on stale fill", c.accent.ink, c.stale.fill, kGraphicsContrast});
  return pairs;
}

class EveryTheme : public testing::TestWithParam<Theme> {};

TEST(Contrast, IsTheRatioOfTheStandard) {
  EXPECT_NEAR(contrastRatio(Qt::white, Qt::black), 21.0, 1e-6);
  EXPECT_NEAR(contrastRatio(Qt::black, Qt::white), 21.0, 1e-6);
  EXPECT_NEAR(contrastRatio(QColor(12, 34, 56), QColor(12, 34, 56)), 1.0, 1e-9);
  EXPECT_NEAR(contrastRatio(QColor(0x77, 0x77, 0x77), Qt::white), 4.48, 0.005);
}

TEST_P(EveryTheme, EveryPairInUseHasItsContrast) {
  const auto pairs = contrastPairs(coloursOf(GetParam()));
  EXPECT_GT(pairs.size(), 30u);
  for (const ContrastPair& pair : pairs)
    EXPECT_GE(contrastRatio(pair.front, pair.back), pair.atLeast)
        << pair.what << ": " << pair.front.name().toStdString() << " on " << pair.back.name().toStdString();
}

TEST_P(EveryTheme, WidgetsTextIsReadInEveryState) {
  const QPalette palette = qtPalette(coloursOf(GetParam()));
  const std::pair<QPalette::ColorRole, QPalette::ColorRole> pairs[] = {
      {QPalette::WindowText, QPalette::Window},
      {QPalette::Text, QPalette::Base},
      {QPalette::Text, QPalette::AlternateBase},
      {QPalette::ButtonText, QPalette::Button},
      {QPalette::HighlightedText, QPalette::Highlight},
      {QPalette::ToolTipText, QPalette::ToolTipBase},
      {QPalette::PlaceholderText, QPalette::Base},
      {QPalette::Link, QPalette::Base},
      {QPalette::Link, QPalette::Window},
      {QPalette::BrightText, QPalette::Window}};
  for (const auto group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled}) {
    for (const auto& [front, back] : pairs)
      EXPECT_GE(contrastRatio(palette.color(group, front), palette.color(group, back)), kTextContrast)
          << "group " << group << ", role " << front << " on " << back;
  }
}

TEST_P(EveryTheme, WhatCannotBeTouchedLooksDifferent) {
  const QPalette palette = qtPalette(coloursOf(GetParam()));
  EXPECT_NE(palette.color(QPalette::Disabled, QPalette::ButtonText),
            palette.color(QPalette::Active, QPalette::ButtonText));
}

TEST(Palette, SunlightIsNearBlackOnWhite) {
  const Colours c = coloursOf(Theme::Sunlight);
  EXPECT_EQ(c.surface, QColor(Qt::white));
  EXPECT_GE(contrastRatio(c.text, c.surface), 18.0);
  EXPECT_GE(contrastRatio(c.textSecondary, c.surface), 12.0);
  EXPECT_GT(c.stroke, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Palette, EveryTheme, testing::ValuesIn(kThemes), [](const auto& theme) {
  switch (theme.param) {
    case Theme::Light: return "Light";
    case Theme::Dark: return "Dark";
    case Theme::Sunlight: return "Sunlight";
  }
  return "";
});

QImage glyphPicture(Glyph glyph, int size) {
  QImage image(size, size, QImage::Format_Grayscale8);
  image.fill(Qt::white);
  QPainter painter(&image);
  drawGlyph(painter, QRectF(0, 0, size, size), glyph, Qt::black);
  return image;
}

TEST(Glyph, NoTwoAreAlikeWithoutColourAtTwelvePixels) {
  constexpr int kSize = 12;
  for (const Glyph a : test::allOf<Glyph>()) {
    const QImage first = glyphPicture(a, kSize);
    for (const Glyph b : test::allOf<Glyph>()) {
      if (b <= a) continue;
      const QImage second = glyphPicture(b, kSize);
      int different = 0;
      for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
          different += std::abs(qGray(first.pixel(x, y)) - qGray(second.pixel(x, y))) > 96;
      EXPECT_GE(different, 5) << "glyphs " << static_cast<int>(a) << " and " << static_cast<int>(b);
    }
  }
}

TEST(Glyph, StaysInsideItsBox) {
  for (const Glyph g : test::allOf<Glyph>()) {
    QImage image(60, 60, QImage::Format_Grayscale8);
    image.fill(Qt::white);
    QPainter painter(&image);
    drawGlyph(painter, QRectF(10, 10, 40, 40), g, Qt::black);
    for (int i = 0; i < 60; ++i) {
      for (const int edge : {7, 52}) {
        EXPECT_EQ(qGray(image.pixel(i, edge)), 255) << "glyph " << static_cast<int>(g);
        EXPECT_EQ(qGray(image.pixel(edge, i)), 255) << "glyph " << static_cast<int>(g);
      }
    }
  }
}

}  // namespace
}  // namespace deckpipe
