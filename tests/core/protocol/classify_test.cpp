// SPDX-License-Identifier: GPL-3.0-or-later
// Whose message is it, and is it a request or an answer: protocol.md 1.3, rule by rule.
#include "protocol/role_walk.h"

#include <gtest/gtest.h>

#include "protocol/catalogue.h"
#include "protocol/decode.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

using test::frame;

constexpr char kAkronName[] = "0B1AC22800420090";
constexpr char kForeignName[] = "0100200100820010";
constexpr char kAnotherForeignName[] = "0200200100820010";
constexpr char kHigherForeignName[] = "01002001000000FF";

// One channel walked in order, with the time the test says.
class OneChannel : public testing::Test {
 protected:
  Classified hear(std::string_view id, std::string_view data) {
    const Frame f = frame(id, data);
    return m_walk.next(f, m_now);
  }
  void pass(Duration d) { m_now = m_now + d; }
  void announce(unsigned address) { hear("18EFFF" + hex(address), "FF83150226021A0B"); }
  static std::string hex(unsigned byte) {
    char text[3];
    std::snprintf(text, sizeof text, "%02X", byte);
    return text;
  }

  RoleWalk m_walk;
  Instant m_now;
};

TEST_F(OneChannel, PresumesAnAkronMessageThatFitsFromAnUnknownDynamicAddress) {
  const Classified what = hear("18EFFF80", "011D940371000041");
  EXPECT_EQ(what.family, Family::Presumed);
  EXPECT_EQ(what.message, MessageId::PositionLimitStatus);
}

TEST_F(OneChannel, DoesNotPresumeOutsideTheDynamicAddresses) {
  for (const char* id : {"18EFFF7F", "18EFFFF8", "18EFFF05"}) {
    EXPECT_EQ(hear(id, "011D940371000041"), Classified{}) << id;
  }
  EXPECT_EQ(hear("18EF7F80", "02"), Classified{});  // a poll's device is its receiver
  EXPECT_EQ(hear("18EF8005", "02").family, Family::Presumed);
}

TEST_F(OneChannel, DoesNotPresumeAWrongLengthOrDirection) {
  EXPECT_EQ(hear("18EFFF80", "011D9403710000"), Classified{});
  EXPECT_EQ(hear("18EF0580", "011D940371000041"), Classified{});  // a status goes to everyone
  EXPECT_EQ(hear("18EFFF80", "02"), Classified{});                // a poll does not
}

TEST_F(OneChannel, CallsAnUndecidedPipeTypeAmbiguous) {
  const Classified what = hear("18EF80F2", "FE413F0D0A");
  EXPECT_EQ(what.family, Family::Ambiguous);
  EXPECT_FALSE(what.isDecoded());
}

TEST_F(OneChannel, KnowsAnAkronDeviceFromItsNextFrameOn) {
  EXPECT_EQ(hear("18EFFF80", "FF83150226021A0B").family, Family::Presumed);
  EXPECT_EQ(hear("18EFFF80", "011D940371000041").family, Family::Akron);
  EXPECT_EQ(hear("18EF80F2", "FE413F0D0A").message, MessageId::PipeData);
}

TEST_F(OneChannel, ReportsTheLengthsWantedOfAMalformedMessage) {
  announce(0x80);
  const Classified what = hear("18EF0580", "0200");
  EXPECT_EQ(what.family, Family::Akron);
  EXPECT_TRUE(what.malformed);
  EXPECT_EQ(what.wanted, lengths(1, 5, 7));
}

TEST_F(OneChannel, DoesNotDecodeAnUnknownTypeOfAnAkronDevice) {
  announce(0x80);
  EXPECT_EQ(hear("18EFFF80", "7700").family, Family::Akron);
  EXPECT_EQ(hear("18EFFF80", "7700").message, MessageId::Count);
  EXPECT_EQ(hear("18EFFF80", "").message, MessageId::Count);
}

TEST_F(OneChannel, TakesTheMakerFromTheNameAlone) {
  hear("18EEFF90", kAkronName);
  EXPECT_EQ(hear("18EFFF90", "011D940371000041").family, Family::Akron);
  hear("18EEFFA0", kForeignName);
  EXPECT_EQ(hear("18EFFFA0", "011D940371000041").family, Family::Other);
  EXPECT_EQ(hear("18EFFFA0", "FF83150226021A0B").family, Family::Other);
}

