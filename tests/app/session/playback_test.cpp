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
  // The state is found at once.
  void timeCame(Instant now) { playback.timeCame(now, playback.cursor()); }
  FrameStore frames;
  Playback playback{&frames};
};

TEST_F(PlaybackTest, StandsAtItsFirstFrameWhereItStartsAtTheBegin) {
  Playback opened(&frames, Playback::Start::AtBegin);
  EXPECT_FALSE(opened.isAtEnd());
  opened.reach({}, false);
  EXPECT_EQ(opened.cursor(), Cursor{}) << "no frame was read yet";
  opened.reach(cursorAfter(frames, 2), false);
  EXPECT_EQ(opened.cursor(), (Cursor{1, at(10)}));
  opened.reach(cursorAfter(frames, 5), false);
  EXPECT_EQ(opened.cursor(), (Cursor{1, at(10)})) << "reading on moves nothing";
  EXPECT_FALSE(opened.isAtEnd());
  opened.seekFrames(3);
  opened.reach(cursorAfter(frames, 5), false);
  EXPECT_EQ(opened.cursor(), (Cursor{3, at(12)}));
}

TEST_F(PlaybackTest, LeavesTheBeginForAPersonWhoDoesNotWaitForIt) {
  Playback opened(&frames, Playback::Start::AtBegin);
  opened.goToEnd();
  opened.reach(cursorAfter(frames, 5), false);
  EXPECT_EQ(opened.cursor(), (Cursor{5, at(14)}));
  EXPECT_TRUE(opened.isAtEnd());
}

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
    for (int i = 1; i <= ticks; ++i) timeCame(at(1000 + c.seconds * i / ticks));
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
  timeCame(at(0.5));
  EXPECT_EQ(playback.cursor(), (Cursor{1, at(10.5)})) << "since the first one";
}

TEST_F(PlaybackTest, PlaysOnFromWithinASilenceAtTheEnd) {
  playback.reach({5, at(44)}, false);
  playback.seek(at(20));
  ASSERT_TRUE(playback.play(at(0)));
  timeCame(at(1));
  EXPECT_EQ(playback.cursor(), (Cursor{5, at(21)}));
}

TEST_F(PlaybackTest, GoesOnByItselfAtTheEndOfALogThatGrows) {
  playback.reach({5, at(14.3)}, true);
  EXPECT_FALSE(playback.play(at(0)));
  EXPECT_TRUE(playback.isAtEnd());
  ASSERT_TRUE(playback.pause());
  EXPECT_EQ(playback.cursor(), (Cursor{5, at(14.3)}));
  playback.reach({5, at(15.3)}, true);
  ASSERT_TRUE(playback.play(at(0)));
  timeCame(at(0.5));
  EXPECT_EQ(playback.cursor(), (Cursor{5, at(14.8)})) << "plays on, though behind the last frame";
  playback.reach({5, at(15.8)}, true);
  timeCame(at(1.5));
  EXPECT_TRUE(playback.isAtEnd()) << "it has caught up";
}

TEST_F(PlaybackTest, DoesNotMoveWhileItDoesNotPlay) {
  playback.seek(at(11));
  timeCame(at(100));
  EXPECT_EQ(playback.cursor(), (Cursor{2, at(11)}));
  ASSERT_TRUE(playback.play(at(200)));
  timeCame(at(200.5));
  EXPECT_EQ(playback.cursor().time, at(11.5)) << "the time before does not count";
  EXPECT_TRUE(playback.pause());
  EXPECT_FALSE(playback.pause());
  timeCame(at(300));
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
  for (const auto& [asked, is] : {std::pair(2.0, 2.0),
                                  {0.1, 0.1},
                                  {100.0, 100.0},
                                  {0.0, Playback::kSlowest},
                                  {1e9, Playback::kFastest},
                                  {Playback::kUnbounded, Playback::kUnbounded}}) {
    playback.setSpeed(asked);
    EXPECT_EQ(playback.speed(), is);
  }
}

