// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/pipe/terminal_panel.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QWheelEvent>

#include "model/pipe_transcript.h"
#include "panel/pipe/file_send_bar.h"
#include "support/look.h"
#include "widgets/panel/sending_panel_test.h"

namespace deckpipe {
namespace {

using test::frame;
using What = intent::PipeAction::What;

const DeviceKey kTerminalMonitor = test::kTarget;
constexpr std::int64_t kMilli = 1'000'000;

struct Terminal : test::SendingPanelTest<TerminalPanel> {
  Terminal() { panel.resize(900, 420); }
  PipeStatus& pipe() {
    if (!services.devices[0].pipe) services.devices[0].pipe.emplace();
    return *services.devices[0].pipe;
  }
  QString text() { return child<QPlainTextEdit>("pipeText")->toPlainText(); }
  QString hint() { return child<QLabel>("pipeHint")->text(); }
  std::vector<std::string> written() const {
    std::vector<std::string> out;
    for (const Intent& intent : intents) {
      if (const auto* write = std::get_if<intent::PipeWrite>(&intent)) out.push_back(write->bytes);
    }
    return out;
  }
  void goRaw() {
    child<QComboBox>("pipeMode")->setFocus();
    QTest::keyClick(child<QComboBox>("pipeMode"), Qt::Key_Down);
  }
};

TEST_F(Terminal, ALineGoesWithItsEndAndCanBeRecalled) {
  auto* input = child<QLineEdit>("pipeInput");
  QTest::keyClicks(input, QStringLiteral("A?"));
  QTest::keyClick(input, Qt::Key_Return);
  child<QComboBox>("pipeLineEnd")->setCurrentIndex(1);
  QTest::keyClick(input, Qt::Key_Up);
  QTest::keyClick(input, Qt::Key_Return);
  EXPECT_EQ(written(), (std::vector<std::string>{"A?\r\n", "A?\r"}));
  EXPECT_TRUE(input->text().isEmpty());
}

TEST_F(Terminal, InRawModeEveryKeyGoesAtOnceAndEscapeOnlyByControlBracket) {
  goRaw();
  auto* input = child<QLineEdit>("pipeInput");
  QTest::keyClick(input, Qt::Key_H);
  QTest::keyClick(input, Qt::Key_Escape);
  QTest::keyClick(input, Qt::Key_C, Qt::ControlModifier);
  QTest::keyClick(input, Qt::Key_BracketLeft, Qt::ControlModifier);
  QTest::keyClick(input, Qt::Key_Backspace);
  EXPECT_EQ(written(), (std::vector<std::string>{"h", "\x03", "\x1B", "\b"}));
  EXPECT_TRUE(input->text().isEmpty());
}

TEST_F(Terminal, InRawModeControlKeysAreTheDevicesAndNotTheMenus) {
  QAction lock(&panel), settings(&panel);
  lock.setShortcut(QKeySequence(Qt::CTRL | Qt::Key_L));
  settings.setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Comma));
  panel.addActions({&lock, &settings});
  int locks = 0, opened = 0;
  QObject::connect(&lock, &QAction::triggered, [&] { ++locks; });
  QObject::connect(&settings, &QAction::triggered, [&] { ++opened; });
  panel.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
  auto* input = child<QLineEdit>("pipeInput");
  input->setFocus();
  QTest::keyClick(input, Qt::Key_L, Qt::ControlModifier);
  EXPECT_EQ(locks, 1) << "typing lines";
  goRaw();
  input->setFocus();
  QTest::keyClick(input, Qt::Key_L, Qt::ControlModifier);
  QTest::keyClick(input, Qt::Key_F, Qt::ControlModifier);
  EXPECT_EQ(locks, 1);
  EXPECT_EQ(written(), (std::vector<std::string>{"\x0C", "\x06"}));
  QTest::keyClick(input, Qt::Key_Comma, Qt::ControlModifier);
  EXPECT_EQ(opened, 1) << "a comma is no control character";
}

