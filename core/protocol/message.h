// SPDX-License-Identifier: GPL-3.0-or-later
// One message as data: its key, how it is told apart, how long it may be, its fields, and what it is for: the
// request it belongs to, its period, whether it is watched, where it stands on a page. All other rooms derive
// their lists of messages from these (lists.h).
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/enum_table.h"
#include "base/request.h"
#include "base/time.h"
#include "bus/j1939.h"
#include "protocol/field.h"
#include "protocol/page_group.h"

namespace deckpipe {

enum class Family : std::uint8_t { None, J1939, Akron, Copley, Canopen, Presumed, Ambiguous, Other };
template <>
inline constexpr Family kLastOf<Family> = Family::Other;

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

// Which end of a message the device is. Either: the message looks the same both ways.
enum class DeviceEnd : std::uint8_t { Sender, Receiver, Either };

// What a message is between a device and whoever asks it.
enum class Part : std::uint8_t {
  None,
  Asks,          // the request
  Answers,       // the answer, or one of the messages that make it up
  Acknowledges,  // the command was taken
  Ends,          // sent anyhow; the request ends when it comes
  Pipe,          // of the data pipe
};

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
  bool sharedType = false;    // other makers send this type too: nothing is presumed of it
  std::uint32_t pdo = 0;      // function code of the PDO in which the gateway sends the same bytes; 0 = none
  std::uint8_t sizeBits = 0;  // bits of byte 1 that only tell the size of an SDO's value
  Duration period{0};         // nominal; 0 = not periodic
  std::uint8_t priority = 6;  // J1939, for sending
  std::string_view source{};  // manual and section, for people
  Request request = Request::Count;  // the request that it is part of
  Part part = Part::None;
  bool isWatched = false;  // `deckpipectl watch` reports it; a periodic one when its bytes changed
  PageGroups page{};       // where a device's page shows it

  // Sent between one device and whoever asks it.
  constexpr bool isSaid() const {
    return part == Part::Asks || part == Part::Answers || part == Part::Acknowledges || part == Part::Pipe;
  }
  constexpr unsigned maxLength() const { return static_cast<unsigned>(std::bit_width(lengths)) - 1u; }
  // Bits before the fields that selecting the message already accounts for.
  constexpr unsigned selectedBits() const { return firstByte >= 0 ? 8 : 0; }
};

// A message on PGN EF00, which its first byte tells apart.
constexpr Message proprietary(Family family, DeviceEnd device, MessageId id, std::string_view key,
                              std::string_view name, int firstByte, Lengths lengths,
                              std::span<const Field> fields, std::string_view source) {
  return {.id = id,
          .key = key,
          .name = name,
          .family = family,
          .selector = pgn::kProprietaryA,
          .firstByte = firstByte,
          .lengths = lengths,
          .fields = fields,
          .device = device,
          .source = source};
}

// What a table line adds to the message that a family's builder made.
constexpr Message partOf(Request request, Part part, Message message) {
  message.request = request;
  message.part = part;
  return message;
}
constexpr Message requests(Request request, Message message) { return partOf(request, Part::Asks, message); }
constexpr Message answers(Request request, Message message) {
  return partOf(request, Part::Answers, message);
}
constexpr Message acknowledges(Request request, Message message) {
  return partOf(request, Part::Acknowledges, message);
}
constexpr Message ends(Request request, Message message) { return partOf(request, Part::Ends, message); }
constexpr Message every(Duration period, Message message) {
  message.period = period;
  return message;
}
constexpr Message watched(Message message) {
  message.isWatched = true;
  return message;
}
constexpr Message onPage(PageGroups page, Message message) {
  message.page = page;
  return message;
}

// The field of a message by its key, at compile time: how typed structs and tests name bits.
consteval Field fieldOf(std::span<const Field> fields, std::string_view key) {
  for (const Field& field : fields) {
    if (field.key == key) return field;
  }
  throw "no field of that key";
}

}  // namespace deckpipe
