// SPDX-License-Identifier: GPL-3.0-or-later
// Copley drives in J1939 mode, PGN EF00 to and from the drive's node, byte 1 = command. Source: AN154 (S3);
// which bytes hold a 20 command's value and a 03 command's, and the byte order, are settled in protocol.md 4.
#pragma once

#include <array>

#include "protocol/message.h"

namespace deckpipe::copley {

inline constexpr std::uint8_t kResponseBit = 0x80;

// The note never states its byte order. Low byte first is presumed everywhere; change it here if a drive
// proves otherwise (parameter 121 must read 2).
constexpr BitRange word(unsigned byte, unsigned width) { return little(byte, width); }

inline constexpr std::array<ValueName, 2> kBanks{{{0, "ram"}, {1, "flash"}}};
inline constexpr std::array<ValueName, 14> kParameters{{
    {0x02, "programmed current"},
    {0x24, "desired state"},
    {0x2F, "programmed velocity"},
    {0xA0, "event status"},
    {0xC1, "network id and bit rate"},
    {0xC8, "trajectory configuration"},
    {0xCA, "position"},
    {0xCB, "velocity"},
    {0xCC, "acceleration"},
    {0xCD, "deceleration"},
    {0xCE, "jerk"},
    {0x10C, "heartbeat time"},
    {0x121, "network options"},
    {0x159, "watchdog action"},
}};
inline constexpr Field kParameter = named(kParameters, number("parameter", "Parameter", word(2, 10)));
inline constexpr std::array<Field, 4> kParameterWord{
    kParameter,
    reserved(little(3, 2, 3)),
    Field{.key = "bank", .name = "Bank", .kind = Kind::Word, .bits = little(3, 1, 5), .words = kBanks},
    reserved(little(3, 3, 6)),
};
constexpr Field tail(unsigned byte) {
  return orLeftOut({.key = "value", .name = "Value", .kind = Kind::Tail, .bits = word(byte, 8)});
}
constexpr Field tailSize(unsigned byte) {
  return viewOf(
      orLeftOut({.key = "size", .name = "Size in bytes", .kind = Kind::TailSize, .bits = word(byte, 8)}));
}
constexpr Field signed32(std::string_view key, std::string_view name, unsigned byte) {
  return scaled(key, name, Kind::Signed, word(byte, 32), 0, Unit::None);
}
constexpr Field real32(std::string_view key, std::string_view name, Unit unit) {
  return scaled(key, name, Kind::Float32, word(2, 32), 0, unit);
}
inline constexpr std::array<ValueName, 20> kErrors{{
    {0, "success"},
    {1, "too much data"},
    {3, "unknown command"},
    {4, "not enough data"},
    {5, "too much data"},
    {9, "unknown parameter"},
    {10, "out of range"},
    {11, "read only"},
    {14, "unknown axis state"},
    {15, "not on that page"},
    {18, "already moving"},
    {19, "velocity limit"},
    {20, "acceleration limit"},
    {21, "deceleration limit"},
    {22, "jerk limit"},
    {25, "trajectory mode"},
    {27, "CVM program running"},
    {32, "CAN failure"},
    {36, "bad axis"},
    {46, "encoder"},
}};
inline constexpr Field kErrorCode = named(kErrors, number("error_code", "Error code", big(2, 8, 8)));

inline constexpr auto kSetParameterFields = joinFields(kParameterWord, std::array{tail(4), tailSize(4)});
inline constexpr std::array kSetRegisterFields{
    number("register", "Register", big(2, 8, 8)),
    onlyIn(lengths(6), signed32("value", "Value", 3)),
    onlyIn(lengths(7), reserved(big(3, 8, 8))),  // as the note prints it: the value from byte 4
    onlyIn(lengths(7), signed32("value", "Value", 4)),
};
inline constexpr std::array kGetRegisterFields{number("register", "Register", big(2, 8, 8))};
inline constexpr std::array<ValueName, 3> kActions{{{0, "abort"}, {1, "start"}, {2, "home"}}};
inline constexpr std::array kTrajectoryFields{
    Field{.key = "action", .name = "Action", .kind = Kind::Word, .bits = big(2, 8, 8), .words = kActions},
    number("axis_mask", "Axis mask", big(3, 8, 8)),
};
inline constexpr std::array kStartMoveFields{signed32("position", "Position", 2)};
inline constexpr std::array kVelocityFields{
    scaled("velocity", "Velocity", Kind::Signed, word(2, 32), 1, Unit::CountsPerSecond)};
inline constexpr std::array kVelocityFloatFields{real32("value", "Velocity (unit not stated)", Unit::None)};
inline constexpr std::array kCurrentFields{
    scaled("current", "Current", Kind::Signed, word(2, 16), 2, Unit::Ampere),
    onlyIn(lengths(5), reserved(word(4, 16))),  // the note's table counts bytes 1-4, its text 1-2
};
inline constexpr std::array kCurrentFloatFields{real32("current", "Current", Unit::Ampere)};

inline constexpr std::array kResponseFields{kErrorCode};
inline constexpr std::array kGetParameterResponseFields{kErrorCode, tail(3), tailSize(3)};
inline constexpr std::array kGetRegisterResponseFields{kErrorCode, orLeftOut(signed32("value", "Value", 3)),
                                                       tailSize(3)};

constexpr Message command(MessageId id, std::string_view key, std::string_view name, int code,
                          Lengths lengths, std::span<const Field> fields, std::string_view source) {
  return proprietary(Family::Copley, DeviceEnd::Receiver, id, key, name, code, lengths, fields, source);
}
constexpr Message response(MessageId id, std::string_view key, std::string_view name, int code,
                           Lengths lengths, std::span<const Field> fields, std::string_view source) {
  return proprietary(Family::Copley, DeviceEnd::Sender, id, key, name, code | kResponseBit, lengths, fields,
                     source);
}

inline constexpr auto kMessages = [] {
  using enum MessageId;
  return std::array{
      command(CopleyNoOperation, "copley_no_operation", "Drive: no operation", 0x00, lengths(1), {},
              "AN154, command 0"),
      command(CopleySetParameter, "copley_set_parameter", "Drive: set parameter", 0x01, lengths(5, 7),
              kSetParameterFields, "AN154, command 1"),
      command(CopleyGetParameter, "copley_get_parameter", "Drive: get parameter", 0x02, lengths(3),
              kParameterWord, "AN154, command 2"),
      command(CopleySetRegister, "copley_set_register", "Drive: set register", 0x03, lengths(6, 7),
              kSetRegisterFields, "AN154, command 3"),
      command(CopleyGetRegister, "copley_get_register", "Drive: get register", 0x04, lengths(2),
              kGetRegisterFields, "AN154, command 4"),
      command(CopleyTrajectory, "copley_trajectory", "Drive: trajectory", 0x10, lengths(2, 3),
              kTrajectoryFields, "AN154, command 16"),
      command(CopleyStartMove, "copley_start_move", "Drive: start move", 0x11, lengths(5), kStartMoveFields,
              "AN154, command 17"),
      command(CopleyVelocity, "copley_velocity", "Drive: velocity", 0x12, lengths(5), kVelocityFields,
              "AN154, command 18"),
      command(CopleyVelocityFloat, "copley_velocity_float", "Drive: velocity (float)", 0x13, lengths(5),
              kVelocityFloatFields, "AN154, command 19"),
      command(CopleyCurrent, "copley_current", "Drive: current", 0x14, lengths(3, 5), kCurrentFields,
              "AN154, command 20"),
      command(CopleyCurrentFloat, "copley_current_float", "Drive: current (float)", 0x15, lengths(5),
              kCurrentFloatFields, "AN154, command 21"),
      response(CopleySetParameterResponse, "copley_set_parameter_response", "Drive answers: set parameter",
               0x01, lengths(2), kResponseFields, "AN154, command 1"),
      response(CopleyGetParameterResponse, "copley_get_parameter_response", "Drive answers: get parameter",
               0x02, lengths(2, 4, 6), kGetParameterResponseFields, "AN154, command 2"),
      response(CopleySetRegisterResponse, "copley_set_register_response", "Drive answers: set register", 0x03,
               lengths(2), kResponseFields, "AN154, command 3"),
      response(CopleyGetRegisterResponse, "copley_get_register_response", "Drive answers: get register", 0x04,
               lengths(2, 6), kGetRegisterResponseFields, "AN154, command 4"),
      response(CopleyTrajectoryResponse, "copley_trajectory_response", "Drive answers: trajectory", 0x10,
               lengths(2), kResponseFields, "AN154, command 16"),
      response(CopleyStartMoveResponse, "copley_start_move_response", "Drive answers: start move", 0x11,
               lengths(2), kResponseFields, "AN154, command 17"),
      response(CopleyVelocityResponse, "copley_velocity_response", "Drive answers: velocity", 0x12,
               lengths(2), kResponseFields, "AN154, command 18"),
      response(CopleyVelocityFloatResponse, "copley_velocity_float_response",
               "Drive answers: velocity (float)", 0x13, lengths(2), kResponseFields, "AN154, command 19"),
      response(CopleyCurrentResponse, "copley_current_response", "Drive answers: current", 0x14, lengths(2),
               kResponseFields, "AN154, command 20"),
      response(CopleyCurrentFloatResponse, "copley_current_float_response", "Drive answers: current (float)",
               0x15, lengths(2), kResponseFields, "AN154, command 21"),
  };
}();

}  // namespace deckpipe::copley
