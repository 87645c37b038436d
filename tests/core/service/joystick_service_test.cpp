// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of motion (design.md section 7) as far as the bus side keeps them, each in tests of its number: the
// console's joystick and a simulated 6032 back to back, time jumping from deadline to deadline.
#include "service/joystick_service.h"

#include <gtest/gtest.h>

#include "support/pair.h"

namespace deckpipe::test {
namespace {

using Stage = JoystickStatus::Progress;
using simulator::Function;
using simulator::Monitor6032;

constexpr Address kOurs{0x38};
const Pin kMonitor = *Pin::parse("1032AE100801035");
const Pin kOther = *Pin::parse("1040AE100801777");

Payload bytes(const char* hex) { return frame("00000000", hex).data; }
const Payload kNeutral = bytes("0100010000000000");

struct Joystick : ::testing::Test {
  explicit Joystick(const ServiceSettings& settings = {.echoIsProven = true})
      : console(pair.addConsole(settings)) {
    simulator::MonitorSettings ahead;
    ahead.startsStowed = false;
    monitor = &pair.simulator.add<Monitor6032>(500ms, kMonitor.text(), ahead, 1u);
    pair.simulator.powerOn(pair.now());
    pair.run(1s);
    pair.unlock();
  }

  Pair pair;
  Monitor6032* monitor;
  Console& console;

