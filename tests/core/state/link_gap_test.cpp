// SPDX-License-Identifier: GPL-3.0-or-later
// What still holds behind a gap, while the link was down and another bus may have come to the plug.
#include <gtest/gtest.h>

#include "health_bus.h"
#include "state/current.h"
#include "state/in_force.h"
#include "state/role_notes.h"

namespace deckpipe::test {
namespace {

constexpr Address kMonitor{0x80};
constexpr Channel kCan0{0};

class BehindAGap : public testing::Test {
 protected:
  void gap(Duration length = 90s) { bus.note(note::LinkDown{}).pass(length).note(note::LinkUp{}).pass(1ms); }
  const AddressBook& book() const { return bus.state().channel(kCan0).book; }
  const Device* at(Address a) const { return bus.state().devices().byAddress(kCan0, a); }
  Health health() const { return healthOf(bus.state(), *at(kMonitor)); }

  Bus bus;
};

TEST_F(BehindAGap, APinIsFormerUntilItIsHeardAnew) {
  bus.monitor().answered();
  gap();
  bus.goOn(1s);
  EXPECT_EQ(bus.device(kPinA), nullptr);
  ASSERT_NE(at(kMonitor), nullptr);
  EXPECT_EQ(at(kMonitor)->kind, Device::Kind::Address);
  EXPECT_TRUE(at(kMonitor)->pin.isNull());
  EXPECT_EQ(book().formerPin(kMonitor).text(), kPinA);
  EXPECT_EQ(book().formerAddress(*Pin::parse(kPinA)), kMonitor);
  EXPECT_FALSE(book().isAkron(kMonitor));
  EXPECT_FALSE(book().isHeld(kMonitor));
  EXPECT_EQ(book().claim(kMonitor, bus.now()), ClaimState::NoClaim);
}

TEST_F(BehindAGap, AnAnnouncementMakesItCurrent) {
  bus.monitor().answered();
  gap(1s);
  bus.hear("18EFFF80", kAnnouncesA).statuses();
  EXPECT_EQ(bus.device(kPinA), at(kMonitor));
  EXPECT_TRUE(book().formerPin(kMonitor).isNull());
  EXPECT_TRUE(book().isAkron(kMonitor));
  EXPECT_EQ(listed(health()), "faults_old") << "the answer is of before";
  EXPECT_EQ(ageOfAnswer(bus.state(), *at(kMonitor), at(kMonitor)->faults().at), AnswerAge::BeforeGap);
  bus.answered();
  EXPECT_EQ(listed(health()), "fine");
}

TEST_F(BehindAGap, ItsNameMakesItCurrent) {
  bus.monitor();
  gap();
  bus.statuses().hear("18EEFF80", kNameOfA);
  ASSERT_NE(bus.device(kPinA), nullptr);
  EXPECT_EQ(bus.device(kPinA), at(kMonitor));
  EXPECT_EQ(book().pin(kMonitor).text(), kPinA);
  EXPECT_TRUE(book().formerHolder(kMonitor).isNull());
}

TEST_F(BehindAGap, AnotherDeviceAtItsAddressHasNothingOfIt) {
  for (const bool claims : {true, false}) {
    bus = {};
    bus.monitor().answered("02002000000000");
    gap();
    bus.goOn(1s);
    if (claims) bus.hear("18EEFF80", kNameOfB);
    bus.hear("18EFFF80", kAnnouncesB).statuses();
    EXPECT_EQ(bus.device(kPinA), nullptr);
    ASSERT_NE(bus.device(kPinB), nullptr);
    EXPECT_EQ(bus.device(kPinB), at(kMonitor));
    EXPECT_FALSE(at(kMonitor)->faults().isKnown());
    EXPECT_EQ(listed(health()), "faults_never_asked");
  }
}

TEST_F(BehindAGap, AForeignNameAtItsAddressEndsIt) {
  bus.monitor();
  gap();
  bus.hear("18EEFF80", kLowerForeignName);
  EXPECT_EQ(at(kMonitor), nullptr);
  EXPECT_TRUE(book().formerPin(kMonitor).isNull());
  EXPECT_TRUE(book().isForeign(kMonitor));
}

TEST_F(BehindAGap, ANameThatCannotClaimIsNowhereAnyMore) {
  bus.monitor();
  gap();
  bus.hear("18EEFFFE", kNameOfA);
  EXPECT_EQ(at(kMonitor), nullptr);
  EXPECT_TRUE(book().formerPin(kMonitor).isNull());
  EXPECT_TRUE(book().formerHolder(kMonitor).isNull());
}

TEST_F(BehindAGap, ThePinAtAnotherAddressLeavesNothingBehind) {
  bus.monitor();
  gap();
  bus.hear("18EFFF81", kAnnouncesA);
  EXPECT_EQ(at(kMonitor), nullptr);
  EXPECT_TRUE(book().formerPin(kMonitor).isNull());
  EXPECT_EQ(bus.device(kPinA), at({0x81}));
}

TEST_F(BehindAGap, WhatHadLostItsAddressIsForgotten) {
  bus.monitor().hear("18EEFF80", kLowerForeignName).pass(kClaimTime);
  ASSERT_NE(bus.device(kPinA), nullptr);
  gap();
  for (const Device& device : bus.state().devices().all()) EXPECT_EQ(device.kind, Device::Kind::Free);
}

TEST_F(BehindAGap, MessagesOfWhatWasAkronsArePresumed) {
  RoleWalk walk;
  const Instant now{1'000'000'000};
  const auto familyOf = [&](std::string_view id, std::string_view data) {
    return walk.next(frame(id, data), now).family;
  };
  familyOf("18EEFF21", kNameOfA);
  EXPECT_EQ(familyOf("18EFFF21", kOutputs), Family::Akron);
  EXPECT_EQ(familyOf("18EFF921", "FE41"), Family::Akron);
  teach(walk, Note{.time = now, .value = note::LinkDown{}});
  EXPECT_EQ(familyOf("18EFFF21", kOutputs), Family::Akron) << "the link is not up again";
  teach(walk, Note{.time = now, .value = note::LinkUp{}});
  EXPECT_EQ(familyOf("18EFFF21", kOutputs), Family::Presumed) << "though no monitor's address";
  EXPECT_EQ(familyOf("18EFF921", "FE41"), Family::Ambiguous);
  familyOf("18EEFF21", kNameOfA);
  EXPECT_EQ(familyOf("18EFFF21", kOutputs), Family::Akron);
}

TEST_F(BehindAGap, AnotherMakersNameIsNoReasonToOverlookAMonitor) {
  bus.hear("18EEFF90", kHigherForeignName).hear("18EFFF90", kOutputs);
  EXPECT_EQ(at({0x90}), nullptr);
  gap();
  bus.hear("18EFFF90", kOutputs);
  EXPECT_NE(at({0x90}), nullptr);
  EXPECT_FALSE(book().formerHolder({0x90}).isNull());
}

TEST_F(BehindAGap, ADriveStaysWhereThePersonSaid) {
  bus.hear("18FF0021", "00").note(note::DriveSaid{{}, {0x21}, true});
  gap();
  EXPECT_TRUE(book().isDrive({0x21}));
}

TEST_F(BehindAGap, ThePartNumberOfANodeIsFormerUntilItIsHeardAnew) {
  constexpr char kPart[] = "4300500116699803";  // 60320022
  bus.node().hear("5A4", kPart);
  const auto node = [&] { return bus.state().devices().byNode(kCan0, NodeId{0x24}); };
  ASSERT_EQ(node()->part(), 60'320'022u);
  gap();
  bus.node();
  EXPECT_EQ(node()->part(), 0u);
  EXPECT_TRUE(node()->partNumber.isKnown());
  EXPECT_FALSE(book().isAkronNode(NodeId{0x24}));
  bus.hear("5A4", kPart);
  EXPECT_EQ(node()->part(), 60'320'022u);
}

TEST_F(BehindAGap, SilenceIsCountedFromWhereTheLinkCameBack) {
  bus.monitor();
  gap();
  bus.hear("18EFFF80", kAnnouncesA).pass(3s - 2ms);
  EXPECT_FALSE(health().has(HealthCause::Silent));
  bus.pass(2s);
  ASSERT_TRUE(health().has(HealthCause::Silent));
  EXPECT_TRUE(health().isSinceLinkUp);
  EXPECT_EQ(health().since, bus.state().channel(kCan0).linkUp);
}

TEST_F(BehindAGap, WhoeverIsNotHeardSinceTheLinkCameBackIsIdleFromThenOn) {
  bus.monitor();
  gap();
  bus.pass(3s);
  ASSERT_EQ(listed(health()), "idle faults_never_asked");
  EXPECT_EQ(health().severity(), Severity::Unknown);
  EXPECT_TRUE(health().isSinceLinkUp);
  EXPECT_EQ(health().since, bus.state().channel(kCan0).linkUp);
}

TEST_F(BehindAGap, WhatAnAddressAnsweredIsNoAnswerOfThePinThatIsAnnouncedThere) {
  bus.statuses().answered("02002000000000");
  ASSERT_TRUE(at(kMonitor)->faults().isKnown());
  gap();
  bus.statuses().hear("18EFFF80", kAnnouncesB);
  ASSERT_EQ(bus.device(kPinB), at(kMonitor));
  EXPECT_FALSE(at(kMonitor)->faults().isKnown());
  EXPECT_TRUE(at(kMonitor)->position().isKnown()) << "it came behind the gap";
}

TEST_F(BehindAGap, WhatANameAnsweredIsNoAnswerOfAnothersPin) {
  bus.hear("18EEFF80", kNameOfA).statuses().answered("02002000000000");
  gap();
  bus.hear("18EFFF80", kAnnouncesB);
  ASSERT_EQ(bus.device(kPinB), at(kMonitor));
  EXPECT_FALSE(at(kMonitor)->faults().isKnown());
  EXPECT_FALSE(at(kMonitor)->position().isKnown());
}

TEST_F(BehindAGap, AnotherNameWithTheNumberOfThePinDoesNotMakeItCurrent) {
  bus.monitor();
  gap();
  bus.hear("18EEFF80", "0B1AC22801420090");  // another function instance
  EXPECT_EQ(bus.device(kPinA), nullptr);
  EXPECT_TRUE(book().pin(kMonitor).isNull());
}

TEST_F(BehindAGap, ANameThatHadLeftIsNotFormer) {
  bus.hear("18EEFF80", kHigherForeignName).hear("18EEFFFE", kHigherForeignName);
  bus.hear("18EEFF90", kHigherForeignName).hear("18EEFF90", kLowerForeignName);
  ASSERT_EQ(book().claimsLost({0x90}), 1);
  gap();
  EXPECT_TRUE(book().formerHolder(kMonitor).isNull());
  EXPECT_FALSE(book().formerHolder({0x90}).isNull());
  EXPECT_EQ(book().claimsLost({0x90}), 0);
}

TEST_F(BehindAGap, AnAddressHasNoMovesOfThePinThatWasThere) {
  bus.monitor().hear("18EFFF81", kAnnouncesA);
  ASSERT_EQ(at({0x81})->previousAddress(), kMonitor);
  gap();
  EXPECT_EQ(at({0x81})->previousAddress(), kNullAddress);
  EXPECT_EQ(at({0x81})->addressChanges, 0);
}

TEST_F(BehindAGap, AJoystickThatIsNotHeardAnewTimesOutForNobody) {
  bus.hear("0CFDD633", "907D010000000000").pass(10ms);
  gap();
  const auto stick = [&] { return *bus.state().channel(kCan0).joysticks.find({0x33}); };
  bus.pass(1s);
  EXPECT_FALSE(stick().isActive());
  EXPECT_FALSE(stick().timedOut);
  EXPECT_EQ(stick().timeouts, 0u);
  EXPECT_FALSE(healthOf(bus.state(), kCan0, {0x33}).has(HealthCause::JoystickStopped));
  bus.hear("0CFDD633", "907D010000000000");
  EXPECT_TRUE(stick().isActive());
  bus.pass(1s);
  EXPECT_EQ(stick().timeouts, 1u);
}

TEST_F(BehindAGap, AJoystickThatHadStoppedBeforeItIsNotSaidToHaveStopped) {
  bus.hear("0CFDD633", "907D010000000000").pass(2s);
  gap(57s);
  EXPECT_FALSE(healthOf(bus.state(), kCan0, {0x33}).has(HealthCause::JoystickStopped));
}

TEST(BehindAGapWithoutTimes, WhatIsSaidAnewIsCurrentAndWhatWasSaidIsForgotten) {
  State state;
  const auto hear = [&](std::string_view id, std::string_view data) { state.apply(frame(id, data), {}); };
  const auto at80 = [&]() -> const Device& { return *state.devices().byAddress(kCan0, kMonitor); };
  state.apply(Note{.value = note::LinkUp{}});
  hear("18EEFF80", kNameOfA);
  hear("18EFFF80", kAnnouncesA);
  hear("18EFFF80", kPosition);
  hear("18EF80F9", "02");
  hear("18EFF980", "02002000000000");
  state.apply(Note{.value = note::LinkDown{}});
  state.apply(Note{.value = note::LinkUp{}});
  EXPECT_FALSE(at80().faults().isKnown());
  EXPECT_FALSE(at80().position().isKnown());
  hear("18EFFF80", kAnnouncesA);
  hear("18EFFF80", kPosition);
  hear("18EF80F9", "02");
  hear("18EFF980", kNoFaults);
  EXPECT_EQ(ageOfAnswer(state, at80(), at80().faults().at), AnswerAge::Current);
  EXPECT_FALSE(isCutOff(state, kCan0, at80().position().at));
}

TEST_F(BehindAGap, StatusesThatCameBackWithTheLinkEndNoSilence) {
  bus.monitor();
  gap();
  bus.hear("18EFFF80", kAnnouncesA).statuses();
  EXPECT_EQ(at(kMonitor)->resumed, kNotYet);
}

TEST_F(BehindAGap, AFormerIdentityIsNotInForce) {
  FrameStore frames;
  NoteStore notes;
  std::vector<Frame> batch;
  std::int64_t stamp = 1'000'000'000;
  for (const char* data : {kAnnouncesA, kOutputs, kOutputs})
    batch.push_back(frame("18EFFF80", data, 0, stamp += 100'000'000));
  ASSERT_TRUE(frames.append(batch));
  EXPECT_EQ(framesInForce(frames, notes, 2, {}).size(), 1u);
  notes.append({.frame = 1, .time = frames.timeAt(0), .value = note::LinkDown{}});
  notes.append({.frame = 1, .time = frames.timeAt(1), .value = note::LinkUp{}});
  EXPECT_TRUE(framesInForce(frames, notes, 2, {}).empty());
}

TEST_F(BehindAGap, WhatWasSaidBeforeItIsNotInForceWhereTheNextFrameComes) {
  FrameStore frames;
  NoteStore notes;
  const std::vector<Frame> batch{
      frame("18EFFF80", kAnnouncesA, 0, 1'000'000'000), frame("18EFF980", "03010203040506", 0, 1'100'000'000),
      frame("18EFF981", "03010203040506", 0, 1'200'000'000),  // of a monitor that has not said its PIN
      frame("18EFFF81", kOutputs, 0, 1'300'000'000), frame("18EFFF81", kOutputs, 0, 1'400'000'000)};
  ASSERT_TRUE(frames.append(batch));
  EXPECT_EQ(framesInForce(frames, notes, 3, {}).size(), 3u);
  notes.append({.frame = 3, .time = frames.timeAt(2), .value = note::LinkDown{}});
  EXPECT_EQ(framesInForce(frames, notes, 3, {}).size(), 3u) << "the link is not up again";
  notes.append({.frame = 3, .time = frames.timeAt(3), .value = note::LinkUp{}});
  EXPECT_TRUE(framesInForce(frames, notes, 3, {}).empty());
  EXPECT_TRUE(framesInForce(frames, notes, 4, {}).empty());
}

TEST(JoystickSource, IsKnownWhereItsMessagesAreMalformedFromTheStart) {
  Bus bus;
  bus.hear("0CFDD633", "01000100");
  const auto stick = [&] { return bus.state().channel(kCan0).joysticks.find({0x33}); };
  ASSERT_NE(stick(), nullptr);
  EXPECT_FALSE(stick()->isUnderstood());
  EXPECT_FALSE(stick()->isActive());
  EXPECT_EQ(listed(healthOf(bus.state(), kCan0, Address{0x33})), "malformed cannot_be_asked");
  bus.pass(1s);
  EXPECT_FALSE(stick()->timedOut) << "controllers held no input of it";
}

}  // namespace
}  // namespace deckpipe::test
