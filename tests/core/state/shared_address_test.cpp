// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdio>

#include "health_bus.h"

namespace deckpipe {
namespace {

using namespace test;

TEST(TwoAtOneAddress, IsWhereTwoPositionsComeInTurn) {
  Bus bus;
  bus.hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA).pass(500ms);
  bus.hear("18EEFF80", kNameOfB).hear("18EFFF80", kAnnouncesB).pass(100ms);
  for (int i = 0; i < 8; ++i) bus.hear("18EFFF80", i % 2 == 0 ? kPosition : kOtherPosition).pass(50ms);
  EXPECT_EQ(listed(bus, kPinA), "two_at_one_address address_lost faults_never_asked status_never_heard");
  EXPECT_EQ(listed(bus, kPinB), "two_at_one_address faults_never_asked status_never_heard");
  EXPECT_EQ(healthOf(bus.state(), *bus.device(kPinA)).sharedAddress, Address{0x80});
}

TEST(TwoAtOneAddress, IsWhereStatusesThatDifferComeTwiceAPeriodForTwoSeconds) {
  Bus bus;
  bus.monitor();
  const auto both = [&](Duration time, Duration apart) {
    for (Duration t = 0s; t < time; t += 100ms)
      bus.hear("18EFFF80", kPosition).pass(apart).hear("18EFFF80", kTurnedALittle).pass(100ms - apart);
  };
  both(1900ms, 10ms);
  EXPECT_EQ(bus.device(kPinA)->doubled, kNotYet);
  both(300ms, 10ms);
  EXPECT_NE(bus.device(kPinA)->doubled, kNotYet);
  bus.goOn(11s);
  EXPECT_EQ(listed(bus), "faults_never_asked") << "the other one is gone";
}

// Both at rest say the same, byte for byte.
TEST(TwoAtOneAddress, IsWhereEqualStatusesComeTwiceAPeriodForTwoSeconds) {
  Bus bus;
  bus.monitor();
  for (int i = 0; i < 21; ++i) bus.pass(40ms).statuses().pass(60ms).statuses();
  EXPECT_EQ(listed(bus), "two_at_one_address faults_never_asked");
}

TEST(TwoAtOneAddress, IsWhereEqualStatusesComeFifteenMillisecondsApart) {
  Bus bus;
  bus.monitor().answered();
  for (int i = 0; i < 100; ++i) {
    bus.pass(85ms).statuses();
    if (i % 10 == 0) bus.answered().hear("18EFF980", kNoFaults);
    bus.pass(15ms).statuses();
  }
  EXPECT_EQ(listed(bus), "two_at_one_address");
}

// A log that holds each frame twice says the same until something changes.
TEST(TwoAtOneAddress, IsOnlyEqualUntilAStatusChangesInPairs) {
  Bus bus;
  const auto health = [&bus] { return healthOf(bus.state(), *bus.device(kPinA)); };
  const auto twice = [&bus](int periods, std::string_view position) {
    for (int i = 0; i < periods; ++i) bus.pass(70ms).statuses(position).pass(30ms).statuses(position);
  };
  bus.monitor();
  twice(25, kPosition);
  EXPECT_TRUE(health().has(HealthCause::TwoAtOneAddress));
  EXPECT_TRUE(health().isOnlyEqual);
  twice(1, kTurnedALittle);
  EXPECT_FALSE(health().has(HealthCause::TwoAtOneAddress));
  for (int i = 0; i < 25; ++i) bus.pass(70ms).statuses(kPosition).pass(30ms).statuses(kTurnedALittle);
  EXPECT_TRUE(health().has(HealthCause::TwoAtOneAddress));
  EXPECT_TRUE(health().isOnlyEqual) << "two loggers may have heard one device, a second apart";
  bus.note(note::LinkUp{}).pass(30ms);
  EXPECT_TRUE(health().has(HealthCause::TwoAtOneAddress));
  EXPECT_FALSE(health().isOnlyEqual) << "they say different things, and one link heard them";
}

// Two loggers heard one moving monitor, and what they wrote was put into one log, a second apart.
TEST(TwoAtOneAddress, IsNotCertainOfAMonitorInALogOfTwoLoggers) {
  Bus bus;
  bus.monitor();
  const auto positionAt = [](int period) {
    char data[17];
    std::snprintf(data, sizeof data, "011D%02X0371000041", period % 256);
    return std::string(data);
  };
  for (int i = 0; i < 60; ++i)
    bus.pass(70ms).hear("18EFFF80", positionAt(i)).pass(30ms).hear("18EFFF80", positionAt(i + 246));
  const Health health = healthOf(bus.state(), *bus.device(kPinA));
  EXPECT_TRUE(health.has(HealthCause::TwoAtOneAddress));
  EXPECT_TRUE(health.isOnlyEqual);
}

// Of two PINs in turn no pace needs to tell.
TEST(TwoAtOneAddress, IsCertainOfTwoPins) {
  Bus bus;
  bus.hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA).pass(500ms);
  bus.hear("18EEFF80", kNameOfB).hear("18EFFF80", kAnnouncesB).pass(100ms);
  for (int i = 0; i < 8; ++i) bus.hear("18EFFF80", i % 2 == 0 ? kPosition : kOtherPosition).pass(50ms);
  bus.hear("18EFFF80", kAnnouncesA).pass(100ms);
  EXPECT_FALSE(healthOf(bus.state(), *bus.device(kPinB)).isOnlyEqual);
}