TEST_F(PlaybackTest, PlaysALoopAgainAndAgain) {
  playback.setLoop(LoopSpan{at(11), at(13)});
  playback.seek(at(10));
  ASSERT_TRUE(playback.play(at(0)));
  EXPECT_EQ(playback.cursor(), (Cursor{2, at(11)})) << "outside of it, from its begin";
  timeCame(at(1.5));
  EXPECT_EQ(playback.cursor(), (Cursor{3, at(12.5)}));
  timeCame(at(2));
  EXPECT_EQ(playback.cursor(), (Cursor{2, at(11)})) << "its end is its begin";
  timeCame(at(7.5));
  EXPECT_EQ(playback.cursor(), (Cursor{3, at(12.5)})) << "a late tick leads where the ticks between would";
  EXPECT_TRUE(playback.isPlaying());
  playback.setLoop({});
  timeCame(at(100));
  EXPECT_TRUE(playback.isAtEnd());
}

TEST_F(PlaybackTest, PlaysOnFromWithinALoop) {
  playback.setLoop(LoopSpan{at(11), at(13)});
  playback.seek(at(12));
  ASSERT_TRUE(playback.play(at(0)));
  EXPECT_EQ(playback.cursor(), (Cursor{3, at(12)}));
}

TEST_F(PlaybackTest, LoopsNoFartherThanTheLogGoes) {
  playback.setLoop(LoopSpan{at(13), at(20)});
  ASSERT_TRUE(playback.play(at(0)));
  timeCame(at(1.25));
  EXPECT_EQ(playback.cursor(), (Cursor{4, at(13.25)}));
  playback.setLoop(LoopSpan{at(30), at(40)});
  timeCame(at(9));
  EXPECT_TRUE(playback.isAtEnd()) << "there is nothing of it";
}

TEST_F(PlaybackTest, TakesNoLoopWithoutLength) {
  playback.setLoop(LoopSpan{at(11), at(11)});
  EXPECT_FALSE(playback.loop());
}

TEST_F(PlaybackTest, LeavesTheLiveEdgeForALoop) {
  playback.reach({5, at(14.3)}, true);
  playback.setLoop(LoopSpan{at(11), at(12)});
  ASSERT_TRUE(playback.play(at(0)));
  EXPECT_EQ(playback.cursor(), (Cursor{2, at(11)}));
  EXPECT_FALSE(playback.isAtEnd());
}

// Frames at 10 to 14 s, at 60 s, and at 61 s.
struct Silence : PlaybackTest {
  Silence() {
    add(60);
    add(61);
    playback.reach(cursorAfter(frames, 7), false);
    playback.setSkipsSilences(true);
    playback.seek(at(13.5));
    EXPECT_TRUE(playback.play(at(0)));
  }
};

TEST_F(Silence, IsSkippedAndTold) {
  timeCame(at(0.25));
  EXPECT_EQ(playback.cursor(), (Cursor{4, at(13.75)}));
  EXPECT_EQ(playback.skipped(), 0s);
  timeCame(at(0.75));
  EXPECT_EQ(playback.cursor(), (Cursor{6, at(60)}));
  EXPECT_EQ(playback.skipped(), 45750ms);
  EXPECT_TRUE(playback.isPlaying());
  timeCame(at(1));
  EXPECT_EQ(playback.cursor(), (Cursor{6, at(60.25)}));
  EXPECT_EQ(playback.skipped(), 45750ms);
  playback.setLoop(LoopSpan{at(60), at(61)});
  timeCame(at(0.75) + Playback::kTellsSkipped);
  EXPECT_EQ(playback.skipped(), 0s) << "it was told for long enough";
}

TEST_F(Silence, IsPlayedWhereThatIsNotWanted) {
  playback.setSkipsSilences(false);
  timeCame(at(10));
  EXPECT_EQ(playback.cursor(), (Cursor{5, at(23.5)}));
  EXPECT_EQ(playback.skipped(), 0s);
}

TEST_F(Silence, IsNoLongerToldOnceAPersonMovesTheCursor) {
  timeCame(at(1));
  ASSERT_NE(playback.skipped(), 0s);
  playback.seek(at(11));
  EXPECT_EQ(playback.skipped(), 0s);
}

TEST_F(Silence, AtTheEndOfALoopLeadsToItsBegin) {
  playback.setLoop(LoopSpan{at(13), at(50)});
  timeCame(at(1));
  EXPECT_EQ(playback.cursor(), (Cursor{4, at(13)}));
}

TEST_F(Silence, BehindTheLastFrameIsSkippedUnlessMoreMayCome) {
  for (const bool grows : {true, false}) {
    playback.reach({7, at(80)}, grows);
    playback.seek(at(60.5));
    ASSERT_TRUE(playback.play(at(0)));
    timeCame(at(1));
    EXPECT_EQ(playback.isPlaying(), grows);
    EXPECT_EQ(playback.cursor(), (grows ? Cursor{7, at(61.5)} : Cursor{7, at(80)}));
  }
}

