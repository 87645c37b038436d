// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/can_link.h"

#include <gtest/gtest.h>

#include <QCanBus>
#include <QCanBusDevice>
#include <QEventLoop>
#include <QTcpServer>
#include <QTest>
#include <QTimer>
#include <atomic>
#include <future>
#include <memory>
#include <thread>

#include "link/adapters.h"
#include "link/link_device.h"
#include "link/virtual_bus.h"
#include "support/patience.h"
#include "support/raw_frames.h"
#include "support/recording_listener.h"

namespace deckpipe {
namespace {

using namespace test;

LinkSettings settingsFor(const QString& name, std::uint8_t channel = 0) {
  return {QStringLiteral("virtualcan"), name, 250'000, Channel{channel}};
}

// One end: a link and what it was told.
struct End {
  explicit End(LinkSettings settings, CanLink::WallClock clock = CanLink::systemClock)
      : link(std::move(settings), nullptr, std::move(clock)) {}
  bool waitForState(LinkState state) {
    return QTest::qWaitFor([&] { return heard.state() == state; }, kPatience);
  }
  bool waitForFrames(std::size_t count) {
    return QTest::qWaitFor([&] { return heard.frames.size() >= count; }, kPatience);
  }
  RecordingListener heard;
  CanLink link;
};

struct CanLinkTest : ::testing::Test {
  void SetUp() override { ASSERT_TRUE(bus.start()) << bus.errorString().toStdString(); }
  bool waitForClients(int count) {
    return QTest::qWaitFor([&] { return bus.clients(0) == count; }, kPatience);
  }
  bool open(End& end) {
    const int before = bus.clients(0);
    end.link.open(end.heard);
    return end.waitForState(LinkState::Up) && waitForClients(before + 1);
  }
  QString withoutEcho() const { return bus.interfaceName(0).section(QLatin1Char('?'), 0, 0); }
  VirtualBus bus;
};

std::vector<Frame> everyKind() {
  return {frameOf(0x000, {0x01, 0x05}),
          frameOf(0x7FF, {}),
          extendedFrame(0x18EF3801, {1, 2, 3, 4, 5, 6, 7, 8}),
          extendedFrame(0x00000123, {0xFF}),
          extendedFrame(0x1FFFFFFF, {0, 0, 0}),
          remoteFrame(0x701, 1),
          remoteFrame(0x18EA3801 | kExtendedBit, 3)};
}

// Without what the way adds: stamp, channel, flags.
std::vector<Frame> bare(std::vector<Frame> frames) {
  for (Frame& frame : frames) {
    frame.stamp = kNoStamp;
    frame.channel = 0;
    frame.flags = 0;
  }
  return frames;
}

TEST_F(CanLinkTest, EveryKindOfFrameGoesBothWaysAndOwnOnesComeBackOnce) {
  End one(settingsFor(bus.interfaceName(0), 1));
  End two(settingsFor(bus.interfaceName(0), 2));
  ASSERT_TRUE(open(one));
  ASSERT_TRUE(open(two));
  EXPECT_TRUE(one.link.echoes());
  for (const bool forth : {true, false}) {
    End& from = forth ? one : two;
    End& to = forth ? two : one;
    from.heard.forget();
    to.heard.forget();
    for (const Frame& frame : everyKind()) EXPECT_EQ(from.link.write(frame), WriteResult::Accepted);
    EXPECT_TRUE(from.heard.frames.empty()) << "from inside write()";
    // One more from the other end, and everything before it has arrived.
    ASSERT_TRUE(to.waitForFrames(everyKind().size()));
    EXPECT_EQ(to.link.write(frameOf(0x100, {})), WriteResult::Accepted);
    auto expected = everyKind();
    expected.push_back(frameOf(0x100, {}));
    ASSERT_TRUE(from.waitForFrames(expected.size()));
    ASSERT_TRUE(to.waitForFrames(expected.size()));

    EXPECT_EQ(bare(to.heard.frames), expected);
    EXPECT_EQ(bare(from.heard.frames), expected);
    for (std::size_t i = 0; i < from.heard.frames.size(); ++i) {
      const Frame& own = from.heard.frames[i];
      EXPECT_EQ(own.flags, i < everyKind().size() ? Frame::kSent | Frame::kConfirmed : 0);
      EXPECT_EQ(own.channel, from.link.settings().channel.value);
      EXPECT_TRUE(own.hasStamp());
    }
    for (const Frame& frame : to.heard.frames)
      EXPECT_EQ((frame.flags & Frame::kSent) != 0, frame.id == 0x100);
  }
  EXPECT_EQ(one.link.status().confirmed, everyKind().size() + 1);
  EXPECT_EQ(bus.refusedLines(), 0);
}

// The name without "?echo" is what a host like Qt's own looks like; that this one returns frames all the same
// must not make them come twice.
TEST_F(CanLinkTest, WithoutEchoOwnFramesComeOnceUnconfirmedWithTheLinksClock) {
  End one(settingsFor(withoutEcho()), [] { return std::int64_t{1'234'567}; });
  End two(settingsFor(bus.interfaceName(0)));
  ASSERT_TRUE(open(one));
  ASSERT_TRUE(open(two));
  EXPECT_FALSE(one.link.echoes());
  EXPECT_EQ(one.link.write(frameOf(0x123, {1})), WriteResult::Accepted);
  EXPECT_TRUE(one.heard.frames.empty()) << "from inside write()";
  ASSERT_TRUE(two.waitForFrames(1));
  two.link.write(frameOf(0x100, {}));
  ASSERT_TRUE(one.waitForFrames(2));
  EXPECT_EQ(bare(one.heard.frames), (std::vector{frameOf(0x123, {1}), frameOf(0x100, {})}));
  EXPECT_EQ(one.heard.frames[0].flags, Frame::kSent);
  EXPECT_EQ(one.heard.frames[0].stamp, 1'234'567);
}

TEST_F(CanLinkTest, ErrorFramesAreNeverWritten) {
  End one(settingsFor(bus.interfaceName(0)));
  End two(settingsFor(bus.interfaceName(0)));
  ASSERT_TRUE(open(one));
  ASSERT_TRUE(open(two));
  EXPECT_EQ(one.link.write(frameOf(kErrorBit | 0x40, {0, 0, 0, 0, 0, 0, 0, 0})), WriteResult::Failed);
  EXPECT_EQ(one.link.write(frameOf(0x123, {})), WriteResult::Accepted);
  ASSERT_TRUE(two.waitForFrames(1));
  EXPECT_EQ(two.heard.frames[0].id, 0x123u);
  EXPECT_EQ(one.link.status().refused, 1u);
}

TEST_F(CanLinkTest, FlexibleDataRateIsCountedAtItsPlace) {
  End one(settingsFor(bus.interfaceName(0)));
  ASSERT_TRUE(open(one));
  std::unique_ptr<QCanBusDevice> plain(
      QCanBus::instance()->createDevice(QStringLiteral("virtualcan"), bus.interfaceName(0)));
  plain->setConfigurationParameter(QCanBusDevice::CanFdKey, true);
  ASSERT_TRUE(plain->connectDevice());
  ASSERT_TRUE(waitForClients(2));
  plain->writeFrame(QCanBusFrame(0x101, QByteArray(2, 'a')));
  plain->writeFrame(QCanBusFrame(0x102, QByteArray(64, 'b')));
  plain->writeFrame(QCanBusFrame(0x103, QByteArray(2, 'c')));
  ASSERT_TRUE(one.waitForFrames(2));
  EXPECT_EQ(one.heard.notKept, (std::vector{std::pair{NotKept::FlexibleDataRate, 1u}}));
  EXPECT_EQ(one.link.status().notKept, 1u);
}

TEST_F(CanLinkTest, FramesArriveInBatchesAndNoneIsLost) {
  End one(settingsFor(bus.interfaceName(0)));
  End two(settingsFor(bus.interfaceName(0)));
  ASSERT_TRUE(open(one));
  ASSERT_TRUE(open(two));
  constexpr std::size_t kCount = 5'000;
  for (std::size_t i = 0; i < kCount; ++i) {
    ASSERT_EQ(one.link.write(extendedFrame(static_cast<std::uint32_t>(i), {})), WriteResult::Accepted);
  }
  ASSERT_TRUE(two.waitForFrames(kCount));
  ASSERT_TRUE(one.waitForFrames(kCount));
  for (std::size_t i = 0; i < kCount; ++i) {
    ASSERT_EQ(two.heard.frames[i].identifier(), i);
    ASSERT_EQ(one.heard.frames[i].identifier(), i);
  }
  EXPECT_LT(two.heard.batches.size(), kCount / 10);
}

TEST_F(CanLinkTest, TwoBusesAtOnceDoNotDisturbEachOther) {
  VirtualBus other;
  ASSERT_TRUE(other.start());
  ASSERT_NE(other.interfaceName(0), bus.interfaceName(0));
  End here(settingsFor(bus.interfaceName(0))), hereToo(settingsFor(bus.interfaceName(0)));
  End there(settingsFor(other.interfaceName(0))), thereToo(settingsFor(other.interfaceName(0)));
  End otherChannel(settingsFor(bus.interfaceName(1)));
  for (End* end : {&here, &hereToo, &there, &thereToo, &otherChannel}) end->link.open(end->heard);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return bus.clients(0) == 2 && bus.clients(1) == 1 && other.clients(0) == 2; }, kPatience));
  here.link.write(frameOf(0x111, {}));
  there.link.write(frameOf(0x222, {}));
  otherChannel.link.write(frameOf(0x333, {}));
  ASSERT_TRUE(hereToo.waitForFrames(1));
  ASSERT_TRUE(thereToo.waitForFrames(1));
  hereToo.link.write(frameOf(0x112, {}));
  thereToo.link.write(frameOf(0x223, {}));
  ASSERT_TRUE(here.waitForFrames(2));
  ASSERT_TRUE(there.waitForFrames(2));
  ASSERT_TRUE(otherChannel.waitForFrames(1));
  EXPECT_EQ(bare(here.heard.frames), (std::vector{frameOf(0x111, {}), frameOf(0x112, {})}));
  EXPECT_EQ(bare(there.heard.frames), (std::vector{frameOf(0x222, {}), frameOf(0x223, {})}));
  EXPECT_EQ(bare(otherChannel.heard.frames), (std::vector{frameOf(0x333, {})}));
}

