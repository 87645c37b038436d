// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/events.h"

#include <gtest/gtest.h>

#include "event_story.h"
#include "state/log_view.h"

namespace deckpipe {
namespace {

// A monitor that is disabled and enabled once a minute, for so many frames.
void fillLog(LogDocument& log, std::uint64_t frames) {
  std::vector<Frame> batch;
  for (std::uint64_t i = 0; i < frames; ++i)
    batch.push_back(test::frame("18EFFF80", i / 600 % 2 == 0 ? "83C051" : "834051", 0,
                                static_cast<std::int64_t>(i) * 100'000'000));
  ASSERT_TRUE(log.frames.append(batch));
}

TEST(Events, AreFoundInStepsThatMakeTheKeyframes) {
  LogDocument log;
  fillLog(log, Keyframes::kEvery + 1000);
  const Cursor end = cursorAfter(log.frames, log.frames.count());
  int steps = 0;
  while (log.events.build(end)) ++steps;
  EXPECT_EQ(steps, 2);
  EXPECT_EQ(log.events.count(), log.frames.count() / 600);
  EXPECT_EQ(log.keyframes.count(), 1u);
  EXPECT_FALSE(log.keyframes.build());
  State plain;
  advance(plain, log.frames, log.notes, cursorAfter(log.frames, Keyframes::kEvery + 77));
  EXPECT_EQ(log.keyframes.at(plain.cursor()), plain);
}

TEST(Events, GoOnWithALogThatGrows) {
  LogDocument log;
  ASSERT_TRUE(log.frames.append(std::vector{test::frame("18EFFF80", "83C051", 0, 0)}));
  EXPECT_TRUE(log.events.build({1, {}}));
  EXPECT_FALSE(log.events.build({1, {}}));
  ASSERT_TRUE(log.frames.append(std::vector{test::frame("18EFFF80", "834051", 0, 100'000'000)}));
  EXPECT_TRUE(log.events.build({2, Instant{100'000'000}}));
  EXPECT_EQ(test::linesOf(log.events.after(0)), (std::vector<std::string>{"0.100 disabled 80"}));
  // No frame comes, but time goes on.
  EXPECT_TRUE(log.events.build({2, Instant{9'000'000'000}}));
  EXPECT_EQ(test::linesOf(log.events.after(1)), (std::vector<std::string>{"3.100 silent 80 since 0.100"}));
  EXPECT_TRUE(log.events.after(99).empty());
}

TEST(Events, EndWithTheListAPersonReads) {
  LogDocument log;
  std::vector<Frame> batch;
  for (std::uint64_t i = 0; i <= Events::kMax; ++i) {
    batch.push_back(test::frame("18EFFF80", i % 2 == 0 ? "83C051" : "834051", 0,
                                static_cast<std::int64_t>(i) * 10'000'000'000));
  }
  ASSERT_TRUE(log.frames.append(batch));
  while (log.events.build(cursorAfter(log.frames, log.frames.count()))) {
  }
  EXPECT_TRUE(log.events.isFull());
  EXPECT_EQ(log.events.count(), Events::kMax);
}

}  // namespace
}  // namespace deckpipe
