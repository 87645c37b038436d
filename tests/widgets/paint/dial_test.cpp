// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/dial.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QImage>
#include <QPaintEvent>
#include <QScreen>
#include <QTest>
#include <cmath>

#include "paint/dial_geometry.h"
#include "support/look.h"
#include "widgets/paint/dial_samples.h"

namespace deckpipe {
namespace {

QImage picture(const DialValues& values, Theme theme = Theme::Light, QSize size = {640, 360},
               double phase = 0) {
  const test::Look look(theme);
  Dial dial;
  dial.setValues(values);
  dial.setPhase(phase);
  dial.resize(size);
  QImage image(size, QImage::Format_RGB32);
  dial.render(&image);
  return image;
}

// What is left of a picture without colour: ink or ground.
std::vector<bool> blackAndWhite(const QImage& image, const QColor& ground) {
  std::vector<bool> ink;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x)
      ink.push_back(std::abs(qGray(image.pixel(x, y)) - qGray(ground.rgb())) > 60);
  }
  return ink;
}

int differences(const std::vector<bool>& a, const std::vector<bool>& b) {
  int count = 0;
  for (size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
  return count;
}

// Pixels in the needle's colour between hub and scale, where nothing else has it: texts are below.
int needlePixels(const QImage& image, const DialView& view, const QColor& colour) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const double r = QLineF(view.pivot, QPointF(x, y)).length() / view.radius;
      if (r > 0.2 && r < 0.84 && view.drawing.contains(x, y)) count += image.pixelColor(x, y) == colour;
    }
  }
  return count;
}

class DialInTheme : public testing::TestWithParam<Theme> {};

TEST_P(DialInTheme, ANeedleIsPaintedForAFreshReadingOnly) {
  const Colours colours = coloursOf(GetParam());
  for (const QSize size : {QSize(640, 360), QSize(200, 200)}) {
    for (const auto& reading : allReadings()) {
      for (const bool stale : {false, true}) {
        DialValues v = usualValues();
        for (DialAxis* axis : {&v.rotation, &v.elevation}) {
          axis->reading = reading;
          axis->isStale = stale;
        }
        const QImage image = picture(v, GetParam(), size);
        const DialGeometry g = dialGeometry(v, QRectF(QPointF(0, 0), size));
        for (const DialView* view : {&g.rotation, &g.elevation}) {
          const int pixels = needlePixels(image, *view, colours.text);
          if (reading == PositionState::Ok && !stale)
            EXPECT_GT(pixels, 40) << size.width();
          else
            EXPECT_EQ(pixels, 0) << size.width() << ", reading "
                                 << (reading ? static_cast<int>(*reading) : -1);
        }
      }
    }
  }
}

TEST_P(DialInTheme, TheCommandToAMonitorThatIsNotHeardIsGrey) {
  const Colours colours = coloursOf(GetParam());
  const QSize size(640, 360);
  DialValues v = usualValues();
  for (DialAxis* axis : {&v.rotation, &v.elevation}) {
    axis->command = DialAxis::Command{0.6, QStringLiteral("Joystick 33")};
    axis->isStale = true;
  }
  const QImage image = picture(v, GetParam(), size);
  const DialGeometry g = dialGeometry(v, QRectF(QPointF(0, 0), size));
  EXPECT_EQ(needlePixels(image, g.rotation, colours.text), 0);
  EXPECT_EQ(needlePixels(image, g.elevation, colours.text), 0);
}

TEST_P(DialInTheme, NoTwoStatesLookAlikeEvenWithoutColour) {
  for (const QSize size : {QSize(640, 360), QSize(480, 112), QSize(200, 200), QSize(200, 120)}) {
    std::vector<std::vector<bool>> pictures;
    const auto samples = dialSamples();
    for (const DialSample& sample : samples)
      pictures.push_back(
          blackAndWhite(picture(sample.values, GetParam(), size), coloursOf(GetParam()).surface));
    for (size_t a = 0; a < samples.size(); ++a) {
      for (size_t b = a + 1; b < samples.size(); ++b)
        EXPECT_GE(differences(pictures[a], pictures[b]), 12)
            << samples[a].name << " and " << samples[b].name << " at " << size.width() << "x"
            << size.height();
    }
  }
}