struct UnboundedPlayback : testing::Test {
  static constexpr std::uint64_t kFrames = 1'000'000;
  UnboundedPlayback() {
    std::vector<Frame> many(kFrames, test::frame("18EFFF80", "01", 0, 0));
    for (std::size_t i = 0; i < many.size(); ++i)
      many[i].stamp = static_cast<std::int64_t>(i + 1) * 1'000'000;
    EXPECT_TRUE(frames.append(many));
    playback.reach(cursorAfter(frames, kFrames), false);
    playback.setSpeed(Playback::kUnbounded);
    playback.seekFrames(1);
    EXPECT_TRUE(playback.play(at(0)));
  }
  std::uint64_t framesPlayed(Cursor found) {
    const std::uint64_t before = playback.cursor().frames;
    playback.timeCame(at(++m_ticks), found);
    return playback.cursor().frames - before;
  }
  FrameStore frames;
  Playback playback{&frames};
  int m_ticks = 0;
};

TEST_F(UnboundedPlayback, WaitsForTheStateAndForNothingElse) {
  const Cursor before = playback.cursor();
  EXPECT_GT(framesPlayed(before), 0u);
  EXPECT_EQ(framesPlayed(before), 0u) << "the state is still on its way";
  EXPECT_EQ(framesPlayed(before), 0u);
  EXPECT_GT(framesPlayed(playback.cursor()), 0u);
  EXPECT_TRUE(playback.isPlaying());
}

TEST_F(UnboundedPlayback, GoesFasterWhileTheStateKeepsUpAndSlowerWhereItDoesNot) {
  std::uint64_t fastest = 0;
  for (int i = 0; i < 9; ++i) fastest = framesPlayed(playback.cursor());
  EXPECT_EQ(fastest, Playback::kLongestStride);
  const Cursor lagging{1, at(0)};
  for (int i = 0; i < 5; ++i) EXPECT_EQ(framesPlayed(lagging), 0u);
  EXPECT_EQ(framesPlayed(playback.cursor()), Playback::kLongestStride / 2);
}

TEST_F(UnboundedPlayback, EndsAtTheEndUnlessItLoops) {
  playback.setLoop(LoopSpan{at(1), at(2)});
  playback.seek(at(1));
  const Cursor begin = playback.cursor();
  ASSERT_TRUE(playback.play(at(0)));
  framesPlayed(playback.cursor());
  EXPECT_EQ(playback.cursor(), begin) << "its thousand frames are played at once";
  playback.setLoop({});
  for (int i = 0; i < 20; ++i) framesPlayed(playback.cursor());
  EXPECT_TRUE(playback.isAtEnd());
}

TEST(PlaybackWithoutTimes, PlaysFrameByFrameAsFastAsTheStateIsFound) {
  FrameStore frames;
  frames.takeNoTimes();
  ASSERT_TRUE(frames.append(std::vector(5'000, test::frame("18EFFF80", "01", 0, kNoStamp))));
  ASSERT_FALSE(frames.hasTimes());
  Playback playback(&frames, Playback::Start::AtBegin);
  playback.reach(cursorAfter(frames, 5'000), false);
  EXPECT_EQ(playback.cursor().frames, 1u);
  ASSERT_TRUE(playback.play(at(0)));
  playback.timeCame(at(0.1), playback.cursor());
  EXPECT_GT(playback.cursor().frames, 1u);
  EXPECT_LT(playback.cursor().frames, 5'000u);
  while (playback.isPlaying()) playback.timeCame(at(1), playback.cursor());
  EXPECT_EQ(playback.cursor().frames, 5'000u);
}

TEST(PlaybackWithoutALog, DoesNothing) {
  Playback playback;
  EXPECT_FALSE(playback.play(at(0)));
  EXPECT_FALSE(playback.pause());
  playback.seek(at(5));
  playback.seekFrames(5);
  playback.step(1);
  playback.setLoop(LoopSpan{at(1), at(2)});
  EXPECT_FALSE(playback.loop());
  playback.timeCame(at(9), {});
  EXPECT_EQ(playback.cursor(), Cursor{});
  EXPECT_TRUE(playback.isAtEnd());
}

}  // namespace
}  // namespace deckpipe
