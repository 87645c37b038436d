// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/timeline.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <limits>
#include <memory>

#include "base/time.h"

namespace deckpipe {
namespace {

constexpr Instant at(double seconds) { return {static_cast<std::int64_t>(seconds * 1e9)}; }

TEST(TimelineGeometry, HasTheLogsEndsAtItsEnds) {
  const TimelineGeometry g{1'020, at(100), at(200)};
  EXPECT_EQ(g.xOf(at(100)), 10);
  EXPECT_EQ(g.xOf(at(200)), 1'010);
  EXPECT_EQ(g.xOf(at(150)), 510);
  EXPECT_EQ(g.timeAt(10), at(100));
  EXPECT_EQ(g.timeAt(1'010), at(200));
  EXPECT_EQ(g.timeAt(-50), at(100));
  EXPECT_EQ(g.timeAt(5'000), at(200));
  EXPECT_EQ(g.timeAt(510), at(150));
}

TEST(TimelineGeometry, AnswersForOddSpansToo) {
  const TimelineGeometry instant{500, at(7), at(7)};
  EXPECT_EQ(instant.timeAt(250), at(7));
  EXPECT_EQ(instant.xOf(at(7)), instant.right());
  const TimelineGeometry hostile{500, {0}, {std::numeric_limits<std::int64_t>::max() - 1}};
  EXPECT_EQ(hostile.xOf(kNotYet), hostile.left());
  EXPECT_GT(hostile.timeAt(250).ns, 0);
  const TimelineGeometry none{0, {}, {}};
  EXPECT_EQ(none.timeAt(0), Instant{});
}

struct Scale {
  const char* name;
  double width, begin, end;  // pixels, seconds since the log's begin
  TimelineUnit unit;
  const char* texts;
};
void PrintTo(const Scale& scale, std::ostream* out) { *out << scale.name; }

struct TimelineScale : testing::TestWithParam<Scale> {
  static double widthOf(const QString& text) { return 7.0 * static_cast<double>(text.size()); }
};

TEST_P(TimelineScale, HasTextsThatAreReadAndDoNotMeet) {
  const Scale& c = GetParam();
  const Instant zero = c.unit == TimelineUnit::Time ? at(1'700'000'000) : Instant{};
  const TimelineGeometry g{c.width, zero + (at(c.begin) - Instant{}), zero + (at(c.end) - Instant{})};
  const auto ticks = timelineTicks(g, zero, c.unit, widthOf);
  QStringList texts;
  double free = 0, lastX = -100;
  for (const TimelineTick& tick : ticks) {
    EXPECT_GE(tick.x, g.left() - 1e-6);
    EXPECT_LE(tick.x, g.right() + 1e-6);
    EXPECT_GE(tick.x - lastX, 4) << "ticks are told apart";
    lastX = tick.x;
    if (tick.text.isEmpty()) continue;
    texts += tick.text;
    EXPECT_GE(tick.left, free) << tick.text.toStdString();
    free = tick.left + widthOf(tick.text) + 4;
    EXPECT_LE(tick.left + widthOf(tick.text), std::max(c.width, widthOf(tick.text)));
  }
  EXPECT_EQ(texts.join(u' ').toStdString(), c.texts);
}

INSTANTIATE_TEST_SUITE_P(
    Table, TimelineScale,
    testing::Values(
        Scale{"tenths", 400, 0, 1, TimelineUnit::Time, "0:00.0 0:00.2 0:00.4 0:00.6 0:00.8 0:01.0"},
        Scale{"seconds", 420, 0, 10, TimelineUnit::Time, "0:00 0:02 0:04 0:06 0:08 0:10"},
        Scale{"part_of_a_log", 320, 61.5, 65.2, TimelineUnit::Time, "1:02 1:03 1:04 1:05"},
        Scale{"half_minutes", 320, 0, 130, TimelineUnit::Time, "0:00 0:30 1:00 1:30 2:00"},
        Scale{"ten_minutes", 420, 0, 3000, TimelineUnit::Time, "0:00 10:00 20:00 30:00 40:00 50:00"},
        Scale{"hours", 420, 0, 4 * 3600, TimelineUnit::Time, "0:00:00 1:00:00 2:00:00 3:00:00 4:00:00"},
        Scale{"days", 420, 0, 5 * 86400.0, TimelineUnit::Time, "0:00:00 48:00:00 96:00:00"},
        Scale{"milliseconds", 420, 5, 5.004, TimelineUnit::Time,
              "0:05.000 0:05.001 0:05.002 0:05.003 0:05.004"},
        Scale{"frames", 420, 0, 5'000, TimelineUnit::Frames, "0 1000 2000 3000 4000 5000"},
        Scale{"few_frames", 420, 0, 3, TimelineUnit::Frames, "0 1 2 3"},
        Scale{"millions_of_frames", 420, 0, 9e6, TimelineUnit::Frames, "0 2000000 4000000 6000000 8000000"},
        Scale{"one_instant", 420, 5, 5, TimelineUnit::Time, ""}),
    [](const auto& row) { return row.param.name; });

TEST(TimelineScaleOfAnySpan, IsShortAndEnds) {
  const auto widthOf = [](const QString& text) { return 7.0 * static_cast<double>(text.size()); };
  for (const double width : {0.0, 1.0, 100.0, 4000.0}) {
    for (const std::int64_t end :
         {std::int64_t{1}, std::int64_t{1'000}, std::int64_t{1'000'000}, std::int64_t{3'600'000'000'000},
          std::numeric_limits<std::int64_t>::max()}) {
      for (const TimelineUnit unit : {TimelineUnit::Time, TimelineUnit::Frames})
        EXPECT_LT(timelineTicks({width, {0}, {end}}, {0}, unit, widthOf).size(), 800u) << width << ' ' << end;
    }
  }
}

struct TimelineTest : testing::Test {
  Timeline timeline;
  QSignalSpy seek{&timeline, &Timeline::seekRequested};
  QSignalSpy end{&timeline, &Timeline::endRequested};

  TimelineTest() {
    timeline.resize(1'020, 48);
    timeline.show();
    TimelineValues values;
    values.isEmpty = false;
    values.begin = at(100);
    values.end = at(200);
    values.cursor = at(150);
    timeline.setValues(values);
  }
  // Paint events from now on.
  struct Paints : QObject {
    explicit Paints(QWidget* widget) { widget->installEventFilter(this); }
    bool eventFilter(QObject*, QEvent* event) override {
      times += event->type() == QEvent::Paint ? 1 : 0;
      return false;
    }
    int times = 0;
  };
  Instant last() const { return seek.isEmpty() ? Instant{-1} : seek.last()[0].value<Instant>(); }
};

TEST_F(TimelineTest, SeeksWhereOnePointsAndDrags) {
  QTest::mousePress(&timeline, Qt::LeftButton, {}, {260, 20});
  EXPECT_EQ(last(), at(125));
  QTest::mouseMove(&timeline, {510, 20});
  QTest::mouseRelease(&timeline, Qt::LeftButton, {}, {510, 20});
  QTest::mousePress(&timeline, Qt::LeftButton, {}, {2, 20});
  EXPECT_EQ(last(), at(100));
  QTest::mousePress(&timeline, Qt::RightButton, {}, {600, 20});
  EXPECT_EQ(last(), at(100));
}

TEST_F(TimelineTest, StepsBySecondsWithKeysAndStopsAtTheEnds) {
  QTest::keyClick(&timeline, Qt::Key_Left);
  EXPECT_EQ(last(), at(149));
  QTest::keyClick(&timeline, Qt::Key_Right);
  EXPECT_EQ(last(), at(151));
  QTest::keyClick(&timeline, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(last(), at(140));
  QTest::keyClick(&timeline, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_EQ(last(), at(160));
  QTest::keyClick(&timeline, Qt::Key_Home);
  EXPECT_EQ(last(), at(100));
  QTest::keyClick(&timeline, Qt::Key_End);
  EXPECT_EQ(end.count(), 1);
  TimelineValues values = timeline.values();
  values.cursor = at(199.5);
  timeline.setValues(values);
  QTest::keyClick(&timeline, Qt::Key_Right);
  EXPECT_EQ(last(), at(200));
  values.cursor = kNotYet;
  timeline.setValues(values);
  QTest::keyClick(&timeline, Qt::Key_Left);
  EXPECT_EQ(last(), at(100));
  QTest::keyClick(&timeline, Qt::Key_Right);
  EXPECT_EQ(last(), at(101));
}

TEST_F(TimelineTest, AsksForNothingWithoutFrames) {
  timeline.setValues({});
  QTest::mouseClick(&timeline, Qt::LeftButton, {}, {300, 20});
  for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Home, Qt::Key_End})
    QTest::keyClick(&timeline, key);
  EXPECT_EQ(seek.count(), 0);
  EXPECT_EQ(end.count(), 0);
  timeline.grab();
}

TEST_F(TimelineTest, LooksCloserWithWheelAndKeysAndFitsAgain) {
  const QSignalSpy shown(&timeline, &Timeline::shownChanged);
  QTest::keyClick(&timeline, Qt::Key_Plus);
  EXPECT_EQ(timeline.shown(), (TimelineSpan{at(125), at(175)}));
  QTest::keyClick(&timeline, Qt::Key_Plus);
  EXPECT_EQ(timeline.shown(), (TimelineSpan{at(137.5), at(162.5)}));
  QTest::keyClick(&timeline, Qt::Key_Minus);
  EXPECT_EQ(timeline.shown(), (TimelineSpan{at(125), at(175)}));
  const QPointF left(10, 20);
  QWheelEvent in(left, timeline.mapToGlobal(left), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                 Qt::NoScrollPhase, false);
  QApplication::sendEvent(&timeline, &in);
  EXPECT_EQ(timeline.shown().begin, at(125));
  EXPECT_LT(timeline.shown().end, at(165));
  QTest::mouseClick(&timeline, Qt::LeftButton, {}, {10, 20});
  EXPECT_EQ(last(), at(125));
  QTest::keyClick(&timeline, Qt::Key_0);
  EXPECT_FALSE(timeline.isZoomed());
  EXPECT_EQ(shown.count(), 5);
  timeline.grab();
}

TEST_F(TimelineTest, LooksCloserWithControlAndWheelAsElsewhere) {
  const QPointF middle(510, 20);
  QWheelEvent in(middle, timeline.mapToGlobal(middle), {}, {0, 240}, Qt::NoButton, Qt::ControlModifier,
                 Qt::NoScrollPhase, false);
  QApplication::sendEvent(&timeline, &in);
  EXPECT_TRUE(in.isAccepted());
  EXPECT_NEAR(timeline.shown().ns(), 100e9 / (1.3 * 1.3), 1e6);
  EXPECT_NEAR(timeline.geometryNow().xOf(at(150)), 510, 0.001);
}

TEST_F(TimelineTest, LooksCloserWhereTwoFingersPartOnATouchpad) {
  const QPointF left(260, 20);
  QNativeGestureEvent part(Qt::ZoomNativeGesture, QPointingDevice::primaryPointingDevice(), 2, left, left,
                           timeline.mapToGlobal(left), 1.0, {});
  QApplication::sendEvent(&timeline, &part);
  EXPECT_EQ(timeline.shown().ns(), 50e9);
  EXPECT_NEAR(timeline.geometryNow().xOf(at(125)), 260, 0.5);
}

TEST_F(TimelineTest, LooksCloserWhereTwoFingersPartOnTheScreen) {
  const std::unique_ptr<QPointingDevice> device(QTest::createTouchDevice());
  QPointingDevice* screen = device.get();
  const auto touch = [&](int left, int right) {
    QTest::touchEvent(&timeline, screen).move(0, {left, 20}).move(1, {right, 20});
  };
  QTest::touchEvent(&timeline, screen).press(0, {460, 20}).press(1, {560, 20});
  for (int far = 60; far <= 200; far += 10) touch(510 - far, 510 + far);
  QTest::touchEvent(&timeline, screen).release(0, {310, 20}).release(1, {710, 20});
  EXPECT_TRUE(timeline.isZoomed());
  EXPECT_LT(timeline.shown().ns(), 60e9);
  EXPECT_NEAR(timeline.geometryNow().xOf(at(150)), 510, 20) << "what is between the fingers stays there";
  EXPECT_EQ(seek.count(), 0) << "the cursor is left alone";
}

TEST_F(TimelineTest, SeeksWhereAFingerTapsOrDrags) {
  const std::unique_ptr<QPointingDevice> device(QTest::createTouchDevice());
  QPointingDevice* screen = device.get();
  QTest::touchEvent(&timeline, screen).press(0, {260, 20});
  QTest::touchEvent(&timeline, screen).release(0, {260, 20});
  EXPECT_EQ(last(), at(125));
  QTest::touchEvent(&timeline, screen).press(0, {260, 20});
  QTest::touchEvent(&timeline, screen).move(0, {510, 20});
  EXPECT_EQ(last(), at(150));
  QTest::touchEvent(&timeline, screen).release(0, {510, 20});
}

TEST_F(TimelineTest, KeepsTheCursorInSight) {
  timeline.showSpan({at(140), at(160)});
  TimelineValues values = timeline.values();
  values.cursor = at(161);
  timeline.setValues(values);
  EXPECT_TRUE(timeline.shown().has(at(161)));
  values.cursor = at(110);
  timeline.setValues(values);
  EXPECT_TRUE(timeline.shown().has(at(110)));
  EXPECT_EQ(timeline.shown().ns(), 20e9);
}

// The log goes on where there is an arrow beside the strip; that of the side where the cursor is differs.
TEST_F(TimelineTest, ShowsWhereTheLogGoesOnOutOfSight) {
  const auto side = [this](int x) { return timeline.grab({x, 0, 8, 48}).toImage(); };
  constexpr int kLeft = 0, kRight = 1'012;
  const QImage nothingLeft = side(kLeft), nothingRight = side(kRight);
  timeline.showSpan({at(140), at(160)});
  const QImage left = side(kLeft), right = side(kRight);
  EXPECT_NE(left, nothingLeft);
  EXPECT_NE(right, nothingRight);
  timeline.showSpan({at(160), at(200)});
  EXPECT_NE(side(kLeft), nothingLeft);
  EXPECT_NE(side(kLeft), left) << "the cursor is on this side";
  timeline.showSpan({at(100), at(120)});
  EXPECT_EQ(side(kLeft), nothingLeft);
  EXPECT_NE(side(kRight), right);
}

TEST_F(TimelineTest, SelectsAboveTheStripWithShiftAndByKeys) {
  QTest::mousePress(&timeline, Qt::LeftButton, {}, {260, 4});
  QTest::mouseMove(&timeline, {510, 4});
  EXPECT_EQ(seek.count(), 0);
  QTest::mouseRelease(&timeline, Qt::LeftButton, {}, {510, 4});
  EXPECT_EQ(timeline.selection(), (TimelineSpan{at(125), at(150)}));
  timeline.grab();
  QTest::keyClick(&timeline, Qt::Key_Escape);
  EXPECT_FALSE(timeline.selection());
  QTest::keyClick(&timeline, Qt::Key_BracketLeft);
  EXPECT_EQ(timeline.selection(), (TimelineSpan{at(150), at(200)}));
  QTest::keyClick(&timeline, Qt::Key_Delete);
  QTest::keyClick(&timeline, Qt::Key_BracketRight);
  EXPECT_EQ(timeline.selection(), (TimelineSpan{at(100), at(150)}));
}

TEST_F(TimelineTest, GivesUpTheSelectionOnlyWhereNoOtherIsDragged) {
  timeline.select(TimelineSpan{at(110), at(120)});
  QSignalSpy selected(&timeline, &Timeline::selectionChanged);
  QTest::mousePress(&timeline, Qt::LeftButton, {}, {260, 4});
  EXPECT_EQ(selected.count(), 0) << "a loop goes on until there is another span";
  QTest::mouseMove(&timeline, {510, 4});
  QTest::mouseRelease(&timeline, Qt::LeftButton, {}, {510, 4});
  EXPECT_EQ(timeline.selection(), (TimelineSpan{at(125), at(150)}));
  QTest::mouseClick(&timeline, Qt::LeftButton, {}, {700, 4});
  EXPECT_FALSE(timeline.selection());
}

TEST_F(TimelineTest, GoesFromMarkToMark) {
  TimelineValues values = timeline.values();
  values.marks = {{TimelineMark::Kind::Event, at(120)}, {TimelineMark::Kind::Event, at(180)}};
  values.gaps = {{TimelineGap::Kind::Silence, {at(130), at(140)}},
                 {TimelineGap::Kind::LinkLost, {at(190), kNever}}};
  timeline.setValues(values);
  QTest::keyClick(&timeline, Qt::Key_Left, Qt::ControlModifier);
  EXPECT_EQ(last(), at(120));
  QTest::keyClick(&timeline, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(last(), at(180));
  timeline.grab();
}

TEST_F(TimelineTest, DrawsAScaleUnderTheStripThatGoesWithWhatIsInSight) {
  timeline.resize(1'020, timeline.sizeHint().height());
  const auto scale = [this] {
    const int top = timeline.height() - timeline.fontMetrics().height();
    return timeline.grab({0, top, timeline.width(), timeline.height() - top}).toImage();
  };
  const QImage whole = scale();
  timeline.showSpan({at(140), at(160)});
  EXPECT_NE(scale(), whole);
  timeline.fit();
  EXPECT_EQ(scale(), whole);
}

TEST_F(TimelineTest, LooksNoCloserThanAFewFramesOfALogWithoutTimes) {
  TimelineValues values = timeline.values();
  values.unit = TimelineUnit::Frames;
  values.begin = at(0);
  values.end = at(1000);
  values.cursor = at(500);
  timeline.setValues(values);
  for (int i = 0; i < 30; ++i) QTest::keyClick(&timeline, Qt::Key_Plus);
  EXPECT_EQ(timeline.shown().ns(), 10e9);
}

TEST_F(TimelineTest, DrawsAMarkOfItsOwnForEachGroup) {
  TimelineValues values = timeline.values();
  std::vector<QImage> pictures;
  for (const EventGroup group : kAllOf<EventGroup>) {
    values.marks = {{TimelineMark::Kind::Event, at(120), QStringLiteral("x"), group, Severity::Fault}};
    timeline.setValues(values);
    const QImage picture = timeline.grab().toImage();
    for (const QImage& other : pictures) EXPECT_NE(picture, other) << static_cast<int>(group);
    pictures.push_back(picture);
  }
}

TEST_F(TimelineTest, LeavesOutTheGroupsThatAreHidden) {
  TimelineValues values = timeline.values();
  const QImage none = timeline.grab().toImage();
  values.marks = {{TimelineMark::Kind::Event, at(180), {}, EventGroup::Stop}};
  timeline.setValues(values);
  EXPECT_NE(timeline.grab().toImage(), none);
  timeline.hide(EventGroup::Stop, true);
  EXPECT_EQ(timeline.grab().toImage(), none);
  const auto before = seek.count();
  QTest::keyClick(&timeline, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(seek.count(), before);
  timeline.hide(EventGroup::Stop, false);
  QTest::keyClick(&timeline, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(last(), at(180));
}

TEST(TimelineSpans, StayWithinTheLog) {
  const TimelineSpan whole{at(0), at(100)};
  EXPECT_EQ(spanZoomed(whole, whole, at(0), 4), (TimelineSpan{at(0), at(25)}));
  EXPECT_EQ(spanZoomed({at(90), at(100)}, whole, at(95), 0.01), whole);
  EXPECT_EQ(spanMoved({at(90), at(100)}, whole, 5), (TimelineSpan{at(90), at(100)}));
  EXPECT_EQ(spanMoved({at(50), at(60)}, whole, -1), (TimelineSpan{at(40), at(50)}));
  EXPECT_GE(spanZoomed(whole, whole, at(50), 1e15).ns(), kMinSpanNs);
  EXPECT_EQ(spanZoomed({at(5), at(5)}, {at(5), at(5)}, at(5), 2), (TimelineSpan{at(5), at(5)}));
}

// 1,000 pixels: a pixel is 0.1 s.
TEST_F(TimelineTest, DrawsALogThatGrowsOnlyOnceThatCanBeSeen) {
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&timeline));
  TimelineValues values = timeline.values();
  values.density = {0.5F, 1.0F};
  const auto paintsAt = [&](double second) {
    values.end = values.cursor = at(second);
    timeline.setValues(values);
    Paints paints(&timeline);
    QApplication::sendPostedEvents();
    return paints.times;
  };
  EXPECT_EQ(paintsAt(200), 1);
  EXPECT_EQ(paintsAt(200.1), 0);
  EXPECT_EQ(paintsAt(200.2), 0);
  EXPECT_EQ(timeline.values().end, at(200.2));
  EXPECT_EQ(paintsAt(200.4), 1) << "since it was drawn last";
  EXPECT_EQ(paintsAt(200.5), 0);
  values.density = {1.0F, 0.5F};
  EXPECT_EQ(paintsAt(200.6), 1) << "another picture";
  values.atEnd = false;
  EXPECT_EQ(paintsAt(200.7), 1) << "a cursor that stands is shown exactly";
}

}  // namespace
}  // namespace deckpipe
