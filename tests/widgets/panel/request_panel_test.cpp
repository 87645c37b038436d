// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/poll/request_panel.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QWheelEvent>
#include <functional>
#include <map>

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
  void showTab(int tab) { child<QTabWidget>("requestTabs")->setCurrentIndex(tab); }
  QPushButton* inQuestion(const char* name) { return test::child<QPushButton>(*dialog(), name); }
  QStringList factsInQuestion() {
    QStringList facts;
    for (const QLabel* label : dialog()->findChildren<QLabel*>(QStringLiteral("dangerFact")))
      facts << label->text();
    return facts;
  }
  // Where every button of the panel is.
  std::map<std::string, QRect> places() {
    std::map<std::string, QRect> found;
    int n = 0;
    for (const auto* each : panel.findChildren<QAbstractButton*>()) {
      const bool comesAndGoes = each->objectName() == QLatin1String("requestUnlock") ||
                                each->objectName() == QLatin1String("repeatEnd");
      if (each->isVisible() && !comesAndGoes)
        found[std::to_string(n++) + each->objectName().toStdString()] =
            QRect(each->mapTo(&panel, QPoint()), each->size());
    }
    return found;
  }
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
  EXPECT_FALSE(card(Request::Reset)->isVisible()) << "it stands apart";
  showTab(1);
  EXPECT_TRUE(card(Request::Reset)->isVisible());
  EXPECT_FALSE(card(Request::ZeroAxes)->isVisible());
  EXPECT_FALSE(card(Request::Vista)->isVisible());
}

TEST_F(RequestsOfDevice, LockedItOffersNothingAndSaysWhy) {
  services.locked = true;
  show();
  EXPECT_FALSE(button(Request::Fault)->isEnabled());
  EXPECT_FALSE(button("askEveryone")->isEnabled());
  EXPECT_FALSE(hint().isEmpty());
  QSignalSpy unlock(&panel, &RequestPanel::unlockRequested);
  QTest::mouseClick(button("requestUnlock"), Qt::LeftButton);
  EXPECT_EQ(unlock.count(), 1);
}

TEST_F(RequestsOfDevice, LockedItAsksEverythingOnceAPersonHasUnlocked) {
  services.locked = true;
  show();
  std::function<void()> unlocked;
  QObject::connect(&panel, &RequestPanel::unlockForRequested,
                   [&](const std::function<void()>& then) { unlocked = then; });
  EXPECT_TRUE(button("askAll")->text().startsWith(QStringLiteral("Unlock")));
  QTest::mouseClick(button("askAll"), Qt::LeftButton);
  ASSERT_TRUE(unlocked);
  show();
  EXPECT_TRUE(intents.empty()) << "nobody has said yes";
  unlocked();
  services.locked = false;
  show();
  ASSERT_EQ(intents.size(), 1u);
  const auto& asked = std::get<intent::SendRequests>(intents[0]);
  EXPECT_EQ(asked.device, kMonitor);
  EXPECT_EQ(asked.requests, kPolls);
}

TEST_F(RequestsOfDevice, OffTheLiveEdgeItOffersNothing) {
  isLive = false;
  show();
  EXPECT_FALSE(button("askAll")->isEnabled());
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
  showTab(1);
  QTest::mouseClick(button(Request::Reset), Qt::LeftButton);
  EXPECT_TRUE(intents.empty());
  ASSERT_NE(dialog(), nullptr);
  EXPECT_TRUE(test::child<QLabel>(*dialog(), "dangerTitle")->text().contains(QStringLiteral("Roof")));
  QTest::mouseClick(test::child<QPushButton>(*dialog(), "dangerVerb"), Qt::LeftButton);
  ASSERT_EQ(intents.size(), 1u);
  EXPECT_EQ(std::get<intent::SendRequests>(intents[0]).requests, RequestSet{Request::Reset});
}

TEST_F(RequestsOfDevice, EnterAndEscapeInTheQuestionLeaveThingsAsTheyAre) {
  showTab(1);
  for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Escape}) {
    QTest::mouseClick(button(Request::Reset), Qt::LeftButton);
    ASSERT_NE(dialog(), nullptr);
    QTest::keyClick(dialog(), key);
    EXPECT_TRUE(intents.empty()) << key;
    EXPECT_TRUE(QTest::qWaitFor([] { return dialog() == nullptr; }));
  }
}

TEST_F(RequestsOfDevice, EnterInTheQuestionPressesTheButtonThatHasTheFocus) {
  showTab(1);
  QTest::mouseClick(button(Request::Reset), Qt::LeftButton);
  ASSERT_NE(dialog(), nullptr);
  inQuestion("dangerVerb")->setFocus(Qt::TabFocusReason);
  QTest::keyClick(inQuestion("dangerVerb"), Qt::Key_Return);
  EXPECT_EQ(intents.size(), 1u);
}

TEST_F(RequestsOfDevice, TheQuestionShowsWhereTheDeviceStandsAndFollowsIt) {
  services.devices[0].takes.add(Request::ZeroAxes);
  add({frame("18EFFF80", "011D940371000041", 0, kSecond)});
  showTab(1);
  QTest::mouseClick(button(Request::ZeroAxes), Qt::LeftButton);
  ASSERT_NE(dialog(), nullptr);
  EXPECT_EQ(factsInQuestion(), (QStringList{QStringLiteral("47.3° right"), QStringLiteral("5.5° down")}));
  EXPECT_EQ(test::child<QLabel>(*dialog(), "dangerWhom")->text(),
            QStringLiteral("6032 Universal II · address 80 hex"));
  const QSize size = dialog()->size();
  add({frame("18EFFF80", "01FFF4FFF4000041", 0, 2 * kSecond)});
  EXPECT_EQ(factsInQuestion(), (QStringList{QStringLiteral("Sensor error"), QStringLiteral("Sensor error")}));
  EXPECT_EQ(dialog()->size(), size);
  EXPECT_TRUE(inQuestion("dangerVerb")->isEnabled());
}