  JoystickStatus status() { return console.status(pair.now()).joystick; }
  intent::ArmJoystick arming() const {
    return {.source = kOurs, .moves = {kMonitor}, .limit = 1000, .platform = "a test"};
  }
  void arm() {
    ASSERT_EQ(pair.intend(arming()), Refusal::None);
    ASSERT_TRUE(pair.runUntil([&] { return status().progress == Stage::Armed; }, 2s));
  }
  Refusal say(bool isHeld, int x = 0, int y = 0, Duration age = 0ns) {
    return pair.intend(intent::HoldJoystick{
        .isHeld = isHeld, .x = *Deflection::of(x), .y = *Deflection::of(y), .verified = pair.now() - age});
  }
  Refusal press() {
    EXPECT_EQ(say(false), Refusal::None);
    return say(true);
  }
  // Held for so long, with a word of it every 20 ms, as long as it is taken for one.
  void hold(Duration length, int x, int y = 0) {
    for (const Instant end = pair.now() + length; pair.now() < end;) {
      say(true, x, y);
      pair.run(std::min<Duration>(20ms, end - pair.now()));
    }
  }
  void pressAndHold(Duration length, int x, int y = 0) {
    ASSERT_EQ(press(), Refusal::None);
    hold(length, x, y);
  }
  void armAndHold(int x = 500, int y = 0) {
    arm();
    pressAndHold(100ms, x, y);
    ASSERT_EQ(status().progress, Stage::Held);
  }
  std::vector<Pair::Seen> fromOurs(Instant from = kNotYet) {
    std::vector<Pair::Seen> out = pair.sentBy(&console, from);
    std::erase_if(out, [](const Pair::Seen& seen) { return seen.id().source != kOurs; });
    return out;
  }
  // Joystick messages as they were handed over to the adapter, since `from` things were.
  std::vector<Frame> written(std::size_t from = 0) const {
    std::vector<Frame> out;
    for (std::size_t i = from; i < pair.written.size(); ++i) {
      if (pair.written[i].id().pgn == pgn::kBasicJoystick) out.push_back(pair.written[i].frame);
    }
    return out;
  }
  std::size_t mark() const { return pair.written.size(); }
  static std::size_t motionIn(const std::vector<Frame>& frames) {
    return static_cast<std::size_t>(
        std::ranges::count_if(frames, [](const Frame& f) { return f.data != kNeutral; }));
  }
  int rotation() const { return monitor->control().rotation(); }
  template <typename Kind>
  std::vector<Kind> notes() {
    std::vector<Kind> out;
    for (const Note& note : console.notes) {
      if (const auto* kind = std::get_if<Kind>(&note.value)) out.push_back(*kind);
    }
    return out;
  }
  void expectNeutralOnly(MotionCause cause, std::size_t from) {
    EXPECT_EQ(status().cause, cause);
    EXPECT_NE(status().progress, Stage::Held);
    const std::vector<Frame> after = written(from);
    ASSERT_FALSE(after.empty());
    EXPECT_EQ(motionIn(after), 0u);
  }
  void addOtherMonitor() {
    pair.inject(simulator::announcementFrame(kOther, Address{0x90}));
    pair.run(1ms);
  }
  Address monitorAddress() const { return monitor->address(); }
  Frame fromMonitor(std::string_view data) {
    Frame f = frame("18EFFF00", data);
    f.id |= monitorAddress().value;
    return f;
  }
};

TEST(Joystick_, Rule03WhatTheMessagesCannotSayCannotBeEncoded) {
  EXPECT_FALSE(Deflection::of(1001));
  EXPECT_FALSE(Deflection::of(-1001));
  EXPECT_FALSE(Deflection::of(1023));
  EXPECT_EQ(Deflection::of(1000)->within(300).tenths(), 300);
  EXPECT_EQ(Deflection::of(-1000)->within(300).tenths(), -300);
}

// Every deflection that can be held, as it is on the bus.
TEST_F(Joystick, Rule03DeflectionsAreWholeAndInOneDirection) {
  struct {
    int x, y;
    const char* data;
  } const rows[] = {
      {1, 0, "5000010000000000"},      {1000, 0, "10FA010000000000"}, {-1, 0, "4400010000000000"},
      {-1000, 0, "04FA010000000000"},  {0, 1000, "010010FA00000000"}, {0, -1000, "010004FA00000000"},
      {500, -250, "107D843E00000000"}, {0, 0, "0100010000000000"},
  };
  for (const auto& row : rows) {
    arm();
    ASSERT_EQ(press(), Refusal::None);
    const std::size_t from = mark();
    say(true, row.x, row.y);
    pair.run(30ms);
    ASSERT_FALSE(written(from).empty());
    const Frame sent = written(from).back();
    EXPECT_EQ(sent.data, bytes(row.data)) << row.x << ' ' << row.y;
    EXPECT_EQ(sent.length, 8);
    EXPECT_EQ(sent.id, frame("0CFDD638", "").id);
    const BasicJoystick read = BasicJoystick::of(sent);
    for (const StickAxis& axis : {read.x, read.y}) {
      EXPECT_EQ((axis.plus == Status2::On) + (axis.minus == Status2::On) + (axis.neutral == Status2::On), 1);
      EXPECT_EQ(axis.detent, Status2::Off);
    }
    pair.intend(intent::DisarmJoystick{});
    pair.run(1s);
  }
}

TEST_F(Joystick, Rule01ArmingNamesEveryMonitorThatIsHeardAndNoOther) {
  intent::ArmJoystick wanted = arming();
  wanted.moves = {};
  EXPECT_EQ(pair.intend(wanted), Refusal::OtherMonitors);
  wanted.moves = {kMonitor, kOther};
  EXPECT_EQ(pair.intend(wanted), Refusal::NoDevice);
  addOtherMonitor();
  EXPECT_EQ(pair.intend(arming()), Refusal::OtherMonitors) << "it would move as well";
  EXPECT_EQ(pair.intend(wanted), Refusal::None);
  EXPECT_TRUE(fromOurs().empty());
}

TEST_F(Joystick, Rule01WhoSpeaksAsAMonitorWithoutAPinCannotBeNamed) {
  pair.inject(frame("18EFFF93", "011D940371000041"));
  pair.run(1ms);
  EXPECT_EQ(pair.intend(arming()), Refusal::OtherMonitors);
}

TEST_F(Joystick, Rule01AMonitorThatWasNotHeardForASecondIsNotMoved) {
  pair.simulator.press(pair.now(), 0, SimulatorButton::PowerOff);
  pair.run(1100ms);
  EXPECT_EQ(pair.intend(arming()), Refusal::NotHeard);
}

TEST_F(Joystick, Rule01ANewPinWhileHeldDisarms) {
  armAndHold();
  const std::size_t from = mark();
  addOtherMonitor();
  pair.run(100ms);
  expectNeutralOnly(MotionCause::ControllerAppeared, from);
  EXPECT_EQ(status().progress, Stage::Ending);
  pair.run(1s);
  EXPECT_EQ(status().progress, Stage::Off);
}

TEST_F(Joystick, Rule01AnAkronNameThatNoPinHasDisarms) {
  arm();
  pair.inject(frame("18EEFF95", "07004028004200A0"));
  pair.run(1ms);
  EXPECT_EQ(status().progress, Stage::Armed) << "not Akron's";
  Frame claim = frame("18EEFF96", "0700C02800420090");
  pair.inject(claim);
  pair.run(1ms);
  EXPECT_EQ(status().cause, MotionCause::ControllerAppeared);
}

TEST_F(Joystick, Rule01AKnownPinAtAnotherAddressDisarms) {
  armAndHold();
  const std::size_t from = mark();
  Frame moved = fromMonitor("FF83150206021A0B");
  moved.id = frame("18EFFFA0", "").id;
  pair.inject(moved);
  pair.run(50ms);
  expectNeutralOnly(MotionCause::ControllerAppeared, from);
}

TEST_F(Joystick, Rule01ALostClaimDisarms) {
  arm();
  Frame taken = frame("18EEFF00", "0100000000000000");
  taken.id |= monitorAddress().value;
  pair.inject(taken);
  pair.run(10ms);
  EXPECT_EQ(status().progress, Stage::Off);
  EXPECT_TRUE(status().cause == MotionCause::ControllerAppeared ||
              status().cause == MotionCause::MonitorGone);
}

TEST_F(Joystick, Rule01AMonitorThatFallsSilentDisarms) {
  armAndHold();
  pair.simulator.press(pair.now(), 0, SimulatorButton::PowerOff);
  hold(1200ms, 500);
  EXPECT_EQ(status().cause, MotionCause::MonitorGone);
  EXPECT_EQ(status().progress, Stage::Ending);
}

TEST_F(Joystick, Rule03TheAddressIsClaimedAsAControllerApplicationOfItsOwn) {
  ASSERT_EQ(pair.intend(arming()), Refusal::None);
  const Instant from = pair.now();
  pair.run(10ms);
  ASSERT_EQ(fromOurs().size(), 1u) << "silent for longer than a second by now";
  EXPECT_EQ(fromOurs()[0].id().pgn, pgn::kAddressClaimed);
  const Name ours = Name::of(fromOurs()[0].frame);
  const Name consoles = consoleName(1);
  EXPECT_NE(ours.value, consoles.value);
  EXPECT_EQ(ours.identityNumber(), consoles.identityNumber());
  EXPECT_EQ(ours.function(), consoles.function());
  EXPECT_NE(ours.part(fieldOf(j1939::kNameFields, "function_instance").bits),
            consoles.part(fieldOf(j1939::kNameFields, "function_instance").bits));
  EXPECT_EQ(say(true), Refusal::NotArmed);
  pair.runTo(from + kClaimTime);
  EXPECT_EQ(status().progress, Stage::Settling) << "counted from its echo";
  pair.run(Pair::kFlight);
  EXPECT_EQ(status().progress, Stage::Armed);
}

TEST_F(Joystick, Rule03AnAddressThatWasUsedWithinASecondOrIsHeldIsNotTaken) {
  intent::ArmJoystick wanted = arming();
  for (const unsigned source : {0x32u, 0x39u, 0xF9u, 0xFEu}) {
    wanted.source = Address{static_cast<std::uint8_t>(source)};
    EXPECT_EQ(pair.intend(wanted), Refusal::NotTaken) << source;
  }
  pair.inject(frame("18FECA38", "0000000000000000"));
  pair.run(999ms);
  EXPECT_EQ(pair.intend(arming()), Refusal::SourceTaken);
  pair.run(2ms);
  EXPECT_EQ(pair.intend(arming()), Refusal::None);
  pair.intend(intent::DisarmJoystick{});
  pair.inject(frame("18EEFF38", "0100000000000000"));
  pair.run(2s);
  EXPECT_EQ(pair.intend(arming()), Refusal::SourceTaken) << "another NAME holds it";
}

TEST_F(Joystick, Rule03SoonAfterUnlockingItListensForTheRestOfASecond) {
  pair.intend(intent::Lock{});
  pair.run(1s);
  pair.intend(intent::Unlock{});
  const Instant unlocked = pair.now();
  pair.run(400ms);
  ASSERT_EQ(pair.intend(arming()), Refusal::None);
  pair.runTo(unlocked + 999ms);
  EXPECT_TRUE(fromOurs().empty());
  EXPECT_EQ(status().progress, Stage::Listening);
  pair.run(2ms);
  EXPECT_EQ(fromOurs().size(), 1u);
}

TEST_F(Joystick, Rule03NoJoystickOfAPersonAtTheTruckIsOutranked) {
  const auto other = [&](std::uint8_t source) {
    Frame f = frame("0CFDD600", "0100010000000000");
    f.id |= source;
    pair.inject(f);
    pair.run(1ms);
  };
  intent::ArmJoystick wanted = arming();
  wanted.source = Address{0x36};
  other(0x37);
  EXPECT_EQ(pair.intend(wanted), Refusal::WouldOutrank);
  pair.run(1s);
  other(0x35);
  EXPECT_EQ(pair.intend(wanted), Refusal::None) << "that one outranks us";
  pair.run(500ms);
  ASSERT_EQ(status().progress, Stage::Armed);
  other(0x37);
  EXPECT_EQ(status().cause, MotionCause::WouldOutrank);
  EXPECT_EQ(status().progress, Stage::Off);
}

TEST_F(Joystick, Rule03OnlyJoystickMessagesAndClaimsGoOutFromTheAddress) {
  armAndHold();
  pair.inject(frame("18EA38F0", "00EE00"));  // our NAME
  pair.inject(frame("18EA38F0", "DAFE00"));  // anything else
  pair.inject(frame("18EFF9F0", "FE41"));
  pair.intend(intent::SendRequests{DeviceKey::of(kMonitor), kPolls});
  hold(500ms, 500);
  std::size_t names = 0;
  for (const Pair::Seen& seen : fromOurs()) {
    names += seen.id().pgn == pgn::kAddressClaimed ? 1 : 0;
    EXPECT_TRUE(seen.id().pgn == pgn::kBasicJoystick || seen.id().pgn == pgn::kAddressClaimed);
  }
  EXPECT_EQ(names, 2u);
  EXPECT_FALSE(pair.sent(0x02, &console).empty()) << "polls go on, from the console's own address";
}

// Whatever the NAME: one neutral at most, so that our deflection does not stay, and 'cannot claim' once.
TEST_F(Joystick, Rule03AForeignClaimOrFrameEndsItAtOnce) {
  for (const char* data : {"0100000000000000", "FFFFFFFFFFFFFFFF", "other"}) {
    armAndHold();
    const Instant from = pair.now();
    const std::size_t before = mark();
    const bool isClaim = data[0] != 'o';
    pair.inject(isClaim ? frame("18EEFF38", data) : frame("0CFDD638", "10FA010000000000"));
    pair.run(3s);
    EXPECT_EQ(status().progress, Stage::Off);
    EXPECT_EQ(status().cause, MotionCause::SourceTaken);
    const std::vector<Frame> after = written(before);
    ASSERT_EQ(after.size(), 1u) << data;
    EXPECT_EQ(after[0].data, kNeutral);
    const auto sent = pair.sentBy(&console, from + Pair::kFlight);
    EXPECT_EQ(std::ranges::count_if(sent,
                                    [](const Pair::Seen& seen) {
                                      return seen.id().pgn == pgn::kAddressClaimed &&
                                             seen.id().source == kNullAddress;
                                    }),
              1);
    pair.inject(frame("18EEFFFE", isClaim ? data : "00"));  // it leaves again
    pair.run(1s);
  }
}

TEST_F(Joystick, Rule03AClaimMeanwhileEndsTheArmingWithoutAWordOfMotion) {
  ASSERT_EQ(pair.intend(arming()), Refusal::None);
  pair.run(100ms);
  ASSERT_EQ(status().progress, Stage::Settling);
  pair.inject(frame("18EEFF38", "FFFFFFFFFFFFFF7F"));
  pair.run(1s);
  EXPECT_EQ(status().cause, MotionCause::SourceTaken);
  EXPECT_TRUE(written().empty());
}

struct Unproven : Joystick {
  Unproven() : Joystick(ServiceSettings{}) {}
};
TEST_F(Unproven, Rule04WithoutProofTheLimitationIsAcceptedAtEachArming) {
  EXPECT_EQ(pair.intend(arming()), Refusal::EchoUnproven);
  intent::ArmJoystick wanted = arming();
  wanted.acceptsUnproven = true;
  EXPECT_EQ(pair.intend(wanted), Refusal::None);
  pair.intend(intent::DisarmJoystick{});
  EXPECT_EQ(pair.intend(arming()), Refusal::EchoUnproven);
}

struct NoEcho : Joystick {
  NoEcho() : Joystick(ServiceSettings{.echoes = false}) {}
};
TEST_F(NoEcho, Rule04WithoutAnyEchoNothingMoves) {
  intent::ArmJoystick wanted = arming();
  wanted.acceptsUnproven = true;
  EXPECT_EQ(pair.intend(wanted), Refusal::EchoUnproven);
}

TEST_F(Joystick, Rule05LockedItCannotBeArmedAndTheLimitIsKept) {
  Pair locked;
  locked.addConsole();
  EXPECT_EQ(locked.intend(arming()), Refusal::Locked);
  intent::ArmJoystick wanted = arming();
  wanted.limit = intent::ArmJoystick{}.limit;
  ASSERT_EQ(wanted.limit, 300);
  ASSERT_EQ(pair.intend(wanted), Refusal::None);
  pair.run(1s);
  const std::size_t from = mark();
  pressAndHold(100ms, 1000, -1000);
  for (const Frame& sent : written(from)) {
    const BasicJoystick message = BasicJoystick::of(sent);
    EXPECT_LE(message.x.tenths, 300);
    EXPECT_GE(message.y.tenths, -300);
  }
  EXPECT_EQ(BasicJoystick::of(written(from).back()).x.tenths, 300);
}

TEST_F(Joystick, Rule05ArmedAndNotHeldItEndsAfterTwoMinutes) {
  arm();
  pair.run(119s);
  EXPECT_EQ(status().progress, Stage::Armed);
  pair.run(2s);
  EXPECT_EQ(status().progress, Stage::Off);
  EXPECT_EQ(status().cause, MotionCause::NotHeldTooLong);
  EXPECT_TRUE(written().empty());
}

TEST_F(Joystick, Rule06EnableOffIsNeutralAndItsReturnMovesNothing) {
  armAndHold();
  const std::size_t from = mark();
  simulator::Misbehaviour off;
  off.enableOff = true;
  pair.simulator.misbehave(pair.now(), 0, off);
  pair.runUntil([&] { return status().progress != Stage::Held || (say(true, 500), false); }, 0ms);
  hold(200ms, 500);
  EXPECT_EQ(status().cause, MotionCause::EnableOff);
  EXPECT_EQ(press(), Refusal::Disabled);
  pair.simulator.misbehave(pair.now(), 0, {});
  hold(1s, 500);
  EXPECT_EQ(status().progress, Stage::Armed);
  EXPECT_GT(motionIn(written(from)), 0u) << "until it was known";
  const std::size_t back = mark();
  hold(200ms, 500);
  EXPECT_TRUE(written(back).empty());
  EXPECT_EQ(press(), Refusal::None);
}

TEST_F(Joystick, Rule06AChangeOfOperationalErrorOrStowedIsNeutral) {
  for (const char* data : {"0100000000000008", "8340A0"}) {
    armAndHold();
    const std::size_t from = mark();
    // 'operational error on'; enabled, but stowed.
    pair.inject(fromMonitor(data[1] == '1' ? "0100000000000004" : "83A000"));
    pair.run(10ms);
    expectNeutralOnly(MotionCause::MonitorChanged, from);
    EXPECT_EQ(status().progress, Stage::Releasing);
    pair.intend(intent::DisarmJoystick{});
    pair.run(1s);
  }
}

TEST_F(Joystick, Rule06AMonitorThatHasAnErrorAlreadyMayBeMoved) {
  simulator::Misbehaviour error;
  error.pcodeError = 11;
  pair.simulator.misbehave(pair.now(), 0, error);
  pair.run(300ms);
  armAndHold();
  EXPECT_EQ(status().progress, Stage::Held);
}

TEST_F(Joystick, Rule06StowOrDeployByAnotherIsNeutral) {
  for (const auto& other : {frame("18EFFFA8", "8502"), frame("18EFFFA8", "8504"),
                            frame("0CFDD633", "0100010000000100"), frame("0CFDD633", "0100010000000040")}) {
    armAndHold();
    const std::size_t from = mark();
    pair.inject(other);
    pair.run(10ms);
    EXPECT_TRUE(status().cause == MotionCause::StowAsked || status().cause == MotionCause::ControllerAppeared)
        << static_cast<int>(status().cause);
    EXPECT_EQ(motionIn(written(from)), 0u);
    pair.intend(intent::DisarmJoystick{});
    pair.run(12s);
  }
}

TEST_F(Joystick, Rule06AWordThatIsOlderThan100MsIsNotHeld) {
  armAndHold();
  const Instant last = pair.now();
  pair.run(500ms);
  EXPECT_EQ(status().cause, MotionCause::HandNotSeen);
  for (const Pair::Seen& seen : fromOurs(last + 101ms)) EXPECT_EQ(seen.frame.data, kNeutral);
  EXPECT_EQ(press(), Refusal::None);
  EXPECT_EQ(say(true, 500, 0, 101ms), Refusal::None);
  EXPECT_EQ(status().cause, MotionCause::HandNotSeen) << "an old word lets go";
  EXPECT_EQ(status().progress, Stage::Releasing);
}

TEST_F(Joystick, Rule06BusOffAndErrorPassiveDisarm) {
  for (const auto& error : {frame("20000040", "0000000000000000"), frame("20000004", "0020000000000000")}) {
    armAndHold();
    pair.inject(error);
    pair.run(10ms);
    EXPECT_EQ(status().cause, MotionCause::BusTrouble);
    EXPECT_EQ(status().progress, Stage::Ending);
    pair.run(1s);
    EXPECT_EQ(pair.intend(arming()), Refusal::BusTrouble);
    pair.inject(frame("20000004", "0040000000000000"));
    pair.run(10ms);
  }
}

TEST_F(Joystick, Rule11SendErrorsOfTheAdapterDisarm) {
  armAndHold();
  const auto read = [&](unsigned errors) {
    console.services.controllerRead(pair.now(), console.state,
                                    {ControllerState::ErrorActive, static_cast<std::uint16_t>(errors)});
    pair.run(1ms);
  };
  read(7);
  EXPECT_EQ(status().progress, Stage::Held);
  read(15);
  EXPECT_EQ(status().cause, MotionCause::BusTrouble);
}

TEST_F(Joystick, Rule06ALinkThatIsLostEndsAllAndNothingGoesOutWhenItIsBack) {
  armAndHold();
  pair.setLink(console, false);
  EXPECT_EQ(status().progress, Stage::Off);
  EXPECT_EQ(status().cause, MotionCause::LinkLost);
  const std::size_t back = mark();
  pair.setLink(console, true);
  hold(1s, 500);
  EXPECT_TRUE(written(back).empty());
  EXPECT_EQ(pair.intend(arming()), Refusal::Locked);
}

TEST_F(Joystick, Rule07HeldIsAnEdgeWithTheStickAtRest) {
  arm();
  EXPECT_EQ(say(true), Refusal::NotReleased) << "'not held' was not said since arming";
  EXPECT_EQ(say(false), Refusal::None);
  EXPECT_EQ(say(true, 500), Refusal::NotReleased) << "not at rest";
  EXPECT_EQ(say(true), Refusal::NotReleased) << "and not let go since";
  pair.run(100ms);
  EXPECT_TRUE(written().empty());
  EXPECT_EQ(press(), Refusal::None);
  EXPECT_EQ(status().progress, Stage::Held);
}

TEST_F(Joystick, Rule07AfterArmingAnewNoOldDeflectionGoesOut) {
  armAndHold(800);
  pair.intend(intent::DisarmJoystick{});
  pair.run(1s);
  EXPECT_EQ(status().progress, Stage::Off);
  const std::size_t from = mark();
  arm();
  hold(200ms, 800);
  EXPECT_EQ(press(), Refusal::None);
  pair.run(60ms);
  EXPECT_EQ(motionIn(written(from)), 0u);
}

TEST_F(Joystick, Rule08HeldForAMinuteIsTheMost) {
  arm();
  ASSERT_EQ(press(), Refusal::None);
  hold(59900ms, 0);
  EXPECT_EQ(status().progress, Stage::Held);
  hold(200ms, 0);
  EXPECT_EQ(status().cause, MotionCause::HeldTooLong);
  EXPECT_EQ(status().progress, Stage::Releasing);
}

TEST_F(Joystick, Rule09TheWrongWayIsNeutral) {
  arm();
  ASSERT_EQ(press(), Refusal::None);
  // The monitor obeys another, which outranks us, and turns left.
  for (int i = 0; i < 100 && status().progress == Stage::Held; ++i) {
    pair.inject(frame("0CFDD633", "04FA010000000000"));
    say(true, 300);
    pair.run(20ms);
  }
  EXPECT_EQ(status().cause, MotionCause::WrongWay);
  EXPECT_LT(rotation(), -10);
}

TEST_F(Joystick, Rule09NoMotionIsNeutralAndNamesWhatItKnows) {
  simulator::Misbehaviour fault;
  fault.faultBits = simulator::faultBit("motor_axis_1");
  pair.simulator.misbehave(pair.now(), 0, fault);
  arm();
  pressAndHold(1200ms, 300);
  EXPECT_EQ(status().cause, MotionCause::NoMotion);
  pair.simulator.misbehave(pair.now(), 0, {});
  pair.intend(intent::DisarmJoystick{});
  pair.run(1s);
  arm();
  pressAndHold(15s, 1000);
  EXPECT_EQ(status().progress, Stage::Held) << "its first move was seen";
  say(false);
  pressAndHold(1500ms, 300);
  EXPECT_EQ(status().cause, MotionCause::AtSoftLimit);
  EXPECT_EQ(press(), Refusal::None);
  hold(500ms, -300);
  EXPECT_EQ(status().progress, Stage::Held);
}

TEST_F(Joystick, Rule09WhoOutranksUsIsNamed) {
  arm();
  ASSERT_EQ(press(), Refusal::None);
  for (int i = 0; i < 80 && status().progress == Stage::Held; ++i) {
    pair.inject(frame("0CFDD633", i % 20 < 10 ? "5000010000000000" : "4400010000000000"));
    say(true, 300);
    pair.run(20ms);
  }
  EXPECT_EQ(status().cause, MotionCause::Outranked);
}

TEST_F(Joystick, Rule09WithoutFeedbackNothingIsSeenAndNothingIsSaid) {
  simulator::Misbehaviour blind;
  blind.feedbackNotFitted = true;
  blind.faultBits = simulator::faultBit("motor_axis_1");
  pair.simulator.misbehave(pair.now(), 0, blind);
  pair.run(1s);
  arm();
  pressAndHold(3s, 300);
  EXPECT_EQ(status().progress, Stage::Held);
}

TEST_F(Joystick, Rule10EveryTwentyMillisecondsThenNeutralForHalfASecondThenSilence) {
  arm();
  ASSERT_EQ(press(), Refusal::None);
  const std::size_t pressed = mark();
  hold(1s, 500);
  EXPECT_EQ(written(pressed).size(), 51u) << "the first at once";
  EXPECT_GT(rotation(), 20);
  const Instant released = pair.now();
  const std::size_t before = mark();
  say(false);
  ASSERT_FALSE(written(before).empty()) << "at once";
  pair.run(3s);
  const std::vector<Frame> after = written(before);
  EXPECT_EQ(after.size(), 25u);
  for (const Frame& sent : after) EXPECT_EQ(sent.data, kNeutral);
  const auto seen = fromOurs(released);
  EXPECT_EQ(seen.back().time, released + 480ms);
  EXPECT_EQ(status().progress, Stage::Armed);
  EXPECT_EQ(status().cause, MotionCause::Released);
}

TEST_F(Joystick, Rule10AfterAStandstillNeutralGoesOutAndNeverTheOldValue) {
  for (const Duration standstill : {Duration(150ms), Duration(300ms)}) {
    armAndHold();
    pair.freeze(console, standstill);
    const std::size_t from = mark();
    pair.run(standstill);
    say(true, 500);  // a hand that never let go
    pair.run(100ms);
    EXPECT_EQ(status().cause, MotionCause::Gap);
    EXPECT_EQ(motionIn(written(from)), 0u);
    EXPECT_LE(written(from).size(), 6u) << "no burst";
    pair.intend(intent::DisarmJoystick{});
    pair.run(1s);
  }
}

TEST_F(Joystick, Rule10MissedDeadlinesAreSkippedAndTheGridStays) {
  arm();
  ASSERT_EQ(press(), Refusal::None);
  const Instant pressed = pair.now();
  hold(100ms, 500);
  pair.freeze(console, 50ms);
  pair.run(50ms);
  hold(100ms, 500);
  EXPECT_EQ(status().progress, Stage::Held);
  for (const Pair::Seen& seen : pair.written) {
    const bool isHeld = seen.time > pressed && seen.id().pgn == pgn::kBasicJoystick;
    EXPECT_TRUE(!isHeld || seen.time == pressed + 150ms || (seen.time - pressed) % 20ms == 0ns);
  }
}

TEST_F(Joystick, Rule10ALockWaitsForNeutral) {
  armAndHold();
  const std::size_t locked = mark();
  pair.intend(intent::Lock{});
  EXPECT_TRUE(console.status(pair.now()).isEnding);
  pair.run(2s);
  EXPECT_TRUE(console.status(pair.now()).locked);
  EXPECT_EQ(written(locked).size(), 25u);
  EXPECT_EQ(motionIn(written(locked)), 0u);
  EXPECT_EQ(status().cause, MotionCause::Locked);
}

// Frames that wait in the adapter for ever, or for so long.
struct Stuck : Joystick {
  void keep(std::optional<Duration> wait) {
    console.leaves = [wait](const Frame& f) {
      return J1939Id::of(f.identifier()).pgn == pgn::kBasicJoystick ? wait : std::optional(Duration{0});
    };
  }
};

TEST_F(Stuck, Rule11OneMotionFrameAtMostIsOnItsWayAndAfter60MsItDisarms) {
  armAndHold();
  keep({});
  const std::size_t from = mark();
  hold(59ms, 500);
  EXPECT_EQ(status().progress, Stage::Held);
  EXPECT_EQ(written(from).size(), 1u);
  hold(25ms, 500);
  EXPECT_EQ(status().cause, MotionCause::NotOnBus);
  EXPECT_EQ(status().progress, Stage::Ending);
  hold(3s, 500);
  EXPECT_EQ(written(from).size(), 2u) << "one neutral behind it";
  EXPECT_EQ(motionIn(written(from)), 1u);
  EXPECT_EQ(status().progress, Stage::Off);
  EXPECT_EQ(pair.intend(arming()), Refusal::StillWaits);
  pair.setLink(console, false);
  pair.setLink(console, true);
  pair.unlock();
  EXPECT_EQ(pair.intend(arming()), Refusal::None) << "taken down and up";
}

TEST_F(Stuck, Rule11AnOldMotionFrameThatGoesOutLateIsAnsweredWithNeutralAndSaid) {
  armAndHold();
  keep(2s);
  hold(20ms, 500);
  keep(Duration{0});
  hold(1500ms, 500);
  EXPECT_EQ(status().cause, MotionCause::NotOnBus);
  EXPECT_EQ(notes<note::MotionLate>().size(), 0u);
  pair.run(400ms);
  const Instant before = pair.now();
  pair.run(2s);
  EXPECT_EQ(notes<note::MotionLate>().size(), 1u);
  EXPECT_TRUE(status().wentOutLate);
  const auto after = fromOurs(before);
  EXPECT_EQ(after.size(), 26u) << "the old one, and half a second of neutral";
  EXPECT_EQ(after.back().frame.data, kNeutral);
  EXPECT_EQ(pair.intend(arming()), Refusal::None) << "all is confirmed";
  EXPECT_FALSE(status().wentOutLate);
}

TEST_F(Stuck, Rule11AFullQueueDisarmsAndOneNeutralIsTriedUntilItIsTaken) {
  armAndHold();
  bool isFull = true;
  console.take = [&](const Frame& f) {
    return isFull && J1939Id::of(f.identifier()).pgn == pgn::kBasicJoystick ? WriteResult::QueueFull
                                                                            : WriteResult::Accepted;
  };
  const std::size_t from = mark();
  hold(700ms, 500);
  EXPECT_EQ(status().cause, MotionCause::NotOnBus);
  EXPECT_EQ(status().progress, Stage::Ending);
  EXPECT_EQ(motionIn(written(from)), 1u);
  EXPECT_GE(written(from).size(), 30u);
  isFull = false;
  const Instant free = pair.now();
  const std::size_t before = mark();
  pair.run(2s);
  EXPECT_EQ(status().progress, Stage::Off);
  EXPECT_GE(fromOurs(free).size(), 20u);
  EXPECT_EQ(motionIn(written(before)), 0u);
}

TEST_F(Stuck, Rule11AnyOtherWriteErrorDisarms) {
  armAndHold();
  console.take = [](const Frame&) { return WriteResult::Failed; };
  hold(40ms, 500);
  EXPECT_EQ(status().cause, MotionCause::WriteFailed);
  hold(2s, 500);
  EXPECT_EQ(status().progress, Stage::Off);
}

TEST_F(Stuck, Rule11EchoesThatMayBeLostAreDoubt) {
  armAndHold();
  keep({});
  hold(20ms, 500);
  pair.loseEchoes(console);
  EXPECT_EQ(status().cause, MotionCause::NotOnBus);
  keep(Duration{0});
  pair.run(2s);
  EXPECT_EQ(pair.intend(arming()), Refusal::StillWaits);
}

TEST_F(Stuck, Rule11AnEndingLastsASecondAtMost) {
  armAndHold();
  console.take = [](const Frame&) { return WriteResult::QueueFull; };
  pair.intend(intent::Lock{});
  pair.run(990ms);
  EXPECT_FALSE(console.status(pair.now()).locked);
  pair.run(20ms);
  EXPECT_TRUE(console.status(pair.now()).locked);
  console.take = [](const Frame&) { return WriteResult::Accepted; };
  const std::size_t from = mark();
  pair.run(2s);
  EXPECT_TRUE(written(from).empty());
}

TEST_F(Joystick, Rule12NoSwitchIsEverPressed) {
  armAndHold(1000, -1000);
  pair.intend(intent::DisarmJoystick{});
  pair.run(1s);
  for (const Frame& sent : written()) {
    const BasicJoystick message = BasicJoystick::of(sent);
    EXPECT_TRUE(std::ranges::all_of(message.switches, [](Status2 s) { return s == Status2::Off; }));
  }
}

TEST_F(Joystick, Rule13NoExtendedMessageIsSent) {
  armAndHold();
  pair.run(2s);
  for (const Pair::Seen& seen : pair.sentBy(&console)) EXPECT_NE(seen.id().pgn, pgn::kExtendedJoystick);
}

TEST_F(Joystick, Rule15ArmingAndEndsAreInTheLogWithWhatWasMeasured) {
  arm();
  ASSERT_EQ(notes<note::MotionArmed>().size(), 1u);
  const note::MotionArmed armed = notes<note::MotionArmed>()[0];
  EXPECT_EQ(armed.address, kOurs);
  EXPECT_EQ(armed.pin, kMonitor);
  EXPECT_EQ(armed.limit, 1000);
  EXPECT_TRUE(armed.isProven);
  EXPECT_EQ(armed.platform.str(), "a test");
  pressAndHold(1s, 500);
  EXPECT_EQ(status().period, 20ms);
  say(false);
  ASSERT_EQ(notes<note::MotionEnded>().size(), 1u);
  const note::MotionEnded ended = notes<note::MotionEnded>()[0];
  EXPECT_EQ(ended.cause, MotionCause::Released);
  EXPECT_FALSE(ended.isDisarmed);
  EXPECT_GE(ended.messages, 49u);
  EXPECT_EQ(ended.period, 20'000u);
  EXPECT_EQ(ended.worstGap, 20'000u);
  pair.intend(intent::DisarmJoystick{});
  ASSERT_EQ(notes<note::MotionEnded>().size(), 2u);
  EXPECT_TRUE(notes<note::MotionEnded>()[1].isDisarmed);
}

// Ours and the controller's: a console that is gone says no neutral, and the monitor stops by itself.
TEST_F(Joystick, Rule10TheControllersOwn200MsAreABackstop) {
  arm();
  pressAndHold(2s, 500);
  pair.freeze(console, 10s);
  const Instant last = fromOurs().back().time;
  const auto isDriven = [&] {
    const auto position = [&] { return monitor->control().axes()[0].position(); };
    const int before = position();
    pair.run(10ms);
    return position() != before;
  };
  while (isDriven()) ASSERT_LT(pair.now() - last, 600ms);
  const Duration alone = pair.now() - last;
  EXPECT_GE(alone, 200ms);
  pair.run(11s);
  pair.intend(intent::DisarmJoystick{});
  pair.run(1s);
  arm();
  pressAndHold(2s, 500);
  const Instant released = pair.now();
  say(false);
  while (isDriven()) ASSERT_LT(pair.now() - released, 600ms);
  EXPECT_LT(pair.now() - released + 150ms, alone) << "neutral stops it sooner";
}

// --- The table, walked whole.

constexpr auto kMoves = kAllOf<JoystickMove>;
constexpr auto kStates = kAllOf<JoystickStatus::Progress>;

TEST(JoystickTable, HeldIsReachedByAPressOfWhatIsArmedAndByNothingElse) {
  for (const Stage state : kStates) {
    for (const JoystickMove move : kMoves) {
      const bool isArmed = state == Stage::Armed || state == Stage::Releasing;
      EXPECT_EQ(after(state, move) == Stage::Held, isArmed && move == JoystickMove::Press);
    }
  }
}
TEST(JoystickTable, WhatWasHeldEndsByNeutralUnlessTheAddressIsAnothers) {
  for (const JoystickMove move : kMoves) {
    const auto next = after(Stage::Held, move);
    if (!next) continue;
    EXPECT_EQ(*next, move == JoystickMove::Yield    ? Stage::Off
                     : move == JoystickMove::Disarm ? Stage::Ending
                                                    : Stage::Releasing);
  }
}
TEST(JoystickTable, EveryStateIsLeftByDisarmingOrIsOverOrEnds) {
  for (const Stage state : kStates) {
    EXPECT_EQ(after(state, JoystickMove::Yield), Stage::Off);
    const auto next = after(state, JoystickMove::Disarm);
    const bool isOver = state == Stage::Off || state == Stage::Ending;
    EXPECT_EQ(next.has_value(), !isOver);
    EXPECT_TRUE(!next || *next == Stage::Off || *next == Stage::Ending);
  }
}
TEST(JoystickTable, ArmingPassesEveryStepInOrder) {
  Stage state = Stage::Off;
  for (const JoystickMove step :
       {JoystickMove::Arm, JoystickMove::Silent, JoystickMove::Claimed, JoystickMove::Settled}) {
    for (const JoystickMove other : kMoves) {
      const bool ends = other == JoystickMove::Yield ||
                        other == (state == Stage::Off ? JoystickMove::Late : JoystickMove::Disarm);
      EXPECT_EQ(after(state, other).has_value(), other == step || ends);
    }
    state = *after(state, step);
  }
  EXPECT_EQ(state, Stage::Armed);
}

// Each state of the real service, and each move that can be made from outside: it does what the table says.
class JoystickWalk : public Joystick,
                     public ::testing::WithParamInterface<std::tuple<std::size_t, std::size_t>> {
 protected:
  void reach(Stage wanted) {
    if (wanted == Stage::Off) return;
    if (wanted == Stage::Listening) {
      pair.intend(intent::Lock{});
      pair.run(100ms);
      pair.intend(intent::Unlock{});
      pair.run(600ms);
    }
    if (wanted == Stage::Claiming)
      console.leaves = [](const Frame&) { return std::optional(Duration(500ms)); };
    ASSERT_EQ(pair.intend(arming()), Refusal::None);
    if (wanted == Stage::Listening) return;
    pair.run(10ms);
    if (wanted == Stage::Claiming || wanted == Stage::Settling) return;
    pair.run(500ms);
    if (wanted == Stage::Armed) return;
    pressAndHold(60ms, 500);
    if (wanted == Stage::Releasing) say(false);
    if (wanted == Stage::Ending) pair.intend(intent::DisarmJoystick{});
  }
  // False where it cannot be made in this state.
  bool make(JoystickMove move, Stage in) {
    switch (move) {
      case JoystickMove::Arm: pair.intend(arming()); return true;
      case JoystickMove::Silent: return in == Stage::Listening && (pair.run(400ms), true);
      case JoystickMove::Claimed: return in == Stage::Claiming && (pair.run(510ms), true);
      case JoystickMove::Settled: return in == Stage::Settling && (pair.run(260ms), true);
      case JoystickMove::Press:
        if (in != Stage::Held) press();
        return true;
      case JoystickMove::Stop: say(false); return true;
      case JoystickMove::Disarm: pair.intend(intent::DisarmJoystick{}); return true;
      case JoystickMove::Yield:
        pair.inject(frame("0CFDD638", "0100010000000000"));
        pair.run(2 * Pair::kFlight);
        return true;
      case JoystickMove::Said:
        return (in == Stage::Releasing || in == Stage::Ending) && (pair.run(510ms), true);
      case JoystickMove::Late:  // see Stuck
      case JoystickMove::Count: break;
    }
    return false;
  }
};

TEST_P(JoystickWalk, DoesWhatTheTableSays) {
  const Stage state = kStates[std::get<0>(GetParam())];
  const JoystickMove move = kMoves[std::get<1>(GetParam())];
  reach(state);
  ASSERT_EQ(status().progress, state);
  if (!make(move, state)) return;
  // Letting go of what is armed changes nothing, and so does what the table leaves out.
  const Stage wanted = after(state, move).value_or(state);
  EXPECT_EQ(status().progress, wanted);
}
INSTANTIATE_TEST_SUITE_P(All, JoystickWalk,
                         ::testing::Combine(::testing::Range(std::size_t{0}, kStates.size()),
                                            ::testing::Range(std::size_t{0}, kMoves.size())));

}  // namespace
}  // namespace deckpipe::test