TEST_P(DialInTheme, EveryReadingHasItsOwnDrawingWithoutItsWords) {
  const QSize size(200, 120);
  const DialLayout layout = layOutDial(QRectF(QPointF(0, 0), size));
  std::vector<std::vector<bool>> drawings;
  for (const bool stale : {false, true}) {
    for (const auto& reading : allReadings()) {
      if (stale && reading != PositionState::Ok) continue;
      DialValues v = usualValues();
      v.rotation.reading = v.elevation.reading = reading;
      v.rotation.isStale = v.elevation.isStale = stale;
      const QRectF part = layout.rotation.drawing | layout.elevation.drawing;
      drawings.push_back(
          blackAndWhite(picture(v, GetParam(), size).copy(part.toRect()), coloursOf(GetParam()).surface));
    }
  }
  for (size_t a = 0; a < drawings.size(); ++a) {
    for (size_t b = a + 1; b < drawings.size(); ++b)
      EXPECT_GE(differences(drawings[a], drawings[b]), 60) << a << " and " << b;
  }
}

TEST_P(DialInTheme, DrawsNoStopInTheColourOfFaults) {
  const Colours colours = coloursOf(GetParam());
  const auto faultPixels = [&](const DialValues& values, QSize size) {
    const QImage image = picture(values, GetParam(), size);
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const QColor pixel = image.pixelColor(x, y);
        count += pixel == colours.fault.ink || pixel == colours.fault.fill;
      }
    }
    return count;
  };
  int stops = 0;
  for (const DialSample& sample : dialSamples()) {
    const bool isFault = sample.values.rotation.reading == PositionState::SensorError;
    if (isFault) continue;
    stops += sample.name.find("stop") != std::string::npos;
    for (const QSize size : {QSize(640, 360), QSize(200, 200), QSize(200, 120)})
      EXPECT_EQ(faultPixels(sample.values, size), 0) << sample.name << " at " << size.width();
  }
  EXPECT_GE(stops, 4);
  DialValues broken = usualValues();
  broken.rotation.reading = PositionState::SensorError;
  EXPECT_GT(faultPixels(broken, {640, 360}), 40);
}

TEST_P(DialInTheme, AStaleReadingIsUnmistakable) {
  DialValues fresh = usualValues();
  fresh.rotation.age = fresh.elevation.age = Age::ago(2400ms);
  DialValues stale = fresh;
  stale.rotation.isStale = stale.elevation.isStale = true;
  for (const QSize size : {QSize(640, 360), QSize(200, 120)}) {
    const QColor ground = coloursOf(GetParam()).surface;
    EXPECT_GT(differences(blackAndWhite(picture(fresh, GetParam(), size), ground),
                          blackAndWhite(picture(stale, GetParam(), size), ground)),
              100);
  }
}

INSTANTIATE_TEST_SUITE_P(Dial, DialInTheme, testing::ValuesIn(kThemes), [](const auto& theme) {
  switch (theme.param) {
    case Theme::Light: return "Light";
    case Theme::Dark: return "Dark";
    case Theme::Sunlight: return "Sunlight";
  }
  return "";
});

TEST(Dial, TheBandMovesWhileOscillatingOnly) {
  DialValues v = usualValues();
  EXPECT_EQ(picture(v, Theme::Light, {640, 360}, 0), picture(v, Theme::Light, {640, 360}, 0.2));
  v.rotation.isOscillating = true;
  EXPECT_NE(picture(v, Theme::Light, {640, 360}, 0), picture(v, Theme::Light, {640, 360}, 0.2));
}