TEST_F(Terminal, WhatIsPastedInRawModeGoesAtOnce) {
  goRaw();
  auto* input = child<QLineEdit>("pipeInput");
  QInputMethodEvent commit;
  commit.setCommitString(QStringLiteral("MENU"));
  QApplication::sendEvent(input, &commit);
  EXPECT_EQ(written(), (std::vector<std::string>{"MENU"}));
  EXPECT_TRUE(input->text().isEmpty());
}

TEST_F(Terminal, PastedLinesStayLinesWithTheChosenEndAndAreCounted) {
  auto* input = child<QLineEdit>("pipeInput");
  auto* send = child<QPushButton>("pipeSend");
  QGuiApplication::clipboard()->setText(QStringLiteral("one\r\ntwo\nthree\r\n"));
  input->paste();
  EXPECT_EQ(send->text(), QStringLiteral("Send 3 lines"));
  QTest::keyClick(input, Qt::Key_Return);
  EXPECT_EQ(written(), (std::vector<std::string>{"one\r\ntwo\r\nthree\r\n"}));
  EXPECT_EQ(send->text(), QStringLiteral("Send"));
  child<QComboBox>("pipeLineEnd")->setCurrentIndex(1);
  input->paste();
  QTest::keyClick(input, Qt::Key_Return);
  EXPECT_EQ(written().back(), "one\rtwo\rthree\r");
  goRaw();
  input->paste();
  EXPECT_EQ(written().back(), "one\rtwo\rthree\r");
}

TEST_F(Terminal, WithoutALineEndPastedLinesKeepTheirOwn) {
  auto* input = child<QLineEdit>("pipeInput");
  QGuiApplication::clipboard()->setText(QStringLiteral("one\r\ntwo\nthree"));
  child<QComboBox>("pipeLineEnd")->setCurrentIndex(3);
  input->paste();
  EXPECT_EQ(child<QPushButton>("pipeSend")->text(), QStringLiteral("Send 3 lines"));
  QTest::keyClick(input, Qt::Key_Return);
  EXPECT_EQ(written(), (std::vector<std::string>{"one\r\ntwo\nthree"}));
  QTest::keyClicks(input, QStringLiteral("four"));
  QTest::keyClick(input, Qt::Key_Return);
  EXPECT_EQ(written().back(), "four");
  goRaw();
  input->paste();
  EXPECT_EQ(written().back(), "one\r\ntwo\nthree");
}

