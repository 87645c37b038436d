// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/file_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "log/frame_store.h"

namespace deckpipe {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kNone = -1;  // a frame without a stamp

struct Stamp {
  std::int64_t ms;
  std::uint8_t channel = 0;
};

std::vector<Frame> framesOf(const std::vector<Stamp>& stamps) {
  std::vector<Frame> frames(stamps.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].channel = stamps[i].channel;
    if (stamps[i].ms != kNone) frames[i].stamp = stamps[i].ms * kMs;
  }
  return frames;
}

struct Timed {
  std::vector<std::int64_t> ms;
  std::vector<std::uint64_t> jumps;
};

Timed timedOf(const FrameStore& store) {
  Timed timed;
  LogTimes inOrder(store);
  for (std::uint64_t i = 0; i < store.count(); ++i) {
    timed.ms.push_back(store.timeAt(i).ns / kMs);
    EXPECT_EQ(inOrder.at(i), store.timeAt(i));
    if ((store[i].flags & Frame::kTimeJump) != 0) timed.jumps.push_back(i);
  }
  return timed;
}

constexpr std::int64_t kHour = 3'600'000;
constexpr std::int64_t kDay = 24 * kHour;

struct Row {
  const char* name;
  std::vector<Stamp> stamps;
  Timed timed;
};

