// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/play/transport_bar.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include "paint/timeline.h"
#include "panel/play/time_field.h"
#include "panel/play/transport_button.h"
#include "support/child.h"
#include "support/frames.h"
#include "support/logs.h"
#include "support/look.h"
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
  bar.setView(test::viewOf(log, 50), {.isPlaying = true, .speed = 5});
  EXPECT_EQ(playButton->sign(), TransportButton::Sign::Pause);
  EXPECT_EQ(playButton->accessibleName(), QStringLiteral("Pause"));
  EXPECT_FALSE(toEnd->isOn());
  EXPECT_EQ(choice->currentText().toStdString(), "5×");
  EXPECT_EQ(speed.count(), 0) << "being told is not asking";
  bar.setView(test::viewOf(log), {.isPlaying = false, .speed = 0.25});
  EXPECT_EQ(playButton->accessibleName(), QStringLiteral("Play"));
  EXPECT_TRUE(toEnd->isOn());
  EXPECT_EQ(toEnd->text(), QStringLiteral("End"));
  EXPECT_EQ(choice->currentText().toStdString(), "0.25×");
  EXPECT_FALSE(child<QAbstractButton>("stepForward")->isEnabled());
}

TEST_F(TransportBarTest, CallsTheLiveEdgeLiveAndTheEndOfALogEnd) {
  auto* toEnd = child<TransportButton>("toEnd");
  QStringList names;
  for (const bool isLive : {false, true}) {
    for (const auto cursor : {std::optional<std::uint64_t>(), std::optional<std::uint64_t>(50)}) {
      bar.setView(test::viewOf(log, cursor), {.isLive = isLive});
      EXPECT_EQ(toEnd->text(), isLive ? QStringLiteral("Live") : QStringLiteral("End"));
      EXPECT_EQ(toEnd->isOn(), !cursor);
      EXPECT_EQ(toEnd->sign() == TransportButton::Sign::Live, isLive && !cursor);
      names += toEnd->accessibleName();
    }
  }
  EXPECT_EQ(names.removeDuplicates(), 0) << "each says what holds and what it does";
}

TEST_F(TransportBarTest, OffersSpeedsFromATenthToAsFastAsItGoes) {
  auto* choice = child<QComboBox>("speed");
  QStringList texts;
  for (int i = 0; i < choice->count(); ++i) texts += choice->itemText(i);
  EXPECT_EQ(texts.join(u' ').toStdString(), "0.1× 0.25× 0.5× 1× 2× 5× 10× 100× Max");
  EXPECT_EQ(choice->itemData(8, Qt::AccessibleTextRole).toString(), QStringLiteral("As fast as it goes"));
  bar.setView(test::viewOf(log, 50), {.speed = 100});
  QTest::keyClick(timeline(), Qt::Key_Up);
  ASSERT_EQ(speed.count(), 1);
  EXPECT_TRUE(std::isinf(speed[0][0].toDouble()));
  bar.setView(test::viewOf(log, 50), {.speed = speed[0][0].toDouble()});
  EXPECT_EQ(choice->currentText(), QStringLiteral("Max"));
  QTest::keyClick(timeline(), Qt::Key_Up);
  EXPECT_EQ(speed.count(), 1) << "there is no faster one";
  QTest::keyClick(timeline(), Qt::Key_Down);
  EXPECT_EQ(speed.last()[0].toDouble(), 100);
}

struct TypedInTheBar : TransportBarTest {
  QSignalSpy frames{&bar, &TransportBar::framesRequested};
  QLineEdit* field() const { return child<QLineEdit>("timeField"); }
  QLabel* sentence() const { return test::child<QLabel>(*bar.window(), "timeFieldSentence"); }
  void type(const char* text) const {
    QTest::keyClicks(field(), QString::fromUtf8(text));
    QTest::keyClick(field(), Qt::Key_Return);
  }
};

