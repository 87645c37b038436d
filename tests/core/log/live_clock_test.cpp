// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/live_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "log/frame_store.h"

namespace deckpipe {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kWall = 1'700'000'000'000;  // ms since 1970 when CLOCK_BOOTTIME is 0
constexpr std::int64_t kNone = -1;  // a frame without a stamp, an adapter without the wall clock

struct Row {
  std::int64_t nowMs;
  std::int64_t stampMs;
  std::int64_t wallMs;  // CLOCK_REALTIME at nowMs; kNone where the stamps are not the wall clock
  std::int64_t timeMs;
  unsigned flags = 0;
  std::int64_t reachedMs = 0;
};

struct Case {
  const char* name;
  std::vector<Row> rows;
};

const Case kCases[] = {
    {"a frame that is handled late keeps its time",
     {{1000, kWall + 1000, kWall + 1000, 1000}, {1700, kWall + 1200, kWall + 1700, 1200}}},
    {"the wall clock is set ahead: log time goes on",
     {{1000, kWall + 1000, kWall + 1000, 1000},
      {1100, kWall + 3'601'100, kWall + 3'601'100, 1100, Frame::kTimeJump},
      {1200, kWall + 3'601'200, kWall + 3'601'200, 1200}}},
    {"the wall clock is set back: log time goes on",
     {{1000, kWall + 1000, kWall + 1000, 1000},
      {1100, kWall - 3'598'900, kWall - 3'598'900, 1100, Frame::kTimeJump},
      {1200, kWall - 3'598'800, kWall - 3'598'800, 1200}}},
    {"the wall clock is slewed by less than 10 ms: nothing changes",
     {{1000, kWall + 1000, kWall + 1000, 1000}, {1100, kWall + 1105, kWall + 1109, 1100}}},
    {"a frame is never later than its arrival",
     {{1000, kWall + 1000, kWall + 1000, 1000}, {1100, kWall + 1150, kWall + 1100, 1100}}},
    {"a frame from before what was shown takes the time that was shown, and is marked late",
     {{1000, kWall + 1000, kWall + 1000, 1000},
      {1700, kWall + 1200, kWall + 1700, 1600, Frame::kLate, 1600},
      {1700, kWall + 1650, kWall + 1700, 1650, 0, 1600}}},
    {"an adapter with a base of its own: the quickest arrival tells the offset",
     {{1000, 40, kNone, 1000}, {1090, 140, kNone, 1090}, {1250, 240, kNone, 1190}, {1300, 340, kNone, 1290}}},
    {"its counter wraps", {{1000, 5'000'000, kNone, 1000}, {1100, 3, kNone, 1100, Frame::kTimeJump}}},
    {"its clock stood still while the machine slept",
     {{1000, 40, kNone, 1000}, {3'601'000, 140, kNone, 3'601'000, Frame::kTimeJump}}},
    {"frames without stamps keep the time before for 100 ms",
     {{1000, kNone, kNone, 1000}, {1090, kNone, kNone, 1000}, {1101, kNone, kNone, 1101}}},
};

TEST(LiveClock, GivesEachFrameItsTime) {
  for (const Case& c : kCases) {
    FrameStore store;
    for (std::size_t i = 0; i < c.rows.size(); ++i) {
      SCOPED_TRACE(c.name);
      SCOPED_TRACE(i);
      const Row& row = c.rows[i];
      Frame frame;
      if (row.stampMs != kNone) frame.stamp = row.stampMs * kMs;
      Arrival arrival{.now = {row.nowMs * kMs}};
      if (row.wallMs != kNone) arrival.wallOffset = Duration{(row.nowMs - row.wallMs) * kMs};
      if (row.reachedMs != 0) arrival.reached = {row.reachedMs * kMs};
      ASSERT_TRUE(store.append({&frame, 1}, arrival));
      EXPECT_EQ(store.timeAt(i).ns, row.timeMs * kMs);
      EXPECT_EQ(store[i].flags, row.flags);
    }
  }
}

TEST(LiveClock, FollowsAnAdapterWhoseClockRunsSlower) {
  FrameStore store;
  // A millisecond in ten seconds, and each frame up to 3 ms late.
  std::mt19937 random(3);
  for (std::int64_t us = 0; us < 120'000'000; us += 20'000) {
    Frame frame;
    frame.stamp = (us - us / 10'000) * 1000;
    const std::int64_t now = us * 1000 + static_cast<std::int64_t>(random() % 3'000'000) + 5'000'000'000;
    ASSERT_TRUE(store.append({&frame, 1}, Arrival{{now}}));
    ASSERT_LE(store.lastTime().ns, now);
    ASSERT_GE(store.lastTime().ns, now - 8 * kMs);
    ASSERT_EQ(store[store.count() - 1].flags, 0);
  }
}

TEST(LiveClock, ChannelsHaveClocksOfTheirOwn) {
  FrameStore store;
  for (std::int64_t ms = 0; ms < 200; ++ms) {
    Frame a, b;
    a.stamp = ms * kMs;
    b.stamp = 77'000'000 * kMs + ms * kMs;
    b.channel = 1;
    ASSERT_TRUE(store.append(std::vector{a, b}, Arrival{{(1000 + ms) * kMs}}));
    EXPECT_EQ(store.lastTime().ns, (1000 + ms) * kMs);
  }
  EXPECT_EQ(store.jumps().size(), 0u);
}

TEST(LiveClock, SurvivesAnyStampsAndLookUpsAgreeWithItsTimes) {
  std::mt19937_64 random(11);
  FrameStore store;
  std::int64_t now = 1'000'000'000;
  for (int i = 0; i < 20'000; ++i) {
    now += static_cast<std::int64_t>(random() % 2'000'000);
    Frame frame;
    frame.channel = static_cast<std::uint8_t>(random() % 2);
    frame.stamp = random() % 50 == 0 ? static_cast<std::int64_t>(random()) : now + kWall * frame.channel;
    Arrival arrival{.now = {now}};
    if (random() % 2 == 0) arrival.wallOffset = Duration{-kWall};
    if (random() % 3 == 0) arrival.reached = {now - 100 * kMs};
    ASSERT_TRUE(store.append({&frame, 1}, arrival));
    ASSERT_LE(store.lastTime().ns, now);
  }
  std::vector<std::int64_t> all;
  LogTimes inOrder(store);
  for (std::uint64_t i = 0; i < store.count(); ++i) {
    all.push_back(store.timeAt(i).ns);
    ASSERT_EQ(inOrder.at(i).ns, all.back());
  }
  EXPECT_TRUE(std::ranges::is_sorted(all));
  for (std::uint64_t i = 0; i < all.size(); i += 7) {
    const auto first = std::ranges::lower_bound(all, all[i]) - all.begin();
    ASSERT_EQ(store.firstAtOrAfter({all[i]}), static_cast<std::uint64_t>(first));
  }
}

}  // namespace
}  // namespace deckpipe