// A 6033 that neither claims nor announces sends its outputs from the address of a 6032.
TEST(TwoAtOneAddress, IsWhereAStatusComesThatTheTypeDoesNotSend) {
  Bus bus;
  bus.monitor().answered().statuses().hear("18EFFF80", kFaultedMiniOutputs);
  EXPECT_EQ(listed(bus), "two_at_one_address") << "the fault is the other device's";
  EXPECT_FALSE(healthOf(bus.state(), *bus.device(kPinA)).isOnlyEqual);
  bus.goOn(5s);
  EXPECT_EQ(listed(bus), "two_at_one_address") << "it is not this device's status that is late";
  bus.goOn(6s);
  EXPECT_EQ(listed(bus), "fine") << "the other one is gone";
}

TEST(TwoAtOneAddress, IsNotWhereATypeSendsSoftLimitsThatItMaySend) {
  Bus bus;
  bus.monitor().answered().statuses().hear("18EFFF80", kRotationLimits);
  EXPECT_EQ(listed(bus), "fine");
}

TEST(TwoAtOneAddress, IsOfThreeAndFour) {
  for (const Duration apart : {33ms, 25ms}) {
    Bus bus;
    bus.monitor();
    for (Duration t = 0s; t < 2300ms; t += apart) bus.pass(apart).statuses();
    EXPECT_EQ(listed(bus), "two_at_one_address faults_never_asked");
  }
}

TEST(TwoAtOneAddress, IsWhereTheFirstPinComesBackAndTheSecondDoesNotGo) {
  Bus bus;
  bus.monitor().pass(500ms).hear("18EFFF80", kAnnouncesB).pass(500ms).hear("18EFFF80", kAnnouncesA);
  EXPECT_EQ(listed(bus), "late faults_never_asked") << "the second may give way yet";
  bus.statuses().pass(250ms);
  EXPECT_EQ(listed(bus), "two_at_one_address faults_never_asked");
}

TEST(TwoAtOneAddress, IsNoSilenceOfTheOneThatLostIt) {
  Bus bus;
  bus.hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA).statuses().answered().pass(500ms);
  bus.hear("18EEFF80", kNameOfB).hear("18EFFF80", kAnnouncesB).pass(100ms);
  for (int i = 0; i < 200; ++i)
    bus.hear("18EFFF80", i % 2 == 0 ? kPosition : kOtherPosition).hear("18EFFF80", kOutputs).pass(50ms);
  EXPECT_EQ(listed(bus, kPinA), "two_at_one_address address_lost");
  bus.goOn(15s);
  EXPECT_EQ(listed(bus, kPinA), "silent address_lost faults_old") << "the other one alone sends";
}

