// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/fake_port.h"

#include <gtest/gtest.h>

#include "support/raw_frames.h"
#include "support/recording_listener.h"

namespace deckpipe {
namespace {

using namespace test;

const Frame kFrame = frameOf(0x123, {1, 2});

struct FakePortTest : ::testing::Test {
  FakePort port;
  RecordingListener heard;
  int flagsOf(std::size_t i) const { return heard.frames.at(i).flags; }
};

TEST_F(FakePortTest, EchoesOnceAndNotFromInsideWrite) {
  port.open(heard);
  EXPECT_EQ(heard.states, (std::vector{LinkState::Connecting, LinkState::Up}));
  port.setClock(77);
  EXPECT_EQ(port.write(kFrame), WriteResult::Accepted);
  EXPECT_TRUE(heard.frames.empty());
  port.deliver();
  port.deliver();
  ASSERT_EQ(heard.frames.size(), 1u);
  EXPECT_EQ(flagsOf(0), Frame::kSent | Frame::kConfirmed);
  EXPECT_EQ(heard.frames[0].stamp, 77);
  EXPECT_EQ(port.written(), std::vector{kFrame});
}

TEST_F(FakePortTest, WithoutEchoAFrameComesUnconfirmed) {
  port.setEchoing(false);
  port.open(heard);
  port.write(kFrame);
  port.deliver();
  ASSERT_EQ(heard.frames.size(), 1u);
  EXPECT_EQ(flagsOf(0), Frame::kSent);
  EXPECT_FALSE(port.echoes());
}

TEST_F(FakePortTest, HeldBusFillsTheQueueAndReleasesInOrder) {
  port.setQueue(2);
  port.holdBus();
  port.open(heard);
  EXPECT_EQ(port.write(frameOf(1, {})), WriteResult::Accepted);
  EXPECT_EQ(port.write(frameOf(2, {})), WriteResult::Accepted);
  EXPECT_EQ(port.write(frameOf(3, {})), WriteResult::QueueFull);
  EXPECT_EQ(port.attempts(), 3u);
  port.deliver();
  EXPECT_TRUE(heard.frames.empty());
  port.releaseBus(1);
  port.deliver();
  ASSERT_EQ(heard.frames.size(), 1u);
  EXPECT_EQ(heard.frames[0].id, 1u);
  EXPECT_EQ(port.waiting(), 1u);
  port.releaseBus();
  port.write(frameOf(4, {}));
  port.deliver();
  ASSERT_EQ(heard.frames.size(), 3u);
  EXPECT_EQ(heard.frames[2].id, 4u);
}

TEST_F(FakePortTest, RefusesAsManyWritesAsTold) {
  port.open(heard);
  port.refuseWrites(WriteResult::Failed, 1);
  EXPECT_EQ(port.write(kFrame), WriteResult::Failed);
  EXPECT_EQ(port.write(kFrame), WriteResult::Accepted);
  port.refuseWrites(WriteResult::QueueFull);
  EXPECT_EQ(port.write(kFrame), WriteResult::QueueFull);
  EXPECT_EQ(port.write(kFrame), WriteResult::QueueFull);
  port.acceptWrites();
  EXPECT_EQ(port.write(kFrame), WriteResult::Accepted);
}

TEST_F(FakePortTest, LostEchoLeavesTheFrameOnTheWire) {
  std::vector<Frame> wire;
  port.setWire([&](const Frame& frame) { wire.push_back(frame); });
  port.open(heard);
  port.loseEchoes(1);
  port.write(kFrame);
  port.deliver();
  EXPECT_EQ(wire.size(), 1u);
  EXPECT_TRUE(heard.frames.empty());
}

TEST_F(FakePortTest, LossKeepsItsPlaceAmongTheFrames) {
  port.open(heard);
  port.hear(frameOf(1, {}));
  port.miss(NotKept::Overflow, 7);
  port.hear(frameOf(2, {}));
  port.deliver();
  EXPECT_EQ(heard.batches, (std::vector<std::size_t>{1, 1}));
  EXPECT_EQ(heard.notKept, (std::vector{std::pair{NotKept::Overflow, 7u}}));
}

TEST_F(FakePortTest, LostLinkTakesNoWritesAndComesBack) {
  port.open(heard);
  port.holdBus();
  port.write(kFrame);
  port.lose("unplugged");
  EXPECT_EQ(heard.state(), LinkState::Lost);
  EXPECT_EQ(heard.reason(), "unplugged");
  EXPECT_EQ(port.write(kFrame), WriteResult::NotOpen);
  port.recover();
  port.releaseBus();
  port.deliver();
  EXPECT_EQ(heard.state(), LinkState::Up);
  EXPECT_TRUE(heard.frames.empty());
}

TEST_F(FakePortTest, OpeningMayFailOrTakeItsTime) {
  port.setOpening(LinkState::Closed, "no such adapter");
  port.open(heard);
  EXPECT_EQ(heard.state(), LinkState::Closed);
  EXPECT_EQ(heard.reason(), "no such adapter");
  port.setOpening(LinkState::Connecting);
  port.open(heard);
  EXPECT_EQ(port.write(kFrame), WriteResult::NotOpen);
  port.finishOpening();
  EXPECT_EQ(port.write(kFrame), WriteResult::Accepted);
}

TEST_F(FakePortTest, ClosingHandsOverTheRestAndIsTheLastWord) {
  port.open(heard);
  port.hear(kFrame);
  port.close();
  EXPECT_EQ(heard.frames.size(), 1u);
  EXPECT_EQ(heard.state(), LinkState::Closed);
  const auto told = heard.states.size();
  port.hear(kFrame);
  port.deliver();
  port.close();
  EXPECT_EQ(heard.frames.size(), 1u);
  EXPECT_EQ(heard.states.size(), told);
}

}  // namespace
}  // namespace deckpipe
