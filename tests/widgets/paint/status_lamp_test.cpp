// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/status_lamp.h"

#include <gtest/gtest.h>

#include <QImage>
#include <array>

#include "support/look.h"

namespace deckpipe {
namespace {

constexpr std::optional<Status2> kStates[] = {
    {}, Status2::Off, Status2::On, Status2::Error, Status2::NotAvailable};

QImage picture(StatusLamp& lamp, QSize size) {
  lamp.resize(size);
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::white);
  lamp.render(&image);
  return image.convertToFormat(QImage::Format_Grayscale8);
}

TEST(StatusLamp, EveryStateHasItsOwnSignInEveryTheme) {
  for (const Theme theme : kThemes) {
    const test::Look look(theme);
    for (const Severity whenOn : {Severity::Plain, Severity::Fine, Severity::Warning, Severity::Fault}) {
      std::vector<QImage> pictures;
      for (const auto& state : kStates) {
        for (const bool stale : {false, true}) {
          // What was never known cannot have become old; a stale lamp says so, its word says what it was.
          if (stale && state != Status2::On) continue;
          StatusLamp lamp;
          lamp.setWhenOn(whenOn);
          lamp.setState(state, stale);
          // As wide as the lamp alone: no word helps.
          pictures.push_back(picture(lamp, QSize(34, 32)));
        }
      }
      for (size_t a = 0; a < pictures.size(); ++a) {
        for (size_t b = a + 1; b < pictures.size(); ++b) {
          int different = 0;
          for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 34; ++x)
              different += std::abs(qGray(pictures[a].pixel(x, y)) - qGray(pictures[b].pixel(x, y))) > 60;
          EXPECT_GE(different, 8) << a << " and " << b;
        }
      }
    }
  }
}

TEST(StatusLamp, ShowsAStopAsABlockWithoutColour) {
  const test::Look look(Theme::Light);
  StatusLamp lamp;
  lamp.setState(Status2::On);
  const QImage usual = picture(lamp, QSize(34, 32));
  lamp.setWhenOn(Severity::Plain, Glyph::Stop);
  EXPECT_NE(picture(lamp, QSize(34, 32)), usual);
  QImage image(QSize(34, 32), QImage::Format_RGB32);
  lamp.render(&image);
  const Colours& c = coloursOf(Theme::Light);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      EXPECT_NE(image.pixelColor(x, y), c.fault.fill);
      EXPECT_NE(image.pixelColor(x, y), c.fault.ink);
    }
  }
}

TEST(StatusLamp, SpeaksLabelAndState) {
  StatusLamp lamp;
  lamp.setLabel(QStringLiteral("Discharge valve"));
  lamp.setState(Status2::On);
  EXPECT_EQ(lamp.accessibleName(), QStringLiteral("Discharge valve"));
  EXPECT_EQ(lamp.accessibleDescription(), QStringLiteral("on"));
  lamp.setState(Status2::On, true);
  EXPECT_EQ(lamp.accessibleDescription(), QStringLiteral("on, stale"));
  lamp.setLabel(QStringLiteral("Right"), QStringLiteral("Rotation, right stop"));
  EXPECT_EQ(lamp.accessibleName(), QStringLiteral("Rotation, right stop"));
  EXPECT_FALSE(lamp.objectName().isEmpty());
}

TEST(StatusLamp, SizeDoesNotDependOnTheState) {
  StatusLamp lamp;
  lamp.setLabel(QStringLiteral("Right"));
  const QSize size = lamp.sizeHint();
  EXPECT_GE(size.height(), 32);
  for (const auto& state : kStates) {
    lamp.setState(state);
    EXPECT_EQ(lamp.sizeHint(), size);
  }
}

}  // namespace
}  // namespace deckpipe