TEST(TwoAtOneAddress, IsOfNobodyWhoLeftItBefore) {
  Bus bus;
  bus.monitor().pass(1s).hear("18EEFF80", kNameOfB).pass(300ms).hear("18EFFF80", kAnnouncesB);
  EXPECT_TRUE(bus.device(kPinA)->address == kNullAddress);
  bus.pass(60s);
  for (int i = 0; i < 8; ++i) bus.hear("18EFFF80", i % 2 == 0 ? kPosition : kOtherPosition).pass(50ms);
  EXPECT_TRUE(healthOf(bus.state(), *bus.device(kPinB)).has(HealthCause::TwoAtOneAddress));
  EXPECT_FALSE(healthOf(bus.state(), *bus.device(kPinA)).has(HealthCause::TwoAtOneAddress));
}

TEST(TwoAtOneAddress, IsOfBothAfterAPauseToo) {
  Bus bus;
  bus.monitor().pass(1s).hear("18EEFF80", kNameOfB).pass(300ms).hear("18EFFF80", kAnnouncesB);
  const auto bothSend = [&](int statuses) {
    for (int i = 0; i < statuses; ++i)
      bus.hear("18EFFF80", i % 2 == 0 ? kPosition : kOtherPosition).pass(50ms);
  };
  bothSend(8);
  EXPECT_TRUE(healthOf(bus.state(), *bus.device(kPinA)).has(HealthCause::TwoAtOneAddress));
  bus.pass(13s);
  EXPECT_FALSE(healthOf(bus.state(), *bus.device(kPinA)).has(HealthCause::TwoAtOneAddress));
  bothSend(160);
  EXPECT_TRUE(healthOf(bus.state(), *bus.device(kPinB)).has(HealthCause::TwoAtOneAddress));
  EXPECT_TRUE(healthOf(bus.state(), *bus.device(kPinA)).has(HealthCause::TwoAtOneAddress));
}

TEST(TwoAtOneAddress, IsOfBothHoweverOftenTheSecondIsAnnounced) {
  Bus bus;
  bus.monitor().pass(300ms);
  for (int i = 0; i < 4; ++i) bus.hear("18EFFF80", kAnnouncesB).pass(5s);
  EXPECT_TRUE(healthOf(bus.state(), *bus.device(kPinB)).has(HealthCause::TwoAtOneAddress));
  EXPECT_TRUE(healthOf(bus.state(), *bus.device(kPinA)).has(HealthCause::TwoAtOneAddress));
}

TEST(TwoAtOneAddress, IsWhereTwoPinsAnswerInTurn) {
  Bus bus;
  const auto bothAnswer = [&] {
    bus.hear("18EAFFF9", kAsksForNames)
        .hear("18EFFF80", kAnnouncesA)
        .pass(20ms)
        .hear("18EFFF80", kAnnouncesB);
  };
  bothAnswer();
  EXPECT_EQ(listed(bus, kPinB), "faults_never_asked status_never_heard");
  bus.pass(1s);
  bothAnswer();
  EXPECT_EQ(listed(bus, kPinB), "two_at_one_address faults_never_asked status_never_heard");
  EXPECT_EQ(listed(bus, kPinA), "two_at_one_address address_lost faults_never_asked status_never_heard");
}

TEST(TwoAtOneAddress, IsWhereTwoNamesTakeItInTurn) {
  Bus bus;
  for (int i = 0; i < 2; ++i) {
    bus.hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA).pass(100ms);
    bus.hear("18EEFF80", kNameOfB).pass(900ms);
  }
  EXPECT_TRUE(healthOf(bus.state(), Channel{0}, Address{0x80}).has(HealthCause::TwoAtOneAddress));
  EXPECT_TRUE(healthOf(bus.state(), *bus.device(kPinA)).has(HealthCause::TwoAtOneAddress));
}

TEST(TwoAtOneAddress, IsOfAPinUnderTheNameOfAnother) {
  Bus bus;
  bus.hear("18EEFF80", kNameOfA).pass(300ms).hear("18EFFF80", kAnnouncesB);
  EXPECT_EQ(listed(bus, kPinB), "two_at_one_address faults_never_asked status_never_heard");
}

