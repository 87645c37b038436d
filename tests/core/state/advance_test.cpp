// SPDX-License-Identifier: GPL-3.0-or-later
// The state at a frame is the same however one got there.
#include "state/advance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "protocol/samples.h"
#include "state/keyframes.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

// A log of every sample from changing addresses, with silences of all lengths, notes, and claims that
// collide.
class AnyLog : public testing::Test {
 protected:
  void fill(std::uint32_t seed, std::size_t frames) {
    std::mt19937 random(seed);
    constexpr Duration kSteps[] = {0ns, 100us, 5ms, 20ms, 99ms, 200ms, 250ms, 300ms, 301ms, 1s, 3s};
    std::int64_t stamp = 0;
    std::vector<Frame> batch;
    for (std::size_t i = 0; i < frames; ++i) {
      const Sample& sample = kSamples[random() % std::size(kSamples)];
      Frame f = test::frame(sample.id, sample.data, static_cast<std::uint8_t>(random() % 5));
      if (f.isExtended() && random() % 2 == 0) f.id = (f.id & ~0xFFu) | (0x80 + random() % 4);
      if (sample.message == MessageId::Name && random() % 2 == 0)
        f.data[0] = static_cast<std::uint8_t>(random());
      stamp += kSteps[random() % (random() % 4 == 0 ? std::size(kSteps) : 3)].count();
      f.stamp = stamp;
      batch.push_back(f);
    }
    ASSERT_TRUE(m_frames.append(batch));
    for (std::uint64_t i = 0; i < frames; i += 1 + random() % 97) {
      const Channel channel{static_cast<std::uint8_t>(random() % 4)};
      const Address address{static_cast<std::uint8_t>(0x80 + random() % 4)};
      const NoteValue any[] = {note::LinkUp{channel},   note::LinkDown{channel, {}, {}},
                               note::Unlocked{channel}, note::Locked{channel},
                               note::Mark{"here"},      note::DriveSaid{channel, address, true},
                               note::Dropped{channel},  note::DriveSaid{channel, address, false}};
      m_notes.append({.frame = i,
                      .time = i == 0 ? Instant{} : m_frames.timeAt(i - 1),
                      .value = any[random() % std::size(any)]});
    }
  }
  Cursor randomCursor(std::mt19937& random) const {
    const std::uint64_t n = random() % (m_frames.count() + 1);
    if (n == 0) return {0, {}};
    // Anywhere in the silence behind frame n.
    const Instant from = m_frames.timeAt(n - 1);
    const Instant to = n < m_frames.count() ? m_frames.timeAt(n) : from + 5s;
    const auto gap = std::max<std::int64_t>((to - from).count(), 1);
    return {n, from + Duration(static_cast<std::int64_t>(random()) % gap)};
  }

  FrameStore m_frames;
  NoteStore m_notes;
};

TEST_F(AnyLog, GivesTheSameStateInOneWalkAndInManySteps) {
  fill(1, 20'000);
  std::mt19937 random(2);
  for (int round = 0; round < 30; ++round) {
    const Cursor to = randomCursor(random);
    State straight;
    advance(straight, m_frames, m_notes, to);
    std::vector<Cursor> stops;
    for (int i = 0; i < 20; ++i) stops.push_back(randomCursor(random));
    std::ranges::sort(stops, {}, [](const Cursor& c) { return std::pair(c.frames, c.time); });
    State stepped;
    for (const Cursor& stop : stops) {
      if (stop.frames < to.frames) advance(stepped, m_frames, m_notes, stop);
    }
    advance(stepped, m_frames, m_notes, to);
    ASSERT_EQ(straight, stepped) << "at frame " << to.frames;
  }
}

TEST_F(AnyLog, GivesTheSameStateFromKeyframesAsFromTheStart) {
  fill(3, 2 * Keyframes::kEvery + 5'000);
  Keyframes keyframes(m_frames, m_notes);
  while (keyframes.build()) {
  }
  EXPECT_EQ(keyframes.count(), 2u);
  std::mt19937 random(4);
  State walking;
  std::vector<Cursor> stops;
  for (int i = 0; i < 12; ++i) stops.push_back(randomCursor(random));
  stops.push_back(cursorAfter(m_frames, Keyframes::kEvery));
  std::ranges::sort(stops, {}, [](const Cursor& c) { return std::pair(c.frames, c.time); });
  for (const Cursor& stop : stops) {
    advance(walking, m_frames, m_notes, stop);
    ASSERT_EQ(keyframes.at(stop), walking) << "at frame " << stop.frames;
  }
}

TEST_F(AnyLog, StandsAtTheCursorItWasTakenTo) {
  fill(5, 1'000);
  const Cursor to{500, m_frames.timeAt(499) + 1ns};
  State state;
  advance(state, m_frames, m_notes, to);
  EXPECT_EQ(state.cursor(), to);
}

TEST(EndOfALog, IsItsLastFrameItsLastNoteOrUntilWhenItRan) {
  FrameStore frames;
  NoteStore notes;
  const auto end = [&] { return endOf(frames, notes); };
  notes.append({.time = {5}, .value = note::RanUntil{}});
  EXPECT_EQ(end().frames, 0u);
  ASSERT_TRUE(frames.append(std::vector<Frame>{test::frame("123", "", 0, 10)}));
  EXPECT_EQ(end(), (Cursor{1, {10}})) << "it ran no longer";
  notes.append({.frame = 1, .time = {20}, .value = note::Mark{}});
  EXPECT_EQ(end(), (Cursor{1, {20}}));
  notes.append({.time = Instant{10} + 30s, .value = note::RanUntil{}});
  EXPECT_EQ(end(), (Cursor{1, Instant{10} + 30s}));
  notes.append({.time = Instant{10} + 1'000h, .value = note::RanUntil{}});
  EXPECT_EQ(end(), (Cursor{1, Instant{10} + 1'000h})) << "a truck may be off for weeks";
  notes.append({.frame = 1, .time = Instant{10} + 2'000h, .value = note::Mark{}});
  EXPECT_EQ(end(), (Cursor{1, Instant{10} + 1'000h + kMaxBehind})) << "a note that cannot be";
}

TEST(CursorAtATime, CountsEveryFrameUpToAndAtIt) {
  FrameStore frames;
  const std::vector<Frame> batch{test::frame("123", "", 0, 10), test::frame("123", "", 0, 20),
                                 test::frame("123", "", 0, 20), test::frame("123", "", 0, 30)};
  ASSERT_TRUE(frames.append(batch));
  EXPECT_EQ(cursorAt(frames, {9}).frames, 0u);
  EXPECT_EQ(cursorAt(frames, {20}).frames, 3u);
  EXPECT_EQ(cursorAt(frames, {25}), (Cursor{3, {25}}));
  EXPECT_EQ(cursorAfter(frames, 4), (Cursor{4, {30}}));
}

}  // namespace
}  // namespace deckpipe