TEST_F(TypedInTheBar, TimesMoveTheCursor) {
  const LogView view = test::viewOf(log, 50);
  bar.setView(view, {});
  const QRect strip = timeline()->geometry();
  QTest::mouseClick(child<QAbstractButton>("timeReadout"), Qt::LeftButton);
  ASSERT_TRUE(field()->isVisible());
  EXPECT_EQ(field()->geometry(), child<QWidget>("timeReadout")->geometry());
  EXPECT_TRUE(field()->hasSelectedText()) << "typing replaces it";
  EXPECT_TRUE(sentence()->text().startsWith(QStringLiteral("Write 1:23.5")));
  type("0:02.5");
  ASSERT_EQ(seek.count(), 1);
  EXPECT_EQ(seek[0][0].value<Instant>(), view.begin + 2500ms);
  EXPECT_FALSE(field()->isVisible());
  EXPECT_FALSE(sentence()->isVisible());
  EXPECT_EQ(timeline()->geometry(), strip);
  bar.typeTime();
  type("+1");
  EXPECT_EQ(seek.last()[0].value<Instant>(), view.cursor.time + 1s);
}

TEST_F(TypedInTheBar, WrongWordsAreToldAndStay) {
  bar.setView(test::viewOf(log, 50), {});
  bar.typeTime();
  type("soon");
  EXPECT_EQ(seek.count(), 0);
  EXPECT_TRUE(field()->isVisible());
  EXPECT_EQ(field()->text(), QStringLiteral("soon"));
  EXPECT_TRUE(sentence()->text().contains(QStringLiteral("“soon” is no time")))
      << sentence()->text().toStdString();
  EXPECT_EQ(field()->accessibleDescription(), sentence()->text());
  const QString wrong = sentence()->text();
  QTest::keyClick(field(), Qt::Key_Backspace);
  EXPECT_NE(sentence()->text(), wrong) << "who goes on typing is helped again";
  QTest::keyClick(field(), Qt::Key_Escape);
  EXPECT_FALSE(field()->isVisible());
  EXPECT_FALSE(sentence()->isVisible());
  EXPECT_EQ(seek.count(), 0);
}

TEST_F(TypedInTheBar, SentencesStandAboveTheBarAndCoverNoButton) {
  QWidget window;
  auto* inside = new TransportBar(&window);
  window.resize(1024, 600);
  for (const Density density : {Density::Desk, Density::Field}) {
    const test::Look look(Theme::Light, density);
    inside->setGeometry(0, 600 - inside->sizeHint().height(), 1024, inside->sizeHint().height());
    window.show();
    inside->setView(test::viewOf(log, 50), {});
    inside->typeTime();
    auto* words = test::child<QLabel>(window, "timeFieldSentence");
    EXPECT_TRUE(words->isVisible());
    EXPECT_EQ(words->window(), &window);
    EXPECT_LE(words->geometry().bottom(), inside->y());
    EXPECT_TRUE(window.rect().contains(words->geometry()));
    inside->hide();
    EXPECT_FALSE(words->isVisible());
    inside->show();
  }
}

TEST_F(TypedInTheBar, KeysOfTheBarAreText) {
  bar.setView(test::viewOf(log, 50), {});
  bar.typeTime();
  QTest::keyClicks(field(), QStringLiteral("1 s,."));
  EXPECT_EQ(field()->text(), QStringLiteral("1 s,."));
  EXPECT_EQ(play.count() + step.count(), 0);
}

TEST_F(TypedInTheBar, FramesMoveTheCursorOfALogWithoutTimes) {
  const auto timeless = test::logOfText("can0 123 [1] 11\ncan0 123 [1] 12\ncan0 123 [1] 13\n");
  bar.setView(test::viewOf(timeless, 1), {});
  EXPECT_FALSE(child<QComboBox>("speed")->isEnabled());
  bar.typeTime();
  type("2");
  ASSERT_EQ(frames.count(), 1);
  EXPECT_EQ(frames[0][0].value<std::uint64_t>(), 2u);
  EXPECT_EQ(timeline()->values().unit, TimelineUnit::Frames);
  QTest::keyClick(timeline(), Qt::Key_Right);
  EXPECT_EQ(frames.last()[0].value<std::uint64_t>(), 2u) << "a frame on";
  QTest::keyClick(timeline(), Qt::Key_Home);
  EXPECT_EQ(frames.last()[0].value<std::uint64_t>(), 0u);
  EXPECT_EQ(seek.count(), 0);
  EXPECT_EQ(child<TimeReadout>("timeReadout")->elapsed(), QStringLiteral("1"));
}

