// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/typed.h"

#include <bit>
#include <cstdlib>
#include <iterator>
#include <utility>

namespace deckpipe {
namespace {

consteval BitRange position(std::string_view key) {
  return fieldOf(akron::kPositionLimitStatusFields, key).bits;
}

// The bits of the fields whose keys begin and end so, in order.
template <std::size_t N>
consteval std::array<BitRange, N> alike(std::span<const Field> fields, std::string_view begin,
                                        std::string_view end = "") {
  std::array<BitRange, N> bits{};
  std::size_t at = 0;
  for (const Field& field : fields) {
    if (field.key.starts_with(begin) && field.key.ends_with(end)) bits[at++] = field.bits;
  }
  return bits;
}
constexpr auto kPlusStops = alike<5>(akron::kPositionLimitStatusFields, "axis", "_plus_stop");
constexpr auto kMinusStops = alike<5>(akron::kPositionLimitStatusFields, "axis", "_minus_stop");
constexpr auto kSwitches = alike<12>(j1939::kBasicJoystickFields, "switch_");
constexpr auto kGripSwitches = alike<4>(j1939::kExtendedJoystickFields, "switch_");

unsigned bitsOf(const Frame& frame, BitRange range) {
  return static_cast<unsigned>(readBits(frame.data, range));
}
std::uint16_t shortAt(const Frame& frame, const Field& field) {
  return static_cast<std::uint16_t>(bitsOf(frame, field.bits));
}
template <BitRange R>
unsigned bitsAt(const LoadedPayload& payload) {
  return static_cast<unsigned>(payload.read<R>());
}
template <BitRange R>
Status2 statusAt(const LoadedPayload& payload) {
  return static_cast<Status2>(bitsAt<R>(payload));
}
// One status2 after another from a list of ranges, unrolled at compile time.
template <auto Ranges, std::size_t N>
void readStatuses(const LoadedPayload& payload, std::array<Status2, N>& out) {
  static_assert(Ranges.size() == N);
  [&]<std::size_t... I>(std::index_sequence<I...>) { ((out[I] = statusAt<Ranges[I]>(payload)), ...); }
  (std::make_index_sequence<N>{});
}
void put(Encoded& out, BitRange range, std::uint64_t value) { writeBits(out.data, range, value); }
void put(Encoded& out, BitRange range, Status2 value) { put(out, range, static_cast<std::uint64_t>(value)); }

// An encoded message with its first byte, everything else 0.
Encoded blank(MessageId id) {
  const Message& message = messageOf(id);
  Encoded out;
  out.length = static_cast<std::uint8_t>(message.maxLength());
  if (message.firstByte >= 0) out.data[0] = static_cast<std::uint8_t>(message.firstByte);
  return out;
}

void putReading(Encoded& out, const Field& field, const PositionReading& reading) {
  const auto signs = [&](Status2 plus, Status2 minus) {
    put(out, field.plus, plus);
    put(out, field.minus, minus);
  };
  put(out, field.bits,
      reading.state == PositionState::Ok ? static_cast<unsigned>(std::abs(reading.tenths)) : 0xFFFu);
  switch (reading.state) {
    case PositionState::Ok:
      if (reading.tenths != 0)
        signs(reading.tenths > 0 ? Status2::On : Status2::Off,
              reading.tenths < 0 ? Status2::On : Status2::Off);
      break;
    case PositionState::SensorError: signs(Status2::On, Status2::Off); break;
    case PositionState::NotFitted: signs(Status2::NotAvailable, Status2::NotAvailable); break;
    case PositionState::Invalid: signs(Status2::Error, Status2::Error); break;
  }
}

void putAxis(Encoded& out, const Field& percent, BitRange neutral, const StickAxis& axis) {
  put(out, percent.bits, axis.tenths ? static_cast<unsigned>(std::abs(*axis.tenths)) : 0x3FFu);
  put(out, percent.plus, axis.plus);
  put(out, percent.minus, axis.minus);
  put(out, neutral, axis.neutral);
}

constexpr Field kRotation = fieldOf(akron::kPositionLimitStatusFields, "rotation_deg");
constexpr Field kElevation = fieldOf(akron::kPositionLimitStatusFields, "elevation_deg");
constexpr BitRange kLeft = fieldOf(akron::kRotationSoftLimitsFields, "left_deg").bits;
constexpr BitRange kRight = fieldOf(akron::kRotationSoftLimitsFields, "right_deg").bits;
constexpr BitRange kOscillating = fieldOf(akron::kRotationSoftLimitsFields, "oscillating").bits;
constexpr BitRange kDown = fieldOf(akron::kElevationSoftLimitsFields, "down_deg").bits;
constexpr BitRange kUp = fieldOf(akron::kElevationSoftLimitsFields, "up_deg").bits;

constexpr Field kX = fieldOf(j1939::kBasicJoystickFields, "x_percent");
constexpr Field kY = fieldOf(j1939::kBasicJoystickFields, "y_percent");
constexpr BitRange kXNeutral = fieldOf(j1939::kBasicJoystickFields, "x_neutral").bits;
constexpr BitRange kYNeutral = fieldOf(j1939::kBasicJoystickFields, "y_neutral").bits;
constexpr Field kGripX = fieldOf(j1939::kExtendedJoystickFields, "grip_x_percent");
constexpr Field kGripY = fieldOf(j1939::kExtendedJoystickFields, "grip_y_percent");
constexpr Field kGripTheta = fieldOf(j1939::kExtendedJoystickFields, "grip_theta_percent");
constexpr BitRange kGripXNeutral = fieldOf(j1939::kExtendedJoystickFields, "grip_x_neutral").bits;
constexpr BitRange kGripYNeutral = fieldOf(j1939::kExtendedJoystickFields, "grip_y_neutral").bits;
constexpr BitRange kGripThetaNeutral = fieldOf(j1939::kExtendedJoystickFields, "grip_theta_neutral").bits;
constexpr BitRange kXDetent = fieldOf(j1939::kBasicJoystickFields, "x_detent").bits;
constexpr BitRange kYDetent = fieldOf(j1939::kBasicJoystickFields, "y_detent").bits;
constexpr BitRange kGripXDetent = fieldOf(j1939::kExtendedJoystickFields, "grip_x_detent").bits;
constexpr BitRange kGripYDetent = fieldOf(j1939::kExtendedJoystickFields, "grip_y_detent").bits;
constexpr BitRange kGripThetaDetent = fieldOf(j1939::kExtendedJoystickFields, "grip_theta_detent").bits;

// A value and the two statuses that sign it.
struct SignedBits {
  BitRange value, plus, minus;
};
constexpr SignedBits signedBits(const Field& field) { return {field.bits, field.plus, field.minus}; }

template <SignedBits B>
PositionReading readingAt(const LoadedPayload& payload) {
  return readPosition(bitsAt<B.value>(payload), bitsAt<B.plus>(payload), bitsAt<B.minus>(payload));
}

template <SignedBits B, BitRange Neutral, BitRange Detent>
StickAxis axisAt(const LoadedPayload& payload) {
  const unsigned plus = bitsAt<B.plus>(payload), minus = bitsAt<B.minus>(payload);
  const auto tenths = readAxis(bitsAt<B.value>(payload), plus, minus);
  StickAxis axis{{},
                 static_cast<Status2>(plus),
                 static_cast<Status2>(minus),
                 statusAt<Neutral>(payload),
                 statusAt<Detent>(payload)};
  if (tenths) axis.tenths = static_cast<std::int16_t>(*tenths);
  return axis;
}

template <BitRange Low, BitRange High>
SoftLimits limitsAt(const LoadedPayload& payload) {
  return {static_cast<std::int16_t>(signExtend(payload.read<Low>(), Low.width)),
          static_cast<std::int16_t>(signExtend(payload.read<High>(), High.width)), false};
}

// A struct's flags beside their bits, so that reading and writing go over one list.
template <typename Struct>
struct FlagAt {
  bool Struct::*member;
  BitRange bits;
};
template <typename Struct>
struct FlagKey {
  bool Struct::*member;
  std::string_view key;
};
template <const auto& Fields, typename Struct, std::size_t N>
consteval std::array<FlagAt<Struct>, N> flagsIn(const FlagKey<Struct> (&keys)[N]) {
  std::array<FlagAt<Struct>, N> flags{};
  for (std::size_t i = 0; i < N; ++i) flags[i] = {keys[i].member, fieldOf(Fields, keys[i].key).bits};
  return flags;
}

constexpr auto kOutputFlags = flagsIn<akron::kDigitalOutputsFields, DigitalOutputs>({
    {&DigitalOutputs::panelLed, "panel_led"},
    {&DigitalOutputs::pointAimLed, "point_aim_led"},
    {&DigitalOutputs::outsideExclusionZone, "outside_exclusion_zone"},
    {&DigitalOutputs::remoteMode, "remote_mode"},
    {&DigitalOutputs::wirelessLed, "wireless_led"},
    {&DigitalOutputs::highFlow, "high_flow"},
    {&DigitalOutputs::dischargeValve, "discharge_valve"},
    {&DigitalOutputs::auxAgent, "aux_agent"},
    {&DigitalOutputs::soeMode, "soe_mode"},
    {&DigitalOutputs::pointAimMode, "point_aim_mode"},
    {&DigitalOutputs::stowed, "stowed"},
    {&DigitalOutputs::active, "active"},
    {&DigitalOutputs::enable, "enable"},
});
constexpr auto kMiniFlags = flagsIn<akron::kMiniDigitalOutputsFields, MiniOutputs>({
    {&MiniOutputs::riserRetracted, "riser_retracted"},
    {&MiniOutputs::riserExtended, "riser_extended"},
    {&MiniOutputs::deviceFaulted, "device_faulted"},
    {&MiniOutputs::deviceActive, "device_active"},
});
constexpr auto kInputFlags = flagsIn<akron::kDigitalInputsFields, DigitalInputs>({
    {&DigitalInputs::allowedInCollisionZone, "allowed_in_collision_zone"},
    {&DigitalInputs::deploy, "deploy"},
    {&DigitalInputs::stow, "stow"},
});
constexpr auto kPermissiveFlags = flagsIn<akron::kSoePermissiveFields, Permissive>({
    {&Permissive::axis1Plus, "axis1_plus"},
    {&Permissive::axis1Minus, "axis1_minus"},
    {&Permissive::axis2Plus, "axis2_plus"},
    {&Permissive::axis2Minus, "axis2_minus"},
});
constexpr BitRange kRiserCommand = fieldOf(akron::kDigitalOutputsFields, "riser_command").bits;

template <auto& Flags, typename Struct>
void readFlags(const LoadedPayload& payload, Struct& out) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    ((out.*Flags[I].member = bitsAt<Flags[I].bits>(payload) != 0), ...);
  }
  (std::make_index_sequence<std::size(Flags)>{});
}
template <typename Struct, std::size_t N>
Encoded encodeFlags(MessageId id, const Struct& value, const std::array<FlagAt<Struct>, N>& flags) {
  Encoded out = blank(id);
  for (const auto& flag : flags) put(out, flag.bits, std::uint64_t{value.*flag.member});
  return out;
}

}  // namespace

