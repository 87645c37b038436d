// SPDX-License-Identifier: GPL-3.0-or-later
// The hot path's structs say what the catalogue says, for any bytes.
#include "protocol/typed.h"

#include <gtest/gtest.h>

#include <random>

#include "support/frames.h"

namespace deckpipe {
namespace {

Value field(const Frame& frame, MessageId id, std::string_view key) {
  for (const Field& f : messageOf(id).fields) {
    if (f.key == key) return valueOf(f, frame);
  }
  ADD_FAILURE() << "no field " << key;
  return {};
}

std::string_view word(Status2 status) {
  constexpr std::string_view kWords[] = {"off", "on", "error", "na"};
  return kWords[static_cast<std::size_t>(status)];
}

Frame randomFrame(std::mt19937& random, MessageId id) {
  const Message& message = messageOf(id);
  Frame f;
  f.length = static_cast<std::uint8_t>(message.maxLength());
  for (unsigned i = 0; i < f.length; ++i) f.data[i] = static_cast<std::uint8_t>(random());
  if (message.firstByte >= 0) f.data[0] = static_cast<std::uint8_t>(message.firstByte);
  return f;
}

TEST(Typed, PositionAgreesWithTheCatalogueForAnyBytes) {
  std::mt19937 random(1);
  constexpr MessageId kId = MessageId::PositionLimitStatus;
  for (int i = 0; i < 2000; ++i) {
    const Frame f = randomFrame(random, kId);
    const PositionLimitStatus s = PositionLimitStatus::of(f);
    EXPECT_EQ(field(f, kId, "rotation_state").text(), kPositionStateKeys[s.rotation.state]);
    EXPECT_EQ(field(f, kId, "elevation_state").text(), kPositionStateKeys[s.elevation.state]);
    const Value rotation = field(f, kId, "rotation_deg");
    EXPECT_EQ(rotation.isNull(), s.rotation.state != PositionState::Ok);
    if (!rotation.isNull()) {
      EXPECT_EQ(rotation.number(), s.rotation.tenths);
    }
    for (std::size_t axis = 0; axis < 5; ++axis) {
      const std::string prefix = "axis" + std::to_string(axis + 1);
      EXPECT_EQ(field(f, kId, prefix + "_plus_stop").text(), word(s.plusStop[axis]));
      EXPECT_EQ(field(f, kId, prefix + "_minus_stop").text(), word(s.minusStop[axis]));
    }
    EXPECT_EQ(field(f, kId, "operational_error").text(), word(s.operationalError));
    EXPECT_EQ(field(f, kId, "calibrated").text(), word(s.calibrated));
  }
}

TEST(Typed, JoystickAgreesWithTheCatalogueForAnyBytes) {
  std::mt19937 random(2);
  constexpr MessageId kId = MessageId::BasicJoystick;
  for (int i = 0; i < 2000; ++i) {
    const Frame f = randomFrame(random, kId);
    const BasicJoystick j = BasicJoystick::of(f);
    const Value x = field(f, kId, "x_percent"), y = field(f, kId, "y_percent");
    EXPECT_EQ(!x.isNull(), j.x.tenths.has_value());
    if (j.x.tenths) {
      EXPECT_EQ(x.number(), *j.x.tenths);
    }
    EXPECT_EQ(!y.isNull(), j.y.tenths.has_value());
    if (j.y.tenths) {
      EXPECT_EQ(y.number(), *j.y.tenths);
    }
    EXPECT_EQ(field(f, kId, "y_back").text(), word(j.y.minus));
    EXPECT_EQ(field(f, kId, "x_detent").text(), word(j.x.detent));
    for (std::size_t n = 0; n < 12; ++n) {
      EXPECT_EQ(field(f, kId, "switch_" + std::to_string(n + 1)).text(), word(j.switches[n]));
    }
  }
}

TEST(Typed, EncodesTheManualsBytes) {
  const auto expectBytes = [](const char* bytes, const Encoded& encoded) {
    const Frame expected = test::frame("18EFFF80", bytes);
    EXPECT_EQ(encoded.data, expected.data) << bytes;
    EXPECT_EQ(encoded.length, expected.length) << bytes;
  };
  const auto from = [](const char* bytes) { return test::frame("18EFFF80", bytes); };
  const auto position = PositionLimitStatus::of(from("011D940371000041"));
  expectBytes("011D940371000041", position.encode());
  const auto rotation = SoftLimits::ofRotation(from("81FED401C280"));
  EXPECT_EQ(rotation, (SoftLimits{-300, 450, true}));
  expectBytes("81FED401C280", rotation.encodeRotation());
  const auto elevation = SoftLimits::ofElevation(from("82FF38038400"));
  EXPECT_EQ(elevation, (SoftLimits{-200, 900, false}));
  expectBytes("82FF38038400", elevation.encodeElevation());
  const auto outputs = DigitalOutputs::of(from("83C051"));
  expectBytes("83C051", outputs.encode());
  const auto mini = MiniOutputs::of(from("848002"));
  expectBytes("848002", mini.encode());
  const auto inputs = DigitalInputs::of(from("8501"));
  expectBytes("8501", inputs.encode());
  const auto joystick = BasicJoystick::of(from("107D046400100000"));
  expectBytes("107D046400100000", joystick.encode());
}

TEST(Typed, NeutralJoystickIsTheFrameTheSafetyRulesName) {
  BasicJoystick neutral;
  neutral.x = neutral.y = StickAxis::at(0);
  EXPECT_EQ(neutral.encode().data, test::frame("0CFDD638", "0100010000000000").data);
}

TEST(Typed, ReadsTheAnswersToPolls) {
  EXPECT_EQ(FaultStatus::of(test::frame("18EF0580", "0200200000000B")), (FaultStatus{1u << 21, 11}));
  EXPECT_EQ(FaultStatus::of(test::frame("18EF0580", "0200200000")), (FaultStatus{1u << 21, {}}));
  EXPECT_EQ(FirmwareVersions::of(test::frame("18EF0580", "03010B02040206")),
            (FirmwareVersions{0x010B, 0x0204, 0x0206}));
  EXPECT_EQ(PcodeVersion::of(test::frame("18EF0580", "040D1C000E0204")), (PcodeVersion{3356, 14, 0x0204}));
  EXPECT_EQ(ConfigVersion::of(test::frame("18EF0580", "050398690E0204")), (ConfigVersion{60320014, 0x0204}));
  EXPECT_EQ(announcedPin(test::frame("18EFFF80", "FF83150206021A0B"))->text(), "1032AE100801035");
  const Name name = Name::of(test::frame("18EEFF80", "0B1AC22800420090"));
  EXPECT_EQ(name.manufacturerCode(), 326u);
  EXPECT_EQ(name.identityNumber(), 0x021A0Bu);
  EXPECT_EQ(name.function(), 66u);
}

}  // namespace
}  // namespace deckpipe
