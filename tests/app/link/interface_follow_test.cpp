// SPDX-License-Identifier: GPL-3.0-or-later
// What a link makes of the kernel's news about its interface: a fake interface under a link on a virtual bus.
// On the real thing: tests/socketcan.
#include <gtest/gtest.h>

#include <QTest>

#include "link/can_link.h"
#include "link/virtual_bus.h"
#include "support/fake_interfaces.h"
#include "support/patience.h"
#include "support/raw_frames.h"
#include "support/recording_listener.h"

namespace deckpipe {
namespace {

using namespace test;

struct FollowedLink : ::testing::Test {
  void SetUp() override {
    ASSERT_TRUE(bus.start());
    const LinkSettings settings{QStringLiteral("virtualcan"), bus.interfaceName(0), 250'000, Channel{0}};
    auto source = std::make_unique<FakeInterfaces>(settings.interfaceName.toStdString());
    fake = source.get();
    link = std::make_unique<CanLink>(settings, nullptr, CanLink::systemClock, std::move(source));
  }
  void open() {
    link->open(heard);
    ASSERT_TRUE(waitFor(LinkState::Up));
    heard.forget();
  }
  bool waitFor(LinkState state) {
    return QTest::qWaitFor([&] { return link->status().state == state; }, kPatience);
  }
  static void down(CanInterface& facts) { facts.isUp = false; }
  static void up(CanInterface& facts) { facts.isUp = true; }

  VirtualBus bus;
  FakeInterfaces* fake = nullptr;
  RecordingListener heard;
  std::unique_ptr<CanLink> link;
};

TEST_F(FollowedLink, DownIsLostAtOnceAndUpAgainIsUp) {
  open();
  fake->set(down);
  EXPECT_EQ(heard.states, std::vector{LinkState::Lost});
  EXPECT_EQ(link->status().fault, LinkFault::InterfaceDown);
  EXPECT_EQ(link->write(frameOf(0x123, {})), WriteResult::NotOpen);
  fake->set(up);
  EXPECT_EQ(heard.states, (std::vector{LinkState::Lost, LinkState::Up}));
  EXPECT_EQ(link->status().fault, LinkFault::None);
  EXPECT_EQ(link->write(frameOf(0x123, {})), WriteResult::Accepted);
}

// The news comes late: by the time it is heard the interface is up again. The gap was there all the same.
TEST_F(FollowedLink, AGapThatIsOverBeforeItIsHeardOfIsStillTold) {
  open();
  CanInterface wasDown = fake->now();
  wasDown.isUp = false;
  fake->tell(wasDown);
  fake->set(up);
  EXPECT_EQ(heard.states, (std::vector{LinkState::Lost, LinkState::Up}));
}

TEST_F(FollowedLink, PulledOutAndPutBackItConnectsByItself) {
  open();
  for (int i = 0; i < 20; ++i) {
    fake->unplug();
    ASSERT_EQ(link->status().state, LinkState::Lost);
    EXPECT_EQ(link->status().fault, LinkFault::Gone);
    EXPECT_FALSE(link->status().hardware);
    fake->plug(down);  // as an adapter comes back; somebody has to set it up
    EXPECT_EQ(link->status().state, LinkState::Lost);
    EXPECT_EQ(link->status().fault, LinkFault::InterfaceDown);
    fake->set(up);
    ASSERT_TRUE(waitFor(LinkState::Up)) << i;
  }
  heard.forget();
  EXPECT_EQ(link->write(frameOf(0x123, {})), WriteResult::Accepted);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !heard.frames.empty(); }, kPatience));
  EXPECT_EQ(heard.frames[0].flags, Frame::kSent | Frame::kConfirmed);
}