PositionLimitStatus PositionLimitStatus::of(const Frame& frame) {
  const LoadedPayload payload(frame.data);
  PositionLimitStatus s;
  s.rotation = readingAt<signedBits(kRotation)>(payload);
  s.elevation = readingAt<signedBits(kElevation)>(payload);
  readStatuses<kPlusStops>(payload, s.plusStop);
  readStatuses<kMinusStops>(payload, s.minusStop);
  s.operationalError = statusAt<position("operational_error")>(payload);
  s.calibrated = statusAt<position("calibrated")>(payload);
  return s;
}

Encoded PositionLimitStatus::encode() const {
  Encoded out = blank(MessageId::PositionLimitStatus);
  putReading(out, kRotation, rotation);
  putReading(out, kElevation, elevation);
  for (std::size_t i = 0; i < 5; ++i) {
    put(out, kPlusStops[i], plusStop[i]);
    put(out, kMinusStops[i], minusStop[i]);
  }
  put(out, position("operational_error"), operationalError);
  put(out, position("calibrated"), calibrated);
  return out;
}

SoftLimits SoftLimits::ofRotation(const Frame& frame) {
  const LoadedPayload payload(frame.data);
  SoftLimits limits = limitsAt<kLeft, kRight>(payload);
  limits.oscillating = bitsAt<kOscillating>(payload) != 0;
  return limits;
}

