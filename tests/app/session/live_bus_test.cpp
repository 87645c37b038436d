// SPDX-License-Identifier: GPL-3.0-or-later
// The bus thread's object on a virtual bus of this process: what it does where the log takes no more, how it
// ends.
#include "session/live_bus.h"

#include <gtest/gtest.h>

#include <QCanBus>
#include <QCanBusDevice>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <memory>

#include "link/virtual_bus.h"
#include "session/clocks.h"
#include "support/frames.h"
#include "support/patience.h"
#include "support/recording_listener.h"

namespace deckpipe {
namespace {

TEST(LiveBus, LocksWhereTheLogTakesNoMoreAndAnswersNothingFromThenOn) {
  VirtualBus bus;
  ASSERT_TRUE(bus.start());
  const LinkSettings settings{QStringLiteral("virtualcan"), bus.interfaceName(0), 250'000, {}};
  const auto full =
      std::make_shared<LogDocument>(StoreLimits{.memoryBytes = 0, .spillFolder = "/nonexistent"});
  LiveBus live(full, settings);
  RecordingListener peer;
  CanLink peerLink(settings);
  peerLink.open(peer);
  live.start();
  const auto waitFor = [](auto condition) { return QTest::qWaitFor(condition, kPatience); };
  ASSERT_TRUE(waitFor([&] { return live.latest().link.state == LinkState::Up; }));
  ASSERT_TRUE(waitFor([&] { return peer.state() == LinkState::Up; }));
  live.apply({intent::Unlock{}, bootTime(), 1});
  ASSERT_FALSE(live.latest().services->locked);
  ASSERT_TRUE(waitFor([&] { return live.latest().storeFull; })) << "its own first frame finds no room";
  EXPECT_TRUE(live.latest().services->locked);
  const auto ours = [&] {
    return std::ranges::count_if(peer.frames, [](const Frame& f) { return (f.flags & Frame::kSent) == 0; });
  };
  ASSERT_TRUE(waitFor([&] { return ours() > 0; }));
  const auto before = ours();
  // Who is there: a console that holds an address would answer.
  ASSERT_EQ(peerLink.write(test::frame("18EAFF80", "00EE00")), WriteResult::Accepted);
  ASSERT_TRUE(waitFor([&] { return ours() < static_cast<std::ptrdiff_t>(peer.frames.size()); }));
  EXPECT_EQ(live.latest().services->claim.progress, ClaimStatus::Progress::Off);
  EXPECT_EQ(ours(), before);
  live.apply({intent::Unlock{}, bootTime(), 2});
  EXPECT_TRUE(live.latest().services->locked) << "nothing is sent on a picture that stands still";
}

TEST(LiveBus, TellsOfItsTickOnceUntilThatIsTaken) {
  VirtualBus bus;
  ASSERT_TRUE(bus.start());
  LiveBus live(std::make_shared<LogDocument>(),
               {QStringLiteral("virtualcan"), bus.interfaceName(0), 250'000, {}});
  QSignalSpy ticked(&live, &LiveBus::ticked);
  live.start();
  const auto publishes = [&] {
    return QTest::qWaitFor([&, before = live.latest().state] { return live.latest().state != before; },
                           kPatience);
  };
  const auto ticks = [&](int times) {
    return QTest::qWaitFor([&] { return ticked.count() == times; }, kPatience);
  };
  ASSERT_TRUE(ticks(1));
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(publishes());
  EXPECT_EQ(ticked.count(), 1) << "a window that takes long finds one tick waiting";
  EXPECT_EQ(live.take().state, live.latest().state);
  EXPECT_TRUE(ticks(2));
}

// The thread stands still for longer than an ack may take, and the ack comes meanwhile.
TEST(LiveBus, AnAckThatCameWhileItsThreadStoodStillIsInTime) {
  VirtualBus bus;
  ASSERT_TRUE(bus.start());
  const LinkSettings settings{QStringLiteral("virtualcan"), bus.interfaceName(0), 250'000, {}};
  QThread thread;
  const std::unique_ptr<QThread, void (*)(QThread*)> ended(&thread, [](QThread* t) { t->wait(); });
  auto* live = new LiveBus(std::make_shared<LogDocument>(), settings);
  live->moveToThread(&thread);
  QObject::connect(&thread, &QThread::finished, live, &QObject::deleteLater);
  thread.start();
  QMetaObject::invokeMethod(live, &LiveBus::start, Qt::QueuedConnection);
  RecordingListener peer;
  CanLink peerLink(settings);
  peerLink.open(peer);
  const auto waitFor = [](auto condition) { return QTest::qWaitFor(condition, kPatience); };
  const auto intend = [live](Intent intent) {
    QMetaObject::invokeMethod(
        live,
        [live, intent] {
          live->apply({intent, bootTime(), 1});
        },
        Qt::QueuedConnection);
  };
  EXPECT_TRUE(waitFor([&] { return live->latest().link.state == LinkState::Up; }));
  EXPECT_TRUE(waitFor([&] { return peer.state() == LinkState::Up; }));
  intend(intent::Unlock{});
  EXPECT_TRUE(waitFor([&] { return live->latest().services->canRequest(); }));
  const DeviceKey monitor = DeviceKey::of(*Pin::parse("1032AE100801035"));
  peerLink.write(test::frame("18EFFF80", "FF83150206021A0B"));
  EXPECT_TRUE(waitFor([&] { return live->latest().services->find(monitor) != nullptr; }));
  intend(intent::PipeWrite{monitor, "abc"});
  EXPECT_TRUE(waitFor([&] {
    return std::ranges::any_of(
        peer.frames, [](const Frame& f) { return (f.id & 0x3FF'0000u) == 0xEF'0000u && f.data[0] == 0xFE; });
  }));
  const auto pipe = [&] { return live->latest().services->find(monitor)->pipe.value_or(PipeStatus{}); };
  QSemaphore stands, goesOn;
  QMetaObject::invokeMethod(
      live,
      [&] {
        stands.release();
        goesOn.acquire();
        QThread::msleep(1'200);
      },
      Qt::QueuedConnection);
  stands.acquire();
  peerLink.write(test::frame("18EFF980", "FE"));
  goesOn.release();
  EXPECT_TRUE(waitFor([&] { return pipe().acks == 1 || pipe().progress == PipeStatus::Progress::Stalled; }));
  EXPECT_EQ(pipe().progress, PipeStatus::Progress::Idle);
  EXPECT_EQ(pipe().lateAcks, 0u);
  QMetaObject::invokeMethod(live, &LiveBus::close, Qt::QueuedConnection);
}

// Controller and driver lose what others sent; our own frames come back from behind them.
TEST(LiveBus, TakesAnEchoForLostWhereTheKernelDroppedFramesAndNotWhereTheControllerLostSome) {
  VirtualBus bus;
  ASSERT_TRUE(bus.start());
  const LinkSettings settings{QStringLiteral("virtualcan"), bus.interfaceName(0), 250'000, {}};
  LiveBus live(std::make_shared<LogDocument>(), settings);
  RecordingListener peer;
  CanLink peerLink(settings);
  peerLink.open(peer);
  live.start();
  const auto waitFor = [](auto condition) { return QTest::qWaitFor(condition, kPatience); };
  ASSERT_TRUE(waitFor([&] { return peer.state() == LinkState::Up; }));
  ASSERT_TRUE(waitFor([&] { return live.latest().link.state == LinkState::Up; }));
  live.apply({intent::Unlock{}, bootTime(), 1});
  ASSERT_TRUE(waitFor([&] { return live.latest().services->canRequest(); }));
  const DeviceKey monitor = DeviceKey::of(*Pin::parse("1032AE100801035"));
  peerLink.write(test::frame("18EFFF80", "FF83150206021A0B"));
  ASSERT_TRUE(waitFor([&] { return live.latest().services->find(monitor) != nullptr; }));

  // From here on no event is handled, so that the echo does not come.
  live.apply({intent::SendRequests{monitor, RequestSet{Request::ZeroAxes}}, bootTime(), 2});
  PortListener& listener = live;
  const auto endAfter = [&](NotKept reason) {
    listener.framesNotKept(reason, 1);
    live.sayDrive({0x20}, false);  // publishes
    return live.latest().services->find(monitor)->of(Request::ZeroAxes).end;
  };
  EXPECT_EQ(endAfter(NotKept::Overrun), RequestEnd::None);
  EXPECT_EQ(endAfter(NotKept::Overflow), RequestEnd::CannotTell);
}

struct EndOfALiveBus : testing::Test {
  void SetUp() override {
    ASSERT_TRUE(bus.start());
    live = std::make_unique<LiveBus>(
        log, LinkSettings{QStringLiteral("virtualcan"), bus.interfaceName(0), 250'000, {}});
    live->start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return live->latest().link.state == LinkState::Up; }, kPatience));
    ASSERT_EQ(noted(), (std::vector<std::string_view>{"link_up"}));
  }
  std::vector<std::string_view> noted() const {
    std::vector<std::string_view> keys;
    for (const Note& note : log->notes.all()) keys.push_back(noteKey(note.value));
    return keys;
  }
  VirtualBus bus;
  std::shared_ptr<LogDocument> log = std::make_shared<LogDocument>();
  std::unique_ptr<LiveBus> live;
};

TEST_F(EndOfALiveBus, IsWrittenDownWhenItIsStopped) {
  live->stop();
  EXPECT_EQ(noted(), (std::vector<std::string_view>{"link_up", "link_down"}));
  EXPECT_EQ(live->latest().link.state, LinkState::Closed);
}

TEST_F(EndOfALiveBus, RunsOnWhileItsLinkIsUpAndNothingComes) {
  const auto goesOn = [&] {
    return QTest::qWaitFor([&, before = log->notes.ranUntil()] { return log->notes.ranUntil() > before; },
                           kPatience);
  };
  EXPECT_TRUE(goesOn());
  EXPECT_TRUE(goesOn());
  EXPECT_EQ(noted(), (std::vector<std::string_view>{"link_up"}));
  live->stop();
  EXPECT_LT(log->notes.ranUntil(), log->notes.lastTime()) << "until the link went down";
}

TEST_F(EndOfALiveBus, NamesItsAdapterInWords) {
  const auto up = std::get<note::LinkUp>(log->notes.all().front().value);
  EXPECT_EQ(up.adapter.str(), "virtualcan " + bus.interfaceName(0).toStdString()) << "it has no bit rate";
}

TEST_F(EndOfALiveBus, NotesHowManyFramesTheLogCannotHold) {
  const std::unique_ptr<QCanBusDevice> flexible(
      QCanBus::instance()->createDevice(QStringLiteral("virtualcan"), bus.interfaceName(0)));
  flexible->setConfigurationParameter(QCanBusDevice::CanFdKey, true);
  ASSERT_TRUE(flexible->connectDevice());
  ASSERT_TRUE(QTest::qWaitFor([&] { return bus.clients(0) == 2; }, kPatience));
  for (int i = 0; i < 5; ++i) flexible->writeFrame(QCanBusFrame(0x102, QByteArray(64, 'b')));
  ASSERT_TRUE(QTest::qWaitFor([&] { return log->notes.missedFrames() == 5; }, kPatience));
  live->stop();
  EXPECT_EQ(log->notes.missedFrames(), 5u);
  for (const Note& note : log->notes.all()) {
    if (const auto* leftOut = std::get_if<note::LeftOut>(&note.value)) {
      EXPECT_EQ(leftOut->why, note::LeftOut::Why::CanFd);
    }
  }
}

TEST_F(EndOfALiveBus, WritesNothingWhileItIsDestroyed) {
  live.reset();
  EXPECT_EQ(noted(), (std::vector<std::string_view>{"link_up"}));
}

}  // namespace
}  // namespace deckpipe