TEST_F(FollowedLink, BackAtAnotherRateItWaitsForTheRightOne) {
  open();
  fake->set(down);
  fake->set([](CanInterface& facts) {
    facts.isUp = true;
    facts.bitRate = 500'000;
  });
  EXPECT_EQ(link->status().state, LinkState::Lost);
  EXPECT_EQ(link->status().error(), (LinkError{.fault = LinkFault::WrongBitRate, .bitRate = 500'000}));
  EXPECT_EQ(link->write(frameOf(0x123, {})), WriteResult::NotOpen);
  fake->set(down);
  fake->set([](CanInterface& facts) {
    facts.isUp = true;
    facts.bitRate = 250'000;
  });
  EXPECT_TRUE(waitFor(LinkState::Up));
}

TEST_F(FollowedLink, OtherInterfacesAreNoneOfItsBusiness) {
  open();
  CanInterface other;
  other.index = 99;
  other.name = "can7";
  other.isCan = true;
  fake->tell(other);
  other.isRemoved = true;
  fake->tell(other);
  EXPECT_TRUE(heard.states.empty());
}

TEST_F(FollowedLink, WhatHappenedWhileNewsWasLostIsReadAnew) {
  open();
  fake->setSilently(down);
  fake->loseNews();
  ASSERT_TRUE(waitFor(LinkState::Lost));
  fake->setSilently(up);
  fake->loseNews();
  ASSERT_TRUE(waitFor(LinkState::Up));
  fake->unplugSilently();
  fake->loseNews();
  ASSERT_TRUE(waitFor(LinkState::Lost));
  EXPECT_EQ(link->status().fault, LinkFault::Gone);
  fake->plug();
  ASSERT_TRUE(waitFor(LinkState::Up));
}

TEST_F(FollowedLink, WithoutAnyNewsItIsKnownByTheNextReading) {
  open();
  fake->setSilently(down);
  ASSERT_TRUE(waitFor(LinkState::Lost));
  fake->setSilently(up);
  ASSERT_TRUE(waitFor(LinkState::Up));
}

TEST_F(FollowedLink, TheControllersStateIsReadAgainAndBusOffToldOnce) {
  open();
  fake->setSilently([](CanInterface& facts) {
    facts.controller = ControllerState::ErrorPassive;
    facts.sendErrors = 128;
  });
  ASSERT_TRUE(QTest::qWaitFor([&] { return link->status().hardware->sendErrors == 128; }, kPatience));
  EXPECT_EQ(link->status().hardware->controller, ControllerState::ErrorPassive);
  EXPECT_TRUE(heard.states.empty());
  for (int i = 0; i < 2; ++i)
    fake->set([](CanInterface& facts) { facts.controller = ControllerState::BusOff; });
  EXPECT_EQ(heard.states, std::vector{LinkState::Up});
  EXPECT_EQ(link->status().errors, 1u);
}

TEST_F(FollowedLink, WhatTheDriverLostIsCountedAsAnOverrunWhichLosesNoEcho) {
  fake->setSilently([](CanInterface& facts) { facts.overruns = 10; });  // before our time
  open();
  fake->set([](CanInterface& facts) { facts.overruns = 13; });
  fake->set([](CanInterface&) {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !heard.notKept.empty(); }, kPatience));
  EXPECT_EQ(heard.notKept, (std::vector{std::pair{NotKept::Overrun, 3u}}));
  EXPECT_EQ(link->status().notKept, 3u);
}

TEST_F(FollowedLink, ClosedIsTheEndOfIt) {
  open();
  fake->set(down);
  link->close();
  EXPECT_FALSE(fake->isStarted());
  fake->plug();
  EXPECT_EQ(link->status().state, LinkState::Closed);
  EXPECT_EQ(heard.state(), LinkState::Closed);
}

// The listener may close, or open again, from inside whatever it is told.
TEST_F(FollowedLink, TheListenerMayCloseFromInside) {
  struct Closing : RecordingListener {
    CanLink* link = nullptr;
    void linkChanged(LinkState state, const std::string& reason) override {
      RecordingListener::linkChanged(state, reason);
      if (state == LinkState::Lost) link->close();
    }
  } closing;
  closing.link = link.get();
  for (const bool pulled : {false, true}) {
    link->open(closing);
    ASSERT_TRUE(waitFor(LinkState::Up));
    if (pulled) {
      fake->unplug();
    } else {
      fake->set(down);
    }
    EXPECT_EQ(closing.state(), LinkState::Closed);
    if (!pulled) fake->set(up);
  }
}

TEST_F(FollowedLink, NeverUpIsClosedAndNotFollowed) {
  fake->setSilently(down);
  link->open(heard);
  EXPECT_EQ(heard.state(), LinkState::Connecting);
  ASSERT_TRUE(waitFor(LinkState::Closed));
  EXPECT_EQ(link->status().fault, LinkFault::InterfaceDown);
  fake->set(up);
  EXPECT_FALSE(fake->isStarted());
  EXPECT_EQ(heard.state(), LinkState::Closed);
}

TEST_F(FollowedLink, PulledOutOrSetDownWhileItConnectsItIsClosed) {
  for (const bool pulled : {false, true}) {
    fake->setSilently(up);
    link->open(heard);
    fake->hold();
    fake->tell(fake->now());  // the news that it is there come before the answer, and it connects
    ASSERT_EQ(heard.state(), LinkState::Connecting);
    if (pulled) {
      fake->unplug();
    } else {
      fake->set(down);
    }
    EXPECT_EQ(heard.state(), LinkState::Closed);
    EXPECT_EQ(link->status().fault, pulled ? LinkFault::Gone : LinkFault::InterfaceDown);
    fake->release();
  }
}

// --- the kernel's network lock is held by somebody, and questions hang

TEST_F(FollowedLink, OpeningIsConnectingUntilTheKernelAnswersAndEventsGoOnMeanwhile) {
  fake->hold();
  link->open(heard);
  std::vector<std::string> order;
  for (int i = 0; i < 3; ++i) {
    QMetaObject::invokeMethod(
        link.get(), [&] { order.push_back("event"); }, Qt::QueuedConnection);
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return order.size() == 3; }, kPatience));
  EXPECT_EQ(heard.states, std::vector{LinkState::Connecting});
  EXPECT_EQ(link->write(frameOf(0x123, {})), WriteResult::NotOpen);
  fake->release();
  ASSERT_TRUE(waitFor(LinkState::Up));
}