// Neither another NAME nor another PIN needs to come in turn.
TEST(TwoAtOneAddress, IsWhereStatusesGoOnUnderTheNameOfAnotherMaker) {
  for (const char* name : {kLowerForeignName, kHigherForeignName}) {
    Bus bus;
    bus.monitor().answered().goOn(5s).hear("18EEFF80", name).goOn(10s);
    EXPECT_EQ(listed(bus), "two_at_one_address");
    EXPECT_EQ(bus.device(kPinA)->address, Address{0x80});
    bus.hear("18EEFF81", name);
    EXPECT_EQ(listed(bus), "fine") << "the other one is elsewhere";
  }
}

TEST(TwoAtOneAddress, IsOfADeviceThatHasNotSaidWhoItIs) {
  Bus bus;
  const auto health = [&bus] { return healthOf(bus.state(), Channel{0}, Address{0x80}); };
  bus.goOn(5s).hear("18EEFF80", kLowerForeignName).goOn(10s);
  EXPECT_TRUE(health().has(HealthCause::TwoAtOneAddress));
  ASSERT_NE(bus.state().devices().byAddress({}, {0x80}), nullptr);
  EXPECT_EQ(bus.state().devices().byAddress({}, {0x80})->lastStatus, bus.now());
  bus.pass(2s);
  EXPECT_FALSE(health().has(HealthCause::TwoAtOneAddress));
  EXPECT_EQ(bus.state().devices().byAddress({}, {0x80}), nullptr) << "the other one has it";
}

// What a lawful bus gives.
class LawfulBus : public testing::Test {
 protected:
  bool isCalledShared() const {
    for (const Device& device : m_bus.state().devices().all()) {
      if (device.kind != Device::Kind::Free &&
          healthOf(m_bus.state(), device).has(HealthCause::TwoAtOneAddress))
        return true;
    }
    return false;
  }
  // A status every 100 ms that differs each time.
  void turn(int statuses) {
    for (int i = 0; i < statuses; ++i) {
      hearAngle();
      m_bus.pass(100ms);
    }
  }
  void hearAngle(std::uint8_t flags = 0) {
    char data[17];
    std::snprintf(data, sizeof data, "01%03X40371000041", 0x100u + m_angle++ % 0x600u * 2);
    m_bus.hear(frame("18EFFF80", data), flags);
  }
  Bus m_bus;
  unsigned m_angle = 0;
};

TEST_F(LawfulBus, ContestsThatTheHolderWins) {
  m_bus.monitor().pass(1s);
  for (int i = 0; i < 10; ++i) {
    m_bus.hear("18EEFF80", kNameOfB).pass(10ms).hear("18EEFF80", kNameOfA).pass(990ms);
    EXPECT_FALSE(isCalledShared());
  }
}

TEST_F(LawfulBus, AnAddressThatGoesOverAndBack) {
  m_bus.monitor().pass(1s);
  m_bus.hear("18EEFF80", kNameOfB).pass(300ms).hear("18EFFF80", kAnnouncesB).pass(2s);
  m_bus.hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA).pass(10ms);
  m_bus.hear("18EEFF81", kNameOfB).pass(250ms).hear("18EFFF81", kAnnouncesB);
  EXPECT_FALSE(isCalledShared());
}

TEST_F(LawfulBus, APowerSupplyThatBouncesTheSameContestEachTime) {
  for (int i = 0; i < 4; ++i) {
    m_bus.hear("18EEFF80", kNameOfB).pass(10ms).hear("18EEFF80", kNameOfA).pass(10ms);
    m_bus.hear("18EEFF81", kNameOfB).pass(250ms);
    m_bus.hear("18EFFF80", kAnnouncesA).hear("18EFFF81", kAnnouncesB).pass(2s);
    EXPECT_FALSE(isCalledShared());
  }
}

TEST_F(LawfulBus, ADeviceThatIsExchangedForAnotherAndBack) {
  m_bus.monitor().pass(1min).hear("18EFFF80", kAnnouncesB).pass(1min).hear("18EFFF80", kAnnouncesA).pass(1s);
  EXPECT_FALSE(isCalledShared());
}

