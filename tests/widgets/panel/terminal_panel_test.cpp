// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/terminal_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>

#include "panel/file_send_bar.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

using test::frame;
using What = wish::PipeAction::What;

const DeviceKey kMonitor = DeviceKey::of(*Pin::parse("1032AE100801035"));
constexpr std::int64_t kMilli = 1'000'000;

struct Terminal : ::testing::Test {
  Terminal() {
    services.locked = false;
    services.linkUp = true;
    services.claim.progress = ClaimStatus::Progress::Claimed;
    services.claim.address = Address{0xF9};
    DeviceServices& device = services.devices.emplace_back();
    device.device = kMonitor;
    device.address = Address{0x80};
    panel.resize(900, 420);
    QObject::connect(&panel, &TerminalPanel::wished, [this](const Wish& wish) { wishes.push_back(wish); });
    panel.setDevice(kMonitor, QStringLiteral("Roof"));
    add({frame("18EFFF80", "FF83150206021A0B", 0, 0)});
    panel.show();
  }
  void add(const std::vector<Frame>& frames) {
    ASSERT_TRUE(document->frames.append(frames));
    while (document->roles.build(1000)) {
    }
    show();
  }
  void show() {
    view.document = document;
    view.frameCount = document->frames.count();
    view.cursor = {view.frameCount, document->frames.timeAt(view.frameCount - 1)};
    talk.take(*document, view.frameCount, 1'000'000);
    panel.setView(view, talk, services, isLive);
  }
  PipeStatus& pipe() {
    if (!services.devices[0].pipe) services.devices[0].pipe.emplace();
    return *services.devices[0].pipe;
  }
  template <typename T>
  T* child(const char* name) {
    return panel.findChild<T*>(QLatin1String(name));
  }
  QString text() { return child<QPlainTextEdit>("pipeText")->toPlainText(); }
  std::vector<std::string> written() const {
    std::vector<std::string> out;
    for (const Wish& wish : wishes) {
      if (const auto* write = std::get_if<wish::PipeWrite>(&wish)) out.push_back(write->bytes);
    }
    return out;
  }

  std::shared_ptr<LogDocument> document = std::make_shared<LogDocument>();
  LogView view;
  Conversations talk;
  ServiceStatus services;
  bool isLive = true;
  TerminalPanel panel;
  std::vector<Wish> wishes;
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
  auto* mode = child<QComboBox>("pipeMode");
  mode->setFocus();
  QTest::keyClick(mode, Qt::Key_Down);
  auto* input = child<QLineEdit>("pipeInput");
  QTest::keyClick(input, Qt::Key_H);
  QTest::keyClick(input, Qt::Key_Escape);
  QTest::keyClick(input, Qt::Key_C, Qt::ControlModifier);
  QTest::keyClick(input, Qt::Key_BracketLeft, Qt::ControlModifier);
  QTest::keyClick(input, Qt::Key_Backspace);
  EXPECT_EQ(written(), (std::vector<std::string>{"h", "\x03", "\x1B", "\b"}));
  EXPECT_TRUE(input->text().isEmpty());
}

TEST_F(Terminal, ShowsBothDirectionsOnLinesOfTheirOwnAndOddBytesAsBytes) {
  add({frame("18EF80F9", "FE413F0D0A"), frame("18EFF980", "FE"), frame("18EFF980", "FE4F4B1B0D0A")});
  EXPECT_EQ(text(), QStringLiteral("› A?\n  OK⟨1B⟩\n"));
  child<QCheckBox>("pipeEcho")->click();
  EXPECT_EQ(text(), QStringLiteral("  OK⟨1B⟩\n"));
  child<QCheckBox>("pipeHex")->click();
  EXPECT_EQ(text(), QStringLiteral("  4F 4B 1B 0D 0A "));
}

TEST_F(Terminal, AppendsWhatIsNewAndGoesBackWithTheCursor) {
  add({frame("18EFF980", "FE4F")});
  add({frame("18EFF980", "FE4B")});
  EXPECT_EQ(text(), QStringLiteral("  OK"));
  view.cursor = {2, document->frames.timeAt(1)};
  panel.setView(view, talk, services, false);
  EXPECT_EQ(text(), QStringLiteral("  O"));
}