TEST_F(OneChannel, ReadsFramesFromAContestedAddressAsItsHolders) {
  hear("18EEFF80", kAkronName);
  hear("18EEFF80", kHigherForeignName);
  pass(250ms - 1ns);
  EXPECT_EQ(hear("18EFFF80", "011D940371000041").family, Family::Akron);
  pass(1ns);
  EXPECT_EQ(hear("18EFFF80", "011D940371000041").family, Family::Other);
}

TEST_F(OneChannel, LeavesTrafficBetweenForeignNodesAlone) {
  hear("18EEFFA0", kForeignName);
  hear("18EEFFA1", kAnotherForeignName);
  EXPECT_EQ(hear("18EFA1A0", "FE01020304050607").family, Family::Other);
  EXPECT_EQ(hear("18EF80A0", "02").family, Family::Presumed);  // the other end may be anyone
}

TEST_F(OneChannel, ReadsTrafficWithADriveAsCopleyUnlessTheOtherEndIsAkron) {
  m_walk.sayDrive({}, {0x21}, true, m_now);
  EXPECT_EQ(hear("18EF2105", "022101").message, MessageId::CopleyGetParameter);
  EXPECT_EQ(hear("18EF0521", "82000200").message, MessageId::CopleyGetParameterResponse);
  announce(0x80);
  EXPECT_EQ(hear("18EF2180", "02").family, Family::Ambiguous);
  EXPECT_EQ(hear("18EF8021", "8200").family, Family::Ambiguous);
  EXPECT_EQ(hear("18EF2105", "0202").malformed, true);
  for (const char* unknown : {"77", "96", "FD", "FE413F0D0A", "FF83150226021A0B"}) {
    EXPECT_EQ(hear("18EF2105", unknown), (Classified{.family = Family::Copley})) << unknown;
  }
}

TEST_F(OneChannel, TellsZeroRequestFromAcknowledgementByTheAkronEnd) {
  announce(0x80);
  EXPECT_EQ(hear("18EF8005", "41").message, MessageId::ZeroAxesRequest);
  EXPECT_EQ(hear("18EF0580", "41").message, MessageId::ZeroAxesAck);
}

TEST_F(OneChannel, TakesTheSecondOfTwoBetweenEqualsAsTheAnswerForTwoSeconds) {
  announce(0x80);
  announce(0x81);
  EXPECT_EQ(hear("18EF8180", "46").message, MessageId::SetupModeRequest);
  pass(2s);
  EXPECT_EQ(hear("18EF8081", "46").message, MessageId::SetupModeAck);
  EXPECT_EQ(hear("18EF8081", "46").message, MessageId::SetupModeRequest) << "answered once";
  pass(2s + 1ns);
  EXPECT_EQ(hear("18EF8180", "46").message, MessageId::SetupModeRequest) << "too late to be an answer";
}

TEST_F(OneChannel, AnswersEachOfTwoRequestsOnce) {
  announce(0x80);
  announce(0x81);
  hear("18EF8180", "41");
  hear("18EF8180", "41");
  EXPECT_EQ(hear("18EF8081", "41").message, MessageId::ZeroAxesAck);
  EXPECT_EQ(hear("18EF8081", "41").message, MessageId::ZeroAxesAck);
  EXPECT_EQ(hear("18EF8081", "41").message, MessageId::ZeroAxesRequest);
}

TEST_F(OneChannel, GuessesTheAcknowledgementOfUnknownNodesFromTheDynamicAddress) {
  EXPECT_EQ(hear("18EF0580", "41").message, MessageId::ZeroAxesAck);
  EXPECT_EQ(hear("18EF8005", "41").message, MessageId::ZeroAxesRequest);
}

TEST_F(OneChannel, ForgetsTheOldestRequestRatherThanFailing) {
  announce(0x80);
  announce(0x81);
  for (int i = 0; i < 1000; ++i) hear("18EF8180", "41");
  EXPECT_EQ(hear("18EF8081", "41").message, MessageId::ZeroAxesAck);
}

