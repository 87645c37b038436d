// SPDX-License-Identifier: GPL-3.0-or-later
// The link on Linux's own CAN. It sends frames and sets interfaces up and down, so it runs only where it is
// told to: DECKPIPE_TEST_CAN="can0 can1", two interfaces of one bus with nothing else on it, up at
// 250000 bit/s, as root, on a machine made for it: `tests/socketcan/guest link`. QEMU's SJA1000 keeps what a
// burst overran and hands it out one by one ever after, so there it is one run a boot.
#include <gtest/gtest.h>

#include <QProcess>
#include <QTest>

#include "link/adapters.h"
#include "link/can_link.h"
#include "support/patience.h"
#include "support/raw_frames.h"
#include "support/recording_listener.h"

namespace deckpipe {
namespace {

using namespace test;

struct CardEnd {
  CardEnd(const QString& name, int bitRate)
      : link({QStringLiteral("socketcan"), name, bitRate, Channel{1}}) {}
  bool waitForState(LinkState state) {
    return QTest::qWaitFor([&] { return heard.state() == state; }, kPatience);
  }
  bool waitForFrames(std::size_t count) {
    return QTest::qWaitFor([&] { return heard.frames.size() >= count; }, kPatience);
  }
  RecordingListener heard;
  CanLink link;
};

struct SocketCan : ::testing::Test {
  void SetUp() override {
    names = qEnvironmentVariable("DECKPIPE_TEST_CAN").split(QLatin1Char(' '), Qt::SkipEmptyParts);
    if (names.size() != 2) GTEST_SKIP() << "DECKPIPE_TEST_CAN does not name two CAN interfaces";
  }
  static void ip(const QStringList& arguments) {
    ASSERT_EQ(QProcess::execute(QStringLiteral("ip"), QStringList{QStringLiteral("link")} + arguments), 0);
  }
  static void setUp(const QString& name, bool up) {
    ip({QStringLiteral("set"), name, up ? QStringLiteral("up") : QStringLiteral("down")});
  }
  static void setRate(const QString& name, int bitRate) {
    ip({QStringLiteral("set"), name, QStringLiteral("type"), QStringLiteral("can"), QStringLiteral("bitrate"),
        QString::number(bitRate)});
  }
  QStringList names;
};

TEST_F(SocketCan, FramesGoBothWaysAndOwnOnesComeBackConfirmedOnce) {
  CardEnd one(names[0], 250'000), two(names[1], 250'000);
  one.link.open(one.heard);
  two.link.open(two.heard);
  ASSERT_TRUE(one.waitForState(LinkState::Up)) << one.heard.reason();
  ASSERT_TRUE(two.waitForState(LinkState::Up)) << two.heard.reason();
  ASSERT_TRUE(one.link.status().hardware);
  EXPECT_EQ(one.link.status().hardware->bitRate, 250'000u);
  EXPECT_EQ(one.link.status().hardware->kind, "can");
  EXPECT_TRUE(one.link.status().hardware->echoesInDriver);
  EXPECT_FALSE(one.link.status().hardware->isListenOnly);
  const auto buffer = one.link.receiveBuffer();
  ASSERT_TRUE(buffer) << "the plugin's socket was not found";
  EXPECT_GE(buffer->bytes, 4'000'000u);

  const std::vector<Frame> sent = {frameOf(0x7FF, {}), frameOf(0x000, {1, 5}),
                                   extendedFrame(0x18EF3801, {1, 2, 3, 4, 5, 6, 7, 8}),
                                   extendedFrame(0x123, {255}), remoteFrame(0x701, 1)};
  for (const Frame& frame : sent) {
    EXPECT_EQ(one.link.write(frame), WriteResult::Accepted);
    ASSERT_TRUE(one.waitForFrames(1));
    ASSERT_TRUE(two.waitForFrames(1));
    Frame expected = frame;
    expected.channel = 1;
    expected.stamp = one.heard.frames[0].stamp;
    expected.flags = Frame::kSent | Frame::kConfirmed;
    EXPECT_EQ(one.heard.frames[0], expected);
    EXPECT_TRUE(expected.hasStamp());
    expected.stamp = two.heard.frames[0].stamp;
    expected.flags = 0;
    EXPECT_EQ(two.heard.frames[0], expected);
    one.heard.forget();
    two.heard.forget();
  }
  EXPECT_EQ(one.link.status().confirmed, sent.size());
  EXPECT_EQ(two.link.status().received, sent.size());
}

TEST_F(SocketCan, WhatAnotherProgramSendsOnOurInterfaceIsNotOurs) {
  CardEnd one(names[0], 250'000), other(names[0], 250'000);
  one.link.open(one.heard);
  other.link.open(other.heard);
  ASSERT_TRUE(one.waitForState(LinkState::Up));
  ASSERT_TRUE(other.waitForState(LinkState::Up));
  other.link.write(frameOf(0x123, {1}));
  ASSERT_TRUE(one.waitForFrames(1));
  EXPECT_EQ(one.heard.frames[0].flags, 0);
}

// An emulated controller sends at once, so the queue is made slow, where the system can.
TEST_F(SocketCan, ABurstEndsInAFullQueueAndWhatWasAcceptedComesBack) {
  const QString tc = QStringLiteral("tc");
  const QStringList slow = QStringLiteral("rate 64kbit burst 320 limit 640").split(QLatin1Char(' '));
  const QStringList qdisc = {QStringLiteral("qdisc"), QStringLiteral("replace"),
                             QStringLiteral("dev"),   names[0],
                             QStringLiteral("root"),  QStringLiteral("tbf")};
  const bool isSlow = QProcess::execute(tc, qdisc + slow) == 0;
  CardEnd one(names[0], 250'000);
  one.link.open(one.heard);
  ASSERT_TRUE(one.waitForState(LinkState::Up));
  std::size_t accepted = 0;
  WriteResult last = WriteResult::Accepted;
  for (int i = 0; i < 200 && last == WriteResult::Accepted; ++i) {
    last = one.link.write(extendedFrame(static_cast<std::uint32_t>(i), {1, 2, 3, 4, 5, 6, 7, 8}));
    accepted += last == WriteResult::Accepted;
  }
  if (isSlow) {
    EXPECT_EQ(last, WriteResult::QueueFull) << one.link.status().reason;
    EXPECT_LT(accepted, 200u);
  }
  EXPECT_TRUE(one.waitForFrames(accepted));
  EXPECT_EQ(one.link.status().confirmed, accepted);
  if (isSlow) {
    QProcess::execute(tc, {QStringLiteral("qdisc"), QStringLiteral("del"), QStringLiteral("dev"), names[0],
                           QStringLiteral("root")});
  }
}

TEST_F(SocketCan, AnotherBitRateThanAskedForIsRefused) {
  CardEnd wrong(names[0], 500'000), asItIs(names[0], 0);
  wrong.link.open(wrong.heard);
  ASSERT_TRUE(wrong.waitForState(LinkState::Closed));
  EXPECT_EQ(wrong.link.status().fault, LinkFault::WrongBitRate);
  asItIs.link.open(asItIs.heard);
  ASSERT_TRUE(asItIs.waitForState(LinkState::Up));
  EXPECT_EQ(asItIs.link.status().hardware->bitRate, 250'000u);
}

TEST_F(SocketCan, DownIsLostAndUpAgainIsUp) {
  CardEnd one(names[0], 250'000);
  one.link.open(one.heard);
  ASSERT_TRUE(one.waitForState(LinkState::Up));
  setUp(names[0], false);
  EXPECT_EQ(one.link.write(frameOf(0x123, {})), WriteResult::Failed) << "before the event is heard";
  ASSERT_TRUE(one.waitForState(LinkState::Lost));
  EXPECT_EQ(one.link.status().fault, LinkFault::InterfaceDown);
  EXPECT_EQ(one.link.write(frameOf(0x123, {})), WriteResult::NotOpen);

  CardEnd late(names[0], 250'000);
  late.link.open(late.heard);
  ASSERT_TRUE(late.waitForState(LinkState::Closed));
  EXPECT_EQ(late.link.status().fault, LinkFault::InterfaceDown);
  bool isListed = false;
  for (const Adapter& adapter : listAdapters().adapters) {
    if (adapter.plugin == QLatin1String("socketcan") && adapter.interfaceName == names[0]) {
      isListed = true;
      EXPECT_FALSE(adapter.isUp);
      EXPECT_EQ(adapter.bitRate, 250'000u);
    }
  }
  EXPECT_TRUE(isListed);

  setUp(names[0], true);
  ASSERT_TRUE(one.waitForState(LinkState::Up));
  one.heard.forget();
  EXPECT_EQ(one.link.write(frameOf(0x124, {})), WriteResult::Accepted);
  ASSERT_TRUE(one.waitForFrames(1));
  EXPECT_EQ(one.heard.frames[0].flags, Frame::kSent | Frame::kConfirmed);
}

TEST_F(SocketCan, UpAgainAtAnotherRateItWaitsForTheRightOne) {
  CardEnd one(names[0], 250'000);
  one.link.open(one.heard);
  ASSERT_TRUE(one.waitForState(LinkState::Up));
  setUp(names[0], false);
  ASSERT_TRUE(one.waitForState(LinkState::Lost));
  setRate(names[0], 500'000);
  setUp(names[0], true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return one.link.status().fault == LinkFault::WrongBitRate; }, kPatience));
  EXPECT_EQ(one.heard.state(), LinkState::Lost);
  EXPECT_EQ(one.link.write(frameOf(0x123, {})), WriteResult::NotOpen);
  setUp(names[0], false);
  setRate(names[0], 250'000);
  setUp(names[0], true);
  ASSERT_TRUE(one.waitForState(LinkState::Up));
  one.heard.forget();
  EXPECT_EQ(one.link.write(frameOf(0x123, {})), WriteResult::Accepted);
  EXPECT_TRUE(one.waitForFrames(1));
}

}  // namespace
}  // namespace deckpipe