const Row kRows[] = {
    {"back by 100 ms is no step", {{1000}, {900}, {1100}}, {{1000, 1000, 1100}, {}}},
    {"back by more than 100 ms begins a piece", {{1000}, {850}, {880}}, {{1000, 1000, 1030}, {1}}},
    {"back at the very end holds", {{1000}, {5}}, {{1000, 1000}, {1}}},
    {"forward by an hour is time", {{1000}, {1000 + kHour}}, {{1000, 1000 + kHour}, {}}},
    {"forward by more than an hour is time, and marked",
     {{990}, {1000}, {1001 + kHour}, {1002 + kHour}, {1003 + kHour}, {1004 + kHour}},
     {{990, 1000, 1001 + kHour, 1002 + kHour, 1003 + kHour, 1004 + kHour}, {2}}},
    {"a first stamp that three refute is followed at once",
     {{7}, {116 * kDay}, {116 * kDay + 100}, {116 * kDay + 200}, {116 * kDay + 300}},
     {{7, 7, 107, 207, 307}, {1}}},
    {"a first stamp ahead that three refute is followed at once",
     {{116 * kDay}, {7}, {107}, {207}, {307}},
     {{116 * kDay, 116 * kDay, 116 * kDay + 100, 116 * kDay + 200, 116 * kDay + 300}, {1}}},
    {"a first stamp that two refute is a time", {{7}, {116 * kDay}, {116 * kDay + 100}}, {{7, 7, 7}, {1, 2}}},
    {"a first stamp with which another channel agrees is a time",
     {{kDay, 0},
      {kDay + 5, 1},
      {kDay + kHour + 100, 0},
      {kDay + kHour + 200, 0},
      {kDay + kHour + 300, 0},
      {kDay + kHour + 400, 0}},
     {{kDay, kDay + 5, kDay + kHour + 100, kDay + kHour + 200, kDay + kHour + 300, kDay + kHour + 400}, {2}}},
    {"a first stamp of a second channel that three refute is followed at once",
     {{kDay, 0}, {kDay + 50, 0}, {3, 1}, {kDay + 100, 1}, {kDay + 200, 1}, {kDay + 300, 1}, {kDay + 400, 1}},
     {{kDay, kDay + 50, kDay + 50, kDay + 50, kDay + 150, kDay + 250, kDay + 350}, {3}}},
    {"a lone stamp ahead at the very end has no time", {{0}, {100}, {116 * kDay}}, {{0, 100, 100}, {2}}},
    {"two stamps ahead at the very end have no time",
     {{0}, {100}, {116 * kDay}, {116 * kDay + 7}},
     {{0, 100, 100, 100}, {2, 3}}},
    {"two stamps ahead have no time",
     {{0}, {116 * kDay}, {116 * kDay + 7}, {200}, {300}},
     {{0, 0, 0, 200, 300}, {1, 2}}},
    {"a stamp ahead that only another channel follows has no time",
     {{0, 0}, {0, 1}, {116 * kDay, 0}, {100, 1}, {200, 1}, {300, 1}, {400, 1}},
     {{0, 0, 0, 100, 200, 300, 400}, {2}}},
    {"a lone stamp ahead has no time", {{0}, {116 * kDay}, {200}, {60'300}}, {{0, 0, 200, 60'300}, {1}}},
    {"a lone stamp back has no time", {{kDay}, {7}, {kDay + 200}}, {{kDay, kDay, kDay + 200}, {1}}},
    {"the clock is set back an hour",
     {{0 + kDay}, {1000 + kDay}, {kDay - kHour}, {kDay - kHour + 58'000}},
     {{kDay, kDay + 1000, kDay + 1000, kDay + 59'000}, {2}}},
    {"the clock is set back and returns to where it stopped",
     {{14 * kDay}, {14 * kDay + 100}, {10}, {110}, {14 * kDay + 200}, {14 * kDay + 300}},
     {{14 * kDay, 14 * kDay + 100, 14 * kDay + 100, 14 * kDay + 200, 14 * kDay + 200, 14 * kDay + 300},
      {2, 4}}},
    {"the clock is set back for a minute and returns to the true time",
     {{14 * kDay}, {10}, {60'010}, {14 * kDay + 60'100}, {14 * kDay + 60'200}},
     {{14 * kDay, 14 * kDay, 14 * kDay + 60'000, 14 * kDay + 60'100, 14 * kDay + 60'200}, {1, 3}}},
    {"two channels a microsecond out of order are no step",
     {{100, 0}, {99, 1}, {200, 0}, {199, 1}},
     {{100, 100, 200, 200}, {}}},
    {"a channel that begins more than an hour away begins now",
     {{kDay, 0}, {kDay + 50, 0}, {3, 1}, {kDay + 100, 0}, {103, 1}},
     {{kDay, kDay + 50, kDay + 50, kDay + 100, kDay + 150}, {}}},
    {"a channel that begins within the hour keeps its stamps",
     {{kDay, 0}, {kDay - 500, 1}, {kDay + 700, 1}},
     {{kDay, kDay, kDay + 700}, {}}},
    {"a step of one channel is none of the other",
     {{kDay, 0}, {kDay, 1}, {kDay - kHour, 0}, {kDay + 50, 1}, {kDay - kHour + 100, 0}},
     {{kDay, kDay, kDay, kDay + 50, kDay + 100}, {2}}},
    {"frames without stamps keep the time before",
     {{kNone}, {5}, {kNone}, {1}, {kNone}},
     {{0, 5, 5, 5, 5}, {}}},
    {"nothing is below zero", {{-500}, {-400}, {2}}, {{0, 0, 2}, {}}},
};

TEST(FileClock, GivesEachFrameItsTimeAndEachStepOneMark) {
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.name);
    FrameStore store;
    ASSERT_TRUE(store.append(framesOf(row.stamps)));
    const Timed timed = timedOf(store);
    EXPECT_EQ(timed.ms, row.timed.ms);
    EXPECT_EQ(timed.jumps, row.timed.jumps);
  }
}

TEST(FileClock, DoesNotDependOnHowTheFileIsCut) {
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.name);
    for (std::size_t piece = 1; piece <= row.stamps.size(); ++piece) {
      FrameStore store;
      std::uint64_t published = 0;
      std::vector<std::int64_t> seen;
      const std::vector<Frame> frames = framesOf(row.stamps);
      for (std::size_t from = 0; from < frames.size(); from += piece) {
        const std::span<const Frame> part =
            std::span(frames).subspan(from, std::min(piece, frames.size() - from));
        ASSERT_TRUE(store.append(part, Follows::More));
        for (; published < store.count(); ++published) seen.push_back(store.timeAt(published).ns / kMs);
      }
      ASSERT_TRUE(store.append({}, Follows::Nothing));
      const Timed timed = timedOf(store);
      EXPECT_EQ(timed.ms, row.timed.ms) << "pieces of " << piece;
      EXPECT_EQ(timed.jumps, row.timed.jumps) << "pieces of " << piece;
      seen.insert(seen.end(), timed.ms.begin() + static_cast<std::ptrdiff_t>(published), timed.ms.end());
      EXPECT_EQ(seen, timed.ms) << "what was published did not change";
    }
  }
}

TEST(FileClock, HoldsNoMoreFramesBackThanItLooksAhead) {
  FrameStore store;
  ASSERT_TRUE(store.append(framesOf({{kDay, 0}, {5, 0}}), Follows::More));
  EXPECT_EQ(store.count(), 1u) << "the step is not decided yet";
  const std::vector<Frame> others = framesOf({{kDay, 1}});
  for (std::size_t i = 1; i < FileClock::kLookAhead; ++i) ASSERT_TRUE(store.append(others, Follows::More));
  EXPECT_EQ(store.count(), 1u);
  ASSERT_TRUE(store.append(others, Follows::More));
  EXPECT_EQ(store.count(), 2 + FileClock::kLookAhead) << "no stamp undid it: it holds";
  EXPECT_EQ(store.timeAt(1).ns, kDay * kMs);
}

TEST(FileClock, SurvivesAnyStamps) {
  std::mt19937_64 random(5);
  std::vector<Frame> frames(20'000);
  for (Frame& frame : frames) {
    frame.channel = static_cast<std::uint8_t>(random() % 3);
    frame.stamp = static_cast<std::int64_t>(random());
    if (random() % 4 != 0) frame.stamp %= kDay * kMs;
  }
  FrameStore store;
  ASSERT_TRUE(store.append(frames));
  EXPECT_EQ(store.count(), frames.size());
  const Timed timed = timedOf(store);
  EXPECT_TRUE(std::ranges::is_sorted(timed.ms));
}

}  // namespace
}  // namespace deckpipe
