// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/link_delivery.h"

#include <gtest/gtest.h>

#include <functional>

#include "link/link_device.h"
#include "support/raw_frames.h"
#include "support/recording_listener.h"

namespace deckpipe {
namespace {

using namespace test;

constexpr std::int64_t kTime = 1'234'567;  // ns

QCanBusFrame echoOf(const Frame& frame) {
  QCanBusFrame out = toCanBusFrame(frame);
  out.setLocalEcho(true);
  return out;
}
QCanBusFrame flexible() { return QCanBusFrame(0x102, QByteArray(64, 'b')); }

const char* wordOf(NotKept reason) {
  switch (reason) {
    case NotKept::FlexibleDataRate: return "flexible";
    case NotKept::Invalid: return "invalid";
    case NotKept::Overflow: return "overflow";
    case NotKept::Overrun: return "overrun";
  }
  return "?";
}

// What the listener was told, in order: "101" a frame, "+" behind an own one, "++" if confirmed; losses by
// their number.
struct Story : PortListener {
  std::vector<std::string> told;
  std::function<void()> onFrames = [] {};
  void framesReceived(std::span<const Frame> frames) override {
    for (const Frame& frame : frames) {
      std::string line = QString::number(frame.id, 16).toStdString();
      if ((frame.flags & Frame::kSent) != 0) line += '+';
      if ((frame.flags & Frame::kConfirmed) != 0) line += '+';
      told.push_back(line);
    }
    onFrames();
  }
  void framesNotKept(NotKept reason, std::uint32_t count) override {
    told.push_back(std::string(wordOf(reason)) + ' ' + std::to_string(count));
  }
  void linkChanged(LinkState, const std::string& reason) override { told.push_back(reason); }
};
using Lines = std::vector<std::string>;

struct Delivery : ::testing::Test {
  LinkStatus status;
  Story story;
  LinkDelivery echoing{Channel{3}, true, status};
  LinkDelivery silent{Channel{3}, false, status};
};

TEST_F(Delivery, IsInOrderOfArrivalWithEachLossAtItsPlace) {
  echoing.begin(story);
  EXPECT_TRUE(echoing.isEmpty());
  echoing.take(toCanBusFrame(frameOf(0x101, {})));
  echoing.take(flexible());
  echoing.take(toCanBusFrame(frameOf(0x103, {})));
  echoing.dropped(2);
  echoing.dropped(3);
  echoing.overran(4);
  EXPECT_TRUE(story.told.empty());
  echoing.handOver();
  EXPECT_EQ(story.told, (Lines{"101", "flexible 1", "103", "overflow 5", "overrun 4"}));
  EXPECT_EQ(status.received, 2u);
  EXPECT_EQ(status.notKept, 10u);
  EXPECT_TRUE(echoing.isEmpty());
  echoing.handOver();
  EXPECT_EQ(story.told.size(), 5u);
}

TEST_F(Delivery, WithEchoAnOwnFrameComesOnItsEchoConfirmed) {
  echoing.begin(story);
  echoing.wrote(frameOf(0x101, {1}), kTime);
  EXPECT_TRUE(echoing.isEmpty());
  echoing.take(echoOf(frameOf(0x101, {1})));
  echoing.handOver();
  EXPECT_EQ(story.told, Lines{"101++"});
  EXPECT_EQ(status.written, 1u);
  EXPECT_EQ(status.confirmed, 1u);
  EXPECT_EQ(status.received, 0u);
}

TEST_F(Delivery, WithoutEchoAnOwnFrameComesOnceThoughThePluginEchoesAllTheSame) {
  RecordingListener heard;
  silent.begin(heard);
  silent.wrote(frameOf(0x101, {1}), kTime);
  silent.take(echoOf(frameOf(0x101, {1})));
  silent.handOver();
  ASSERT_EQ(heard.frames.size(), 1u);
  EXPECT_EQ(heard.frames[0].flags, Frame::kSent);
  EXPECT_EQ(heard.frames[0].stamp, kTime);
  EXPECT_EQ(heard.frames[0].channel, 3);
  EXPECT_EQ(status.confirmed, 0u);
}

TEST_F(Delivery, WhatIsClearedIsNotHandedOver) {
  echoing.begin(story);
  echoing.take(toCanBusFrame(frameOf(0x101, {})));
  echoing.take(flexible());
  echoing.dropped(1);
  echoing.wrote(frameOf(0x102, {}), kTime);
  echoing.clear();
  EXPECT_TRUE(echoing.isEmpty());
  echoing.handOver();
  EXPECT_TRUE(story.told.empty());
}

TEST_F(Delivery, FramesWrittenFromInsideComeWithTheNextHandOver) {
  silent.begin(story);
  silent.take(toCanBusFrame(frameOf(0x101, {})));
  silent.take(flexible());
  story.onFrames = [&] {
    if (story.told.size() == 1) silent.wrote(frameOf(0x555, {}), kTime);
  };
  silent.handOver();
  EXPECT_EQ(story.told, (Lines{"101", "flexible 1"}));
  silent.handOver();
  EXPECT_EQ(story.told, (Lines{"101", "flexible 1", "555+"}));
}

// The rest of what was handed over belongs to neither: one listener closed, the other opened later.
TEST_F(Delivery, AListenerThatEndsFromInsideHearsNoMoreAndTheNextOneNothingOfIt) {
  Story later;
  echoing.begin(story);
  echoing.take(toCanBusFrame(frameOf(0x101, {})));
  echoing.take(flexible());
  echoing.take(toCanBusFrame(frameOf(0x103, {})));
  echoing.dropped(1);
  story.onFrames = [&] {
    EXPECT_EQ(echoing.end(), &story);
    echoing.begin(later);
  };
  echoing.handOver();
  EXPECT_EQ(story.told, Lines{"101"});
  echoing.handOver();
  EXPECT_TRUE(later.told.empty());
}

TEST_F(Delivery, WithoutAListenerNobodyIsTold) {
  echoing.tell(LinkState::Up, "up");
  echoing.begin(story);
  echoing.tell(LinkState::Lost, "lost");
  echoing.end();
  EXPECT_FALSE(echoing.hasListener());
  echoing.tell(LinkState::Up, "up");
  echoing.handOver();
  EXPECT_EQ(story.told, Lines{"lost"});
}

}  // namespace
}  // namespace deckpipe