TEST(Dial, OneAxisDoesNotDisturbTheOther) {
  DialValues v = usualValues();
  const QImage before = picture(v);
  v.rotation.degrees = -118.4;
  v.rotation.plusStop = Status2::On;
  v.rotation.command = DialAxis::Command{1, QStringLiteral("A source with a very long name indeed")};
  const QImage after = picture(v);
  const DialLayout layout = layOutDial(QRectF(0, 0, 640, 360));
  for (const QRectF& part : {layout.elevation.drawing, layout.elevation.texts})
    EXPECT_EQ(before.copy(part.toAlignedRect()), after.copy(part.toAlignedRect()));
}

// A dial on the screen, of which only what changed is drawn anew.
struct ShownDial : testing::Test, QObject {
  test::Look look{Theme::Light};
  Dial dial;
  QRegion painted;

  ShownDial() {
    dial.resize(640, 360);
    dial.setValues(usualValues());
    dial.show();
    dial.installEventFilter(this);
  }
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) painted += static_cast<QPaintEvent*>(event)->region();
    return false;
  }
  QImage onScreen() {
    QApplication::sendPostedEvents();
    return dial.screen()->grabWindow(dial.winId()).toImage().convertToFormat(QImage::Format_RGB32);
  }
  QImage drawnAnew() const {
    Dial other;
    other.setFont(dial.font());
    other.setValues(dial.values());
    other.resize(dial.size());
    QImage image(dial.size(), QImage::Format_RGB32);
    other.render(&image);
    return image;
  }
};

TEST_F(ShownDial, LooksAsIfDrawnAnewWhateverChanges) {
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dial));
  EXPECT_EQ(onScreen(), drawnAnew());
  for (const DialSample& sample : dialSamples()) {
    dial.setValues(sample.values);
    EXPECT_EQ(onScreen(), drawnAnew()) << sample.name;
    dial.setValues(usualValues());
    EXPECT_EQ(onScreen(), drawnAnew()) << "after " << sample.name;
  }
  DialValues v = usualValues();
  for (double degrees = -190; degrees <= 190; degrees += 7.5) {
    v.rotation.degrees = degrees;
    v.elevation.degrees = degrees / 2;
    dial.setValues(v);
    EXPECT_EQ(onScreen(), drawnAnew()) << degrees;
  }
}

TEST_F(ShownDial, LooksAsIfDrawnAnewInAnotherThemeFontOrSize) {
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dial));
  EXPECT_EQ(onScreen(), drawnAnew());
  for (const Theme theme : kThemes) {
    for (const Density density : {Density::Field, Density::Desk}) {
      const test::Look other(theme, density);
      EXPECT_EQ(onScreen(), drawnAnew());
    }
  }
  dial.resize(500, 300);
  EXPECT_EQ(onScreen(), drawnAnew());
}

TEST_F(ShownDial, HasTheSharpnessOfWhatItIsDrawnOn) {
  const auto drawnAt = [](Dial& on, int pixelRatio) {
    QImage image(on.size() * pixelRatio, QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelRatio);
    on.render(&image);
    return image;
  };
  Dial other;
  other.setValues(dial.values());
  other.resize(dial.size());
  drawnAt(dial, 1);
  EXPECT_EQ(drawnAt(dial, 2), drawnAt(other, 2));
}

TEST_F(ShownDial, DrawsTheSurroundingsOfANeedleThatMoves) {
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dial));
  onScreen();
  painted = {};
  DialValues v = usualValues();
  v.rotation.degrees += 0.5;
  dial.setValues(v);
  onScreen();
  const DialGeometry g = dialGeometry(v, dial.rect());
  EXPECT_TRUE(painted.contains(g.rotation.needle->p2().toPoint()));
  EXPECT_TRUE(painted.contains(g.rotation.value.center().toPoint()));
  EXPECT_FALSE(painted.intersects(g.elevation.drawing.toRect()));
  EXPECT_FALSE(painted.contains(g.rotation.at(0, 1).toPoint()));
}