TEST_F(TransportBarTest, LoopsWhatIsSelected) {
  QSignalSpy loop(&bar, &TransportBar::loopRequested);
  const auto span = [&] { return loop.last()[0].value<std::optional<TimelineSpan>>(); };
  auto* button = child<QAbstractButton>("loop");
  bar.setView(test::viewOf(log, 50), {});
  EXPECT_FALSE(button->isEnabled());
  bar.toggleLoop();
  EXPECT_EQ(loop.count(), 0);
  const Instant begin = timeline()->values().begin;
  timeline()->select(TimelineSpan{begin, begin + 2s});
  ASSERT_TRUE(button->isEnabled());
  QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_EQ(loop.count(), 1);
  EXPECT_EQ(span(), (TimelineSpan{begin, begin + 2s}));
  EXPECT_FALSE(button->isChecked()) << "until it is so";
  bar.setView(test::viewOf(log, 50), {.isLooping = true});
  EXPECT_TRUE(button->isChecked());
  timeline()->select(TimelineSpan{begin, begin + 3s});
  EXPECT_EQ(span(), (TimelineSpan{begin, begin + 3s})) << "the loop goes with the selection";
  timeline()->select({});
  EXPECT_EQ(span(), std::nullopt);
}

TEST_F(TransportBarTest, SkipsSilencesAndSaysSo) {
  QSignalSpy silences(&bar, &TransportBar::silencesRequested);
  auto* button = child<QAbstractButton>("silences");
  bar.setView(test::viewOf(log, 50), {});
  QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_EQ(silences.count(), 1);
  EXPECT_TRUE(silences[0][0].toBool());
  const QImage before = timeline()->grab().toImage();
  bar.setView(test::viewOf(log, 50), {.isPlaying = true, .skipsSilences = true, .skipped = 83s});
  EXPECT_TRUE(button->isChecked());
  EXPECT_EQ(timeline()->values().atCursor.toStdString(), "83 s without frames skipped");
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return timeline()->accessibleDescription().contains(timeline()->values().atCursor); }));
  EXPECT_NE(timeline()->grab().toImage(), before);
}

// Play, speed, time and the end stay at any width, with a timeline between them.
TEST_F(TransportBarTest, GivesUpTheRarerButtonsWhereItIsNarrow) {
  for (const Density density : {Density::Desk, Density::Field}) {
    const test::Look look(Theme::Light, density);
    for (const int width : {1366, 1024, 800, 640}) {
      bar.resize(width, bar.sizeHint().height());
      QCoreApplication::sendPostedEvents();
      for (const char* name : {"play", "timeReadout", "timeline", "speed", "toEnd"}) {
        auto* widget = child<QWidget>(name);
        EXPECT_TRUE(widget->isVisible() && bar.rect().contains(widget->geometry()))
            << name << " at " << width;
      }
      EXPECT_TRUE(child<QWidget>("loop")->isVisible() || width < 1024) << width;
    }
  }
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
  bar.setView(test::viewOf(log, 1), {.isPlaying = false, .speed = 100});
  QCoreApplication::sendPostedEvents();
  EXPECT_EQ(timeline()->geometry(), strip);
  bar.setView({}, {});
  QCoreApplication::sendPostedEvents();
  EXPECT_EQ(timeline()->geometry(), strip);
}

TEST_F(TransportBarTest, ControlsAreLargeEnoughAndHaveNames) {
  bar.setView(test::viewOf(log, 50), {});
  bar.typeTime();
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

TEST(LogMarks, FindsNoSilenceInALogSavedThroughAFilterAndNoEventInAddedFrames) {
  std::vector<Frame> frames;
  for (const std::int64_t s : {0, 1, 40, 100}) frames.push_back(test::frame("123", "", 0, s * 1'000'000'000));
  const auto log = test::logOf(frames);
  log->notes.append({.frame = 0, .time = {}, .value = note::Filtered{"id=123"}});
  log->notes.append({.frame = 2, .time = {40'000'000'000}, .value = note::Added{1}});
  const LogView view = test::viewOf(log);
  LogMarks marks;
  marks.take(view, {view.begin, view.end}, 100);
  EXPECT_TRUE(marks.gaps().empty());
  EXPECT_EQ(marks.marks().size(), 1u);
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
