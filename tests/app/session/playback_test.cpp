// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "support/frames.h"

namespace deckpipe {
namespace {

constexpr Instant at(double seconds) { return {static_cast<std::int64_t>(seconds * 1e9)}; }

// Five frames, at 10, 11, 12, 13 and 14 s.
struct PlaybackTest : testing::Test {
  PlaybackTest() {
    for (int i = 0; i < 5; ++i) add(10 + i);
    playback.reach(cursorAfter(frames, 5), false);
  }
  void add(double seconds) {
    EXPECT_TRUE(frames.append(std::vector{test::frame("18EFFF80", "01", 0, at(seconds).ns)}));
  }
  FrameStore frames;
  Playback playback{&frames};
};

TEST_F(PlaybackTest, StandsAtTheEndAndGoesWithIt) {
  EXPECT_EQ(playback.begin(), at(10));
  EXPECT_EQ(playback.cursor(), (Cursor{5, at(14)}));
  add(15);
  playback.reach(cursorAfter(frames, 6), false);
  EXPECT_EQ(playback.cursor(), (Cursor{6, at(15)}));
  EXPECT_TRUE(playback.isAtEnd());
  playback.pause();
  add(16);
  playback.reach(cursorAfter(frames, 7), false);
  EXPECT_EQ(playback.cursor(), (Cursor{6, at(15)})) << "paused, it stays";
  EXPECT_EQ(playback.end(), (Cursor{7, at(16)}));
}

struct Played {
  const char* name;
  double from, speed, seconds;  // plays so long from there
  Cursor cursor;
  bool isPlaying;
};
void PrintTo(const Played& played, std::ostream* out) { *out << played.name; }

struct PlayedFor : PlaybackTest, testing::WithParamInterface<Played> {};

TEST_P(PlayedFor, StandsWhereTimeTimesSpeedLeads) {
  const Played& c = GetParam();
  // In one tick as in many.
  for (const int ticks : {1, 4}) {
    playback.seek(at(c.from));
    playback.setSpeed(c.speed);
    ASSERT_TRUE(playback.play(at(1000)));
    for (int i = 1; i <= ticks; ++i) playback.timeCame(at(1000 + c.seconds * i / ticks));
    EXPECT_EQ(playback.cursor(), c.cursor) << ticks;
    EXPECT_EQ(playback.isPlaying(), c.isPlaying);
    EXPECT_EQ(playback.isAtEnd(), !c.isPlaying);
  }
}

INSTANTIATE_TEST_SUITE_P(Table, PlayedFor,
                         testing::Values(Played{"no time", 11, 1, 0, {2, at(11)}, true},
                                         Played{"real time", 11, 1, 1.5, {3, at(12.5)}, true},
                                         Played{"slow", 10, 0.5, 1, {1, at(10.5)}, true},
                                         Played{"fast", 10, 4, 0.5, {3, at(12)}, true},
                                         Played{"to the end", 10, 16, 0.25, {5, at(14)}, false},
                                         Played{"beyond the end", 13, 1, 60, {5, at(14)}, false}),
                         [](const auto& row) {
                           std::string name = row.param.name;
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

TEST_F(PlaybackTest, StartsOverFromTheEndOfALogThatDoesNotGrow) {
  ASSERT_TRUE(playback.play(at(0)));
  EXPECT_EQ(playback.cursor(), (Cursor{0, at(10)}));
  EXPECT_FALSE(playback.play(at(1))) << "it plays already";
  playback.timeCame(at(0.5));
  EXPECT_EQ(playback.cursor(), (Cursor{1, at(10.5)})) << "since the first one";
}

TEST_F(PlaybackTest, GoesOnByItselfAtTheEndOfALogThatGrows) {
  playback.reach({5, at(14.3)}, true);
  EXPECT_FALSE(playback.play(at(0)));
  EXPECT_TRUE(playback.isAtEnd());
  ASSERT_TRUE(playback.pause());
  EXPECT_EQ(playback.cursor(), (Cursor{5, at(14.3)}));
  playback.reach({5, at(15.3)}, true);
  ASSERT_TRUE(playback.play(at(0)));
  playback.timeCame(at(0.5));
  EXPECT_EQ(playback.cursor(), (Cursor{5, at(14.8)})) << "plays on, though behind the last frame";
  playback.reach({5, at(15.8)}, true);
  playback.timeCame(at(1.5));
  EXPECT_TRUE(playback.isAtEnd()) << "it has caught up";
}

TEST_F(PlaybackTest, DoesNotMoveWhileItDoesNotPlay) {
  playback.seek(at(11));
  playback.timeCame(at(100));
  EXPECT_EQ(playback.cursor(), (Cursor{2, at(11)}));
  ASSERT_TRUE(playback.play(at(200)));
  playback.timeCame(at(200.5));
  EXPECT_EQ(playback.cursor().time, at(11.5)) << "the time before does not count";
  EXPECT_TRUE(playback.pause());
  EXPECT_FALSE(playback.pause());
  playback.timeCame(at(300));
  EXPECT_EQ(playback.cursor().time, at(11.5));
}

struct Deed {
  const char* name;
  void (*deed)(Playback&);
  Cursor cursor;
};
void PrintTo(const Deed& deed, std::ostream* out) { *out << deed.name; }

struct SoughtByHand : PlaybackTest, testing::WithParamInterface<Deed> {};

TEST_P(SoughtByHand, StopsPlayingAndStandsWithinTheLog) {
  playback.seekFrames(2);
  ASSERT_TRUE(playback.play(at(0)));
  GetParam().deed(playback);
  EXPECT_EQ(playback.cursor(), GetParam().cursor);
  EXPECT_FALSE(playback.isPlaying());
  EXPECT_FALSE(playback.isAtEnd());
}

INSTANTIATE_TEST_SUITE_P(
    Table, SoughtByHand,
    testing::Values(Deed{"time", [](Playback& p) { p.seek(at(12.5)); }, {3, at(12.5)}},
                    Deed{"time_before_the_log", [](Playback& p) { p.seek(at(1)); }, {1, at(10)}},
                    Deed{"time_after_the_log", [](Playback& p) { p.seek(at(99)); }, {5, at(14)}},
                    Deed{"frames", [](Playback& p) { p.seekFrames(4); }, {4, at(13)}},
                    Deed{"too_many_frames", [](Playback& p) { p.seekFrames(100); }, {5, at(14)}},
                    Deed{"step_on", [](Playback& p) { p.step(1); }, {3, at(12)}},
                    Deed{"step_back", [](Playback& p) { p.step(-1); }, {1, at(10)}},
                    Deed{"step_far_on", [](Playback& p) { p.step(100); }, {5, at(14)}},
                    Deed{"pause", [](Playback& p) { p.pause(); }, {2, at(11)}}),
    [](const auto& row) { return row.param.name; });

TEST_F(PlaybackTest, StepsBackNoFartherThanTheBegin) {
  playback.step(-100);
  EXPECT_EQ(playback.cursor().frames, 0u);
  playback.step(std::numeric_limits<int>::min());
  EXPECT_EQ(playback.cursor().frames, 0u);
}

TEST_F(PlaybackTest, GoesToTheEndFromAnywhere) {
  playback.seekFrames(1);
  playback.play(at(0));
  playback.goToEnd();
  EXPECT_EQ(playback.cursor(), (Cursor{5, at(14)}));
  EXPECT_TRUE(playback.isAtEnd());
  EXPECT_FALSE(playback.isPlaying());
}

TEST_F(PlaybackTest, KeepsItsSpeedBetweenSlowestAndFastest) {
  for (const auto& [asked, is] :
       {std::pair(2.0, 2.0), {0.0, Playback::kSlowest}, {1e9, Playback::kFastest}}) {
    playback.setSpeed(asked);
    EXPECT_EQ(playback.speed(), is);
  }
}

TEST(PlaybackWithoutALog, DoesNothing) {
  Playback playback;
  EXPECT_FALSE(playback.play(at(0)));
  EXPECT_FALSE(playback.pause());
  playback.seek(at(5));
  playback.seekFrames(5);
  playback.step(1);
  playback.timeCame(at(9));
  EXPECT_EQ(playback.cursor(), Cursor{});
  EXPECT_TRUE(playback.isAtEnd());
}

}  // namespace
}  // namespace deckpipe