TEST_F(Terminal, AnotherDeviceHasAnotherTranscript) {
  add({frame("18EFF980", "FE4F")});
  panel.setDevice(DeviceKey::of(*Pin::parse("1033AE100802117")), QStringLiteral("Riser"));
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
  for (const char* name : {"pipeResend", "pipeSkip", "pipeAbort"})
    QTest::mouseClick(child<QPushButton>(name), Qt::LeftButton);
  ASSERT_EQ(wishes.size(), 3u);
  const What expected[] = {What::Resend, What::Skip, What::Abort};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(std::get<wish::PipeAction>(wishes[i]).what, expected[i]);
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
  QTest::mouseClick(child<QPushButton>("filePause"), Qt::LeftButton);
  pipe().progress = PipeStatus::Progress::Paused;
  show();
  QTest::mouseClick(child<QPushButton>("filePause"), Qt::LeftButton);
  QTest::mouseClick(child<QPushButton>("fileCancel"), Qt::LeftButton);
  const What expected[] = {What::Pause, What::Resume, What::Cancel};
  ASSERT_EQ(wishes.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(std::get<wish::PipeAction>(wishes[i]).what, expected[i]);
}

TEST_F(Terminal, OffTheLiveEdgeAFileCanBePausedAndCancelledButDoesNotGoOn) {
  pipe() = {.progress = PipeStatus::Progress::Sending, .file = "menu.txt", .fileSize = 1000};
  isLive = false;
  show();
  QTest::mouseClick(child<QPushButton>("filePause"), Qt::LeftButton);
  pipe().progress = PipeStatus::Progress::Paused;
  show();
  EXPECT_FALSE(child<QPushButton>("filePause")->isEnabled());
  QTest::mouseClick(child<QPushButton>("fileCancel"), Qt::LeftButton);
  ASSERT_EQ(wishes.size(), 2u);
  EXPECT_EQ(std::get<wish::PipeAction>(wishes[0]).what, What::Pause);
  EXPECT_EQ(std::get<wish::PipeAction>(wishes[1]).what, What::Cancel);
}

TEST_F(Terminal, OffTheLiveEdgeAStallCanOnlyBeAborted) {
  pipe().progress = PipeStatus::Progress::Stalled;
  isLive = false;
  show();
  EXPECT_FALSE(child<QPushButton>("pipeResend")->isEnabled());
  EXPECT_FALSE(child<QPushButton>("pipeSkip")->isEnabled());
  QTest::mouseClick(child<QPushButton>("pipeAbort"), Qt::LeftButton);
  ASSERT_EQ(wishes.size(), 1u);
  EXPECT_EQ(std::get<wish::PipeAction>(wishes[0]).what, What::Abort);
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

TEST_F(Terminal, TheManualsCautionIsAlwaysThere) {
  EXPECT_TRUE(child<QLabel>("pipeCaution")->isVisible());
  EXPECT_TRUE(
      child<QLabel>("pipeCaution")->text().contains(QStringLiteral("not available for integrator use")));
}

TEST(PipeTranscript, KnowsTheAckOfEachPacketAndSavesThem) {
  auto document = std::make_shared<LogDocument>();
  ASSERT_TRUE(document->frames.append(
      std::array{frame("18EFFF80", "FF83150206021A0B", 0, 0), frame("18EF80F9", "FE410A", 0, 10 * kMilli),
                 frame("18EFF980", "FE", 0, 14 * kMilli), frame("18EFF980", "FE42", 0, 20 * kMilli),
                 frame("18EF80F9", "FE43", 0, 30 * kMilli)}));
  while (document->roles.build(100)) {
  }
  Conversations talk;
  ASSERT_TRUE(talk.take(*document, 5, 100));
  LogView view;
  view.document = document;
  view.cursor = {5, document->frames.timeAt(4)};
  view.begin = document->frames.timeAt(0);
  PipeTranscript transcript;
  transcript.take(view, talk, kMonitor);
  ASSERT_EQ(transcript.packets().size(), 3u);
  EXPECT_EQ(*transcript.packets()[0].acknowledged - transcript.packets()[0].time, 4ms);
  EXPECT_FALSE(transcript.packets()[1].acknowledged);
  EXPECT_EQ(transcript.ledger(), QStringLiteral("time_s,direction,bytes,ack_ms\n0.010000,out,2,4.0\n"
                                                "0.020000,in,1,\n0.030000,out,1,\n"));
  EXPECT_EQ(transcript.text(), QStringLiteral("0:00:00.010  > A\n0:00:00.020  < B\n0:00:00.030  > C\n"));
}

}  // namespace
}  // namespace deckpipe