TEST_F(CanLinkTest, WhenTheBusGoesTheLinkIsLostAndCanBeOpenedAgain) {
  End one(settingsFor(bus.interfaceName(0)));
  ASSERT_TRUE(open(one));
  bus.stop();
  ASSERT_TRUE(one.waitForState(LinkState::Lost));
  EXPECT_FALSE(one.heard.reason().empty());
  EXPECT_EQ(one.link.status().fault, LinkFault::Gone);
  EXPECT_EQ(one.link.write(frameOf(0x123, {})), WriteResult::NotOpen);
  one.link.close();
  EXPECT_EQ(one.heard.state(), LinkState::Closed);

  ASSERT_TRUE(bus.start());
  End again(settingsFor(bus.interfaceName(0)));
  ASSERT_TRUE(open(again));
}

TEST_F(CanLinkTest, ClosingTakesLeaveOfTheBusAndIsTheLastWord) {
  End one(settingsFor(bus.interfaceName(0)));
  End two(settingsFor(bus.interfaceName(0)));
  ASSERT_TRUE(open(one));
  ASSERT_TRUE(open(two));
  two.link.write(frameOf(0x123, {}));
  one.link.write(frameOf(0x124, {}));
  one.link.close();
  EXPECT_EQ(one.heard.state(), LinkState::Closed);
  const auto told = one.heard.states.size();
  const auto frames = one.heard.frames.size();
  ASSERT_TRUE(two.waitForFrames(2)) << "what was written before closing arrives";
  ASSERT_TRUE(waitForClients(1));
  EXPECT_EQ(one.heard.states.size(), told);
  EXPECT_EQ(one.heard.frames.size(), frames);
  EXPECT_EQ(two.heard.state(), LinkState::Up) << "that another leaves is nobody's fault";
  ASSERT_TRUE(open(one)) << "a closed link opens again";
}

