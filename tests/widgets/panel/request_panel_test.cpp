// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/poll/request_panel.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QWheelEvent>

#include "model/answer_history.h"
#include "panel/poll/request_card.h"
#include "support/child.h"
#include "widgets/panel/sending_panel_test.h"

namespace deckpipe {
namespace {

using test::frame;

const DeviceKey kMonitor = test::kTarget;
constexpr std::int64_t kSecond = 1'000'000'000;

struct RequestsOfDevice : test::SendingPanelTest<RequestPanel> {
  RequestsOfDevice() {
    services.devices[0].takes = kPolls;
    services.devices[0].takes.add(Request::Reset);
    panel.resize(380, 700);
    show();
  }
  RequestStatus& request(Request request) { return services.devices[0].requests[request]; }
  RequestCard* card(Request request) {
    return test::child<RequestCard>(panel, QStringLiteral("askCard%1").arg(static_cast<int>(request)));
  }
  QPushButton* button(Request request) { return test::child<QPushButton>(*card(request), "askButton"); }
  using SendingPanelTest::button;
  QString hint() { return child<QLabel>("requestHint")->text(); }
};

TEST_F(RequestsOfDevice, AButtonAsksTheChosenDeviceAndNothingElse) {
  QTest::mouseClick(button(Request::Firmware), Qt::LeftButton);
  ASSERT_EQ(intents.size(), 1u);
  const auto& intent = std::get<intent::SendRequests>(intents[0]);
  EXPECT_EQ(intent.device, kMonitor);
  EXPECT_EQ(intent.requests, RequestSet{Request::Firmware});
}

TEST_F(RequestsOfDevice, OffersOnlyWhatTheTypeTakes) {
  EXPECT_TRUE(card(Request::Vista)->isVisible());
  EXPECT_TRUE(card(Request::Reset)->isVisible());
  EXPECT_FALSE(card(Request::ZeroAxes)->isVisible());
}

TEST_F(RequestsOfDevice, LockedItOffersNothingAndSaysWhy) {
  services.locked = true;
  show();
  EXPECT_FALSE(button(Request::Fault)->isEnabled());
  EXPECT_FALSE(button("askAll")->isEnabled());
  EXPECT_FALSE(hint().isEmpty());
  QSignalSpy unlock(&panel, &RequestPanel::unlockRequested);
  QTest::mouseClick(button("requestUnlock"), Qt::LeftButton);
  EXPECT_EQ(unlock.count(), 1);
}

TEST_F(RequestsOfDevice, OffTheLiveEdgeItOffersNothing) {
  isLive = false;
  show();
  EXPECT_FALSE(button(Request::Fault)->isEnabled());
  EXPECT_FALSE(button("requestUnlock")->isVisible());
}

TEST_F(RequestsOfDevice, OffTheLiveEdgeWhatGoesOnCanBeEndedButNothingBegun) {
  request(Request::Fault) = {.progress = RequestStatus::Progress::Queued, .period = 5s};
  isLive = false;
  show();
  auto* period = child<QComboBox>("askRepeat");
  EXPECT_EQ(period->currentIndex(), 3);
  period->setFocus();
  QTest::keyClick(period, Qt::Key_Down);
  EXPECT_TRUE(intents.empty()) << "another period would begin something";
  QTest::keyClick(period, Qt::Key_Home);
  ASSERT_EQ(intents.size(), 1u);
  EXPECT_EQ(std::get<intent::Repeat>(intents[0]).period, 0s);
  QTest::mouseClick(button("askCancel"), Qt::LeftButton);
  ASSERT_EQ(intents.size(), 2u);
  EXPECT_EQ(std::get<intent::Cancel>(intents[1]).device, kMonitor);
}

TEST_F(RequestsOfDevice, ACommandIsAskedOnceByTheDevicesName) {
  QTest::mouseClick(button(Request::Reset), Qt::LeftButton);
  EXPECT_TRUE(intents.empty());
  ASSERT_NE(dialog(), nullptr);
  EXPECT_TRUE(test::child<QLabel>(*dialog(), "dangerTitle")->text().contains(QStringLiteral("Roof")));
  QTest::mouseClick(test::child<QPushButton>(*dialog(), "dangerVerb"), Qt::LeftButton);
  ASSERT_EQ(intents.size(), 1u);
  EXPECT_EQ(std::get<intent::SendRequests>(intents[0]).requests, RequestSet{Request::Reset});
}

TEST_F(RequestsOfDevice, EnterAndEscapeInTheQuestionLeaveThingsAsTheyAre) {
  for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Escape}) {
    QTest::mouseClick(button(Request::Reset), Qt::LeftButton);
    ASSERT_NE(dialog(), nullptr);
    QTest::keyClick(dialog(), key);
    EXPECT_TRUE(intents.empty()) << key;
    EXPECT_TRUE(QTest::qWaitFor([] { return dialog() == nullptr; }));
  }
}