TEST_F(OneChannel, PresumesPdosUntilTheNodeAnswersWithAPartNumber) {
  EXPECT_EQ(hear("1A4", "011D940371000001").family, Family::Presumed);
  EXPECT_EQ(hear("224", "107D046400100000").family, Family::Presumed);
  EXPECT_EQ(hear("1A4", "021D940371000001"), Classified{});
  EXPECT_EQ(hear("2A4", "83C0"), Classified{});
  hear("5A4", "4300500100000000");
  EXPECT_EQ(hear("1A4", "011D940371000001").family, Family::Presumed) << "0 is no part number";
  hear("5A4", "4300500116699803");
  EXPECT_EQ(hear("1A4", "011D940371000001").family, Family::Canopen);
  EXPECT_TRUE(hear("2A4", "83C0").malformed);
}

TEST_F(OneChannel, HoldsSdosToTheSizeTheirSpecifierSays) {
  EXPECT_FALSE(hear("5A4", "4F0150020B").malformed);
  EXPECT_FALSE(hear("5A4", "4F0150020B000000").malformed);
  EXPECT_EQ(hear("5A4", "4F0150020B00").wanted, lengths(5, 8));
  EXPECT_TRUE(hear("5A4", "4F0150020B00").malformed);
  EXPECT_EQ(hear("5A4", "2F0150020B").message, MessageId::SdoOther) << "a write is a request";
  EXPECT_EQ(hear("624", "60").message, MessageId::SdoOther) << "of a request 60 asks for a segment";
  EXPECT_TRUE(hear("5A4", "").malformed);
}

TEST_F(OneChannel, DecodesNothingForNodeZero) {
  EXPECT_EQ(hear("700", "05"), Classified{});
  EXPECT_EQ(hear("580", "4300500116699803"), Classified{});
}

TEST_F(OneChannel, DecodesNeitherRemoteNorErrorFrames) {
  Frame guarding = frame("724", "");
  guarding.id |= kRemoteBit;
  EXPECT_EQ(m_walk.peek(guarding, m_now), Classified{});
  Frame error = frame("00000080", "0000000000000000");
  error.id |= kErrorBit;
  EXPECT_EQ(m_walk.peek(error, m_now), Classified{});
}

// Raw deflection, plus, minus -> tenths of a percent.
struct AxisCase {
  const char* name;
  unsigned raw, plus, minus;
  std::optional<int> tenths;
};
TEST(Axis, IsSignedOnlyWhereExactlyOneDirectionIsOn) {
  const AxisCase cases[] = {
      {"right", 500, 1, 0, 500},
      {"left", 500, 0, 1, -500},
      {"centre", 0, 0, 0, 0},
      {"zero to the right", 0, 1, 0, 0},
      {"both on", 500, 1, 1, {}},
      {"none on but deflected", 500, 0, 0, {}},
      {"above full", 1001, 1, 0, {}},
      {"full", 1000, 0, 1, -1000},
      {"error", 500, 2, 0, {}},
      {"other side error", 500, 1, 2, {}},
      {"not available", 1023, 3, 3, {}},
  };
  for (const AxisCase& c : cases) EXPECT_EQ(readAxis(c.raw, c.plus, c.minus), c.tenths) << c.name;
}

struct PositionCase {
  const char* name;
  unsigned raw, plus, minus;
  PositionReading reading;
};
TEST(Position, HasAValueOnlyInStateOk) {
  using enum PositionState;
  const PositionCase cases[] = {
      {"right", 473, 1, 0, {Ok, 473}},
      {"left", 55, 0, 1, {Ok, -55}},
      {"centre by our rule", 0, 0, 0, {Ok, 0}},
      {"no side but an angle", 1, 0, 0, {Invalid, 0}},
      {"both sides", 473, 1, 1, {Invalid, 0}},
      {"other side error", 473, 1, 2, {Invalid, 0}},
      {"sensor error", 0xFFF, 1, 0, {SensorError, 0}},
      {"not fitted", 0xFFF, 3, 3, {NotFitted, 0}},
      {"no angle, other side", 0xFFF, 0, 1, {Invalid, 0}},
      {"not available with an angle", 12, 3, 3, {Invalid, 0}},
  };
  for (const PositionCase& c : cases) EXPECT_EQ(readPosition(c.raw, c.plus, c.minus), c.reading) << c.name;
}

}  // namespace
}  // namespace deckpipe
