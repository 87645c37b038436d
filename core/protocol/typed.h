// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of the hot path as plain structs: State and the simulator use these. They name their bits through
// the catalogue (fieldOf), so there is still only one place that says where a bit is.
// Each `of` expects a frame that classified as the struct's message.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/ids.h"
#include "base/part_state.h"
#include "bus/frame.h"
#include "protocol/decode.h"
#include "protocol/encode.h"
#include "protocol/name.h"

namespace deckpipe {

// Types 01 and TPDO1. Angles in 0.1 degree, right and up positive.
struct PositionLimitStatus {
  PositionReading rotation, elevation;
  std::array<Status2, 5> plusStop{}, minusStop{};  // hard stops of axes 1..5
  Status2 operationalError = Status2::Off;
  Status2 calibrated = Status2::Off;

  static PositionLimitStatus of(const Frame& frame);
  Encoded encode() const;
  friend bool operator==(const PositionLimitStatus&, const PositionLimitStatus&) = default;
};

// Types 81 (left, right) and 82 (down, up), 0.1 degree.
struct SoftLimits {
  std::int16_t low = 0, high = 0;
  bool oscillating = false;  // rotation only: the limits are then the oscillation's

  static SoftLimits ofRotation(const Frame& frame);
  static SoftLimits ofElevation(const Frame& frame);
  Encoded encodeRotation() const;
  Encoded encodeElevation() const;
  friend bool operator==(const SoftLimits&, const SoftLimits&) = default;
};

// Type 83 and TPDO2.
struct DigitalOutputs {
  bool panelLed = false, pointAimLed = false, outsideExclusionZone = false, remoteMode = false,
       wirelessLed = false, highFlow = false, dischargeValve = false, auxAgent = false;
  std::uint8_t riserCommand = 0;  // 0..3, no meaning given
  bool soeMode = false, pointAimMode = false, stowed = false, active = false, enable = false;

  static DigitalOutputs of(const Frame& frame);
  Encoded encode() const;
  friend bool operator==(const DigitalOutputs&, const DigitalOutputs&) = default;
};

// Type 84, 6033.
struct MiniOutputs {
  bool riserRetracted = false, riserExtended = false, deviceFaulted = false, deviceActive = false;

  static MiniOutputs of(const Frame& frame);
  Encoded encode() const;
  friend bool operator==(const MiniOutputs&, const MiniOutputs&) = default;
};

// Type 85, 6039.
struct DigitalInputs {
  bool allowedInCollisionZone = false, deploy = false, stow = false;

  static DigitalInputs of(const Frame& frame);
  Encoded encode() const;
  friend bool operator==(const DigitalInputs&, const DigitalInputs&) = default;
};

// Type A1.
struct Permissive {
  bool axis1Plus = false, axis1Minus = false, axis2Plus = false, axis2Minus = false;

  static Permissive of(const Frame& frame);
  friend bool operator==(const Permissive&, const Permissive&) = default;
};

// One deflection of a joystick message.
struct StickAxis {
  std::optional<std::int16_t> tenths;  // 0.1 %, right and forward positive; nothing where not valid
  Status2 plus = Status2::Off, minus = Status2::Off, neutral = Status2::Off, detent = Status2::Off;

  static StickAxis at(int tenths);  // deflected so far, statuses set to match
  friend bool operator==(const StickAxis&, const StickAxis&) = default;
};

// PGN 64982 and RPDO1.
struct BasicJoystick {
  StickAxis x, y;
  std::array<Status2, 12> switches{};  // [0] is switch 1

  static BasicJoystick of(const Frame& frame);
  Encoded encode() const;
  friend bool operator==(const BasicJoystick&, const BasicJoystick&) = default;
};

// PGN 64983.
struct ExtendedJoystick {
  StickAxis gripX, gripY, gripTheta;
  std::array<Status2, 4> switches{};  // [0] is switch 13

  static ExtendedJoystick of(const Frame& frame);
  friend bool operator==(const ExtendedJoystick&, const ExtendedJoystick&) = default;
};

// Type 02, or the answer to SDO 5001.01: the same map.
struct FaultStatus {
  std::uint32_t map = 0;                    // bits as in akron::kFaultBits
  std::optional<std::uint16_t> pcodeError;  // nothing in an SDO and in the 5-byte answer of older firmware

  static FaultStatus of(const Frame& frame);
  friend bool operator==(const FaultStatus&, const FaultStatus&) = default;
};

// Types 03, 04 and 05; versions as major << 8 | minor.
struct FirmwareVersions {
  std::uint16_t fixedBoot = 0, bootloader = 0, system = 0;
  static FirmwareVersions of(const Frame& frame);
  friend bool operator==(const FirmwareVersions&, const FirmwareVersions&) = default;
};
struct PcodeVersion {
  std::uint16_t style = 0, subtype = 0, version = 0;
  static PcodeVersion of(const Frame& frame);
  friend bool operator==(const PcodeVersion&, const PcodeVersion&) = default;
};
struct ConfigVersion {
  std::uint32_t type = 0;  // part number
  std::uint16_t version = 0;
  static ConfigVersion of(const Frame& frame);
  friend bool operator==(const ConfigVersion&, const ConfigVersion&) = default;
};

// Low seven bits of a heartbeat: gateway::kOperational, …
std::uint8_t heartbeatState(const Frame& frame);

// Type FF: nothing where the bits are no PIN.
std::optional<Pin> announcedPin(const Frame& frame);

}  // namespace deckpipe