TEST_F(RequestsOfDevice, ShowsTheAnswerInWordsAndHowItWent) {
  add({frame("18EF80F9", "02", 0, 2 * kSecond), frame("18EFF980", "0200200000000B", 0, 2 * kSecond)});
  request(Request::Fault) = {.progress = RequestStatus::Progress::Ended,
                             .end = RequestEnd::Answered,
                             .tries = 1,
                             .sent = view.cursor.time,
                             .ended = view.cursor.time,
                             .latency = 3ms};
  show();
  EXPECT_TRUE(card(Request::Fault)->values().answer.contains(QStringLiteral("nternal fuse")))
      << card(Request::Fault)->values().answer.toStdString();
  EXPECT_TRUE(card(Request::Fault)->values().state.contains(QStringLiteral("3 ms")));
  EXPECT_TRUE(card(Request::Fault)->values().isFault);
  EXPECT_EQ(card(Request::Fault)->values().tone, Severity::Plain) << "no tick beside a fault";
}

TEST_F(RequestsOfDevice, OnlyAnAnswerWithoutFaultsHasATick) {
  add({frame("18EF80F9", "02", 0, 2 * kSecond), frame("18EFF980", "02000000000000", 0, 2 * kSecond)});
  request(Request::Fault) = {.progress = RequestStatus::Progress::Ended,
                             .end = RequestEnd::Answered,
                             .tries = 1,
                             .sent = view.cursor.time,
                             .ended = view.cursor.time,
                             .latency = 3ms};
  show();
  EXPECT_FALSE(card(Request::Fault)->values().isFault);
  EXPECT_EQ(card(Request::Fault)->values().tone, Severity::Fine);
}

TEST_F(RequestsOfDevice, AnAnswerBeforeARestartIsDrawnAsOld) {
  add({frame("18EF80F9", "02", 0, 2 * kSecond), frame("18EFF980", "02000000000000", 0, 2 * kSecond),
       frame("18EFFF80", "FF83150206021A0B", 0, 95 * kSecond)});
  request(Request::Fault) = {.progress = RequestStatus::Progress::Ended,
                             .end = RequestEnd::Answered,
                             .tries = 1,
                             .sent = view.cursor.time - 93s,
                             .ended = view.cursor.time - 93s,
                             .latency = 3ms};
  show();
  EXPECT_TRUE(card(Request::Fault)->values().isOld);
  EXPECT_NE(card(Request::Fault)->values().tone, Severity::Fine);
  EXPECT_TRUE(
      card(Request::Fault)->values().state.endsWith(QStringLiteral("heard 93 s ago, restarted since")))
      << card(Request::Fault)->values().state.toStdString();
}

TEST_F(RequestsOfDevice, ALogTellsNeverAskedFromNoAnswer) {
  add({frame("18EF80F9", "02", 0, 2 * kSecond), frame("18EFFF80", "011D940371000041", 0, 5 * kSecond)});
  show();
  EXPECT_EQ(card(Request::Fault)->values().state, QStringLiteral("no answer, asked 3.0 s ago"));
  EXPECT_EQ(card(Request::Fault)->values().tone, Severity::Warning);
  EXPECT_EQ(card(Request::Firmware)->values().state, QStringLiteral("never asked"));
}

TEST_F(RequestsOfDevice, ALogTellsRefusedFromNeverAsked) {
  add({frame("18EF80F9", "02", 0, 2 * kSecond), frame("18EFF980", "0200", 0, 2 * kSecond)});
  show();
  EXPECT_EQ(card(Request::Fault)->values().state, QStringLiteral("refused, or answered in a wrong length"));
  EXPECT_EQ(card(Request::Fault)->values().tone, Severity::Warning);
}

TEST_F(RequestsOfDevice, ALogTellsThatAnAnswerWasFollowedByARefusal) {
  add({frame("18EF80F9", "02", 0, 2 * kSecond), frame("18EFF980", "02000000000000", 0, 2 * kSecond),
       frame("18EF80F9", "02", 0, 3 * kSecond), frame("18EFF980", "0200", 0, 3 * kSecond)});
  show();
  EXPECT_TRUE(card(Request::Fault)->values().state.startsWith(QStringLiteral("asked again: refused")))
      << card(Request::Fault)->values().state.toStdString();
  EXPECT_EQ(card(Request::Fault)->values().tone, Severity::Warning);
}

