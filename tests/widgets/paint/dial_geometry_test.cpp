// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/dial_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "widgets/paint/dial_samples.h"

namespace deckpipe {
namespace {

const QRectF kUsual(0, 0, 640, 400);

DialGeometry at(double rotation, double elevation, const QRectF& bounds = kUsual) {
  DialValues v = usualValues();
  v.rotation.degrees = rotation;
  v.elevation.degrees = elevation;
  return dialGeometry(v, bounds);
}

// The needle's direction as a unit vector, y downwards.
QPointF direction(const DialView& view) {
  const QLineF& needle = view.needle.value();
  return (needle.p2() - needle.p1()) / needle.length();
}

void expectDirection(const DialView& view, double x, double y) {
  ASSERT_TRUE(view.needle);
  EXPECT_NEAR(direction(view).x(), x, 1e-9);
  EXPECT_NEAR(direction(view).y(), y, 1e-9);
}

TEST(DialNeedle, RotationZeroIsUpAndRightIsClockwise) {
  expectDirection(at(0, 0).rotation, 0, -1);
  expectDirection(at(90, 0).rotation, 1, 0);
  expectDirection(at(-90, 0).rotation, -1, 0);
  expectDirection(at(180, 0).rotation, 0, 1);
  expectDirection(at(-180, 0).rotation, 0, 1);
  EXPECT_GT(direction(at(0.1, 0).rotation).x(), 0);
}

TEST(DialNeedle, ElevationIsSeenFromTheLeftSoAheadIsLeft) {
  expectDirection(at(0, 0).elevation, -1, 0);
  expectDirection(at(0, 90).elevation, 0, -1);
  expectDirection(at(0, -90).elevation, 0, 1);
  expectDirection(at(0, 45).elevation, -std::sqrt(0.5), -std::sqrt(0.5));
}

TEST(DialNeedle, StartsAtTheHubAndEndsInsideTheScale) {
  const DialView view = at(33, 10).rotation;
  EXPECT_NEAR(QLineF(view.pivot, view.needle->p1()).length(), dial::kHub * view.radius, 1e-6);
  EXPECT_NEAR(QLineF(view.pivot, view.needle->p2()).length(), dial::kNeedleTip * view.radius, 1e-6);
}

TEST(DialNeedle, RotationBeyondHalfATurnIsStillADirection) {
  const DialGeometry g = at(190, 0);
  expectDirection(g.rotation, direction(at(-170, 0).rotation).x(), direction(at(-170, 0).rotation).y());
  EXPECT_FALSE(g.rotation.offScale);
}

TEST(DialNeedle, ElevationIsHeldAtTheScalesEndAndMarked) {
  const DialGeometry over = at(0, 104.2), under = at(0, -130);
  expectDirection(over.elevation, 0, -1);
  expectDirection(under.elevation, 0, 1);
  EXPECT_TRUE(over.elevation.offScale);
  EXPECT_TRUE(under.elevation.offScale);
  EXPECT_FALSE(at(0, 90).elevation.offScale);
  EXPECT_EQ(over.elevation.axis.degrees, 104.2);
}

TEST(DialNeedle, IsThereForAReadingThatIsOkAndForNoOther) {
  for (const auto& reading : allReadings()) {
    if (reading == PositionState::Ok) continue;
    DialValues v = usualValues();
    v.rotation.reading = v.elevation.reading = reading;
    const DialGeometry g = dialGeometry(v, kUsual);
    EXPECT_FALSE(g.rotation.needle);
    EXPECT_FALSE(g.elevation.needle);
    EXPECT_TRUE(g.rotation.needleShape.isEmpty());
  }
  DialValues broken = usualValues();
  broken.rotation.degrees = std::nan("");
  EXPECT_FALSE(dialGeometry(broken, kUsual).rotation.needle);
}

TEST(DialBand, LiesBetweenTheLimits) {
  const DialView view = at(0, 0).rotation;
  ASSERT_TRUE(view.band);
  EXPECT_EQ(view.band->from, -120);
  EXPECT_EQ(view.band->to, 90);
  EXPECT_EQ(view.low->degrees, -120);
  EXPECT_EQ(view.high->degrees, 90);
}

TEST(DialBand, NeedsBothEndsTheRightWayRound) {
  DialValues v = usualValues();
  v.rotation.limitHigh = {};
  EXPECT_FALSE(dialGeometry(v, kUsual).rotation.band);
  EXPECT_TRUE(dialGeometry(v, kUsual).rotation.low);
  v.rotation.limitHigh = -150;
  EXPECT_FALSE(dialGeometry(v, kUsual).rotation.band);
  EXPECT_TRUE(dialGeometry(v, kUsual).rotation.high);
}

TEST(DialBand, IsHeldToTheScaleButItsLabelsSayTheTruth) {
  DialValues v = usualValues();
  v.elevation.limitHigh = 120;
  const DialView view = dialGeometry(v, kUsual).elevation;
  EXPECT_EQ(view.band->to, 90);
  EXPECT_EQ(view.high->degrees, 120);
}

double bearingOf(const DialView& view, const QPointF& p) {
  const QPointF d = p - view.pivot;
  return std::atan2(d.x(), -d.y()) * 180 / 3.14159265358979;
}

TEST(DialStop, StandsAgainstTheNeedleOnItsOwnSide) {
  for (const double degrees : {-170.0, -90.0, 0.0, 45.0, 120.0}) {
    DialValues v = usualValues();
    v.rotation.degrees = degrees;
    v.rotation.plusStop = v.rotation.minusStop = Status2::On;
    const DialView view = dialGeometry(v, kUsual).rotation;
    ASSERT_TRUE(view.plusStop && view.minusStop);
    for (const QPointF& p : view.plusStop->shape) {
      const double off = std::remainder(bearingOf(view, p) - degrees, 360);
      EXPECT_GT(off, 0) << degrees;
      EXPECT_LT(off, 30) << degrees;
    }
    for (const QPointF& p : view.minusStop->shape)
      EXPECT_LT(std::remainder(bearingOf(view, p) - degrees, 360), 0) << degrees;
    EXPECT_TRUE(view.plusStop->shape.boundingRect().contains(view.plusStop->glyph.center()));
  }
}

TEST(DialStop, IsDrawnWhenOnOrInErrorOnly) {
  for (const auto& [stop, drawn] : {std::pair{std::optional<Status2>(), false},
                                    {Status2::Off, false},
                                    {Status2::On, true},
                                    {Status2::Error, true},
                                    {Status2::NotAvailable, false}}) {
    DialValues v = usualValues();
    v.elevation.plusStop = stop;
    EXPECT_EQ(dialGeometry(v, kUsual).elevation.plusStop.has_value(), drawn);
  }
}

TEST(DialStop, WithoutANeedleSaysWhichEndBesideTheHub) {
  DialValues v = usualValues();
  v.rotation.reading = v.elevation.reading = PositionState::NotFitted;
  v.rotation.plusStop = v.elevation.plusStop = Status2::On;
  v.rotation.minusStop = v.elevation.minusStop = Status2::On;
  const DialGeometry g = dialGeometry(v, kUsual);
  EXPECT_GT(g.rotation.plusStop->glyph.center().x(), g.rotation.pivot.x());
  EXPECT_LT(g.rotation.minusStop->glyph.center().x(), g.rotation.pivot.x());
  EXPECT_LT(g.elevation.plusStop->glyph.center().y(), g.elevation.pivot.y());
  EXPECT_GT(g.elevation.minusStop->glyph.center().y(), g.elevation.pivot.y());
}

double commandedLength(double speed, PositionState reading = PositionState::Ok) {
  DialValues v = usualValues();
  v.rotation.reading = reading;
  v.rotation.command = DialAxis::Command{speed, QStringLiteral("Joystick 33")};
  return dialGeometry(v, kUsual).rotation.commandLength;
}

TEST(DialCommand, LengthIsTheSpeed) {
  for (const PositionState reading : {PositionState::Ok, PositionState::NotFitted}) {
    EXPECT_LT(commandedLength(0.1, reading), commandedLength(0.5, reading));
    EXPECT_LT(commandedLength(0.5, reading), commandedLength(1, reading));
    EXPECT_DOUBLE_EQ(commandedLength(-0.5, reading), commandedLength(0.5, reading));
    EXPECT_DOUBLE_EQ(commandedLength(7, reading), commandedLength(1, reading));
    // Linear: equal steps in speed are equal steps in length.
    EXPECT_NEAR(commandedLength(0.75, reading) - commandedLength(0.5, reading),
                commandedLength(0.5, reading) - commandedLength(0.25, reading), 1e-9);
  }
}

TEST(DialCommand, AtRestThereIsNoArrow) {
  DialValues v = usualValues();
  EXPECT_TRUE(dialGeometry(v, kUsual).rotation.command.isEmpty());
  v.rotation.command = DialAxis::Command{0, QStringLiteral("Joystick 33")};
  EXPECT_TRUE(dialGeometry(v, kUsual).rotation.command.isEmpty());
}

TEST(DialCommand, PointsFromTheNeedleToItsSide) {
  for (const double speed : {-0.6, 0.6}) {
    DialValues v = usualValues();
    v.rotation.degrees = 10;
    v.rotation.command = DialAxis::Command{speed, QString()};
    const DialView view = dialGeometry(v, kUsual).rotation;
    for (const QPointF& p : view.command) EXPECT_GT(std::remainder(bearingOf(view, p) - 10, 360) * speed, 0);
  }
}

struct Size {
  const char* name;
  QRectF bounds;
};
class DialAtSize : public testing::TestWithParam<Size> {
 protected:
  const QRectF& bounds() const { return GetParam().bounds; }
};

std::vector<QRectF> rectangles(const DialView& v) {
  std::vector<QRectF> all{v.drawing, v.value, v.title, v.age, v.condition, v.source};
  if (v.low) all.push_back(v.low->label);
  if (v.high) all.push_back(v.high->label);
  std::erase_if(all, [](const QRectF& r) { return r.isNull(); });
  return all;
}

QRectF circleOf(const DialView& v) {
  return {v.pivot.x() - v.radius, v.pivot.y() - v.radius, 2 * v.radius, 2 * v.radius};
}

TEST_P(DialAtSize, EverythingIsInsideAndTheViewsDoNotTouch) {
  for (const DialSample& sample : dialSamples()) {
    const DialGeometry g = dialGeometry(sample.values, bounds());
    for (const QRectF& a : rectangles(g.rotation)) {
      EXPECT_TRUE(bounds().contains(a)) << sample.name;
      for (const QRectF& b : rectangles(g.elevation)) {
        // Texts lie below both drawings, so only parts of one kind could meet.
        EXPECT_FALSE(a.intersects(b)) << sample.name;
      }
    }
    for (const QRectF& b : rectangles(g.elevation)) EXPECT_TRUE(bounds().contains(b)) << sample.name;
    EXPECT_TRUE(g.rotation.drawing.contains(circleOf(g.rotation))) << sample.name;
  }
}

TEST_P(DialAtSize, TextsOfOneViewDoNotOverlap) {
  const DialLayout layout = layOutDial(bounds());
  for (const DialViewLayout* v : {&layout.rotation, &layout.elevation}) {
    const QRectF parts[] = {v->drawing, v->title, v->value, v->age, v->condition, v->source};
    for (const QRectF& a : parts) {
      for (const QRectF& b : parts) EXPECT_TRUE(&a == &b || !a.intersects(b));
    }
  }
}

TEST_P(DialAtSize, LabelsClearTheCircleEachOtherAndTheChipsAtEveryAngle) {
  for (int low = -180; low <= 180; low += 3) {
    for (int span = 0; span <= 360; span += 9) {
      DialValues v = usualValues();
      v.rotation.limitLow = low;
      v.rotation.limitHigh = std::min(180, low + span);
      v.elevation.limitLow = low / 2.0;
      v.elevation.limitHigh = std::min(90.0, (low + span) / 2.0);
      const DialGeometry g = dialGeometry(v, bounds());
      for (const DialView* view : {&g.rotation, &g.elevation}) {
        const QRectF a = view->low->label, b = view->high->label;
        EXPECT_EQ(a.isNull(), g.layout.labelWidth == 0) << low << "+" << span;
        EXPECT_EQ(b.isNull(), g.layout.labelWidth == 0) << low << "+" << span;
        if (a.isNull() || b.isNull()) continue;
        const std::string where = std::to_string(low) + "+" + std::to_string(span);
        EXPECT_TRUE(view->drawing.contains(a) && view->drawing.contains(b)) << where;
        EXPECT_FALSE(a.intersects(b)) << where;
        EXPECT_FALSE(a.intersects(g.layout.enableChip) || b.intersects(g.layout.enableChip)) << where;
        EXPECT_FALSE(a.intersects(g.layout.stowedChip) || b.intersects(g.layout.stowedChip)) << where;
        for (const QRectF& label : {a, b}) {
          const double dx = std::max({label.left() - view->pivot.x(), 0.0, view->pivot.x() - label.right()});
          const double dy = std::max({label.top() - view->pivot.y(), 0.0, view->pivot.y() - label.bottom()});
          EXPECT_GE(std::hypot(dx, dy), view->radius * 0.99) << where;
        }
      }
    }
  }
}

TEST_P(DialAtSize, EndsThatMeetKeepTheirLabelsOnTheirOwnSide) {
  DialValues v = usualValues();
  v.rotation.limitLow = -180;
  v.rotation.limitHigh = 180;
  const DialView behind = dialGeometry(v, bounds()).rotation;
  v.rotation.limitLow = -2;
  v.rotation.limitHigh = 2;
  const DialView ahead = dialGeometry(v, bounds()).rotation;
  if (behind.low->label.isNull()) return;  // no room for labels
  // Left of the vehicle is left on the screen, ahead and behind alike.
  EXPECT_LT(behind.low->label.right(), behind.high->label.left());
  EXPECT_LT(ahead.low->label.right(), ahead.high->label.left());
}

TEST_P(DialAtSize, ShapesStayInTheirOwnDrawingAtEveryAngle) {
  for (int degrees = -180; degrees <= 180; degrees += 5) {
    for (const double speed : {-1.0, 1.0}) {
      DialValues v = usualValues();
      v.rotation.degrees = degrees;
      v.elevation.degrees = degrees;
      for (DialAxis* axis : {&v.rotation, &v.elevation}) {
        axis->plusStop = axis->minusStop = Status2::On;
        axis->command = DialAxis::Command{speed, QString()};
      }
      const DialGeometry g = dialGeometry(v, bounds());
      for (const DialView* view : {&g.rotation, &g.elevation}) {
        for (const QPolygonF& shape :
             {view->needleShape, view->command, view->plusStop->shape, view->minusStop->shape})
          EXPECT_TRUE(view->drawing.contains(shape.boundingRect())) << degrees;
      }
    }
  }
}

TEST_P(DialAtSize, NothingMovesWhenValuesChange) {
  const DialGeometry usual = dialGeometry(usualValues(), bounds());
  for (const DialSample& sample : dialSamples()) {
    const DialGeometry g = dialGeometry(sample.values, bounds());
    EXPECT_EQ(g.rotation.pivot, usual.rotation.pivot) << sample.name;
    EXPECT_EQ(g.rotation.value, usual.rotation.value) << sample.name;
    EXPECT_EQ(g.rotation.condition, usual.rotation.condition) << sample.name;
    EXPECT_EQ(g.elevation.pivot, usual.elevation.pivot) << sample.name;
    EXPECT_EQ(g.elevation.value, usual.elevation.value) << sample.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, DialAtSize,
                         testing::Values(Size{"Square200", {0, 0, 200, 200}},
                                         Size{"Flat200", {0, 0, 200, 120}}, Size{"Usual", {0, 0, 640, 400}},
                                         Size{"Page", {0, 0, 640, 360}}, Size{"Tall", {0, 0, 480, 900}},
                                         Size{"Wide", {0, 0, 1200, 260}}, Size{"Low", {0, 0, 656, 128}},
                                         Size{"Lowest", {0, 0, 480, 112}},
                                         Size{"LowOnAPage", {0, 0, 554, 160}},
                                         Size{"Shifted", {50, 70, 800, 500}},
                                         Size{"Full", {0, 0, 1920, 1080}}, Size{"Wall", {0, 0, 3000, 1500}}),
                         [](const auto& size) { return size.param.name; });

TEST(DialLayout, PutsTheNumbersBesideTheDrawingsWhereHeightIsShort) {
  for (const QRectF& bounds : {QRectF(0, 0, 656, 128), QRectF(0, 0, 554, 154), QRectF(0, 0, 480, 112)}) {
    const DialLayout dial = layOutDial(bounds);
    EXPECT_GE(dial.rotation.radius, bounds.height() * 0.36) << bounds.width();
    EXPECT_GE(dial.valueSize, 24) << bounds.width();
    EXPECT_GE(dial.textSize, 12) << bounds.width();
    for (const DialViewLayout* view : {&dial.rotation, &dial.elevation}) {
      EXPECT_GE(view->value.left(), view->drawing.right());
      EXPECT_FALSE(view->condition.isNull());
      EXPECT_FALSE(view->source.isNull());
    }
    EXPECT_TRUE(dial.rotation.texts.contains(dial.enableChip)) << "a word, not a sign alone";
    EXPECT_TRUE(dial.elevation.texts.contains(dial.stowedChip));
  }
}

TEST(DialLayout, SmallSizesDropTextsInsteadOfSqueezingThem) {
  const DialLayout square = layOutDial({0, 0, 200, 200}), flat = layOutDial({0, 0, 200, 120});
  EXPECT_EQ(square.labelWidth, 0);
  EXPECT_TRUE(square.rotation.title.isNull());
  EXPECT_FALSE(square.rotation.source.isNull());
  EXPECT_TRUE(flat.rotation.source.isNull());
  EXPECT_FALSE(flat.rotation.condition.isNull());
  EXPECT_GE(flat.rotation.radius, 30);
  EXPECT_GE(square.valueSize, 18);
}

TEST(DialLayout, NoSizeIsTooSmallToBeAsked) {
  for (const double side : {0.0, 1.0, 10.0, 39.0, 41.0, 60.0}) {
    const DialGeometry g = dialGeometry(usualValues(), QRectF(0, 0, side, side));
    EXPECT_TRUE(std::isfinite(g.rotation.radius));
  }
}

}  // namespace
}  // namespace deckpipe
