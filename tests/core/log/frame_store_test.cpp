// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/frame_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <random>
#include <thread>
#include <vector>

namespace deckpipe {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

Frame stamped(std::int64_t stamp, std::uint8_t channel = 0) {
  Frame frame;
  frame.stamp = stamp;
  frame.channel = channel;
  return frame;
}

std::vector<std::int64_t> times(const FrameStore& store) {
  std::vector<std::int64_t> all;
  for (std::uint64_t i = 0; i < store.count(); ++i) all.push_back(store.timeAt(i).ns);
  return all;
}

std::vector<std::uint64_t> jumps(const FrameStore& store) {
  std::vector<std::uint64_t> all;
  for (std::uint64_t i = 0; i < store.count(); ++i) {
    if (store[i].flags & Frame::kTimeJump) all.push_back(i);
  }
  return all;
}

void append(FrameStore& store, const std::vector<Frame>& frames) { ASSERT_TRUE(store.append(frames)); }

TEST(FrameStore, HasTimesWhereAnyFrameHasOne) {
  const Frame without = stamped(kNoStamp);
  FrameStore empty, timeless, laterOnes, atZero, live;
  append(timeless, {without, without});
  append(laterOnes, {without, stamped(kSecond)});
  append(atZero, {stamped(0)});
  ASSERT_TRUE(live.append({&without, 1}, Arrival{Instant{kSecond}}));
  EXPECT_TRUE(empty.hasTimes());
  EXPECT_FALSE(timeless.hasTimes());
  EXPECT_TRUE(laterOnes.hasTimes());
  EXPECT_FALSE(atZero.hasTimes()) << "a stamp of 0 alone says nothing";
  EXPECT_TRUE(live.hasTimes()) << "of a driver that gives no stamps";
}

TEST(FrameStore, GivesBackWhatWasAppendedAcrossChunks) {
  FrameStore store;
  constexpr std::uint64_t n = 3 * FrameStore::kChunkFrames + 17;
  std::vector<Frame> frames(n);
  for (std::uint64_t i = 0; i < n; ++i) {
    frames[i].stamp = static_cast<std::int64_t>(i);
    frames[i].id = static_cast<std::uint32_t>(i * 7);
  }
  const std::span<const Frame> all = frames;
  append(store, {frames.begin(), frames.begin() + 5});
  const Frame* const first = &store[0];
  ASSERT_TRUE(store.append(all.subspan(5)));

  EXPECT_EQ(store.count(), n);
  EXPECT_EQ(&store[0], first) << "frames never move";
  std::uint64_t seen = 0;
  for (auto run = store.run(0); !run.empty(); run = store.run(seen)) {
    EXPECT_TRUE(std::equal(run.begin(), run.end(), frames.begin() + static_cast<std::ptrdiff_t>(seen)));
    EXPECT_LE(run.size(), FrameStore::kChunkFrames);
    seen += run.size();
  }
  EXPECT_EQ(seen, n);
  EXPECT_EQ(store.run(FrameStore::kChunkFrames - 3).size(), 3u);
  EXPECT_TRUE(store.run(n).empty());
}

TEST(FrameStore, TimeOfAFileIsTheRunningMaximumOfItsStampsWhereNoClockSteps) {
  FrameStore store;
  append(store, {Frame{}, stamped(5 * kSecond), Frame{}, stamped(5 * kSecond - 100'000'000),
                 stamped(6 * kSecond), Frame{}});
  EXPECT_EQ(times(store),
            (std::vector<std::int64_t>{0, 5 * kSecond, 5 * kSecond, 5 * kSecond, 6 * kSecond, 6 * kSecond}));
  EXPECT_EQ(store.lastTime().ns, 6 * kSecond);
}

TEST(FrameStore, TimeNeverStartsBelowZero) {
  FrameStore store;
  append(store, {stamped(-5), stamped(-3), stamped(2)});
  EXPECT_EQ(times(store), (std::vector<std::int64_t>{0, 0, 2}));
}

TEST(FrameStore, EmptyHasTimeZeroAndNoFirst) {
  const FrameStore store;
  EXPECT_EQ(store.lastTime().ns, 0);
  EXPECT_EQ(store.firstAtOrAfter({5}), 0u);
  EXPECT_EQ(store.firstAfter(kNever), 0u);
}

TEST(FrameStore, DecidesItselfWhatIsATimeJump) {
  Frame claims = stamped(7);
  claims.flags = Frame::kTimeJump | Frame::kSent;
  FrameStore store;
  append(store, {claims});
  EXPECT_EQ(store[0].flags, Frame::kSent);
}

// What the header says, frame by frame, without any index.
std::vector<std::int64_t> plainTimes(const std::vector<Frame>& frames) {
  std::vector<std::int64_t> all;
  std::int64_t time = 0;
  for (const Frame& frame : frames) {
    if (frame.hasStamp()) time = std::max(time, frame.stamp);
    all.push_back(time);
  }
  return all;
}

std::vector<Frame> disorderlyFrames(std::uint64_t n) {
  std::mt19937_64 random(7);
  std::vector<Frame> frames(n);
  std::int64_t stamp = 1000;
  for (Frame& frame : frames) {
    const auto dice = random() % 100;
    stamp += static_cast<std::int64_t>(random() % 1000) * (dice < 90 ? 1 : -3);  // never a step of the clock
    if (dice != 50) frame.stamp = stamp;
  }
  return frames;
}

TEST(FrameStore, TimesAndLookUpsAgreeWithAPlainScan) {
  const std::vector<Frame> frames = disorderlyFrames(2 * FrameStore::kChunkFrames + 1234);
  const std::vector<std::int64_t> expected = plainTimes(frames);
  FrameStore store;
  append(store, frames);

  LogTimes inOrder(store);
  std::mt19937_64 random(9);
  for (std::uint64_t i = 0; i < frames.size(); ++i) {
    ASSERT_EQ(inOrder.at(i).ns, expected[i]) << i;
    if (i % 97 == 0) {
      ASSERT_EQ(store.timeAt(i).ns, expected[i]) << i;
    }
  }
  LogTimes anyOrder(store);
  for (int k = 0; k < 5000; ++k) {
    const std::uint64_t i = random() % frames.size();
    ASSERT_EQ(anyOrder.at(i).ns, expected[i]);
    ASSERT_EQ(anyOrder.at(i).ns, expected[i]) << "the same again";
    const std::int64_t t = expected[i] + static_cast<std::int64_t>(random() % 3) - 1;
    const auto first = [&](auto found) { return static_cast<std::uint64_t>(found - expected.begin()); };
    ASSERT_EQ(store.firstAtOrAfter({t}), first(std::lower_bound(expected.begin(), expected.end(), t)));
    ASSERT_EQ(store.firstAfter({t}), first(std::upper_bound(expected.begin(), expected.end(), t)));
  }
  EXPECT_EQ(store.firstAtOrAfter({expected.back() + 1}), frames.size());
  EXPECT_EQ(store.firstAfter(kNever), frames.size());
  EXPECT_EQ(store.firstAtOrAfter(kNotYet), 0u);
}

TEST(FrameStore, RestoredFromFramesAndOffsetsHasTheSameTimesAndMarks) {
  FrameStore store;
  std::int64_t now = kSecond;
  for (int i = 0; i < 100; ++i) {
    now += kSecond;
    const Frame frame = i % 7 == 0 ? Frame{} : stamped(i < 50 ? now / 3 : now / 5, i % 2 ? 1 : 0);
    ASSERT_TRUE(store.append({&frame, 1}, Arrival{.now = Instant{now}, .reached = Instant{now - kSecond}}));
  }
  ASSERT_FALSE(jumps(store).empty());
  std::vector<ClockOffset> offsets;
  for (std::uint8_t channel = 0; channel < 2; ++channel) {
    const auto* list = store.offsets(channel);
    ASSERT_NE(list, nullptr);
    for (std::size_t i = 0; i < list->size(); ++i) offsets.push_back((*list)[i]);
  }
  EXPECT_EQ(store.offsets(2), nullptr);
  std::ranges::sort(offsets, {}, &ClockOffset::frame);

  FrameStore restored;
  std::span<const ClockOffset> rest(offsets);
  for (std::uint64_t i = 0; i < 100;) {  // in pieces
    const std::uint64_t to = std::min<std::uint64_t>(i + 30, 100);
    ASSERT_TRUE(restored.restore(store.run(i).first(to - i), rest));
    while (!rest.empty() && rest.front().frame < to) rest = rest.subspan(1);
    i = to;
  }
  EXPECT_EQ(times(restored), times(store));
  EXPECT_EQ(jumps(restored), jumps(store));
}

TEST(FrameStore, LookUpsAgreeWithTheTimesOfALiveLogThatJumps) {
  std::mt19937_64 random(11);
  FrameStore store;
  std::int64_t now = kSecond, clock[2] = {0, 1'700'000'000 * kSecond};
  for (int i = 0; i < 20'000; ++i) {
    const std::int64_t step = static_cast<std::int64_t>(random() % 2'000'000);
    const auto channel = static_cast<std::uint8_t>(random() % 2);
    now += step;
    for (std::int64_t& c : clock) c += step;
    if (random() % 500 == 0)
      clock[channel] += static_cast<std::int64_t>(random() % 100) * kSecond - 50 * kSecond;
    const Frame frame = random() % 10 == 0 ? Frame{} : stamped(clock[channel], channel);
    ASSERT_TRUE(store.append({&frame, 1}, Arrival{Instant{now}}));
  }
  EXPECT_FALSE(jumps(store).empty());
  const std::vector<std::int64_t> all = times(store);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  for (std::uint64_t i = 0; i < all.size(); i += 7) {
    const auto first = std::lower_bound(all.begin(), all.end(), all[i]) - all.begin();
    ASSERT_EQ(store.firstAtOrAfter({all[i]}), static_cast<std::uint64_t>(first));
  }
}

TEST(FrameStore, IndexTakesLessThanFivePercentOfTheFrames) {
  FrameStore store;
  append(store, std::vector<Frame>(20 * FrameStore::kChunkFrames));
  EXPECT_LT(static_cast<double>(store.indexBytes()),
            0.05 * static_cast<double>(store.count() * sizeof(Frame)));
}

TEST(FrameStore, FramesBeyondTheMemoryBudgetLieOnDiskAndReadTheSame) {
  const std::vector<Frame> frames = disorderlyFrames(9 * FrameStore::kChunkFrames);
  FrameStore store({.memoryBytes = 8 << 20, .spillFolder = testing::TempDir()});
  append(store, frames);
  EXPECT_GT(store.spilledBytes(), 0u);
  EXPECT_LT(store.spilledBytes(), 10u * FrameStore::kChunkFrames * sizeof(Frame))
      << "the first chunks are in memory";
  ASSERT_EQ(store.count(), frames.size());
  const std::vector<std::int64_t> expected = plainTimes(frames);
  for (std::uint64_t i = 0; i < frames.size(); i += 101) {
    ASSERT_EQ(store[i].stamp, frames[i].stamp);
    ASSERT_EQ(store.timeAt(i).ns, expected[i]);
  }
}

TEST(FrameStore, SaysSoWhereThereIsNoRoomAndKeepsWhatFitted) {
  FrameStore store({.memoryBytes = 0, .spillFolder = "/nonexistent"});
  EXPECT_FALSE(store.append(std::vector<Frame>(5)));
  EXPECT_EQ(store.count(), 0u);

  FrameStore part({.memoryBytes = 8 << 20, .spillFolder = "/nonexistent"});
  EXPECT_FALSE(part.append(std::vector<Frame>(6 * FrameStore::kChunkFrames)));
  EXPECT_EQ(part.count(), 4 * FrameStore::kChunkFrames);
}

TEST(FrameStore, ChannelNamesKeepTheirIndex) {
  FrameStore store;
  EXPECT_EQ(store.channel("can0"), 0);
  EXPECT_EQ(store.channel("can1"), 1);
  EXPECT_EQ(store.channel("can0"), 0);
  EXPECT_EQ(store.channelName(1), "can1");
  EXPECT_EQ(store.channelName(2), "");
  EXPECT_EQ(store.channelCount(), 2u);
}

TEST(FrameStore, ChannelNamesBeyondTheLastShareOneIndex) {
  FrameStore store;
  for (int i = 0; i < 1000; ++i) store.channel("can" + std::to_string(i));
  EXPECT_EQ(store.channel("can254"), 254);
  EXPECT_EQ(store.channel("can255"), FrameStore::kOtherChannels);
  EXPECT_EQ(store.channel("can999"), FrameStore::kOtherChannels);
  EXPECT_EQ(store.channelName(FrameStore::kOtherChannels), FrameStore::kOtherChannelsName);
  EXPECT_EQ(store.channelCount(), 256u);
}

TEST(FrameStore, ReadersSeeWholeFramesWhileItGrows) {
  FrameStore store;
  std::atomic<bool> done = false;
  constexpr std::uint64_t n = 3 * FrameStore::kChunkFrames;
  std::thread writer([&] {
    Frame frame;
    for (std::uint64_t i = 0; i < n; ++i) {
      const auto step = static_cast<std::int64_t>(i) * 1000;
      // The clock is set forward now and then, so that offsets are read while they are added.
      frame.stamp = step + static_cast<std::int64_t>(i / 10'000) * kSecond;
      frame.id = static_cast<std::uint32_t>(i);
      frame.data = std::bit_cast<Payload>(i);
      if (!store.append({&frame, 1}, Arrival{Instant{kSecond + step}})) break;
      if (i % 50'000 == 0) store.channel("can" + std::to_string(i));
    }
    done = true;
  });
  std::uint64_t seen = 0, wrong = 0;
  std::mt19937_64 random(3);
  while (!done || seen < store.count()) {
    const std::uint64_t count = store.count();
    if (count == 0) continue;
    for (; seen < count; ++seen)
      wrong += store[seen].id != seen || std::bit_cast<std::uint64_t>(store[seen].data) != seen;
    const std::uint64_t i = random() % count;
    const Instant time = store.timeAt(i);
    wrong += time.ns != kSecond + static_cast<std::int64_t>(i) * 1000;
    wrong += store.firstAtOrAfter(time) != i;
    for (std::size_t c = 0; c < store.channelCount(); ++c)
      wrong += store.channelName(static_cast<std::uint8_t>(c)).empty();
  }
  writer.join();
  EXPECT_EQ(seen, n);
  EXPECT_EQ(wrong, 0u);
}

TEST(FrameStore, ListsTheFramesWhereTheClockJumps) {
  FrameStore store;
  append(store, {stamped(10 * kSecond), stamped(11 * kSecond), stamped(5 * kSecond), stamped(6 * kSecond),
                 stamped(90'000 * kSecond)});
  ASSERT_EQ(store.jumps().size(), 2u);
  EXPECT_EQ(store.jumps()[0], 2u);
  EXPECT_EQ(store.jumps()[1], 4u);
  EXPECT_EQ(jumps(store), (std::vector<std::uint64_t>{2, 4}));
}

}  // namespace
}  // namespace deckpipe
