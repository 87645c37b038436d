// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/play/transport_bar.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cstdlib>
#include <ctime>

#include "paint/timeline.h"
#include "panel/play/time_readout.h"
#include "panel/play/transport_button.h"
#include "support/child.h"
#include "support/frames.h"
#include "support/logs.h"
#include "widgets/panel/panel_samples.h"

namespace deckpipe {
namespace {

struct TransportBarTest : testing::Test {
  TransportBar bar;
  QSignalSpy play{&bar, &TransportBar::playRequested};
  QSignalSpy pause{&bar, &TransportBar::pauseRequested};
  QSignalSpy seek{&bar, &TransportBar::seekRequested};
  QSignalSpy step{&bar, &TransportBar::stepRequested};
  QSignalSpy end{&bar, &TransportBar::endRequested};
  QSignalSpy speed{&bar, &TransportBar::speedRequested};
  std::shared_ptr<LogDocument> log = test::logOfText(test::busyText(100));

  TransportBarTest() {
    bar.resize(1366, bar.sizeHint().height());
    bar.show();
  }
  template <typename T>
  T* child(const char* name) const {
    return test::child<T>(bar, name);
  }
  Timeline* timeline() const { return child<Timeline>("timeline"); }
};

TEST_F(TransportBarTest, OffersNothingWithoutFrames) {
  for (const auto& view : {LogView{}, test::viewOf(std::make_shared<LogDocument>())}) {
    bar.setView(view, {});
    for (const char* name : {"play", "stepBack", "stepForward", "toEnd"})
      EXPECT_FALSE(child<QAbstractButton>(name)->isEnabled()) << name;
    QTest::keyClick(timeline(), Qt::Key_Space);
    QTest::keyClick(timeline(), Qt::Key_Right);
    bar.grab();
  }
  EXPECT_EQ(play.count() + pause.count() + seek.count() + step.count() + end.count(), 0);
}

TEST_F(TransportBarTest, SpacePlaysAndPauses) {
  bar.setView(test::viewOf(log, 50), {.isPlaying = false});
  QTest::keyClick(timeline(), Qt::Key_Space);
  EXPECT_EQ(play.count(), 1);
  bar.setView(test::viewOf(log, 50), {.isPlaying = true});
  QTest::keyClick(timeline(), Qt::Key_Space);
  EXPECT_EQ(pause.count(), 1);
  EXPECT_EQ(play.count(), 1);
}

TEST_F(TransportBarTest, ButtonsAskForWhatTheySay) {
  bar.setView(test::viewOf(log, 50), {});
  QTest::mouseClick(child<QAbstractButton>("play"), Qt::LeftButton);
  QTest::mouseClick(child<QAbstractButton>("stepBack"), Qt::LeftButton);
  QTest::mouseClick(child<QAbstractButton>("stepForward"), Qt::LeftButton);
  QTest::mouseClick(child<QAbstractButton>("toEnd"), Qt::LeftButton);
  EXPECT_EQ(play.count(), 1);
  ASSERT_EQ(step.count(), 2);
  EXPECT_EQ(step[0][0].toInt(), -1);
  EXPECT_EQ(step[1][0].toInt(), 1);
  EXPECT_EQ(end.count(), 1);
}

TEST_F(TransportBarTest, SeeksToTheInstantThatIsPointedAt) {
  const LogView view = test::viewOf(log, 50);
  bar.setView(view, {});
  const TimelineGeometry g = timeline()->geometryNow();
  QTest::mouseClick(timeline(), Qt::LeftButton, {}, {static_cast<int>(g.right()) + 1, 20});
  EXPECT_EQ(seek.last()[0].value<Instant>(), view.end);
  QTest::mouseClick(timeline(), Qt::LeftButton, {}, {2, 20});
  EXPECT_EQ(seek.last()[0].value<Instant>(), view.begin);
  const int x = 400;
  QTest::mouseClick(timeline(), Qt::LeftButton, {}, {x, 20});
  EXPECT_EQ(seek.last()[0].value<Instant>(), g.timeAt(x));
  QTest::keyClick(timeline(), Qt::Key_Right);
  EXPECT_EQ(seek.last()[0].value<Instant>(), view.cursor.time + 1s);
}

TEST_F(TransportBarTest, ShowsTheStateItIsGiven) {
  auto* playButton = child<TransportButton>("play");
  auto* toEnd = child<TransportButton>("toEnd");
  auto* choice = child<QComboBox>("speed");
  bar.setView(test::viewOf(log, 50), {.isPlaying = true, .speed = 4});
  EXPECT_EQ(playButton->sign(), TransportButton::Sign::Pause);
  EXPECT_EQ(playButton->accessibleName(), QStringLiteral("Pause"));
  EXPECT_FALSE(toEnd->isOn());
  EXPECT_EQ(choice->currentText().toStdString(), "4×");
  EXPECT_EQ(speed.count(), 0) << "being told is not asking";
  bar.setView(test::viewOf(log), {.isPlaying = false, .speed = 0.25});
  EXPECT_EQ(playButton->accessibleName(), QStringLiteral("Play"));
  EXPECT_TRUE(toEnd->isOn());
  EXPECT_EQ(toEnd->text(), QStringLiteral("At the end"));
  EXPECT_EQ(choice->currentText().toStdString(), "0.25×");
  EXPECT_FALSE(child<QAbstractButton>("stepForward")->isEnabled());
}

TEST_F(TransportBarTest, AsksForTheSpeedThatIsChosen) {
  bar.setView(test::viewOf(log, 50), {});
  auto* choice = child<QComboBox>("speed");
  choice->setFocus();
  QTest::keyClick(choice, Qt::Key_Down);
  ASSERT_EQ(speed.count(), 1);
  EXPECT_EQ(speed[0][0].toDouble(), 2.0);
}

TEST_F(TransportBarTest, ChangesOfStateMoveNothing) {
  bar.setView(test::viewOf(log), {.isPlaying = true});
  const QRect strip = timeline()->geometry();
  bar.setView(test::viewOf(log, 1), {.isPlaying = false, .speed = 16});
  QCoreApplication::sendPostedEvents();
  EXPECT_EQ(timeline()->geometry(), strip);
  bar.setView({}, {});
  QCoreApplication::sendPostedEvents();
  EXPECT_EQ(timeline()->geometry(), strip);
}

TEST_F(TransportBarTest, ControlsAreLargeEnoughAndHaveNames) {
  for (QWidget* widget : bar.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    EXPECT_GE(widget->height(), 32) << widget->objectName().toStdString();
    EXPECT_GE(widget->width(), 32) << widget->objectName().toStdString();
    EXPECT_FALSE(widget->objectName().isEmpty());
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->objectName().toStdString();
  }
}

TEST_F(TransportBarTest, FillsTheTimelineFromTheLog) {
  log->notes.append({.frame = 30, .time = log->frames.timeAt(30), .value = note::Mark{"water on"}});
  log->notes.append({.frame = 60, .time = log->frames.timeAt(60), .value = note::Dropped{{}, 12}});
  bar.setView(test::viewOf(log, 50), {});
  const TimelineValues& values = timeline()->values();
  EXPECT_FALSE(values.isEmpty);
  EXPECT_EQ(values.end, log->frames.lastTime());
  std::vector<TimelineMark> marks = values.marks;
  EXPECT_TRUE(std::ranges::is_sorted(marks, {}, &TimelineMark::time));
  EXPECT_EQ(std::erase_if(marks,
                          [](const TimelineMark& mark) {
                            return mark.kind == TimelineMark::Kind::Event && mark.group != EventGroup::Note;
                          }),
            log->events.count() - 1)
      << "a mark for each event, and a line for the jump";
  ASSERT_EQ(marks.size(), 3u);
  EXPECT_EQ(marks[0].text, QStringLiteral("water on"));
  EXPECT_EQ(marks[1].weight, Severity::Warning);
  EXPECT_EQ(marks[1].text, QStringLiteral("can0: 12 frames lost"));
  EXPECT_EQ(marks[2].kind, TimelineMark::Kind::TimeJump);
}

TEST(LogMarks, CountsFramesInEqualPartsOfTheSpan) {
  std::vector<Frame> frames;
  for (const std::int64_t ms : {0, 1, 2, 3, 500, 990, 1000})
    frames.push_back(test::frame("123", "", 0, ms * 1'000'000 + 1));
  const LogView view = test::viewOf(test::logOf(frames));
  LogMarks marks;
  marks.take(view, {view.begin, view.end}, 4);
  ASSERT_EQ(marks.density().size(), 4u);
  EXPECT_EQ(marks.density()[0], 1.0f);
  EXPECT_EQ(marks.density()[1], 0.0f);
  EXPECT_EQ(marks.density()[2], 0.5f);
  EXPECT_FLOAT_EQ(marks.density()[3], std::sqrt(0.5f));
}

TEST(LogMarks, CountsOnlyTheSpanInSight) {
  std::vector<Frame> frames;
  for (const std::int64_t ms : {0, 100, 200, 210, 900, 1000})
    frames.push_back(test::frame("123", "", 0, ms * 1'000'000));
  const LogView view = test::viewOf(test::logOf(frames));
  LogMarks marks;
  marks.take(view, {{50'000'000}, {250'000'000}}, 2);
  EXPECT_FLOAT_EQ(marks.density()[0], std::sqrt(0.5f));
  EXPECT_EQ(marks.density()[1], 1.0f);
}

TEST(LogMarks, FindsTheJumpsOfALongLogAtOnce) {
  std::vector<Frame> frames(1'000'000, test::frame("123", "", 0, 5'000'000'000));
  frames.back().stamp = 1'000'000'000;
  const LogView view = test::viewOf(test::logOf(frames));
  LogMarks marks;
  marks.take(view, {view.begin, view.end}, 100);
  EXPECT_EQ(marks.marks().size(), 1u);
  marks.take(LogView{}, {}, 100);
  EXPECT_TRUE(marks.marks().empty());
}

TEST(LogMarks, FindsSilenceAndLostLinks) {
  std::vector<Frame> frames;
  for (const std::int64_t s : {0, 1, 2, 3, 40, 41, 42, 100})
    frames.push_back(test::frame("123", "", 0, s * 1'000'000'000));
  const auto log = test::logOf(frames);
  log->notes.append({.frame = 4, .time = {5'000'000'000}, .value = note::LinkDown{}});
  log->notes.append({.frame = 4, .time = {39'000'000'000}, .value = note::LinkUp{}});
  const LogView view = test::viewOf(log);
  LogMarks marks;
  marks.take(view, {view.begin, view.end}, 100);
  ASSERT_EQ(marks.gaps().size(), 3u);
  EXPECT_EQ(marks.gaps()[0], (TimelineGap{TimelineGap::Kind::LinkLost, {{5'000'000'000}, {39'000'000'000}}}));
  EXPECT_EQ(marks.gaps()[1], (TimelineGap{TimelineGap::Kind::Silence, {{3'000'000'000}, {40'000'000'000}}}));
  EXPECT_EQ(marks.gaps()[2],
            (TimelineGap{TimelineGap::Kind::Silence, {{42'000'000'000}, {100'000'000'000}}}));
}

TEST_F(TransportBarTest, StepsByRowsOfTheFilterAndWithShiftByFrames) {
  const QSignalSpy steps(&bar, &TransportBar::stepRequested), rows(&bar, &TransportBar::rowStepRequested);
  bar.setView(test::viewOf(log, 50), {});
  QTest::keyClick(timeline(), Qt::Key_Period);
  EXPECT_EQ(steps.count(), 1);
  bar.setFiltered(true);
  QTest::keyClick(timeline(), Qt::Key_Comma);
  EXPECT_EQ(rows.count(), 1);
  EXPECT_EQ(rows.back().front().toInt(), -1);
  QTest::keyClick(timeline(), Qt::Key_Period, Qt::ShiftModifier);
  EXPECT_EQ(steps.count(), 2);
}

TEST_F(TransportBarTest, SaysWhatIsSelectedAndOffersItAsAFilter) {
  bar.setView(test::viewOf(log, 50), {});
  const Instant begin = timeline()->values().begin;
  timeline()->select(TimelineSpan{begin, begin + 10ms});
  EXPECT_TRUE(timeline()->values().selection.contains(QStringLiteral("frames")));
  const QSignalSpy only(&bar, &TransportBar::spanRequested);
  Q_EMIT timeline()->customContextMenuRequested({20, 20});
  auto* menu = child<QMenu>("timelineMenu");
  menu->actions()[1]->trigger();
  EXPECT_EQ(only.back().front().toString(), QStringLiteral("t>=0.000000 and t<0.010000"));
  const QSignalSpy saved(&bar, &TransportBar::saveRequested);
  menu->actions()[2]->trigger();
  ASSERT_EQ(saved.size(), 1);
  EXPECT_EQ(saved[0][0].toULongLong(), 0u);
  EXPECT_GT(saved[0][1].toULongLong(), 0u);
  menu->actions()[0]->trigger();
  EXPECT_TRUE(timeline()->isZoomed());
  delete menu;
}

TEST(TimeReadout, WritesTimesInFiguresThatDoNotJump) {
  EXPECT_EQ(elapsedText(Duration(0)).toStdString(), "0:00:00.000");
  EXPECT_EQ(elapsedText(3723456789000ns).toStdString(), "1:02:03.456");
  EXPECT_EQ(elapsedText(-5s).toStdString(), "0:00:00.000");
  setenv("TZ", "UTC", 1);
  tzset();
  EXPECT_EQ(stampTimeText(1'700'000'000'123'456'789).toStdString(), "2023-11-14 22:13:20.123");
  EXPECT_EQ(stampTimeText(12'345'600'000).toStdString(), "12.345 s") << "cut, as elapsedText() cuts";
}

TEST(TimeReadout, SaysWhatTheLogsOwnClockSaysAtTheCursor) {
  auto log =
      test::logOf({test::frame("123", "", 0, 2'000'000'000), test::frame("123", "", 0, 3'000'000'000)});
  EXPECT_FALSE(stampAt({}));
  EXPECT_FALSE(stampAt(test::viewOf(log, 0)));
  EXPECT_EQ(stampAt(test::viewOf(log, 1)), 2'000'000'000);
  LogView between = test::viewOf(log, 1);
  between.cursor.time = between.cursor.time + 250ms;
  EXPECT_EQ(stampAt(between), 2'250'000'000);
}

}  // namespace
}  // namespace deckpipe