TEST_F(RequestsOfDevice, TheQuestionIsWithdrawnWithASentenceOnceItCannotBeDone) {
  const auto locked = [&] { services.locked = true; };
  const auto down = [&] { services.linkUp = false; };
  const auto past = [&] { isLive = false; };
  const auto moved = [&] { add({frame("18EFFF91", "FF83150206021A0B", 0, kSecond)}); };
  const auto silent = [&] { add({frame("18EFFF92", "830040", 0, 4 * kSecond)}); };
  showTab(1);
  for (const auto& [why, sentence] :
       std::initializer_list<std::pair<std::function<void()>, const char*>>{{locked, "locked"},
                                                                            {down, "link"},
                                                                            {past, "past"},
                                                                            {moved, "address 91 hex now"},
                                                                            {silent, "1 s"}}) {
    QTest::mouseClick(button(Request::Reset), Qt::LeftButton);
    ASSERT_NE(dialog(), nullptr) << sentence;
    const QSize size = dialog()->size();
    const ServiceStatus before = services;
    why();
    show();
    EXPECT_FALSE(inQuestion("dangerVerb")->isEnabled()) << sentence;
    const QString said = test::child<QLabel>(*dialog(), "dangerWithdrawn")->text();
    EXPECT_TRUE(said.contains(QLatin1String(sentence))) << said.toStdString();
    EXPECT_EQ(dialog()->size(), size) << sentence;
    services = before;
    isLive = true;
    show();
    EXPECT_FALSE(inQuestion("dangerVerb")->isEnabled()) << "what is withdrawn stays so";
    QTest::keyClick(dialog(), Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([] { return dialog() == nullptr; }));
  }
  EXPECT_TRUE(intents.empty());
}

TEST_F(RequestsOfDevice, BehindTheLockACommandIsOfferedAndAskedOnceThereIsAnAddress) {
  services.locked = true;
  services.claim = {};
  show();
  showTab(1);
  std::function<void()> unlocked;
  QObject::connect(&panel, &RequestPanel::unlockForRequested,
                   [&](const std::function<void()>& then) { unlocked = then; });
  QPushButton* reset = button(Request::Reset);
  ASSERT_TRUE(reset->isEnabled());
  EXPECT_TRUE(reset->text().contains(QStringLiteral("Unlock and ask")));
  QTest::mouseClick(reset, Qt::LeftButton);
  ASSERT_TRUE(unlocked);
  services.locked = false;
  services.claim.progress = ClaimStatus::Progress::Claimed;
  show();
  EXPECT_EQ(dialog(), nullptr) << "the person has not unlocked for it";
  services.locked = true;
  services.claim = {};
  show();
  QTest::mouseClick(reset, Qt::LeftButton);
  unlocked();
  show();
  services.locked = false;
  services.claim.progress = ClaimStatus::Progress::Claiming;
  show();
  EXPECT_EQ(dialog(), nullptr);
  services.claim.progress = ClaimStatus::Progress::Claimed;
  show();
  ASSERT_NE(dialog(), nullptr);
  EXPECT_TRUE(intents.empty()) << "it asks";
  QTest::mouseClick(inQuestion("dangerVerb"), Qt::LeftButton);
  EXPECT_EQ(intents.size(), 1u);
}

TEST_F(RequestsOfDevice, WhatWaitsForTheLockIsForgottenWhereAnotherDeviceIsChosenOrItTakesLong) {
  std::function<void()> unlocked;
  QObject::connect(&panel, &RequestPanel::unlockForRequested,
                   [&](const std::function<void()>& then) { unlocked = then; });
  showTab(1);
  for (const bool isOther : {false, true}) {
    services.locked = true;
    show();
    QTest::mouseClick(button(Request::Reset), Qt::LeftButton);
    unlocked();
    if (isOther) {
      device = {};
      show();
    } else {
      add({frame("18EFFF80", "FF83150206021A0B", 0, 60 * kSecond)});
    }
    device = kMonitor;
    services.locked = false;
    show();
    EXPECT_EQ(dialog(), nullptr);
  }
}

TEST_F(RequestsOfDevice, OnAListenOnlyAdapterNothingIsBehindTheLock) {
  services.locked = services.isListenOnly = true;
  show();
  EXPECT_FALSE(button(Request::Reset)->isEnabled());
}

TEST_F(RequestsOfDevice, UnlockingAndFirstAnswersMoveNoButton) {
  services.devices[0].takes.add(Request::ZeroAxes);
  for (const int tab : {0, 1}) {
    showTab(tab);
    for (const int wide : {300, 380, 700}) {
      panel.resize(wide, 700);
      services.locked = true;
      show();
      QApplication::processEvents();
      const auto before = places();
      services.locked = false;
      show();
      QApplication::processEvents();
      EXPECT_EQ(places(), before) << tab << " at " << wide;
      isLive = false;
      show();
      QApplication::processEvents();
      EXPECT_EQ(places(), before) << tab << " in the past at " << wide;
      isLive = true;
    }
  }
  showTab(0);
  const auto before = places();
  add({frame("18EF80F9", "03", 0, kSecond), frame("18EFF980", "03010B02040206", 0, kSecond)});
  services.devices[0].requests[Request::Firmware] = {.progress = RequestStatus::Progress::Queued,
                                                     .period = 5s};
  show();
  QApplication::processEvents();
  EXPECT_EQ(places(), before);
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