TEST_F(CanLinkTest, WhatWasWrittenLastLeavesThoughTheLinkIsDestroyed) {
  auto one = std::make_unique<End>(settingsFor(bus.interfaceName(0)));
  End two(settingsFor(bus.interfaceName(0)));
  ASSERT_TRUE(open(*one));
  ASSERT_TRUE(open(two));
  one->link.write(frameOf(0x123, {}));
  one.reset();
  ASSERT_TRUE(two.waitForFrames(1));
  ASSERT_TRUE(waitForClients(1));
}

TEST_F(CanLinkTest, TheListenerMayWriteAndCloseFromInside) {
  struct Answering : RecordingListener {
    CanLink* link = nullptr;
    void framesReceived(std::span<const Frame> received) override {
      RecordingListener::framesReceived(received);
      for (const Frame& frame : received) {
        if (frame.id == 0x601) link->write(frameOf(0x581, {}));
        if (frame.id == 0x602) link->close();
      }
    }
  } answering;
  CanLink server(settingsFor(bus.interfaceName(0)));
  answering.link = &server;
  server.open(answering);
  ASSERT_TRUE(waitForClients(1));
  End client(settingsFor(bus.interfaceName(0)));
  ASSERT_TRUE(open(client));
  client.link.write(frameOf(0x601, {}));
  ASSERT_TRUE(client.waitForFrames(2));
  EXPECT_EQ(client.heard.frames[1].id, 0x581u);
  client.link.write(frameOf(0x602, {}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return answering.state() == LinkState::Closed; }, kPatience));
}

