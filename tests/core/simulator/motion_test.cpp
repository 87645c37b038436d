// SPDX-License-Identifier: GPL-3.0-or-later
// What moves the simulated 6032 and what stops it: Appendices B and C, message A1.
#include <gtest/gtest.h>

#include <cmath>

#include "rig.h"

namespace deckpipe::simulator::test {
namespace {

constexpr int kFull = 1000;
// A ramp down from full speed and one pass of the control loop.
constexpr double kCoastDegrees = 1.0;

Frame extended(unsigned source, Value gripX, const char* xDirection, Value gripY, const char* yDirection) {
  const Value on = Value::word("on"), na = Value::word("na");
  std::vector<FieldValue> values = {{"grip_x_percent", gripX},       {"grip_y_percent", gripY},
                                    {"grip_theta_percent", Value()}, {"grip_theta_forward", na},
                                    {"grip_theta_back", na},         {"grip_theta_neutral", na}};
  if (*xDirection != 0) values.push_back({xDirection, on});
  if (*yDirection != 0) values.push_back({yDirection, on});
  const auto data = encode(messageOf(MessageId::ExtendedJoystick), values);
  return j1939Frame(messageOf(MessageId::ExtendedJoystick), data.value(),
                    Address{static_cast<std::uint8_t>(source)});
}
Frame notAiming(unsigned source) {
  return frame("0CFDD7" + std::string(source == 0x33 ? "33" : "38"), "FFFFFFFFFFFFFF00");
}

TEST(Motion, FollowsTheStick) {
  struct Row {
    const char* name;
    int x, y;
    int rotation, elevation;  // signs of the motion
  };
  const Row rows[] = {
      {"right", kFull, 0, 1, 0},         {"left", -kFull, 0, -1, 0},
      {"back_is_up", 0, kFull, 0, 1},    {"forward_is_down", 0, -kFull, 0, -1},
      {"both_axes", kFull, kFull, 1, 1}, {"neutral", 0, 0, 0, 0},
  };
  for (const Row& row : rows) {
    MonitorRig rig;
    rig.hold(stick(0x33, row.x, row.y), 1s);
    EXPECT_EQ(rig.rotation() > 0.5, row.rotation > 0) << row.name;
    EXPECT_EQ(rig.rotation() < -0.5, row.rotation < 0) << row.name;
    EXPECT_EQ(rig.elevation() > 0.5, row.elevation > 0) << row.name;
    EXPECT_EQ(rig.elevation() < -0.5, row.elevation < 0) << row.name;
  }
}

TEST(Motion, SpeedIsProportionalAndReachedByARamp) {
  struct Row {
    const char* name;
    int x;
    double degreesASecond;
  };
  for (const Row& row : {Row{"full", 1000, 12}, Row{"half", 500, 6}, Row{"tenth", 100, 1.2}}) {
    MonitorRig rig;
    rig.hold(stick(0x33, row.x, 0), 100ms);
    EXPECT_LT(rig.rotation(), 0.1 * row.degreesASecond) << row.name << ": it starts with a ramp";
    rig.hold(stick(0x33, row.x, 0), 400ms);
    const double before = rig.rotation();
    rig.hold(stick(0x33, row.x, 0), 1s);
    EXPECT_NEAR(rig.rotation() - before, row.degreesASecond, 0.01) << row.name;
  }
}

TEST(Motion, StopsTwoHundredMillisecondsAfterTheLastMessage) {
  MonitorRig rig;
  rig.hold(stick(0x33, kFull, 0), 1s);
  const double atLast = rig.rotation();
  rig.run(170ms);  // 190 ms after the last message
  EXPECT_NEAR(rig.rotation() - atLast, 12 * 0.17, 0.01) << "it goes on at full speed";
  const double atTimeout = rig.rotation();
  rig.run(150ms);
  const double stopped = rig.rotation();
  EXPECT_LT(stopped - atTimeout, kCoastDegrees);
  rig.run(5s);
  EXPECT_EQ(rig.rotation(), stopped);
}

// How long after `from` the rotation is no longer at full speed, by the millisecond.
Duration untilSlower(MonitorRig& rig, Instant from) {
  while (rig.monitor.control().axes()[0].speed() == 120'000 && rig.now() - from < 1s) rig.run(1ms);
  return rig.now() - from;
}

TEST(Motion, TimeOutTakesEffectWithinOnePassOfTheControlLoop) {
  for (const Duration phase : {0ms, 1ms, 5ms, 9ms}) {
    MonitorRig rig;
    rig.run(phase);
    rig.hold(stick(0x33, kFull, 0), 1s);
    const Duration slower = untilSlower(rig, rig.now() - 20ms);
    EXPECT_GE(slower, JoystickInputs::kTimeout) << phase.count();
    EXPECT_LE(slower, JoystickInputs::kTimeout + MonitorControl::kStep) << phase.count();
  }
  static_assert(JoystickInputs::kTimeout == 200ms);
}

TEST(Motion, NeutralStopsAtOnce) {
  MonitorRig rig;
  rig.hold(stick(0x33, kFull, 0), 1s);
  const double before = rig.rotation();
  rig.hold(stick(0x33, 0, 0), 200ms);
  const double stopped = rig.rotation();
  EXPECT_LT(stopped - before, kCoastDegrees);
  rig.run(1s);
  EXPECT_EQ(rig.rotation(), stopped);
}

TEST(Motion, HigherPriorityOverridesOnlyTheAxisItDeflects) {
  struct Row {
    const char* name;
    Frame first, second;  // held together
    int rotation, elevation;
  };
  const Row rows[] = {
      {"same_axis_opposite_ways", stick(0x33, 300, 0), stick(0x38, -kFull, 0), 1, 0},
      {"the_order_of_frames_does_not_matter", stick(0x38, -kFull, 0), stick(0x33, 300, 0), 1, 0},
      {"different_axes_are_both_honoured", stick(0x33, kFull, 0), stick(0x38, 0, kFull), 1, 1},
      {"one_axis_overridden_the_other_honoured", stick(0x33, -300, 0), stick(0x34, kFull, -kFull), -1, -1},
      {"a_resting_stick_stops_nothing", stick(0x33, 0, 0), stick(0x38, kFull, 0), 1, 0},
      {"sources_outside_33_to_38_move_nothing", stick(0x32, kFull, 0), stick(0x39, 0, kFull), 0, 0},
  };
  for (const Row& row : rows) {
    MonitorRig rig;
    for (int i = 0; i < 50; ++i) {
      rig.send(row.first);
      rig.send(row.second);
      rig.run(20ms);
    }
    EXPECT_EQ(rig.rotation() > 0.5, row.rotation > 0) << row.name;
    EXPECT_EQ(rig.rotation() < -0.5, row.rotation < 0) << row.name;
    EXPECT_EQ(rig.elevation() > 0.5, row.elevation > 0) << row.name;
    EXPECT_EQ(rig.elevation() < -0.5, row.elevation < 0) << row.name;
  }
}

TEST(Motion, HigherPrioritysSpeedHoldsForItsDirection) {
  MonitorRig rig;
  for (int i = 0; i < 100; ++i) {
    rig.send(stick(0x33, 100, 0));
    rig.send(stick(0x38, kFull, 0));
    rig.run(20ms);
  }
  EXPECT_LT(rig.rotation(), 2 * 1.2);
}

TEST(Motion, LowerPriorityIsHeardAgainOnceTheHigherOneTimesOut) {
  MonitorRig rig;
  rig.send(stick(0x33, -kFull, 0));
  rig.hold(stick(0x38, kFull, 0), 190ms);
  EXPECT_LT(rig.rotation(), 0);
  rig.hold(stick(0x38, kFull, 0), 2s);
  EXPECT_GT(rig.rotation(), 10);
}

TEST(Motion, OppositeFunctionsGoByPriorityAndOthersTogether) {
  MonitorRig rig;
  for (int i = 0; i < 400; ++i) {
    rig.send(stick(0x33, 0, 0, {Function::Stream}));
    rig.send(stick(0x38, 0, 0, {Function::Fog, Function::FlowHigh}));
    rig.run(20ms);
  }
  EXPECT_EQ(rig.position().plusStop[2], Status2::On) << "stream is the plus end of axis 3";
  EXPECT_EQ(rig.position().plusStop[3], Status2::On) << "high flow is the plus end of axis 4";
  EXPECT_TRUE(rig.outputs().highFlow);
  rig.hold(stick(0x38, 0, 0, {Function::Fog, Function::FlowLow}), 8s);
  EXPECT_EQ(rig.position().minusStop[2], Status2::On);
  EXPECT_EQ(rig.position().minusStop[3], Status2::On);
  EXPECT_FALSE(rig.outputs().highFlow);
}

TEST(Motion, ADeflectionThatIsNotValidMovesNothing) {
  struct Row {
    const char* name;
    const char* data;
  };
  const Row rows[] = {
      {"both_directions", "147D000000000000"}, {"no_direction", "007D000000000000"},
      {"error", "207D000000000000"},           {"not_available", "FFFFFFFF00000000"},
      {"above_full", "50FB000000000000"},      {"error_1022", "90FF000000000000"},
      {"seven_bytes", "10FA0000000000"},
  };
  for (const Row& row : rows) {
    MonitorRig rig;
    rig.hold(frame("0CFDD633", row.data), 1s);
    EXPECT_EQ(rig.rotation(), 0) << row.name;
    EXPECT_EQ(rig.elevation(), 0) << row.name;
  }
}

TEST(Motion, StopsAtSoftLimitsAndReportsNoHardStop) {
  struct Row {
    const char* name;
    int x, y;
    int rotation, elevation;  // 0.1 degree, where it ends
  };
  const Row rows[] = {{"right", kFull, 0, 900, 0},
                      {"left", -kFull, 0, -900, 0},
                      {"up", 0, kFull, 0, 800},
                      {"down", 0, -kFull, 0, -200}};
  for (const Row& row : rows) {
    MonitorRig rig;
    rig.hold(stick(0x33, row.x, row.y), 15s);
    EXPECT_EQ(rig.position().rotation.tenths, row.rotation) << row.name;
    EXPECT_EQ(rig.position().elevation.tenths, row.elevation) << row.name;
    for (const std::size_t axis : {0u, 1u}) {
      EXPECT_EQ(rig.position().plusStop[axis], Status2::Off) << row.name;
      EXPECT_EQ(rig.position().minusStop[axis], Status2::Off) << row.name;
    }
  }
}

TEST(Motion, StandsAgainstHardStopsWhereSoftLimitsAreBeyondThem) {
  MonitorSettings wide = MonitorRig::ahead();
  wide.softLeft = -2000;
  wide.softRight = 2000;
  wide.softDown = -900;
  wide.softUp = 1200;
  MonitorRig rig(wide);
  rig.hold(stick(0x33, kFull, kFull), 20s);
  EXPECT_EQ(rig.position().rotation.tenths, 1750);
  EXPECT_EQ(rig.position().elevation.tenths, 900);
  EXPECT_EQ(rig.position().plusStop[0], Status2::On);
  EXPECT_EQ(rig.position().plusStop[1], Status2::On);
  EXPECT_EQ(rig.position().minusStop[0], Status2::Off);
  rig.hold(stick(0x33, -kFull, -kFull), 40s);
  EXPECT_EQ(rig.position().rotation.tenths, -1750);
  EXPECT_EQ(rig.position().elevation.tenths, -450);
  EXPECT_EQ(rig.position().minusStop[0], Status2::On);
  EXPECT_EQ(rig.position().minusStop[1], Status2::On);
  EXPECT_EQ(rig.position().plusStop[0], Status2::Off);
}

TEST(Motion, OutsideOfSoftLimitsItMayOnlyMoveBackIn) {
  MonitorRig rig(MonitorSettings{});  // stowed: below the lower soft limit
  ASSERT_EQ(rig.position().elevation.tenths, -400);
  rig.hold(stick(0x33, 0, -kFull), 2s);
  EXPECT_EQ(rig.position().elevation.tenths, -400);
  rig.hold(stick(0x33, 0, kFull), 4s);
  EXPECT_GT(rig.position().elevation.tenths, -200);
  rig.hold(stick(0x33, 0, -kFull), 10s);
  EXPECT_EQ(rig.position().elevation.tenths, -200);
}

TEST(Motion, ReportsItsSoftLimits) {
  MonitorRig rig;
  EXPECT_EQ(rig.last(MessageId::RotationSoftLimits), "left_deg=-90; right_deg=90; oscillating=off");
  EXPECT_EQ(rig.last(MessageId::ElevationSoftLimits), "down_deg=-20; up_deg=80");
}

TEST(Motion, DischargeValveGoesOnOpeningOncePressed) {
  MonitorRig rig;
  EXPECT_EQ(rig.position().minusStop[4], Status2::On);
  EXPECT_FALSE(rig.outputs().dischargeValve);
  rig.hold(stick(0x33, 0, 0, {Function::DischargeOn}), 200ms);
  rig.run(2s);
  EXPECT_TRUE(rig.outputs().dischargeValve);
  EXPECT_EQ(rig.position().plusStop[4], Status2::Off);
  rig.run(4s);
  EXPECT_EQ(rig.position().plusStop[4], Status2::On);
  rig.hold(stick(0x33, 0, 0, {Function::DischargeOff}), 200ms);
  rig.run(6s);
  EXPECT_EQ(rig.position().minusStop[4], Status2::On);
  EXPECT_FALSE(rig.outputs().dischargeValve);
}

TEST(Oscillation, StaysWithinItsLimitsAndSaysSo) {
  MonitorRig rig;
  rig.hold(stick(0x33, 0, 0, {Function::OscillateSet}), 300ms);
  const Instant from = rig.now();
  rig.run(60s);
  EXPECT_EQ(rig.last(MessageId::RotationSoftLimits), "left_deg=-30; right_deg=45; oscillating=on");
  int left = 0, right = 0;
  for (const Seen& seen : rig.all(MessageId::PositionLimitStatus, from)) {
    const int at = PositionLimitStatus::of(seen.frame).rotation.tenths;
    left = std::min(left, at);
    right = std::max(right, at);
  }
  EXPECT_EQ(left, -300);
  EXPECT_EQ(right, 450);
  for (const Seen& seen : rig.all(MessageId::RotationSoftLimits, from))
    EXPECT_TRUE(SoftLimits::ofRotation(seen.frame).oscillating);
}

TEST(Oscillation, TakesTheSweepMadeByHandAsItsLimits) {
  MonitorRig rig;
  rig.hold(stick(0x33, kFull, 0), 2s);
  rig.hold(stick(0x33, -kFull, 0), 3s);
  rig.hold(stick(0x33, 0, 0, {Function::OscillateSet}), 300ms);
  rig.run(200ms);
  const SoftLimits limits = rig.rotationLimits();
  EXPECT_TRUE(limits.oscillating);
  EXPECT_NEAR(limits.high, 230, 20);
  EXPECT_NEAR(limits.low, -110, 40);
}

TEST(Oscillation, IsInterruptedByAnyManualRotationButNotByElevation) {
  MonitorRig rig;
  rig.hold(stick(0x33, 0, 0, {Function::OscillateSet}), 300ms);
  rig.run(1s);
  rig.hold(stick(0x38, 0, 500), 500ms);
  EXPECT_TRUE(rig.rotationLimits().oscillating);
  rig.hold(stick(0x38, -100, 0), 300ms);
  EXPECT_FALSE(rig.rotationLimits().oscillating);
  rig.run(1s);
  const double stopped = rig.rotation();
  rig.run(10s);
  EXPECT_EQ(rig.rotation(), stopped) << "it does not start again by itself";
}

TEST(Oscillation, PausesAndResumes) {
  MonitorRig rig;
  rig.hold(stick(0x33, 0, 0, {Function::OscillateSet}), 300ms);
  rig.run(1s);
  rig.hold(stick(0x33, 0, 0, {Function::OscillatePause}), 500ms);
  rig.run(500ms);
  const double paused = rig.rotation();
  rig.run(5s);
  EXPECT_EQ(rig.rotation(), paused);
  rig.hold(stick(0x33, 0, 0, {Function::OscillatePause}), 300ms);
  rig.run(1s);
  EXPECT_NE(rig.rotation(), paused);
}

TEST(Stow, DrivesToTheStowPositionThenSaysStowed) {
  MonitorRig rig;
  rig.hold(stick(0x33, kFull, kFull), 3s);
  EXPECT_TRUE(rig.outputs().active);
  EXPECT_FALSE(rig.outputs().stowed);
  rig.hold(stick(0x33, 0, 0, {Function::Stow}), 300ms);
  rig.run(1s);
  EXPECT_TRUE(rig.outputs().active) << "not before it is there";
  rig.run(30s);
  EXPECT_TRUE(rig.outputs().stowed);
  EXPECT_FALSE(rig.outputs().active);
  EXPECT_EQ(rig.position().rotation.tenths, MonitorControl::kStowRotation);
  EXPECT_EQ(rig.position().elevation.tenths, MonitorControl::kStowElevation);
  rig.hold(stick(0x33, 0, 0, {Function::Deploy}), 300ms);
  rig.run(20s);
  EXPECT_FALSE(rig.outputs().stowed);
  EXPECT_TRUE(rig.outputs().active);
  EXPECT_EQ(rig.position().elevation.tenths, 150);
}

TEST(Stow, IsEndedByAHandOnTheStick) {
  MonitorRig rig;
  rig.hold(stick(0x33, kFull, 0), 4s);
  rig.hold(stick(0x33, 0, 0, {Function::Stow}), 300ms);
  rig.run(500ms);
  rig.hold(stick(0x33, 0, 200), 100ms);
  rig.run(1s);
  const double rotation = rig.rotation(), elevation = rig.elevation();
  rig.run(10s);
  EXPECT_EQ(rig.rotation(), rotation);
  EXPECT_EQ(rig.elevation(), elevation);
  EXPECT_FALSE(rig.outputs().stowed);
}

TEST(PointAim, GoesToItsTargetAndSaysSo) {
  struct Row {
    const char* name;
    int x, y;  // 0.1 %, right and forward positive
    int rotation, elevation;
  };
  const Row rows[] = {{"right_and_up", 200, 500, 350, 450},
                      {"left_and_down", -400, -100, -700, -90},
                      {"beyond_the_soft_limits", 1000, 1000, 900, 800}};
  for (const Row& row : rows) {
    MonitorRig rig;
    rig.hold(extended(0x33, Value::decimal(row.x, 1), row.x > 0 ? "grip_x_right" : "grip_x_left",
                      Value::decimal(row.y, 1), row.y > 0 ? "grip_y_forward" : "grip_y_back"),
             20s);
    EXPECT_TRUE(rig.outputs().pointAimMode) << row.name;
    EXPECT_EQ(rig.position().rotation.tenths, row.rotation) << row.name;
    EXPECT_EQ(rig.position().elevation.tenths, row.elevation) << row.name;
    rig.hold(notAiming(0x33), 500ms);
    EXPECT_FALSE(rig.outputs().pointAimMode) << row.name;
  }
}

TEST(PointAim, EndsWithItsSourceAndWithNotAvailable) {
  for (const bool says : {false, true}) {
    MonitorRig rig;
    const Frame aim = extended(0x33, Value::decimal(500, 1), "grip_x_right", Value(), "");
    rig.hold(aim, 1s);
    if (says) rig.send(notAiming(0x33));
    rig.run(500ms);
    EXPECT_FALSE(rig.outputs().pointAimMode) << says;
    const double stopped = rig.rotation();
    rig.run(5s);
    EXPECT_EQ(rig.rotation(), stopped) << says;
    EXPECT_GT(stopped, 5) << says;
  }
}

TEST(PointAim, AGripWithoutADirectionIsATargetOnlyWhereSet) {
  for (const bool neutralAims : {false, true}) {
    MonitorSettings settings = MonitorRig::ahead();
    settings.aimAtNeutral = neutralAims;
    MonitorRig rig(settings);
    rig.hold(stick(0x33, kFull, 0), 2s);
    const double before = rig.rotation();
    rig.hold(frame("0CFDD738", "01000100FFFF0000"), 10s);
    if (neutralAims) {
      EXPECT_EQ(rig.rotation(), 0);
    } else {
      EXPECT_GT(rig.rotation(), before - 0.01);
    }
    EXPECT_EQ(rig.outputs().pointAimMode, neutralAims);
  }
}

TEST(PointAim, YieldsToADeflectionOfTheSameAxis) {
  MonitorRig rig;
  for (int i = 0; i < 50; ++i) {
    rig.send(
        extended(0x38, Value::decimal(500, 1), "grip_x_right", Value::decimal(500, 1), "grip_y_forward"));
    rig.send(stick(0x38, -kFull, 0));
    rig.run(20ms);
  }
  EXPECT_LT(rig.rotation(), -5);
  EXPECT_GT(rig.elevation(), 5);
}

TEST(Permissive, IsNeededForEachDirectionInSoeMode) {
  struct Row {
    const char* name;
    const char* permissive;  // "" = none is sent
    bool right, left, up, down;
  };
  const Row rows[] = {{"none", "", false, false, false, false},
                      {"nothing_allowed", "A10000", false, false, false, false},
                      {"right", "A10001", true, false, false, false},
                      {"left", "A10002", false, true, false, false},
                      {"up", "A10004", false, false, true, false},
                      {"down", "A10008", false, false, false, true},
                      {"manuals_example", "A10009", true, false, false, true},
                      {"two_bytes_are_no_permissive", "A10F", false, false, false, false}};
  for (const Row& row : rows) {
    const auto moves = [&](int x, int y) {
      MonitorSettings settings = MonitorRig::ahead();
      settings.soeMode = true;
      MonitorRig rig(settings);
      EXPECT_TRUE(rig.outputs().soeMode);
      for (int i = 0; i < 50; ++i) {
        if (*row.permissive != 0) rig.send("18EF8005", row.permissive);
        rig.send(stick(0x33, x, y));
        rig.run(20ms);
      }
      return rig.rotation() != 0 || rig.elevation() != 0;
    };
    EXPECT_EQ(moves(kFull, 0), row.right) << row.name;
    EXPECT_EQ(moves(-kFull, 0), row.left) << row.name;
    EXPECT_EQ(moves(0, kFull), row.up) << row.name;
    EXPECT_EQ(moves(0, -kFull), row.down) << row.name;
  }
}

TEST(Permissive, TimesOutAfterThreeHundredMilliseconds) {
  MonitorSettings settings = MonitorRig::ahead();
  settings.soeMode = true;
  MonitorRig rig(settings);
  for (int i = 0; i < 10; ++i) {
    rig.send("18EF8005", "A10001");
    rig.hold(stick(0x33, kFull, 0), 100ms);
  }
  const double before = rig.rotation();
  rig.hold(stick(0x33, kFull, 0), 180ms);  // 280 ms after the last permissive
  EXPECT_NEAR(rig.rotation() - before, 12 * 0.18, 0.01);
  rig.hold(stick(0x33, kFull, 0), 40ms);
  const double stopped = rig.rotation();
  rig.hold(stick(0x33, kFull, 0), 1s);
  EXPECT_EQ(rig.rotation(), stopped) << "without a ramp, and while the stick is still deflected";
}

TEST(Permissive, TimeOutTakesEffectWithinOnePassOfTheControlLoop) {
  for (const Duration phase : {0ms, 1ms, 5ms, 9ms}) {
    MonitorSettings settings = MonitorRig::ahead();
    settings.soeMode = true;
    MonitorRig rig(settings);
    rig.run(phase);
    for (int i = 0; i < 10; ++i) {
      rig.send("18EF8005", "A10001");
      rig.hold(stick(0x33, kFull, 0), 100ms);
    }
    const Instant last = rig.now() - 100ms;
    rig.hold(stick(0x33, kFull, 0), 160ms);
    const Duration stopped = untilSlower(rig, last);
    EXPECT_EQ(rig.monitor.control().axes()[0].speed(), 0);
    EXPECT_GE(stopped, 300ms) << phase.count();
    EXPECT_LE(stopped, 310ms) << phase.count();
  }
}

TEST(Permissive, ToAnotherNodeAllowsNothing) {
  MonitorSettings settings = MonitorRig::ahead();
  settings.soeMode = true;
  MonitorRig rig(settings);
  for (int i = 0; i < 20; ++i) {
    rig.send("18EF8105", "A1000F");
    rig.send("18EFFF05", "A1000F");
    rig.hold(stick(0x33, kFull, 0), 100ms);
  }
  EXPECT_EQ(rig.rotation(), 0);
}

}  // namespace
}  // namespace deckpipe::simulator::test