SoftLimits SoftLimits::ofElevation(const Frame& frame) {
  return limitsAt<kDown, kUp>(LoadedPayload(frame.data));
}

Encoded SoftLimits::encodeRotation() const {
  Encoded out = blank(MessageId::RotationSoftLimits);
  put(out, kLeft, static_cast<std::uint16_t>(low));
  put(out, kRight, static_cast<std::uint16_t>(high));
  put(out, kOscillating, std::uint64_t{oscillating});
  return out;
}

Encoded SoftLimits::encodeElevation() const {
  Encoded out = blank(MessageId::ElevationSoftLimits);
  put(out, kDown, static_cast<std::uint16_t>(low));
  put(out, kUp, static_cast<std::uint16_t>(high));
  return out;
}

DigitalOutputs DigitalOutputs::of(const Frame& frame) {
  const LoadedPayload payload(frame.data);
  DigitalOutputs outputs;
  readFlags<kOutputFlags>(payload, outputs);
  outputs.riserCommand = static_cast<std::uint8_t>(bitsAt<kRiserCommand>(payload));
  return outputs;
}

Encoded DigitalOutputs::encode() const {
  Encoded out = encodeFlags(MessageId::DigitalOutputs, *this, kOutputFlags);
  put(out, kRiserCommand, std::uint64_t{riserCommand});
  return out;
}

