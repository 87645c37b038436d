// SPDX-License-Identifier: GPL-3.0-or-later
// One message as data: its key, how it is told apart, how long it may be, and its fields.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/time.h"
#include "protocol/field.h"

namespace deckpipe {

enum class Family : std::uint8_t { None, J1939, Akron, Copley, Canopen, Presumed, Ambiguous, Other };

// Every message of the catalogue, in its order; also the index of counters.
enum class MessageId : std::uint8_t {
  // clang-format off
  Request, Name, BasicJoystick, ExtendedJoystick,
  AddressAnnouncement, DiagnosticData, PositionLimitStatus, RotationSoftLimits, ElevationSoftLimits,
  DigitalOutputs, MiniDigitalOutputs, DigitalInputs, SoePermissive,
  FaultPoll, FaultResponse, FirmwarePoll, FirmwareResponse, PcodePoll, PcodeResponse, ConfigPoll, ConfigResponse,
  VistaPoll, VistaStatus, VistaPosition,
  ZeroAxesRequest, ZeroAxesAck, ResetRequest, SetupModeRequest, SetupModeAck, PipeData, PipeAck,
  NmtCommand, Heartbeat, SdoReadRequest, SdoReadResponse, SdoWriteRequest, SdoWriteResponse, SdoAbort, SdoOther,
  GatewayJoystick,
  CopleyNoOperation, CopleySetParameter, CopleyGetParameter, CopleySetRegister, CopleyGetRegister,
  CopleyTrajectory, CopleyStartMove, CopleyVelocity, CopleyVelocityFloat, CopleyCurrent, CopleyCurrentFloat,
  CopleySetParameterResponse, CopleyGetParameterResponse, CopleySetRegisterResponse, CopleyGetRegisterResponse,
  CopleyTrajectoryResponse, CopleyStartMoveResponse, CopleyVelocityResponse, CopleyVelocityFloatResponse,
  CopleyCurrentResponse, CopleyCurrentFloatResponse,
  Count,
  // clang-format on
};

// Which end of an EF00 message the Akron device is.
enum class DeviceEnd : std::uint8_t { Sender, Receiver };

// A set of data lengths: bit n stands for n bytes.
using Lengths = std::uint16_t;
template <typename... N>
constexpr Lengths lengths(N... n) {
  return static_cast<Lengths>(((1u << n) | ...));
}
constexpr Lengths lengthsFrom(unsigned first, unsigned last) {
  return static_cast<Lengths>((2u << last) - (1u << first));
}
constexpr bool allows(Lengths set, unsigned length) { return length <= 8 && (set >> length & 1u) != 0; }

struct Message {
  MessageId id = MessageId::Count;
  std::string_view key{};   // frozen contract
  std::string_view name{};  // for people, translatable
  Family family = Family::None;
  // What tells it apart: the PGN (29-bit) or the function code (11-bit), and where they have one, byte 1:
  // Akron's message type, Copley's command, CANopen's first byte.
  std::uint32_t selector = 0;
  int firstByte = -1;
  Lengths lengths = 0;
  std::span<const Field> fields{};
  bool broadcast = false;  // EF00: sent to the global address
  DeviceEnd device = DeviceEnd::Sender;
  Duration period{0};         // nominal; 0 = not periodic
  std::uint8_t priority = 6;  // J1939, for sending
  std::string_view source{};  // manual and section, for people

  constexpr unsigned maxLength() const { return static_cast<unsigned>(std::bit_width(lengths)) - 1u; }
  // Bits before the fields that selecting the message already accounts for.
  constexpr unsigned selectedBits() const { return firstByte >= 0 ? 8 : 0; }
};

// The field of a message by its key, at compile time: how typed structs and tests name bits.
consteval Field fieldOf(std::span<const Field> fields, std::string_view key) {
  for (const Field& field : fields) {
    if (field.key == key) return field;
  }
  throw "no field of that key";
}

}  // namespace deckpipe
