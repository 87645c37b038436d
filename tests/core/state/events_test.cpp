// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/events.h"

#include <gtest/gtest.h>

#include "support/frames.h"

namespace deckpipe {
namespace {

using test::frame;

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr auto kPin = "FF83150206021A0B";    // 1032AE100801035
constexpr auto kFine = "011D940371000041";   // position, calibrated
constexpr auto kError = "011D940371000045";  // … with an operational error
constexpr auto kAkronName = "3412C02800420090";
constexpr auto kOtherName = "3412A00000420090";

struct Log {
  LogDocument document;
  Events events;

  void add(const std::vector<Frame>& frames) {
    ASSERT_TRUE(document.frames.append(frames));
    while (document.roles.build(1000)) {
    }
    EXPECT_TRUE(events.take(document, document.frames.count(), 1'000'000));
  }
  std::vector<EventKind> kinds() const {
    std::vector<EventKind> kinds;
    for (const Event& event : events.list()) kinds.push_back(event.kind);
    return kinds;
  }
};

TEST(Events, TellOnceThatADeviceAppeared) {
  Log log;
  log.add({frame("18EFFF80", kPin, 0, 1 * kSecond), frame("18EFFF80", kPin, 0, 2 * kSecond)});
  ASSERT_EQ(log.kinds(), (std::vector{EventKind::Announced}));
  EXPECT_EQ(log.events.list()[0].pin.text(), "1032AE100801035");
  EXPECT_EQ(log.events.list()[0].address, Address{0x80});
}

TEST(Events, TellThatADeviceChangedItsAddress) {
  Log log;
  log.add({frame("18EFFF80", kPin, 0, 1 * kSecond), frame("18EFFF85", kPin, 0, 2 * kSecond)});
  ASSERT_EQ(log.kinds(), (std::vector{EventKind::Announced, EventKind::AddressChanged}));
  EXPECT_EQ(log.events.list()[1].previous, Address{0x80});
  EXPECT_EQ(log.events.list()[1].address, Address{0x85});
}

TEST(Events, TellClaimsByAnotherNameAndWhoCannotClaim) {
  Log log;
  log.add({frame("18EEFF80", kAkronName), frame("18EEFF80", kAkronName), frame("18EEFF80", kOtherName),
           frame("18EEFFFE", kOtherName)});
  ASSERT_EQ(log.kinds(), (std::vector{EventKind::Claimed, EventKind::Claimed, EventKind::CannotClaim}));
  EXPECT_EQ(log.events.list()[0].name.manufacturerCode(), 326u);
  EXPECT_EQ(log.events.list()[2].address, Address{0x80});
}

TEST(Events, TellAContestAtTheFrameThatDecidesIt) {
  Log log;
  constexpr auto kHigherName = "3412A000004200FF";
  log.add({frame("18EEFF80", kAkronName, 0, 0), frame("18EEFF80", kHigherName, 0, kSecond),
           frame("18FF0081", "00", 0, kSecond + 249'999'999),
           frame("18FF0081", "00", 0, kSecond + 250'000'000)});
  ASSERT_EQ(log.kinds(), (std::vector{EventKind::Claimed, EventKind::Claimed}));
  EXPECT_EQ(log.events.list()[1].frame, 3u);
  EXPECT_EQ(log.events.list()[1].name.value, Name::of(frame("18EEFF80", kHigherName)).value);
}

TEST(Events, TellWhenAnOperationalErrorBeginsAndEnds) {
  Log log;
  log.add({frame("18EFFF80", kFine, 0, 0), frame("18EFFF80", kError, 0, kSecond / 10),
           frame("18EFFF80", kError, 0, kSecond / 5), frame("18EFFF80", kFine, 0, kSecond / 3)});
  EXPECT_EQ(log.kinds(), (std::vector{EventKind::ErrorBegan, EventKind::ErrorEnded}));
}

TEST(Events, TellThatAMonitorIsHeardAgain) {
  Log log;
  log.add({frame("18EFFF80", kFine, 0, 0), frame("18EFFF80", kFine, 0, kSecond / 2),
           frame("18EFFF80", kFine, 0, 3 * kSecond)});
  ASSERT_EQ(log.kinds(), (std::vector{EventKind::SilenceEnded}));
  EXPECT_EQ(log.events.list()[0].lasted, Duration(2500ms));
}

TEST(Events, LeaveTheMessagesOfOtherMakersAlone) {
  Log log;
  log.add({frame("18EEFF80", kOtherName), frame("18EFFF80", kPin), frame("18EFFF80", kError)});
  EXPECT_EQ(log.kinds(), (std::vector{EventKind::Claimed}));
}

TEST(Events, TellThatANodeStartedAndOneSeriesOfErrorFrames) {
  Log log;
  Frame error = frame("004", "0000000000000000", 0, 2 * kSecond);
  error.id |= kErrorBit;
  Frame next = error;
  next.stamp += kSecond / 2;
  log.add({frame("724", "00", 0, 1 * kSecond), error, next});
  ASSERT_EQ(log.kinds(), (std::vector{EventKind::NodeStarted, EventKind::ErrorFrames}));
  EXPECT_EQ(log.events.list()[0].node, NodeId{0x24});
}

TEST(Events, GoOnWhereTheyStoppedAndNoFurtherThanTold) {
  Log log;
  ASSERT_TRUE(
      log.document.frames.append(std::vector{frame("18EFFF80", kPin, 0, 1), frame("724", "00", 0, 2)}));
  EXPECT_FALSE(log.events.take(log.document, 2, 2)) << "not beyond the index of roles";
  EXPECT_EQ(log.kinds().size(), 0u);
  while (log.document.roles.build(100)) {
  }
  EXPECT_FALSE(log.events.take(log.document, 2, 1));
  EXPECT_EQ(log.kinds().size(), 1u);
  EXPECT_TRUE(log.events.take(log.document, 2, 1));
  EXPECT_EQ(log.kinds().size(), 2u);
}

}  // namespace
}  // namespace deckpipe