TEST_F(CanLinkTest, LinksOfOtherThreadsMayOpenAtTheSameTime) {
  std::vector<std::thread> threads;
  std::atomic<int> cameUp = 0;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, name = bus.interfaceName(0)] {
      QEventLoop loop;
      struct Listener : RecordingListener {
        QEventLoop* loop = nullptr;
        void linkChanged(LinkState state, const std::string& reason) override {
          RecordingListener::linkChanged(state, reason);
          if (state != LinkState::Connecting) loop->quit();
        }
      } listener;
      listener.loop = &loop;
      CanLink link(settingsFor(name));
      link.open(listener);
      if (listener.state() == LinkState::Connecting) loop.exec();
      cameUp += listener.state() == LinkState::Up;
    });
  }
  EXPECT_TRUE(QTest::qWaitFor([&] { return cameUp == 4; }, kPatience));
  for (std::thread& thread : threads) thread.join();
}

// Whoever lists adapters holds QtSerialBus for as long as a maker's library takes.
TEST_F(CanLinkTest, WhileAdaptersAreListedOpeningWaitsAndItsThreadGoesOn) {
  std::promise<void> isListing, isDone;
  std::thread listing([&] {
    const std::lock_guard lock(serialBusMutex());
    isListing.set_value();
    isDone.get_future().wait();
  });
  isListing.get_future().wait();
  End one(settingsFor(bus.interfaceName(0)));
  one.link.open(one.heard);
  bool hasGoneOn = false;
  QTimer::singleShot(2 * LinkDevice::kTryAgain, &one.link, [&] { hasGoneOn = true; });
  EXPECT_TRUE(QTest::qWaitFor([&] { return hasGoneOn; }, kPatience));
  EXPECT_EQ(one.heard.states, std::vector{LinkState::Connecting});
  isDone.set_value();
  EXPECT_TRUE(one.waitForState(LinkState::Up));
  listing.join();
}