TEST_F(LawfulBus, ABurstAfterAnAdapterStoodStill) {
  turn(20);
  m_bus.pass(10s);
  for (int i = 0; i < 100; ++i) hearAngle(Frame::kLate);  // all at the time of the cursor
  turn(20);
  EXPECT_FALSE(isCalledShared());
  m_bus.pass(10s);
  for (int i = 0; i < 100; ++i) {
    hearAngle();
    m_bus.pass(500us);
  }
  turn(30);
  EXPECT_FALSE(isCalledShared());
}

TEST_F(LawfulBus, AnAdapterThatGivesItsFramesInBatches) {
  for (int batch = 0; batch < 40; ++batch) {
    for (int i = 0; i < 5; ++i) {
      hearAngle();
      m_bus.pass(1ms);
    }
    m_bus.pass(495ms);
  }
  EXPECT_FALSE(isCalledShared());
}

TEST_F(LawfulBus, ALogThatHoldsEveryFrameTwice) {
  for (int i = 0; i < 60; ++i) {
    const char* position = i % 2 == 0 ? kPosition : kTurnedALittle;
    m_bus.hear("18EFFF80", position).pass(1ms).hear("18EFFF80", position).pass(99ms);
  }
  EXPECT_FALSE(isCalledShared());
}

TEST_F(LawfulBus, ALogThatHoldsEveryFrameTwiceAtOnceWhileNothingChanges) {
  for (int i = 0; i < 100; ++i) m_bus.statuses().pass(4ms).statuses().pass(96ms);
  EXPECT_FALSE(isCalledShared());
}

TEST_F(LawfulBus, AMonitorThatTurnsAndThatTwoLoggersHeardWhoseClocksDiffer) {
  for (const Duration apart : {10ms, 30ms, 47ms}) {
    for (int i = 0; i < 100; ++i) {
      const unsigned angle = m_angle;
      hearAngle();
      m_bus.hear("18EFFF80", kOutputs).pass(apart);
      m_angle = angle;
      hearAngle();
      m_bus.hear("18EFFF80", kOutputs).pass(100ms - apart);
      EXPECT_FALSE(isCalledShared()) << apart.count() << " at " << i;
    }
    m_bus.pass(20s);
  }
}

TEST_F(LawfulBus, AnAdapterThatStoodStillAndDrainsSlowly) {
  for (const bool turns : {true, false}) {
    turn(20);
    m_bus.goOn(2s).pass(4s);
    for (int i = 0; i < 60; ++i) {
      turns ? hearAngle() : static_cast<void>(m_bus.statuses());
      m_bus.pass(50ms);
      EXPECT_FALSE(isCalledShared()) << i;
    }
    turn(30);
    EXPECT_FALSE(isCalledShared());
  }
}

TEST_F(LawfulBus, AnAddressThatGoesBackToWhoeverCouldClaimNoOther) {
  m_bus.hear("18EEFF80", kNameOfB).hear("18EFFF80", kAnnouncesB).pass(3s);
  m_bus.hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA).pass(10ms);
  m_bus.hear("18EEFFFE", kNameOfB).pass(3s);
  m_bus.hear("18EEFF80", kNameOfB).pass(300ms).hear("18EFFF80", kAnnouncesB).pass(1s);
  EXPECT_FALSE(isCalledShared());
}

TEST_F(LawfulBus, ANameThatReplacesADevice) {
  for (const char* name : {kLowerForeignName, kHigherForeignName}) {
    Bus bus;
    bus.monitor().answered().goOn(5s).hear("18EEFF80", name).pass(10ms).statuses().pass(240ms).goOn(5s);
    EXPECT_EQ(listed(bus), "silent address_lost faults_old");
  }
}

TEST_F(LawfulBus, ASensorThatJumps) {
  for (int i = 0; i < 60; ++i) m_bus.hear("18EFFF80", i % 2 == 0 ? kPosition : kOtherPosition).pass(100ms);
  EXPECT_FALSE(isCalledShared());
}

TEST_F(LawfulBus, AGatewayThatIsSetToSendMoreOften) {
  for (int i = 0; i < 200; ++i) m_bus.hear("1A4", i % 2 == 0 ? kPosition : kOtherPosition).pass(50ms);
  EXPECT_FALSE(isCalledShared());
}

}  // namespace
}  // namespace deckpipe