TEST(Dial, TimerRunsOnlyWhileVisibleAndOscillating) {
  Dial dial;
  DialValues v = usualValues();
  v.rotation.isOscillating = true;
  dial.setValues(v);
  EXPECT_FALSE(dial.isAnimating());
  dial.show();
  EXPECT_TRUE(dial.isAnimating());
  dial.setAnimated(false);
  EXPECT_FALSE(dial.isAnimating());
  dial.setAnimated(true);
  v.rotation.areLimitsStale = true;
  dial.setValues(v);
  EXPECT_FALSE(dial.isAnimating());
  v.rotation.areLimitsStale = false;
  dial.setValues(v);
  EXPECT_TRUE(dial.isAnimating());
  dial.hide();
  EXPECT_FALSE(dial.isAnimating());
}

QString spoken(Dial& dial) {
  QAccessibleInterface* face = QAccessible::queryAccessibleInterface(&dial);
  return face ? face->text(QAccessible::Description) : QString();
}

QString described(const DialValues& values) {
  Dial dial;
  dial.setValues(values);
  return spoken(dial);
}

bool says(const QString& text, const char* part) { return text.contains(QString::fromUtf8(part)); }

TEST(DialSpoken, HasANameAndAnObjectName) {
  Dial dial;
  EXPECT_FALSE(dial.objectName().isEmpty());
  EXPECT_FALSE(dial.accessibleName().isEmpty());
  EXPECT_TRUE(says(spoken(dial), "Rotation: no data received"));
}

TEST(DialSpoken, SaysValuesLimitsStopsAndWhoCommands) {
  DialValues v = usualValues();
  v.rotation.degrees = -47.3;
  v.rotation.minusStop = Status2::On;
  v.rotation.command = DialAxis::Command{-0.5, QStringLiteral("Joystick 33")};
  const QString text = described(v);
  EXPECT_TRUE(says(text, "Rotation: 47.3 degrees left."));
  EXPECT_TRUE(says(text, "Left stop."));
  EXPECT_TRUE(says(text, "Soft limits 120.0 degrees left and 90.0 degrees right."));
  EXPECT_TRUE(says(text, "Joystick 33 commands left, 50 percent."));
  EXPECT_TRUE(says(text, "Elevation: 22.5 degrees up."));
  EXPECT_TRUE(says(text, "Motion is enabled."));
}

TEST(DialSpoken, NeverSpeaksAnOldValueAsASteadyOne) {
  DialValues v = usualValues();
  v.rotation.isStale = true;
  v.rotation.age = Age::ago(2400ms);
  EXPECT_TRUE(says(described(v), "Rotation: 47.3 degrees right, stale, 2.4 s old."));
  v.rotation.age = Age::linkDown(12s);
  EXPECT_TRUE(says(described(v), "Rotation: 47.3 degrees right, before the link went down."));
}

TEST(DialSpoken, NamesEveryReasonForNoValue) {
  const std::pair<std::optional<PositionState>, const char*> reasons[] = {
      {std::nullopt, "no data received"},
      {PositionState::SensorError, "sensor error"},
      {PositionState::NotFitted, "no position sensor fitted"},
      {PositionState::Invalid, "invalid position value"}};
  for (const auto& [reading, words] : reasons) {
    DialValues v = usualValues();
    v.elevation.reading = reading;
    EXPECT_TRUE(says(described(v), words)) << words;
    EXPECT_FALSE(says(described(v), "22.5")) << words;
  }
}

TEST(DialSpoken, FollowsTheValuesThoughNotThirtyTimesASecond) {
  Dial dial;
  DialValues v = usualValues();
  dial.setValues(v);
  const QString first = spoken(dial);
  EXPECT_TRUE(says(first, "47.3"));
  v.rotation.degrees = 50;
  dial.setValues(v);
  v.rotation.degrees = 51.2;
  dial.setValues(v);
  EXPECT_EQ(spoken(dial), first);
  EXPECT_TRUE(QTest::qWaitFor([&] { return says(spoken(dial), "51.2 degrees right"); }, 5000));
}

}  // namespace
}  // namespace deckpipe