TEST_F(CanLinkTest, ADestructorTellsNothing) {
  RecordingListener heard;
  auto link = std::make_unique<CanLink>(settingsFor(bus.interfaceName(0)));
  link->open(heard);
  ASSERT_TRUE(QTest::qWaitFor([&] { return heard.state() == LinkState::Up; }, kPatience));
  ASSERT_EQ(link->write(frameOf(0x123, {})), WriteResult::Accepted);
  heard.forget();
  link.reset();
  ASSERT_TRUE(waitForClients(0));
  EXPECT_TRUE(heard.states.empty());
  EXPECT_TRUE(heard.frames.empty());
}

// --- what cannot be opened: a reason, no crash

struct Refusal {
  const char* name;
  const char* plugin;
  const char* interfaceName;
  LinkFault fault;
  int bitRate = 250'000;
};

class RefusedLink : public ::testing::TestWithParam<Refusal> {};

TEST_P(RefusedLink, SaysWhy) {
  End end(
      {QString::fromLatin1(GetParam().plugin), QString::fromLatin1(GetParam().interfaceName), 250'000, {}});
  end.link.open(end.heard);
  ASSERT_TRUE(end.waitForState(LinkState::Closed));
  EXPECT_EQ(end.heard.states, (std::vector{LinkState::Connecting, LinkState::Closed}));
  EXPECT_FALSE(end.heard.reason().empty());
  EXPECT_EQ(end.link.status().fault, GetParam().fault);
  EXPECT_EQ(end.link.write(frameOf(0x123, {})), WriteResult::NotOpen);
  end.link.close();
  EXPECT_EQ(end.heard.states.size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(
    Link, RefusedLink,
    ::testing::Values(Refusal{"unknown_plugin", "nosuchcan", "can0", LinkFault::NoPlugin},
                      Refusal{"no_plugin", "", "", LinkFault::NoPlugin},
                      Refusal{"third_channel", "virtualcan", "can2", LinkFault::NoInterface},
                      Refusal{"nonsense", "virtualcan", "what is this", LinkFault::NoInterface},
                      Refusal{"host_name", "virtualcan", "tcp://example.invalid:1/can0",
                              LinkFault::NoAnswer}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(SocketCanLink, RefusesInterfacesThatAreMissingOrNotCan) {
  if (!QCanBus::instance()->plugins().contains(QStringLiteral("socketcan"))) GTEST_SKIP();
  for (const auto& name : {QStringLiteral("nosuchcan9"), QStringLiteral("lo"), QString()}) {
    End end({QStringLiteral("socketcan"), name, 250'000, {}});
    end.link.open(end.heard);
    EXPECT_EQ(end.heard.state(), LinkState::Connecting) << "the kernel is asked by a worker";
    ASSERT_TRUE(end.waitForState(LinkState::Closed));
    EXPECT_EQ(end.link.status().fault, LinkFault::NoInterface);
  }
}

// Qt's plugin hosts one server a program, so that a second port is hosted by nobody; it would wait for ever.
TEST(VirtualCanLink, WhereNobodyListensItIsGivenUp) {
  const auto freePort = [] {
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return QStringLiteral("tcp://127.0.0.1:%1/can0").arg(server.serverPort());
  };
  End host(settingsFor(freePort()));  // hosted by the plugin itself, unless it has done so before
  host.link.open(host.heard);
  EXPECT_FALSE(host.link.echoes());
  ASSERT_TRUE(QTest::qWaitFor([&] { return host.heard.state() != LinkState::Connecting; }, kPatience));

  End end(settingsFor(freePort()));
  end.link.open(end.heard);
  ASSERT_TRUE(end.waitForState(LinkState::Closed));
  EXPECT_EQ(end.link.status().fault, LinkFault::NoAnswer);
  EXPECT_FALSE(end.heard.reason().empty());
}

}  // namespace
}  // namespace deckpipe
