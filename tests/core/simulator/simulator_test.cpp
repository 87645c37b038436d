// SPDX-License-Identifier: GPL-3.0-or-later
// The simulator as a whole: misbehaviours, determinism, totality, speed.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "rig.h"

namespace deckpipe::simulator::test {
namespace {

std::vector<DueFrame> standardRun(std::uint64_t seed, Duration d) {
  StandardSimulator s = standardSimulator(seed);
  s.simulator.powerOn({});
  std::vector<DueFrame> frames;
  for (Instant t = s.simulator.nextTime(); t <= Instant{} + d; t = s.simulator.nextTime())
    s.simulator.timeCame(t);
  s.simulator.takeFrames(frames);
  return frames;
}

TEST(OtherTraffic, FillsItsShareOfTheBusInOrderAndChangesNothingElse) {
  const std::vector<DueFrame> quiet = standardRun(1, 10s);
  for (const double share : {0.1, 0.8, 2.0}) {
    StandardSimulator s = standardSimulator(1);
    s.simulator.powerOn({});
    s.simulator.fill({}, share);
    s.simulator.timeCame(Instant{} + 10s);
    std::vector<DueFrame> all;
    s.simulator.takeFrames(all);
    EXPECT_TRUE(std::ranges::is_sorted(all, {}, [](const DueFrame& f) { return f.time.ns; }));
    double bits = 0;
    std::erase_if(all, [&](const DueFrame& f) {
      const bool isOther = J1939Id::of(f.frame.identifier()).source == Background::kSource;
      if (isOther) bits += estimatedBits(f.frame);
      return isOther;
    });
    EXPECT_NEAR(bits / 2'500'000, std::min(share, Background::kMax), 0.001);
    EXPECT_EQ(all, quiet) << share;
  }
}

TEST(Misbehaviour, SilentSendsNothingAndHearsOn) {
  MonitorRig rig;
  rig.monitor.misbehave({.silent = true});
  const Instant from = rig.now();
  rig.hold(stick(0x33, 1000, 0), 2s);
  EXPECT_EQ(rig.all(MessageId::PositionLimitStatus, from).size(), 0u);
  EXPECT_GT(rig.rotation(), 10);
  rig.monitor.misbehave({});
  rig.run(200ms);
  EXPECT_NE(rig.all(MessageId::PositionLimitStatus, from).size(), 0u);
}

TEST(Misbehaviour, WrongLengthsAreMalformed) {
  MonitorRig rig;
  rig.monitor.misbehave({.wrongLengths = true});
  const Instant from = rig.now();
  rig.send("18EF8005", "03");
  rig.run(1s);
  std::size_t malformed = 0;
  for (const Seen& seen : rig.log) {
    if (seen.time <= from) continue;
    EXPECT_TRUE(seen.what.malformed) << std::hex << +seen.frame.data[0];
    ++malformed;
  }
  EXPECT_GE(malformed, 40u);
}

TEST(Misbehaviour, SensorErrorIsInThePositionTheFaultsAndTheLed) {
  struct Row {
    const char* name;
    Misbehaviour how;
    PositionState rotation, elevation;
    const char* faults;
  };
  const Row rows[] = {
      {"rotation",
       {.rotationSensorError = true},
       PositionState::SensorError,
       PositionState::Ok,
       "faults=; reserved_bits=; pcode_error=11"},
      {"elevation",
       {.elevationSensorError = true},
       PositionState::Ok,
       PositionState::SensorError,
       "faults=; reserved_bits=; pcode_error=12"},
  };
  for (const Row& row : rows) {
    MonitorRig rig;
    rig.monitor.misbehave(row.how);
    rig.run(200ms);
    EXPECT_EQ(rig.position().rotation.state, row.rotation) << row.name;
    EXPECT_EQ(rig.position().elevation.state, row.elevation) << row.name;
    EXPECT_EQ(rig.position().operationalError, Status2::On) << row.name;
    rig.send("18EF8005", "02");
    rig.run(10ms);
    EXPECT_EQ(rig.last(MessageId::FaultResponse), row.faults) << row.name;
    rig.monitor.misbehave({});
    rig.run(200ms);
    EXPECT_EQ(rig.position().operationalError, Status2::Off) << row.name;
  }
}

TEST(Misbehaviour, PanelLedBlinksTheErrorCode) {
  MonitorRig rig;
  rig.run(1s);
  EXPECT_TRUE(rig.outputs().panelLed) << "steady while all is well";
  rig.monitor.misbehave({.rotationSensorError = true});
  const Instant from = rig.now();
  rig.run(86s);  // ten rounds of 11 flashes of 0.6 s and 2 s of darkness
  int flashes = 0;
  bool before = true;
  for (const Seen& seen : rig.all(MessageId::DigitalOutputs, from)) {
    const bool on = DigitalOutputs::of(seen.frame).panelLed;
    flashes += on && !before;
    before = on;
  }
  EXPECT_NEAR(flashes, 110, 1);
}

TEST(Misbehaviour, WithoutFeedbackThereAreNoPositionsAndNoLimits) {
  MonitorRig rig;
  rig.monitor.misbehave({.feedbackNotFitted = true});
  const Instant from = rig.now();
  rig.hold(stick(0x33, 0, 0, {Function::OscillateSet}), 500ms);
  rig.hold(stick(0x33, 0, 0, {Function::Stow}), 2s);
  EXPECT_EQ(rig.position().rotation.state, PositionState::NotFitted);
  EXPECT_EQ(rig.position().elevation.state, PositionState::NotFitted);
  EXPECT_EQ(rig.position().operationalError, Status2::Off);
  EXPECT_LE(rig.all(MessageId::RotationSoftLimits, from).size(), 1u);
  EXPECT_LE(rig.all(MessageId::ElevationSoftLimits, from).size(), 1u);
  EXPECT_EQ(rig.rotation(), 0);
  EXPECT_EQ(rig.elevation(), 0);
}

TEST(Misbehaviour, ATakenAddressIsLostToAForeignName) {
  MonitorRig rig;
  rig.monitor.misbehave({.addressTaken = true});
  rig.run(1s);
  EXPECT_EQ(rig.monitor.address(), Address{0x81});
  EXPECT_EQ(rig.last(MessageId::AddressAnnouncement), "pin=1032AE100801035; device_type=1032");
  EXPECT_EQ(rig.all(MessageId::AddressAnnouncement).back().source(), Address{0x81});
  const Instant from = rig.now();
  rig.send("18EAFFF9", "00EE00");
  rig.run(10ms);
  const auto names = rig.all(MessageId::Name, Address{0x80}, from);
  ASSERT_EQ(names.size(), 1u) << "the other one is really there";
  EXPECT_NE(Name::of(names[0].frame).manufacturerCode(), j1939::kAkronManufacturer);
}

TEST(Misbehaviour, LateAndJitteringFramesComeLateAndStillInOrder) {
  MonitorRig rig;
  rig.monitor.misbehave({.late = 150ms, .jitter = 80ms});
  rig.run(10s);
  const auto seen = rig.all(MessageId::PositionLimitStatus, Instant{} + 2s);
  Duration shortest = 1h, longest{0};
  for (std::size_t i = 1; i < seen.size(); ++i) {
    shortest = std::min(shortest, seen[i].time - seen[i - 1].time);
    longest = std::max(longest, seen[i].time - seen[i - 1].time);
  }
  EXPECT_GE(seen.size(), 75u);
  EXPECT_LT(shortest, 80ms);
  EXPECT_GT(longest, 120ms);
}

TEST(Misbehaviour, EnableOffGoesOnTalkingAndMovesNothing) {
  MonitorRig rig;
  rig.hold(stick(0x33, 0, 0, {Function::OscillateSet, Function::DischargeOn}), 1s);
  rig.monitor.misbehave({.enableOff = true});
  rig.run(20ms);
  const auto positions = [&] {
    std::array<int, 5> at{};
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = rig.monitor.control().axes()[i].position();
    return at;
  };
  const auto before = positions();
  const Instant from = rig.now();
  rig.hold(stick(0x33, 1000, 1000, {Function::Stream, Function::FlowHigh, Function::DischargeOff}), 2s);
  EXPECT_EQ(positions(), before);
  EXPECT_FALSE(rig.outputs().enable);
  EXPECT_GE(rig.all(MessageId::PositionLimitStatus, from).size(), 19u);
  rig.run(300ms);  // until the stick is no longer heard
  rig.monitor.misbehave({});
  rig.run(5s);
  EXPECT_EQ(positions(), before) << "enabling starts nothing again";
}

TEST(Misbehaviour, FaultBitsAreAnsweredAndAFaultyMotorStands) {
  MonitorRig rig;
  rig.monitor.misbehave({.faultBits = faultBit("motor_axis_1") | faultBit("internal_fuse")});
  rig.hold(stick(0x33, 1000, 1000), 1s);
  EXPECT_EQ(rig.rotation(), 0);
  EXPECT_GT(rig.elevation(), 3);
  rig.send("18EF8005", "02");
  rig.run(10ms);
  EXPECT_EQ(rig.last(MessageId::FaultResponse),
            "faults=motor_axis_1, internal_fuse; reserved_bits=; pcode_error=0");
}

TEST(Misbehaviour, IsPlannedForLater) {
  MonitorRig rig;
  rig.simulator.misbehave(rig.now() + 3s, 0, {});
  rig.simulator.misbehave(rig.now() + 1s, 0, {.silent = true});
  const Instant from = rig.now();
  rig.run(5s);
  for (const Seen& seen : rig.log) {
    const Duration at = seen.time - from;
    EXPECT_FALSE(at > 1s && at < 3s) << at.count();
  }
  EXPECT_GE(rig.all(MessageId::PositionLimitStatus, from + 3s).size(), 19u);
}

TEST(Simulator, PowersUpAsATruckDoes) {
  Rig rig;
  StandardSimulator standard = standardSimulator(42);
  rig.simulator = std::move(standard.simulator);
  rig.simulator.powerOn(rig.now());
  rig.run(3s);
  std::vector<std::string> pins;
  for (const Seen& seen : rig.all(MessageId::AddressAnnouncement))
    pins.emplace_back(announcedPin(seen.frame)->text());
  std::sort(pins.begin(), pins.end());
  EXPECT_EQ(pins, (std::vector<std::string>{"1032AE100801035", "1033AE100802117", "1035AE100804442"}));
  EXPECT_EQ(rig.all(MessageId::Name).front().source(), Address{0x80});
  std::vector<unsigned> addresses;
  for (std::size_t i = 0; i < rig.simulator.size(); ++i)
    addresses.push_back(rig.simulator.device(i).address().value);
  std::sort(addresses.begin(), addresses.end());
  EXPECT_EQ(addresses, (std::vector<unsigned>{0x80, 0x81, 0x82, 0x83}));
  EXPECT_TRUE(DigitalOutputs::of(rig.all(MessageId::DigitalOutputs).back().frame).stowed);
  rig.run(60s);
  EXPECT_FALSE(standard.monitor->control().isStowed()) << "the hand on the joystick has deployed it";
  EXPECT_TRUE(standard.riser->isExtended());
}

TEST(Simulator, TheSameSeedGivesTheSameFramesAndAnotherGivesOthers) {
  const auto first = standardRun(1, 60s);
  EXPECT_GT(first.size(), 5000u);
  EXPECT_EQ(first, standardRun(1, 60s));
  EXPECT_NE(first, standardRun(2, 60s));
}

TEST(Simulator, HowOftenTimeComesMakesNoDifference) {
  const auto stepped = standardRun(5, 30s);
  std::vector<DueFrame> fine, coarse;
  StandardSimulator often = standardSimulator(5), rarely = standardSimulator(5);
  often.simulator.powerOn({});
  rarely.simulator.powerOn({});
  for (Instant t{}; t <= Instant{} + 30s; t = t + 1ms) {
    often.simulator.timeCame(t);
    often.simulator.takeFrames(fine);
  }
  rarely.simulator.timeCame(Instant{} + 30s);
  rarely.simulator.takeFrames(coarse);
  EXPECT_EQ(fine, stepped);
  EXPECT_EQ(coarse, stepped);
}

// Anything on the bus: no crash, and the monitor moves only where a joystick could have asked for it.
TEST(Simulator, AnyFramesInNeitherCrashItNorMoveItBeyondItsRange) {
  std::mt19937 engine(1);
  const auto random = [&] { return static_cast<std::uint32_t>(engine()); };
  Rig rig;
  StandardSimulator standard = standardSimulator(9);
  rig.simulator = std::move(standard.simulator);
  rig.simulator.powerOn(rig.now());
  std::vector<DueFrame> frames;
  Instant now{};
  constexpr std::uint32_t kIds[] = {0x18EF8000, 0x18EEFF00, 0x18EAFF00, 0x0CFDD600, 0x0CFDD700, 0x18EF8100};
  for (int i = 0; i < 200'000; ++i) {
    Frame f;
    const bool likely = random() % 4 != 0;
    f.id = likely ? kExtendedBit | kIds[random() % 6] | (random() & 0xFF) : random();
    if (likely && random() % 2 == 0) f.id = (f.id & ~0xFFu) | (0x33 + random() % 6);
    f.length = static_cast<std::uint8_t>(random() % (likely ? 9 : 256));
    for (auto& byte : f.data) byte = static_cast<std::uint8_t>(random());
    now = now + Duration(random() % 5'000'000);
    rig.simulator.received(now, f);
    if (i % 1000 == 0) rig.simulator.takeFrames(frames);
    const auto& axes = standard.monitor->control().axes();
    ASSERT_GE(axes[0].position(), MonitorControl::kHardLeft * 100'000);
    ASSERT_LE(axes[0].position(), MonitorControl::kHardRight * 100'000);
    ASSERT_GE(axes[1].position(), MonitorControl::kHardDown * 100'000);
    ASSERT_LE(axes[1].position(), MonitorControl::kHardUp * 100'000);
    ASSERT_LE(std::abs(axes[0].speed()), 120'000);
    ASSERT_LE(std::abs(axes[1].speed()), 80'000);
  }
}

TEST(Simulator, RandomFramesThatAreNoJoysticksMoveNothing) {
  std::mt19937 engine(2);
  const auto random = [&] { return static_cast<std::uint32_t>(engine()); };
  MonitorRig rig;
  Instant now = rig.now();
  for (int i = 0; i < 100'000; ++i) {
    Frame f;
    f.id = kExtendedBit | (random() % 2 == 0 ? 0x18EF8000u | (random() & 0xFF) : random() & kIdMask);
    const std::uint32_t pgn = J1939Id::of(f.identifier()).pgn;
    if (pgn == pgn::kBasicJoystick || pgn == pgn::kExtendedJoystick) continue;
    f.length = static_cast<std::uint8_t>(random() % 9);
    for (auto& byte : f.data) byte = static_cast<std::uint8_t>(random());
    now = now + Duration(random() % 3'000'000);
    rig.simulator.received(now, f);
  }
  for (const Axis& axis : rig.monitor.control().axes()) EXPECT_EQ(axis.speed(), 0);
  EXPECT_EQ(rig.rotation(), 0);
  EXPECT_EQ(rig.elevation(), 0);
}

TEST(Simulator, AFloodOfPollsIsBoundedAndItsLossIsAFault) {
  MonitorRig rig;
  for (int i = 0; i < 10'000; ++i) rig.send("18EF8005", "21");
  EXPECT_LT(rig.log.size(), 10'300u);
  rig.run(1s);
  rig.send("18EF8005", "02");
  rig.run(10ms);
  EXPECT_EQ(rig.last(MessageId::FaultResponse), "faults=can_output_overrun; reserved_bits=; pcode_error=0");
}

TEST(Simulator, SixtyMonitorsHaveTheirAddressesAndShareTheBusEvenly) {
  Rig rig;
  rig.simulator = standardSimulator(1, {}, 60).simulator;
  ASSERT_EQ(rig.simulator.size(), 63u);
  rig.simulator.powerOn(rig.now());
  rig.run(10s);
  std::set<std::string> pins;
  std::set<unsigned> addresses;
  for (const Seen& seen : rig.all(MessageId::AddressAnnouncement))
    pins.emplace(announcedPin(seen.frame)->text());
  for (std::size_t i = 0; i < rig.simulator.size(); ++i)
    addresses.insert(rig.simulator.device(i).address().value);
  EXPECT_EQ(pins.size(), 62u);
  EXPECT_EQ(addresses.size(), 63u);
  EXPECT_EQ(addresses.count(kNullAddress.value), 0u);
  std::map<std::int64_t, int> frames;  // in each 10 ms
  for (const Seen& seen : rig.log) {
    if (seen.time >= Instant{} + 8s && seen.what.message != MessageId::BasicJoystick)
      ++frames[seen.time.ns / 10'000'000];
  }
  for (const auto& [at, count] : frames) EXPECT_LE(count, 30) << "a tenth of 4 x 60 and some";
}

TEST(Simulator, SixtyMonitorsAreSteadyWhenAnotherTimeComesOften) {
  const auto run = [](Duration every) {
    StandardSimulator s = standardSimulator(1, {}, 60);
    s.simulator.powerOn({});
    std::vector<DueFrame> frames;
    for (Instant t{}; t <= Instant{} + 6s; t = t + every) s.simulator.timeCame(t);
    s.simulator.takeFrames(frames);
    return frames;
  };
  EXPECT_EQ(run(1ms), run(100ms));
}

}  // namespace
}  // namespace deckpipe::simulator::test
