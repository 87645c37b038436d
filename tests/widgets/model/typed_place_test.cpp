// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/typed_place.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <string>

#include "model/log_clock.h"
#include "support/frames.h"
#include "support/logs.h"

namespace deckpipe {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
// 2023-11-14 14:00:00 UTC
constexpr std::int64_t kTwoOClock = 1'699'970'400 * kSecond;

struct TypedPlaceTest : testing::Test {
  TypedPlaceTest() {
    setenv("TZ", "UTC", 1);
    tzset();
  }
  // Frames at these seconds after `base`; the cursor stands behind the second.
  static LogView viewAt(std::int64_t base, const std::vector<double>& seconds) {
    std::vector<Frame> frames;
    for (const double second : seconds)
      frames.push_back(test::frame("123", "", 0, base + static_cast<std::int64_t>(second * 1e9)));
    return test::viewOf(test::logOf(frames), 2);
  }
  // A frame every half hour; the cursor stands at the second.
  static LogView viewOfHours(double hours) {
    std::vector<double> seconds;
    for (double second = 0; second <= hours * 3600; second += 1800) seconds.push_back(second);
    return viewAt(kTwoOClock, seconds);
  }
  // "83.5" seconds since the begin, "frame 5", or the sentence.
  static std::string read(const LogView& view, const char* typed) {
    const auto place = placeOf(QString::fromUtf8(typed), view);
    if (!place) return place.error().toStdString();
    if (const auto* frames = std::get_if<std::uint64_t>(&place.value()))
      return "frame " + std::to_string(*frames);
    const double seconds = static_cast<double>((std::get<Instant>(place.value()) - view.begin).count()) / 1e9;
    return QString::number(seconds, 'g', 12).toStdString();
  }
};

// Half an hour from two o'clock on; the cursor stands at 60 s.
struct Typed : TypedPlaceTest, testing::WithParamInterface<std::pair<const char*, const char*>> {
  LogView view = viewAt(kTwoOClock, {0, 60, 1800});
};

TEST_P(Typed, IsThisPlace) { EXPECT_EQ(read(view, GetParam().first), GetParam().second); }

INSTANTIATE_TEST_SUITE_P(SinceTheBegin, Typed,
                         testing::Values(std::pair("1:23.5", "83.5"), std::pair("1:23,5", "83.5"),
                                         std::pair("0:01:23.456", "83.456"), std::pair("83.5 s", "83.5"),
                                         std::pair("83.5", "83.5"), std::pair(" 83.5s ", "83.5"),
                                         std::pair(".5", "0.5"), std::pair("0", "0"),
                                         std::pair("1800", "1800"), std::pair("30:00", "1800")));
INSTANTIATE_TEST_SUITE_P(InUnits, Typed,
                         testing::Values(std::pair("1 min 23.5 s", "83.5"), std::pair("2m", "120"),
                                         std::pair("200 ms", "0.2"), std::pair("0.25 h", "900"),
                                         std::pair("1min", "60")));
INSTANTIATE_TEST_SUITE_P(ByTheClock, Typed,
                         testing::Values(std::pair("14:03:22", "202"), std::pair("14:03:22.5", "202.5"),
                                         std::pair("2023-11-14 14:03:22", "202"),
                                         std::pair("2023-11-14T14:03:22", "202"), std::pair("14:00:00", "0"),
                                         std::pair("14:30:00", "1800"),
                                         std::pair("2023-11-14 14:03", "180")));
INSTANTIATE_TEST_SUITE_P(FromTheCursor, Typed,
                         testing::Values(std::pair("+5", "65"), std::pair("-0.2", "59.8"),
                                         std::pair("\u22120.2", "59.8"), std::pair("+ 1:30", "150"),
                                         std::pair("-60", "0"), std::pair("+500 ms", "60.5")));

const char kOutside[] =
    "The log does not have this time: it goes from 0:00:00 to 0:30:00.000, by the clock 14:00:00 to "
    "14:30:00.";
INSTANTIATE_TEST_SUITE_P(
    InVain, Typed,
    testing::Values(std::pair("1801", kOutside), std::pair("30:01", kOutside),
                    std::pair("13:59:59", kOutside), std::pair("14:30:01", kOutside),
                    std::pair("2023-11-15 14:03:22", kOutside), std::pair("-61", kOutside),
                    std::pair("+1741", kOutside), std::pair("99999999999999999999999", kOutside),
                    std::pair("25:00:00", kOutside),
                    std::pair("1:75", "\u201c1:75\u201d is no time: minutes and seconds go from 0 to 59."),
                    std::pair("0:61:00",
                              "\u201c0:61:00\u201d is no time: minutes and seconds go from 0 to 59."),
                    std::pair("noon",
                              "\u201cnoon\u201d is no time. Write 1:23.5 or 83.5 s since the begin, or +5 or "
                              "\u22120.2 from here, or a time of the clock, 14:00:00 to 14:30:00.")));

TEST_F(TypedPlaceTest, NamesWhatWasTypedInEverySentenceAboutIt) {
  const LogView view = viewAt(kTwoOClock, {0, 60, 1800});
  for (const char* typed : {"+", "-", "5 x", "1:", ":5", "1:2:3:4", "2023-13-01 10:00", "2023-11-14 10", "s",
                            "5 s s", "+-5", "2023-11-14 25:00:00"})
    EXPECT_EQ(read(view, typed).rfind("\u201c" + std::string(typed) + "\u201d is no time.", 0), 0u) << typed;
}

TEST_F(TypedPlaceTest, WithHoursIsATimeSinceTheBeginWhereTheLogHasNoSuchTimeOfDay) {
  const LogView view = viewOfHours(4);
  EXPECT_EQ(read(view, "1:30:00"), "5400");
  EXPECT_EQ(read(view, "3:00"), "180") << "minutes and seconds come first";
  EXPECT_EQ(read(view, "15:30:00"), "5400");
}

TEST_F(TypedPlaceTest, OfTwoMeaningsIsNotGuessed) {
  const LogView view = viewOfHours(20);
  EXPECT_EQ(read(view, "15:00:00"),
            "The log has 15:00:00 since its begin and by the clock: write \u201c54000 s\u201d or "
            "\u201c2023-11-14 15:00:00\u201d.");
  EXPECT_EQ(read(view, "54000 s"), "54000");
  EXPECT_EQ(read(view, "2023-11-14 15:00:00"), "3600");
}

TEST_F(TypedPlaceTest, FindsTheDayByItself) {
  const LogView view = viewOfHours(11);
  EXPECT_EQ(read(view, "23:30:00"), "34200");
  EXPECT_EQ(read(view, "12:30:00").rfind("The log does not have this time", 0), 0u);
  EXPECT_EQ(read(view, "2023-11-15 00:30:00"), "37800");
}

TEST_F(TypedPlaceTest, AsksForTheDateWhereTheLogSpansDays) {
  const LogView view = viewOfHours(72);
  EXPECT_EQ(read(view, "80:00:00"),
            "The log does not have this time: it goes from 0:00:00 to 72:00:00.000, by the clock "
            "2023-11-14 14:00:00 to 2023-11-17 14:00:00.");
  EXPECT_EQ(read(view, "73:00:00").rfind("The log does not have this time", 0), 0u);
  EXPECT_EQ(read(view, "2023-11-16 08:00"), std::to_string(42 * 3600));
  EXPECT_EQ(read(view, "2023-11-17 14:00:01").rfind("The log does not have this time", 0), 0u);
}

TEST_F(TypedPlaceTest, OfTheClockNeedsAClockWithDates) {
  const LogView view = viewAt(5 * kSecond, {0, 60, 1800});
  EXPECT_EQ(read(view, "1:23.5"), "83.5");
  EXPECT_EQ(read(view, "14:03:22"), "The log does not have this time: it goes from 0:00:00 to 0:30:00.000.");
  EXPECT_EQ(
      read(view, "?"),
      "\u201c?\u201d is no time. Write 1:23.5 or 83.5 s since the begin, or +5 or \u22120.2 from here.");
}

TEST_F(TypedPlaceTest, OfALogWithoutTimesIsAFrame) {
  auto log = std::make_shared<LogDocument>();
  log->frames.takeNoTimes();
  ASSERT_TRUE(log->frames.append(std::vector(2'000, test::frame("123", "", 0, kNoStamp))));
  const LogView view = test::viewOf(log, 1'000);
  EXPECT_EQ(read(view, "1234"), "frame 1234");
  EXPECT_EQ(read(view, "1,234"), "frame 1234");
  EXPECT_EQ(read(view, "+5"), "frame 1005");
  EXPECT_EQ(read(view, "-2"), "frame 998");
  for (const char* typed : {"0", "2001", "-1000", "+1001"})
    EXPECT_EQ(read(view, typed), "The log does not have this frame: its frames are 1 to 2000.") << typed;
  EXPECT_EQ(read(view, "1:23"),
            "\u201c1:23\u201d is no frame. Write the number of a frame, 1 to 2000, or a way from here, as "
            "in +5 or "
            "\u22122.");
}

// The clock is set back by an hour after 10 s, so that 14:00:05 comes twice.
TEST_F(TypedPlaceTest, FollowsAClockThatJumps) {
  const LogView view = viewAt(kTwoOClock, {0, 5, 10, -3600, -3595, -3590});
  ASSERT_EQ(view.document->frames.jumps().size(), 1u);
  EXPECT_EQ(read(view, "14:00:05"), "5");
  EXPECT_EQ(read(view, "13:00:05"), "15");
  EXPECT_EQ(read(view, "13:30:00").rfind("The log does not have this time", 0), 0u);
}

}  // namespace
}  // namespace deckpipe
