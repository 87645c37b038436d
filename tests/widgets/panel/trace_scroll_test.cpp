// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/trace_scroll.h"

#include <gtest/gtest.h>

namespace deckpipe {
namespace {

TraceScroll scrollOf(std::uint64_t rows, std::uint64_t pageRows, std::uint64_t top = 0) {
  return {.rows = rows, .pageRows = pageRows, .top = top};
}

TEST(TraceScroll, HasNowhereToGoWhereAllRowsAreSeen) {
  for (const std::uint64_t rows : {0u, 1u, 40u}) {
    TraceScroll s = scrollOf(rows, 40);
    s.moveBy(5);
    EXPECT_EQ(s.top, 0u);
    EXPECT_TRUE(s.isAtEnd());
    EXPECT_EQ(s.barMaximum(), 0);
  }
}

TEST(TraceScroll, TenMillionRowsHaveAPlaceOfTheBarEach) {
  TraceScroll s = scrollOf(10'000'000, 40);
  EXPECT_EQ(s.lastTop(), 9'999'960u);
  EXPECT_EQ(s.barMaximum(), 9'999'960);
  for (const std::uint64_t top : {0u, 1u, 4'999'999u, 9'999'959u, 9'999'960u}) {
    s.moveTo(top);
    EXPECT_EQ(s.barValue(), static_cast<int>(top));
    EXPECT_EQ(s.topOf(s.barValue()), top);
  }
  s.moveBy(1);
  EXPECT_EQ(s.top, 9'999'960u);
  s.moveBy(-3);
  EXPECT_EQ(s.top, 9'999'957u);
  EXPECT_FALSE(s.isAtEnd());
}

TEST(TraceScroll, BeyondTheBarsRangeRowsAreStillMovedByOne) {
  const std::uint64_t rows = 40'000'000'000;
  TraceScroll s = scrollOf(rows, 50);
  EXPECT_EQ(s.barMaximum(), TraceScroll::kBarMost);
  EXPECT_EQ(s.topOf(0), 0u);
  EXPECT_EQ(s.topOf(TraceScroll::kBarMost), rows - 50);
  s.moveTo(20'000'000'000);
  s.moveBy(1);
  EXPECT_EQ(s.top, 20'000'000'001u);
  s.moveBy(-2);
  EXPECT_EQ(s.top, 19'999'999'999u);
  EXPECT_NEAR(s.barValue(), TraceScroll::kBarMost / 2, 2);
  // There and back by the bar alone is within one step of it.
  EXPECT_LE(s.top - s.topOf(s.barValue()) + 40, 80u);
  s.moveBy(std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(s.top, rows - 50);
  EXPECT_EQ(s.barValue(), TraceScroll::kBarMost);
  s.moveBy(std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(s.top, 0u);
}

TEST(TraceScroll, HoldsAsManyRowsAs64BitsCount) {
  const std::uint64_t rows = std::numeric_limits<std::uint64_t>::max();
  TraceScroll s = scrollOf(rows, 50);
  s.moveTo(rows);
  EXPECT_EQ(s.top, rows - 50);
  s.moveBy(std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(s.top, rows - 50);
  EXPECT_EQ(s.barValue(), TraceScroll::kBarMost);
}

TEST(TraceScroll, ShowsARowWithTheLeastMove) {
  TraceScroll s = scrollOf(1'000, 10, 100);
  s.show(105);
  EXPECT_EQ(s.top, 100u);
  s.show(109);
  EXPECT_EQ(s.top, 100u);
  s.show(110);
  EXPECT_EQ(s.top, 101u);
  s.show(50);
  EXPECT_EQ(s.top, 50u);
  s.show(999);
  EXPECT_EQ(s.top, 990u);
  EXPECT_TRUE(s.isAtEnd());
}

}  // namespace
}  // namespace deckpipe