TEST_F(FollowedLink, WhileAQuestionHangsFramesAndNewsComeAllTheSame) {
  open();
  fake->hold();
  fake->loseNews();
  ASSERT_TRUE(fake->isAsked());
  EXPECT_EQ(link->write(frameOf(0x123, {})), WriteResult::Accepted);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !heard.frames.empty(); }, kPatience));
  fake->set(down);
  EXPECT_EQ(heard.states, std::vector{LinkState::Lost});
}

TEST_F(FollowedLink, AnAnswerThatNewsHaveOvertakenChangesNothing) {
  open();
  fake->hold();
  fake->loseNews();  // asked while it is up ...
  fake->set(down);
  ASSERT_EQ(heard.states, std::vector{LinkState::Lost});
  fake->release();  // ... and answered after it went down
  // It is asked anew, and answers as it is now.
  fake->setSilently([](CanInterface& facts) { facts.sendErrors = 7; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return link->status().hardware->sendErrors == 7; }, kPatience));
  EXPECT_EQ(heard.states, std::vector{LinkState::Lost});
}

TEST_F(FollowedLink, ClosesAndIsDestroyedWhileAQuestionHangs) {
  fake->hold();
  link->open(heard);
  link->close();
  EXPECT_EQ(heard.states, (std::vector{LinkState::Connecting, LinkState::Closed}));
  fake->release();
  heard.forget();
  link->open(heard);
  ASSERT_TRUE(waitFor(LinkState::Up));
  EXPECT_EQ(heard.states, (std::vector{LinkState::Connecting, LinkState::Up}));
  fake->hold();
  fake->loseNews();
  heard.forget();
  link.reset();
  EXPECT_TRUE(heard.states.empty()) << "nothing is told by a destructor";
}

}  // namespace
}  // namespace deckpipe