TEST_F(RequestsOfDevice, AResetThatWasSeenIsARestart) {
  request(Request::Reset) = {.progress = RequestStatus::Progress::Ended,
                             .end = RequestEnd::Answered,
                             .tries = 1,
                             .sent = view.cursor.time,
                             .ended = view.cursor.time,
                             .latency = 3200ms};
  show();
  EXPECT_TRUE(card(Request::Reset)->values().state.startsWith(QStringLiteral("restarted")))
      << card(Request::Reset)->values().state.toStdString();
}

TEST_F(RequestsOfDevice, NoAnswerIsSaidAsClearly) {
  request(Request::Fault) = {.progress = RequestStatus::Progress::Ended,
                             .end = RequestEnd::NoAnswer,
                             .tries = 3,
                             .sent = view.cursor.time,
                             .ended = view.cursor.time};
  show();
  EXPECT_EQ(card(Request::Fault)->values().tone, Severity::Warning);
  EXPECT_TRUE(card(Request::Fault)->values().state.contains(QStringLiteral("no answer")));
}

TEST_F(RequestsOfDevice, AnAnswerToALaterTryIsSaidToBeOne) {
  request(Request::Fault) = {.progress = RequestStatus::Progress::Ended,
                             .end = RequestEnd::Answered,
                             .tries = 2,
                             .firstSent = view.cursor.time - 800ms,
                             .sent = view.cursor.time - 300ms,
                             .ended = view.cursor.time,
                             .latency = 300ms};
  show();
  EXPECT_TRUE(
      card(Request::Fault)->values().state.contains(QStringLiteral("at try 2, 800 ms after the first")))
      << card(Request::Fault)->values().state.toStdString();
}

TEST_F(RequestsOfDevice, AnOlderAnswerKeepsItsAgeBesideAQuestionWithoutOne) {
  add({frame("18EF80F9", "02", 0, 2 * kSecond), frame("18EFF980", "0200200000000B", 0, 2 * kSecond)});
  request(Request::Fault) = {.progress = RequestStatus::Progress::Ended,
                             .end = RequestEnd::NoAnswer,
                             .tries = 3,
                             .sent = view.cursor.time,
                             .ended = view.cursor.time};
  show();
  EXPECT_TRUE(card(Request::Fault)->values().state.contains(QStringLiteral("no answer")));
  EXPECT_TRUE(card(Request::Fault)->values().state.contains(QStringLiteral("heard")));
}

// How it ended is of now.
TEST_F(RequestsOfDevice, ThePastKnowsNothingOfHowALaterRequestEnded) {
  request(Request::Fault) = {
      .progress = RequestStatus::Progress::Ended, .end = RequestEnd::NoAnswer, .tries = 3};
  view.atEnd = false;
  isLive = false;
  show();
  EXPECT_EQ(card(Request::Fault)->values().state, QStringLiteral("never asked"));
}

TEST_F(RequestsOfDevice, EveryDeviceIsAskedAsOftenAsChosen) {
  button("askEveryone")->click();
  auto* period = child<QComboBox>("askRepeat");
  period->setFocus();
  QTest::keyClick(period, Qt::Key_Down);
  button("askEveryone")->click();
  ASSERT_EQ(intents.size(), 3u);
  EXPECT_TRUE(std::get<intent::SendRequests>(intents[0]).device.isNull());
  EXPECT_TRUE(std::get<intent::Repeat>(intents[2]).device.isNull());
  EXPECT_EQ(std::get<intent::Repeat>(intents[2]).period, 500ms);
}

TEST_F(RequestsOfDevice, WhileOneWaitsItIsNotOfferedAgain) {
  request(Request::Fault) = {
      .progress = RequestStatus::Progress::Waiting, .tries = 2, .sent = view.cursor.time};
  show();
  EXPECT_FALSE(button(Request::Fault)->isEnabled());
  EXPECT_TRUE(button(Request::Firmware)->isEnabled());
  EXPECT_TRUE(button("askCancel")->isEnabled());
}

TEST_F(RequestsOfDevice, RepeatsAtTheChosenPeriodUntilOnce) {
  auto* period = child<QComboBox>("askRepeat");
  period->setFocus();
  QTest::keyClick(period, Qt::Key_Down);
  ASSERT_EQ(intents.size(), 1u);
  EXPECT_EQ(std::get<intent::Repeat>(intents[0]).period, 500ms);
  EXPECT_EQ(std::get<intent::Repeat>(intents[0]).requests, kPolls);
}