TEST_F(Terminal, OfALongTextNothingIsCut) {
  auto* input = child<QLineEdit>("pipeInput");
  const std::string text(100'000, 'x');
  QGuiApplication::clipboard()->setText(QString::fromStdString(text));
  input->paste();
  QTest::keyClick(input, Qt::Key_Return);
  EXPECT_EQ(written(), (std::vector<std::string>{text + "\r\n"}));
}

TEST_F(Terminal, CharactersOfMoreThanAByteAreRefusedWithWords) {
  auto* input = child<QLineEdit>("pipeInput");
  input->setText(QStringLiteral("5 €"));
  QTest::keyClick(input, Qt::Key_Return);
  EXPECT_TRUE(hint().contains(QStringLiteral("“€”"))) << hint().toStdString();
  EXPECT_EQ(input->text(), QStringLiteral("5 €")) << "to be mended";
  input->setText(QStringLiteral("5 \u00b0"));
  QTest::keyClick(input, Qt::Key_Return);
  EXPECT_EQ(written(), (std::vector<std::string>{"5 \xB0\r\n"}));
  EXPECT_FALSE(child<QLabel>("pipeHint")->isVisible()) << "that was the next deed";
  goRaw();
  QTest::sendKeyEvent(QTest::Click, input, Qt::Key_unknown, QStringLiteral("€"), Qt::NoModifier);
  EXPECT_TRUE(hint().contains(QStringLiteral("“€”")));
  EXPECT_TRUE(input->text().isEmpty());
  EXPECT_EQ(written().size(), 1u);
}

TEST_F(Terminal, OfALongTextTheRefusalNamesOnlyTheCharacter) {
  auto* input = child<QLineEdit>("pipeInput");
  const auto hintOf = [&](const QString& character) {
    input->setText(QString(50'000, QLatin1Char('x')) + character + QStringLiteral("y€"));
    QTest::keyClick(input, Qt::Key_Return);
    EXPECT_LT(hint().size(), 120);
    return hint();
  };
  EXPECT_TRUE(hintOf(QStringLiteral("ž")).contains(QStringLiteral("“ž”"))) << hint().toStdString();
  EXPECT_TRUE(hintOf(QStringLiteral("🚒")).contains(QStringLiteral("“🚒”"))) << hint().toStdString();
  // A space without width: nothing to see.
  EXPECT_TRUE(hintOf(QString(QChar(0x200B))).contains(QStringLiteral("“U+200B”"))) << hint().toStdString();
  EXPECT_TRUE(written().empty());
}

TEST_F(Terminal, WhatWasTypedForOneDeviceIsNotThereForAnother) {
  auto* input = child<QLineEdit>("pipeInput");
  QTest::keyClicks(input, QStringLiteral("for the roof"));
  deviceName = QStringLiteral("Roof, renamed");
  showView();
  EXPECT_FALSE(input->text().isEmpty());
  device = DeviceKey::of(*Pin::parse("1033AE100802117"));
  showView();
  EXPECT_TRUE(input->text().isEmpty());
}

TEST_F(Terminal, TheWheelChangesNothingThatIsSent) {
  for (const char* name : {"pipeMode", "pipeLineEnd"}) {
    auto* combo = child<QComboBox>(name);
    for (const bool hasFocus : {false, true}) {
      if (hasFocus) combo->setFocus();
      const QPointF middle = QRectF(combo->rect()).center();
      QWheelEvent wheel(middle, combo->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(combo, &wheel);
      EXPECT_EQ(combo->currentIndex(), 0) << name;
    }
  }
}

TEST_F(Terminal, ShowsBothDirectionsOnLinesOfTheirOwnAndOddBytesAsBytes) {
  Frame ours = frame("18EF80F9", "FE413F0D0A");
  ours.flags |= Frame::kSent;
  add({ours, frame("18EFF980", "FE"), frame("18EFF980", "FE4F4B1B0D0A")});
  EXPECT_EQ(text(), QStringLiteral("› A?\n  OK⟨1B⟩\n"));
  child<QCheckBox>("pipeEcho")->click();
  EXPECT_EQ(text(), QStringLiteral("  OK⟨1B⟩\n"));
  child<QCheckBox>("pipeHex")->click();
  EXPECT_EQ(text(), QStringLiteral("  4F 4B 1B 0D 0A "));
}

TEST_F(Terminal, WhatAnotherConsoleSendsIsNotTakenForOurs) {
  add({frame("18EF80F8", "FE413F0D0A")});
  EXPECT_EQ(text(), QStringLiteral("F8› A?\n"));
}

TEST_F(Terminal, AppendsWhatIsNewAndGoesBackWithTheCursor) {
  add({frame("18EFF980", "FE4F")});
  add({frame("18EFF980", "FE4B")});
  EXPECT_EQ(text(), QStringLiteral("  OK"));
  view.cursor = {2, document->frames.timeAt(1)};
  isLive = false;
  showView();
  EXPECT_EQ(text(), QStringLiteral("  O"));
}

TEST_F(Terminal, AnotherDeviceHasAnotherTranscript) {
  add({frame("18EFF980", "FE4F")});
  device = DeviceKey::of(*Pin::parse("1033AE100802117"));
  show();
  EXPECT_TRUE(text().isEmpty());
}

TEST_F(Terminal, LockedNothingCanBeTyped) {
  services.locked = true;
  show();
  EXPECT_FALSE(child<QLineEdit>("pipeInput")->isEnabled());
  EXPECT_FALSE(child<QPushButton>("pipeSendFile")->isEnabled());
  EXPECT_TRUE(child<QPushButton>("pipeUnlock")->isVisible());
}

TEST_F(Terminal, AMissingAckOffersResendSkipAndAbort) {
  EXPECT_FALSE(child<QWidget>("pipeStall")->isVisible());
  pipe().progress = PipeStatus::Progress::Stalled;
  pipe().stall = PipeStatus::Stall::NoAck;
  show();
  ASSERT_TRUE(child<QWidget>("pipeStall")->isVisible());
  for (const char* name : {"pipeResend", "pipeSkip", "pipeAbort"}) click(name);
  ASSERT_EQ(intents.size(), 3u);
  const What expected[] = {What::Resend, What::Skip, What::Abort};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(std::get<intent::PipeAction>(intents[i]).what, expected[i]);
}

TEST_F(Terminal, WhatIsDecidedMayBeForTheRestTooAndIsAskedAnewEachTime) {
  pipe() = {.progress = PipeStatus::Progress::Stalled,
            .stall = PipeStatus::Stall::NoAck,
            .file = "menu.txt",
            .fileSize = 1000,
            .fileSent = 250};
  show();
  const QString before = child<QLabel>("pipeStallText")->text();
  auto* rest = child<QCheckBox>("pipeForTheRest");
  ASSERT_TRUE(rest->isVisible());
  EXPECT_FALSE(rest->isChecked());
  EXPECT_TRUE(rest->text().contains(QStringLiteral("rest of this file")));
  for (const char* name : {"pipeSkip", "pipeResend", "pipeAbort"}) {
    rest->click();
    EXPECT_TRUE(child<QLabel>("pipeStallText")->text().contains(QStringLiteral("Skip may leave gaps")));
    click(name);
    EXPECT_FALSE(rest->isChecked());
  }
  EXPECT_EQ(child<QLabel>("pipeStallText")->text(), before);
  click("pipeSkip");
  ASSERT_EQ(intents.size(), 4u);
  const bool expected[] = {true, true, false, false};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(std::get<intent::PipeAction>(intents[i]).forTheRest, expected[i]) << i;
  rest->click();
  pipe().progress = PipeStatus::Progress::Sending;  // the ack came after all
  show();
  pipe().progress = PipeStatus::Progress::Stalled;
  show();
  EXPECT_FALSE(rest->isChecked()) << "another missing ack";
}

TEST_F(Terminal, ForTheRestIsOfferedOnlyForAMissingAckAndWhereThereIsARest) {
  pipe().progress = PipeStatus::Progress::Stalled;
  pipe().stall = PipeStatus::Stall::NoAck;
  pipe().waiting = 3;
  show();
  EXPECT_TRUE(child<QCheckBox>("pipeForTheRest")->isVisible());
  pipe().waiting = 0;
  show();
  EXPECT_FALSE(child<QCheckBox>("pipeForTheRest")->isVisible()) << "it was the last packet";
  pipe().waiting = 3;
  pipe().stall = PipeStatus::Stall::NotTaken;
  show();
  EXPECT_FALSE(child<QCheckBox>("pipeForTheRest")->isVisible());
}

TEST_F(Terminal, SaysWhatIsDoneForTheRestAndWhatBecameOfTheText) {
  pipe().progress = PipeStatus::Progress::Settling;
  pipe().rest = PipeStatus::Rest::Skip;
  pipe().waiting = 30;
  pipe().textSkipped = 2;
  show();
  EXPECT_TRUE(hint().contains(QStringLiteral("are skipped, so far 2"))) << hint().toStdString();
  pipe() = {};
  pipe().textSkipped = 3;
  pipe().textResent = 1;
  show();
  EXPECT_TRUE(hint().contains(QStringLiteral("3 packets were skipped and 1 sent again")));
  EXPECT_TRUE(hint().contains(QStringLiteral("what arrived is not known")));
  pipe() = {.progress = PipeStatus::Progress::Sending,
            .rest = PipeStatus::Rest::Resend,
            .file = "menu.txt",
            .fileSize = 1000,
            .fileSent = 250,
            .fileResent = 4};
  show();
  EXPECT_TRUE(child<QLabel>("fileFigures")->text().contains(QStringLiteral("are sent again, so far 4")));
  pipe().rest = PipeStatus::Rest::Ask;
  pipe().fileEnd = PipeStatus::FileEnd::Cancelled;
  show();
  EXPECT_TRUE(
      child<QLabel>("fileFigures")->text().contains(QStringLiteral("0 packets skipped, 4 sent again")));
}

TEST_F(Terminal, SaysThatTheDeviceRestartedAfterWhatWasSentUntilSomethingIsSentAgain) {
  Frame ours = frame("18EF80F9", "FE4142", 0, 1'000 * kMilli);
  ours.flags |= Frame::kSent;
  add({ours});
  EXPECT_FALSE(child<QLabel>("pipeHint")->isVisible());
  add({frame("18EFFF80", "FF83150206021A0B", 0, 9'000 * kMilli)});
  EXPECT_EQ(text(), QStringLiteral("› AB\n— the device restarted —\n"));
  EXPECT_TRUE(hint().startsWith(QStringLiteral("The device restarted"))) << hint().toStdString();
  EXPECT_TRUE(child<QLineEdit>("pipeInput")->placeholderText().contains(QStringLiteral("has restarted")));
  pipe().notTaken = 12;
  show();
  EXPECT_TRUE(hint().contains(QStringLiteral("12 characters"))) << hint().toStdString();
  EXPECT_TRUE(hint().contains(QStringLiteral("were not taken")));
  ours.stamp = 10'000 * kMilli;
  pipe().notTaken = 0;
  add({frame("18EFF980", "FE4F", 0, 9'500 * kMilli), ours});
  EXPECT_EQ(text(), QStringLiteral("› AB\n— the device restarted —\n  O\n› AB"));
  EXPECT_FALSE(child<QLabel>("pipeHint")->isVisible());
  EXPECT_FALSE(child<QLineEdit>("pipeInput")->placeholderText().contains(QStringLiteral("has restarted")));
}

TEST_F(Terminal, AFileThatARestartEndedSaysSo) {
  pipe() = {.file = "menu.txt", .fileSize = 1000, .fileSent = 250, .fileEnd = PipeStatus::FileEnd::Restarted};
  show();
  EXPECT_TRUE(
      child<QLabel>("fileFigures")->text().startsWith(QStringLiteral("Stopped: the device restarted")));
}

TEST_F(Terminal, TheLinesOfATextFileGoWithTheChosenEndUnlessTheyAreToGoAsTheyAre) {
  QTemporaryDir dir;
  const auto send = [&](const QByteArray& content, bool unticks) {
    QFile file(dir.filePath(QStringLiteral("text")));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) return std::string("?");
    file.close();
    click("pipeSendFile");
    auto* chooser = child<QFileDialog>("pipeFileDialog");
    Q_EMIT chooser->fileSelected(file.fileName());
    chooser->close();
    auto* asked = test::child<QDialog>(panel, "dangerDialog");
    if (auto* option = asked->findChild<QCheckBox*>(QStringLiteral("dangerOption"))) {
      if (unticks) option->click();
    }
    test::child<QAbstractButton>(*asked, "dangerVerb")->click();
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return *std::get<intent::PipeFile>(intents.back()).content;
  };
  child<QComboBox>("pipeLineEnd")->setCurrentIndex(1);
  EXPECT_EQ(send("VER\r\nA?\r\n\nB", false), "VER\rA?\r\rB");
  EXPECT_EQ(send("VER\r\nA?\r\n", true), "VER\r\nA?\r\n");
  EXPECT_EQ(send(QByteArray("\x01\r\n", 3), false), "\x01\r\n") << "no text";
  child<QComboBox>("pipeLineEnd")->setCurrentIndex(0);
  EXPECT_EQ(send("VER\r\nA?\n", false), "VER\r\nA?\r\n");
}

TEST_F(Terminal, AFileShowsItsProgressAndCanBePausedAndCancelled) {
  pipe() = {.progress = PipeStatus::Progress::Sending,
            .file = "menu.txt",
            .fileSize = 1000,
            .fileSent = 250,
            .fileBegan = view.cursor.time - 10s,
            .acks = 36,
            .ackWorst = 40ms,
            .ackSum = 360ms};
  show();
  EXPECT_FALSE(child<QLineEdit>("pipeInput")->isEnabled()) << "it would end up in the file";
  EXPECT_EQ(rateText(pipe(), view.cursor.time), QStringLiteral("25 B/s"));
  EXPECT_EQ(timeLeftText(pipe(), view.cursor.time), QStringLiteral("about 30 s left"));
  click("filePause");
  pipe().progress = PipeStatus::Progress::Paused;
  pipe().isPaused = true;
  show();
  click("filePause");
  click("fileCancel");
  const What expected[] = {What::Pause, What::Resume, What::Cancel};
  ASSERT_EQ(intents.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(std::get<intent::PipeAction>(intents[i]).what, expected[i]);
}

TEST_F(Terminal, AFileWithSkippedPacketsIsNotSaidToBeSent) {
  pipe() = {.file = "menu.txt", .fileSize = 1000, .fileSent = 1000, .fileEnd = PipeStatus::FileEnd::Done};
  show();
  EXPECT_TRUE(child<QLabel>("fileFigures")->text().startsWith(QStringLiteral("Sent ·")));
  pipe().fileSkipped = 2;
  show();
  EXPECT_TRUE(child<QLabel>("fileFigures")->text().contains(QStringLiteral("2 packets skipped")));
  EXPECT_TRUE(child<QLabel>("fileFigures")->text().contains(QStringLiteral("what arrived is not known")));
}

TEST_F(Terminal, StaysAtTheEndWhenItGetsLessRoom) {
  for (int i = 0; i < 60; ++i) add({frame("18EFF980", "FE410D0A")});
  const auto* bar = child<QPlainTextEdit>("pipeText")->verticalScrollBar();
  ASSERT_GT(bar->maximum(), 0);
  EXPECT_EQ(bar->value(), bar->maximum());
  panel.resize(900, 300);
  QApplication::sendPostedEvents();
  EXPECT_EQ(bar->value(), bar->maximum());
  child<QPlainTextEdit>("pipeText")->verticalScrollBar()->setValue(0);
  add({frame("18EFF980", "FE420D0A")});
  EXPECT_EQ(bar->value(), 0) << "a person looks at the begin";
}

TEST_F(Terminal, OffTheLiveEdgeAFileCanBePausedAndCancelledButDoesNotGoOn) {
  pipe() = {.progress = PipeStatus::Progress::Sending, .file = "menu.txt", .fileSize = 1000};
  isLive = false;
  show();
  click("filePause");
  pipe().progress = PipeStatus::Progress::Paused;
  pipe().isPaused = true;
  show();
  EXPECT_FALSE(child<QPushButton>("filePause")->isEnabled());
  click("fileCancel");
  ASSERT_EQ(intents.size(), 2u);
  EXPECT_EQ(std::get<intent::PipeAction>(intents[0]).what, What::Pause);
  EXPECT_EQ(std::get<intent::PipeAction>(intents[1]).what, What::Cancel);
}

TEST_F(Terminal, OffTheLiveEdgeAStallCanOnlyBeAborted) {
  pipe().progress = PipeStatus::Progress::Stalled;
  isLive = false;
  show();
  EXPECT_FALSE(child<QPushButton>("pipeResend")->isEnabled());
  EXPECT_FALSE(child<QPushButton>("pipeSkip")->isEnabled());
  click("pipeAbort");
  ASSERT_EQ(intents.size(), 1u);
  EXPECT_EQ(std::get<intent::PipeAction>(intents[0]).what, What::Abort);
}

TEST_F(Terminal, SearchesFromTheNewestBackAndSaysWhenThereIsNothing) {
  add({frame("18EFF980", "FE41420A"), frame("18EFF980", "FE41430A")});
  auto* search = child<QLineEdit>("pipeSearch");
  QTest::keyClicks(search, QStringLiteral("A"));
  const auto found = [this] { return child<QPlainTextEdit>("pipeText")->textCursor().blockNumber(); };
  EXPECT_EQ(found(), 1);
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(found(), 0);
  QTest::keyClicks(search, QStringLiteral("X"));
  EXPECT_FALSE(search->toolTip().isEmpty());
}

TEST_F(Terminal, AlwaysSaysWhomItTalksTo) {
  QTest::keyClicks(child<QLineEdit>("pipeInput"), QStringLiteral("something"));
  EXPECT_TRUE(child<QLabel>("pipeDevice")->isVisible());
  EXPECT_EQ(child<QLabel>("pipeDevice")->text(), QStringLiteral("Roof (1032AE100801035)"));
  pipe().progress = PipeStatus::Progress::Stalled;
  show();
  EXPECT_TRUE(child<QLabel>("pipeDevice")->isVisible());
}

// At 1366×768 the Ask dock leaves it so much, and the letters of the field are larger.
TEST_F(Terminal, FitsBesideTheAskPanelInFieldSize) {
  constexpr int kRoom = 960;
  const test::Look look(Theme::Light, Density::Field);
  pipe() = {.progress = PipeStatus::Progress::Sending,
            .file = "a menu with a rather long name for a file.txt",
            .fileSize = 100'000,
            .fileSent = 42'000,
            .fileBegan = view.cursor.time - 60s,
            .acks = 6'000,
            .ackWorst = 72ms,
            .ackSum = 24s};
  show();
  click("pipeMore");
  EXPECT_LE(panel.minimumSizeHint().width(), kRoom);
  pipe().progress = PipeStatus::Progress::Stalled;
  show();
  EXPECT_LE(panel.minimumSizeHint().width(), kRoom);
}

TEST_F(Terminal, TheManualsCautionIsAlwaysThere) {
  EXPECT_TRUE(child<QLabel>("pipeCaution")->isVisible());
  EXPECT_TRUE(
      child<QLabel>("pipeCaution")->text().contains(QStringLiteral("not available for integrator use")));
}

// At the end of the log, with all of it found.
LogView builtView(const std::shared_ptr<LogDocument>& document) {
  while (document->roles.build(100)) {
  }
  while (document->exchanges.build(100)) {
  }
  LogView view;
  view.document = document;
  view.frameCount = document->frames.count();
  view.cursor = {view.frameCount, document->frames.lastTime()};
  while (document->events.build(view.cursor)) {
  }
  view.begin = document->frames.timeAt(0);
  view.state = std::make_shared<State>(document->keyframes.at(view.cursor));
  return view;
}

TEST(PipeTranscript, KnowsTheAckOfEachPacketAndSavesThem) {
  auto document = std::make_shared<LogDocument>();
  Frame ours = frame("18EF80F9", "FE43", 0, 30 * kMilli);
  ours.flags |= Frame::kSent;
  ASSERT_TRUE(document->frames.append(
      std::array{frame("18EFFF80", "FF83150206021A0B", 0, 0), frame("18EF80F8", "FE410A", 0, 10 * kMilli),
                 frame("18EFF880", "FE", 0, 14 * kMilli), frame("18EFF980", "FE42", 0, 20 * kMilli), ours}));
  while (document->roles.build(100)) {
  }
  while (document->exchanges.build(100)) {
  }
  LogView view;
  view.document = document;
  view.cursor = {5, document->frames.timeAt(4)};
  view.begin = document->frames.timeAt(0);
  PipeTranscript transcript;
  transcript.take(view, kTerminalMonitor);
  ASSERT_EQ(transcript.packets().size(), 3u);
  EXPECT_EQ(*transcript.packets()[0].acknowledged - transcript.packets()[0].time, 4ms);
  EXPECT_FALSE(transcript.packets()[1].acknowledged);
  EXPECT_EQ(transcript.ledger(), QStringLiteral("time_s,direction,bytes,ack_ms,repair\n"
                                                "0.010000,out,2,4.0,\n0.020000,in,1,,\n0.030000,out,1,,\n"));
  EXPECT_EQ(transcript.text(), QStringLiteral("0:00:00.010  F8> A\n0:00:00.020  < B\n0:00:00.030  > C\n"));
}

TEST(PipeTranscript, SaysWhichPacketsWereSentAgainAndWhichWereSkipped) {
  auto document = std::make_shared<LogDocument>();
  std::vector<Frame> frames{frame("18EFFF80", "FF83150206021A0B", 0, 0)};
  for (int i = 1; i <= 4; ++i) {
    frames.push_back(frame("18EF80F9", "FE41", 0, i * 1'000 * kMilli));
    frames.back().flags |= Frame::kSent;
  }
  ASSERT_TRUE(document->frames.append(frames));
  const auto note = [&](std::uint64_t at, const char* pin, PipeEvent event) {
    document->notes.append({.frame = at,
                            .time = document->frames.timeAt(at - 1),
                            .value = note::Pipe{{}, Address{0x80}, *Pin::parse(pin), event, {}}});
  };
  note(2, "1032AE100801035", PipeEvent::Resent);
  note(3, "1032AE100801035", PipeEvent::Skipped);
  note(5, "1032AE100801036", PipeEvent::Skipped);
  LogView view = builtView(document);
  PipeTranscript transcript;
  transcript.take(view, kTerminalMonitor);
  EXPECT_EQ(transcript.ledger(),
            QStringLiteral("time_s,direction,bytes,ack_ms,repair\n1.000000,out,1,,\n"
                           "2.000000,out,1,,resent skipped\n3.000000,out,1,,\n4.000000,out,1,,\n"));
}

TEST(PipeTranscript, HasEveryRestartOfTheDevice) {
  auto document = std::make_shared<LogDocument>();
  std::vector<Frame> frames;
  for (int i = 0; i <= 3; ++i) {
    frames.push_back(frame("18EFFF80", "FF83150206021A0B", 0, i * 60'000 * kMilli));
    for (int k = 1; k < 500; ++k)
      frames.push_back(frame("18EFFF80", "83C051", 0, (i * 60'000 + k * 100) * kMilli));
    frames.push_back(frame("18EF80F9", "FE410A", 0, (i * 60'000 + 50'000) * kMilli));
    frames.back().flags |= Frame::kSent;
  }
  ASSERT_TRUE(document->frames.append(frames));
  const LogView view = builtView(document);
  PipeTranscript transcript;
  transcript.take(view, kTerminalMonitor);
  const QString restart = QStringLiteral("  — the device restarted —\n");
  EXPECT_EQ(transcript.text(), QStringLiteral("0:00:50.000  > A\n0:01:00.000") + restart +
                                   QStringLiteral("0:01:50.000  > A\n0:02:00.000") + restart +
                                   QStringLiteral("0:02:50.000  > A\n0:03:00.000") + restart +
                                   QStringLiteral("0:03:50.000  > A\n"));
}

}  // namespace
}  // namespace deckpipe
