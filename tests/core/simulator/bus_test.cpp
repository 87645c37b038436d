// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulated devices say: periods, answers, acknowledgements, the pipe, resets.
#include <gtest/gtest.h>

#include "rig.h"

namespace deckpipe::simulator::test {
namespace {

TEST(Status, ComesEveryHundredMilliseconds) {
  struct Row {
    const char* name;
    std::size_t device;  // of the standard simulator
    MessageId message;
  };
  const Row rows[] = {{"position", 0, MessageId::PositionLimitStatus},
                      {"rotation_limits", 0, MessageId::RotationSoftLimits},
                      {"elevation_limits", 0, MessageId::ElevationSoftLimits},
                      {"outputs", 0, MessageId::DigitalOutputs},
                      {"mini_outputs", 1, MessageId::MiniDigitalOutputs},
                      {"inputs", 2, MessageId::DigitalInputs}};
  Rig rig;
  rig.simulator = standardSimulator(7).simulator;
  rig.simulator.powerOn(rig.now());
  rig.run(12500ms);
  for (const Row& row : rows) {
    const Address source = rig.simulator.device(row.device).address();
    const auto seen = rig.all(row.message, source, Instant{} + 2500ms);
    ASSERT_GE(seen.size(), 99u) << row.name;
    for (std::size_t i = 1; i < seen.size(); ++i) {
      const Duration period = seen[i].time - seen[i - 1].time;
      EXPECT_GE(period, 99ms) << row.name;
      EXPECT_LE(period, 101ms) << row.name;
    }
  }
}

TEST(Status, FramesOfOneDeviceAreSpreadByHalfAMillisecondAndInOrder) {
  Rig rig;
  rig.simulator = standardSimulator(7).simulator;
  rig.simulator.powerOn(rig.now());
  rig.run(5s);
  std::map<unsigned, Instant> last;
  Instant before = kNotYet;
  for (const Seen& seen : rig.log) {
    EXPECT_GE(seen.time, before);
    before = seen.time;
    const auto [at, isFirst] = last.emplace(seen.source().value, seen.time);
    if (!isFirst) {
      EXPECT_GE(seen.time - at->second, 500us) << std::hex << seen.frame.id;
      at->second = seen.time;
    }
  }
}

TEST(Status, EveryFrameOfTheStandardSimulatorIsInTheCatalogue) {
  Rig rig;
  rig.simulator = standardSimulator(3).simulator;
  rig.simulator.powerOn(rig.now());
  rig.run(60s);
  for (const Seen& seen : rig.log) ASSERT_TRUE(seen.what.isDecoded()) << std::hex << seen.frame.id;
}

TEST(Poll, EveryAnswerDecodesToItsFields) {
  struct Row {
    const char* name;
    std::size_t device;
    const char* poll;
    MessageId answer;
    const char* fields;
  };
  const Row rows[] = {
      {"6032_fault", 0, "02", MessageId::FaultResponse, "faults=; reserved_bits=; pcode_error=0"},
      {"6032_firmware", 0, "03", MessageId::FirmwareResponse, "fixed_boot=1.11; bootloader=2.4; system=2.6"},
      {"6032_pcode", 0, "04", MessageId::PcodeResponse, "style=3356; subtype=14; version=2.4"},
      {"6032_config", 0, "05", MessageId::ConfigResponse, "config_type=60320014; version=2.4"},
      {"6032_vista_position", 0, "21", MessageId::VistaPosition, "rotation_raw=32767; elevation_raw=2427"},
      {"6033_fault", 1, "02", MessageId::FaultResponse, "faults=; reserved_bits=; pcode_error=0"},
      {"6033_firmware", 1, "03", MessageId::FirmwareResponse, "fixed_boot=1.11; bootloader=2.4; system=2.6"},
      {"6033_pcode", 1, "04", MessageId::PcodeResponse, "style=6033; subtype=1; version=1.2"},
      {"6033_config", 1, "05", MessageId::ConfigResponse, "config_type=60330001; version=1.0"},
      {"6039_config", 2, "05", MessageId::ConfigResponse, "config_type=60390001; version=1.0"},
      {"6035_pcode", 3, "04", MessageId::PcodeResponse, "style=6035; subtype=1; version=1.3"},
  };
  for (const Row& row : rows) {
    Rig rig;
    StandardSimulator standard = standardSimulator(1);
    standard.joystick->release();
    rig.simulator = std::move(standard.simulator);
    rig.simulator.powerOn(rig.now());
    rig.run(3s);
    const Instant before = rig.now();
    const Address to = rig.simulator.device(row.device).address();
    Frame poll = frame("18EF00F9", row.poll);
    poll.id |= static_cast<std::uint32_t>(to.value) << 8;
    rig.send(poll);
    rig.run(20ms);
    const auto answers = rig.all(row.answer, before);
    ASSERT_EQ(answers.size(), 1u) << row.name;
    EXPECT_EQ(answers[0].source(), to) << row.name;
    EXPECT_EQ(answers[0].destination(), Address{0xF9}) << row.name;
    EXPECT_EQ(Rig::textOf(answers[0]), row.fields) << row.name;
  }
}

TEST(Poll, VistaPollIsAnsweredByOneStatusAndOnePosition) {
  MonitorRig rig;
  rig.hold(stick(0x33, 500, -300, {Function::DischargeOn}), 500ms);
  rig.send("18EF8005", "21");
  rig.run(20ms);
  EXPECT_EQ(rig.all(MessageId::VistaStatus).size(), 1u);
  EXPECT_EQ(rig.all(MessageId::VistaPosition).size(), 1u);
  const std::string status = rig.last(MessageId::VistaStatus);
  for (const char* part :
       {"system_voltage_raw=552", "joystick_x_raw=500", "joystick_y_raw=300", "joystick_x_right=on",
        "joystick_y_forward=on", "joystick_sw3=on", "joystick_sw10=off"})
    EXPECT_NE(status.find(part), std::string::npos) << part << " in " << status;
}

TEST(Poll, NobodyAnswersWhatIsNotForThem) {
  struct Row {
    const char* name;
    const char* id;
    const char* data;
  };
  const Row rows[] = {{"broadcast", "18EFFFF9", "02"},   {"another_node", "18EF81F9", "02"},
                      {"two_bytes", "18EF80F9", "0200"}, {"unknown_type", "18EF80F9", "77"},
                      {"empty", "18EF80F9", ""},         {"another_pgn", "18EB80F9", "02"},
                      {"from_nobody", "18EF80FE", "02"}, {"from_everybody", "18EF80FF", "02"},
                      {"data_page_1", "19EF80F9", "02"}};
  for (const Row& row : rows) {
    MonitorRig rig;
    const Instant before = rig.now();
    rig.send(row.id, row.data);
    rig.run(50ms);
    for (const Seen& seen : rig.log) {
      if (seen.time <= before) continue;
      EXPECT_EQ(seen.destination(), kGlobalAddress) << row.name;
    }
  }
}

TEST(Zero, IsAcknowledgedAndMakesBothPositionsZero) {
  MonitorRig rig;
  rig.hold(stick(0x33, 1000, 1000), 2s);
  rig.run(500ms);
  ASSERT_GT(rig.position().rotation.tenths, 100);
  rig.send("18EF8005", "41");
  rig.run(200ms);
  const auto acks = rig.all(MessageId::ZeroAxesAck);
  ASSERT_EQ(acks.size(), 1u);
  EXPECT_EQ(acks[0].destination(), Address{0x05});
  EXPECT_EQ(rig.position().rotation, (PositionReading{PositionState::Ok, 0}));
  EXPECT_EQ(rig.position().elevation, (PositionReading{PositionState::Ok, 0}));
  EXPECT_GT(rig.rotation(), 10) << "it did not move";
  rig.hold(stick(0x33, 1000, 0), 15s);
  EXPECT_EQ(rig.position().rotation.tenths, 900) << "the soft limits keep their numbers";
}

TEST(Zero, IsNotAcknowledgedWithoutFeedback) {
  MonitorRig rig;
  rig.monitor.misbehave({.feedbackNotFitted = true});
  rig.send("18EF8005", "41");
  rig.run(1s);
  EXPECT_TRUE(rig.all(MessageId::ZeroAxesAck).empty());
}

TEST(Reset, IsSilentThenClaimsAndAnnouncesAnew) {
  MonitorRig rig;
  rig.hold(stick(0x33, 1000, 0), 1s);
  const Instant at = rig.now();
  rig.send("18EF8005", "45");
  rig.run(20s);
  const auto names = rig.all(MessageId::Name, at);
  const auto announcements = rig.all(MessageId::AddressAnnouncement, at);
  ASSERT_EQ(names.size(), 1u);
  ASSERT_EQ(announcements.size(), 1u);
  EXPECT_EQ(names[0].time - at, 1500ms);
  EXPECT_EQ(announcements[0].time - at, 1750ms);
  EXPECT_EQ(announcements[0].source(), Address{0x80});
  for (const Seen& seen : rig.log) {
    if (seen.time > at) {
      EXPECT_GE(seen.time - at, 1500ms) << "not even an acknowledgement";
    }
  }
}

TEST(Reset, ForgetsWhatWasAskedAndMovesNothing) {
  MonitorRig rig;
  rig.hold(stick(0x33, 0, 0, {Function::OscillateSet}), 1s);
  rig.send("18EF8005", "45");
  const double before = rig.rotation();
  rig.run(20s);
  EXPECT_EQ(rig.rotation(), before);
  EXPECT_FALSE(rig.rotationLimits().oscillating);
}

TEST(Setup, IsAcknowledgedAndLeftByAReset) {
  MonitorRig rig;
  rig.send("18EF8005", "46");
  rig.run(10ms);
  ASSERT_EQ(rig.all(MessageId::SetupModeAck).size(), 1u);
  EXPECT_EQ(rig.all(MessageId::SetupModeAck)[0].destination(), Address{0x05});
  EXPECT_TRUE(rig.monitor.isInSetupMode());
  rig.send("18EF8005", "45");
  rig.run(3s);
  EXPECT_FALSE(rig.monitor.isInSetupMode());
}

TEST(Riser, TakesSixSecondsBetweenItsEnds) {
  Rig rig;
  auto& riser = rig.simulator.add<MiniUniversal6033>(100ms, "1033AE100802117", 1u);
  rig.simulator.powerOn(rig.now());
  rig.run(1s);
  EXPECT_EQ(rig.last(MessageId::MiniDigitalOutputs),
            "riser_retracted=on; riser_extended=off; device_faulted=off; device_active=on");
  rig.hold(stick(0x33, 0, 0, {Function::Deploy}), 400ms);
  rig.run(3s);
  EXPECT_EQ(rig.last(MessageId::MiniDigitalOutputs),
            "riser_retracted=off; riser_extended=off; device_faulted=off; device_active=on");
  rig.run(3s);
  EXPECT_TRUE(riser.isExtended());
  rig.hold(stick(0x33, 0, 0, {Function::Stow}), 400ms);
  rig.run(5s);
  EXPECT_FALSE(riser.isRetracted());
  rig.run(1s);
  EXPECT_TRUE(riser.isRetracted());
}

TEST(IoModule, SaysItsInputs) {
  Rig rig;
  auto& module = rig.simulator.add<IoModule6039>(100ms, 4711u, 1u);
  rig.simulator.powerOn(rig.now());
  rig.run(120s);
  bool seenOff = false, seenOn = false;
  for (const Seen& seen : rig.all(MessageId::DigitalInputs))
    (DigitalInputs::of(seen.frame).allowedInCollisionZone ? seenOn : seenOff) = true;
  EXPECT_TRUE(seenOff && seenOn) << "its script changes it";
  module.setInputs({.deploy = true});
  rig.run(120s);
  EXPECT_EQ(rig.last(MessageId::DigitalInputs), "allowed_in_collision_zone=off; deploy=on; stow=off");
}

TEST(Joystick, SendsEveryTwentyMillisecondsFromItsFixedSource) {
  Rig rig;
  rig.simulator.add<Joystick6035>(100ms, "1035AE100804442", Address{0x35}, 1u);
  rig.simulator.powerOn(rig.now());
  rig.run(300s);
  const auto sent = rig.all(MessageId::BasicJoystick);
  ASSERT_GT(sent.size(), 14'900u);
  bool right = false, left = false, up = false, down = false, neutral = false;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    EXPECT_EQ(sent[i].source(), Address{0x35});
    if (i > 0) {
      EXPECT_NEAR(static_cast<double>((sent[i].time - sent[i - 1].time).count()), 20e6, 1.5e6);
    }
    const BasicJoystick stick = BasicJoystick::of(sent[i].frame);
    ASSERT_TRUE(stick.x.tenths && stick.y.tenths);
    right |= *stick.x.tenths > 200;
    left |= *stick.x.tenths < -200;
    up |= *stick.y.tenths < -200;
    down |= *stick.y.tenths > 200;
    neutral |= *stick.x.tenths == 0 && *stick.y.tenths == 0;
  }
  EXPECT_TRUE(right && left && up && down && neutral);
}

TEST(Joystick, ReleasedItGoesOnSendingNeutral) {
  Rig rig;
  auto& joystick = rig.simulator.add<Joystick6035>(100ms, "1035AE100804442", Address{0x33}, 1u);
  rig.simulator.powerOn(rig.now());
  rig.run(30s);
  joystick.release();
  rig.run(1s);
  const Instant from = rig.now();
  rig.run(10s);
  const auto sent = rig.all(MessageId::BasicJoystick, from);
  EXPECT_GE(sent.size(), 499u);
  for (const Seen& seen : sent) EXPECT_EQ(seen.frame.data, frame("0CFDD633", "0100010000000000").data);
}

}  // namespace
}  // namespace deckpipe::simulator::test