TEST_F(RequestsOfDevice, TheWheelBeginsNoRepeatedPoll) {
  auto* period = child<QComboBox>("askRepeat");
  period->setFocus();
  const QPointF middle = QRectF(period->rect()).center();
  QWheelEvent wheel(middle, period->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(period, &wheel);
  EXPECT_EQ(period->currentIndex(), 0);
  EXPECT_TRUE(intents.empty());
  EXPECT_FALSE(wheel.isAccepted()) << "it scrolls the panel";
}

TEST_F(RequestsOfDevice, EveryRepeatedPollIsSeenWhateverDeviceIsChosenAndEndedAtOnce) {
  EXPECT_FALSE(test::child<QWidget>(panel, "repeatBar")->isVisible());
  for (int i = 0; i < 6; ++i) {
    DeviceServices& other = services.devices.emplace_back();
    other.device = DeviceKey::of(*Pin::make(1032, 'A', 'E', 200u + static_cast<unsigned>(i)));
    other.requests[Request::Fault] = {.progress = RequestStatus::Progress::Queued, .period = 5s};
  }
  labels.set(services.devices[1].device.pin, QStringLiteral("Front"));
  show();
  auto* text = test::child<QLabel>(panel, "repeatText");
  EXPECT_TRUE(text->isVisible());
  EXPECT_TRUE(text->text().contains(QStringLiteral("Front: every 5.0 s\n1032AE000000201: every")))
      << text->text().toStdString();
  EXPECT_TRUE(text->text().endsWith(QStringLiteral("and 3 more"))) << text->text().toStdString();
  isLive = false;
  show();
  QTest::mouseClick(button("repeatEnd"), Qt::LeftButton);
  ASSERT_EQ(intents.size(), 1u);
  const auto& intent = std::get<intent::Repeat>(intents[0]);
  EXPECT_TRUE(intent.device.isNull());
  EXPECT_EQ(intent.period, 0s);
}

TEST_F(RequestsOfDevice, ListsEarlierAnswersAndWhatChanged) {
  QAbstractItemModel* history = test::child<AnswerHistory>(panel);
  QAbstractItemModelTester tester(history, QAbstractItemModelTester::FailureReportingMode::Fatal);
  add({frame("18EFF980", "02000000000000", 0, 2 * kSecond)});
  add({frame("18EFF980", "0200200000000B", 0, 3 * kSecond),
       frame("18EFF980", "0200200000000B", 0, 4 * kSecond)});
  ASSERT_EQ(history->rowCount(), 3);
  const auto changed = [&](int row) { return history->index(row, AnswerHistory::Changed).data().toString(); };
  EXPECT_EQ(changed(0), QStringLiteral("first answer"));
  EXPECT_TRUE(changed(1).contains(QStringLiteral("was"))) << changed(1).toStdString();
  EXPECT_EQ(changed(2), QStringLiteral("unchanged"));
  // An earlier cursor knows only what had been said by then.
  view.cursor = {2, document->frames.timeAt(1)};
  isLive = false;
  showView();
  EXPECT_EQ(history->rowCount(), 1);
}

TEST_F(RequestsOfDevice, WhatWasAnsweredOnceStaysAnsweredBelowManyOtherAnswers) {
  AnswerHistory* history = test::child<AnswerHistory>(panel);
  QAbstractItemModelTester tester(history, QAbstractItemModelTester::FailureReportingMode::Fatal);
  std::int64_t time = 2 * kSecond;
  const auto faults = [&](std::size_t count) {
    std::vector<Frame> frames;
    for (std::size_t i = 0; i < count; ++i) frames.push_back(frame("18EFF980", "02000000000000", 0, ++time));
    return frames;
  };
  const auto expectBoth = [&] {
    EXPECT_EQ(history->rowCount(), static_cast<int>(AnswerHistory::kMaxRows));
    EXPECT_EQ(history->rows().front().request, Request::Firmware);
    EXPECT_EQ(history->rows().back().frame, view.frameCount - 1);
    EXPECT_FALSE(card(Request::Firmware)->values().answer.isEmpty());
    EXPECT_TRUE(card(Request::Firmware)->values().state.contains(QStringLiteral("heard")))
        << card(Request::Firmware)->values().state.toStdString();
  };
  // All at once, as of a file; one by one, as of a link; more than there is room for, behind others.
  std::vector<Frame> frames = faults(3);
  frames.push_back(frame("18EFF980", "03010B02040206", 0, ++time));
  const std::vector<Frame> more = faults(AnswerHistory::kMaxRows + 100);
  frames.insert(frames.end(), more.begin(), more.end());
  add(frames);
  expectBoth();
  for (int i = 0; i < 3; ++i) add(faults(1));
  expectBoth();
  add(faults(AnswerHistory::kMaxRows + 7));
  expectBoth();
}

}  // namespace
}  // namespace deckpipe