MiniOutputs MiniOutputs::of(const Frame& frame) {
  MiniOutputs result;
  readFlags<kMiniFlags>(LoadedPayload(frame.data), result);
  return result;
}
Encoded MiniOutputs::encode() const { return encodeFlags(MessageId::MiniDigitalOutputs, *this, kMiniFlags); }
DigitalInputs DigitalInputs::of(const Frame& frame) {
  DigitalInputs result;
  readFlags<kInputFlags>(LoadedPayload(frame.data), result);
  return result;
}
Encoded DigitalInputs::encode() const { return encodeFlags(MessageId::DigitalInputs, *this, kInputFlags); }
Permissive Permissive::of(const Frame& frame) {
  Permissive result;
  readFlags<kPermissiveFlags>(LoadedPayload(frame.data), result);
  return result;
}

StickAxis StickAxis::at(int tenths) {
  StickAxis axis;
  axis.tenths = static_cast<std::int16_t>(tenths);
  axis.plus = tenths > 0 ? Status2::On : Status2::Off;
  axis.minus = tenths < 0 ? Status2::On : Status2::Off;
  axis.neutral = tenths == 0 ? Status2::On : Status2::Off;
  return axis;
}

BasicJoystick BasicJoystick::of(const Frame& frame) {
  const LoadedPayload payload(frame.data);
  BasicJoystick joystick;
  joystick.x = axisAt<signedBits(kX), kXNeutral, kXDetent>(payload);
  joystick.y = axisAt<signedBits(kY), kYNeutral, kYDetent>(payload);
  readStatuses<kSwitches>(payload, joystick.switches);
  return joystick;
}

Encoded BasicJoystick::encode() const {
  Encoded out = blank(MessageId::BasicJoystick);
  putAxis(out, kX, kXNeutral, x);
  put(out, kXDetent, x.detent);
  putAxis(out, kY, kYNeutral, y);
  put(out, kYDetent, y.detent);
  for (std::size_t i = 0; i < kSwitches.size(); ++i) put(out, kSwitches[i], switches[i]);
  return out;
}

ExtendedJoystick ExtendedJoystick::of(const Frame& frame) {
  const LoadedPayload payload(frame.data);
  ExtendedJoystick joystick;
  joystick.gripX = axisAt<signedBits(kGripX), kGripXNeutral, kGripXDetent>(payload);
  joystick.gripY = axisAt<signedBits(kGripY), kGripYNeutral, kGripYDetent>(payload);
  joystick.gripTheta = axisAt<signedBits(kGripTheta), kGripThetaNeutral, kGripThetaDetent>(payload);
  readStatuses<kGripSwitches>(payload, joystick.switches);
  return joystick;
}

FaultStatus FaultStatus::of(const Frame& frame) {
  constexpr Field kPcodeError = fieldOf(akron::kFaultResponseFields, "pcode_error");
  constexpr BitRange kSdoMap = fieldOf(gateway::kSdoReadResponseFields, "faults").bits;
  FaultStatus status;
  if (frame.data[0] != messageOf(MessageId::FaultResponse).firstByte) {
    status.map = bitsOf(frame, kSdoMap);
    return status;
  }
  status.map = bitsOf(frame, fieldOf(akron::kFaultResponseFields, "faults").bits);
  if (kPcodeError.bits.bytesNeeded() <= frame.length) {
    status.pcodeError = static_cast<std::uint16_t>(bitsOf(frame, kPcodeError.bits));
  }
  return status;
}

std::uint8_t heartbeatState(const Frame& frame) {
  return static_cast<std::uint8_t>(bitsOf(frame, fieldOf(gateway::kHeartbeatFields, "state").bits));
}

FirmwareVersions FirmwareVersions::of(const Frame& frame) {
  return {shortAt(frame, fieldOf(akron::kFirmwareResponseFields, "fixed_boot")),
          shortAt(frame, fieldOf(akron::kFirmwareResponseFields, "bootloader")),
          shortAt(frame, fieldOf(akron::kFirmwareResponseFields, "system"))};
}

PcodeVersion PcodeVersion::of(const Frame& frame) {
  return {shortAt(frame, fieldOf(akron::kPcodeResponseFields, "style")),
          shortAt(frame, fieldOf(akron::kPcodeResponseFields, "subtype")),
          shortAt(frame, fieldOf(akron::kPcodeResponseFields, "version"))};
}

ConfigVersion ConfigVersion::of(const Frame& frame) {
  return {bitsOf(frame, fieldOf(akron::kConfigResponseFields, "config_type").bits),
          shortAt(frame, fieldOf(akron::kConfigResponseFields, "version"))};
}

std::optional<Pin> announcedPin(const Frame& frame) {
  return Pin::make(bitsOf(frame, akron::kPinType), bitsOf(frame, akron::kPinLetter5),
                   bitsOf(frame, akron::kPinLetter6), bitsOf(frame, akron::kPinSerial));
}

}  // namespace deckpipe
