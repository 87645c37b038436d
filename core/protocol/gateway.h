// SPDX-License-Identifier: GPL-3.0-or-later
// The 6051 CAN Gateway's CANopen side, 11-bit identifiers. Source: CAN Gateway Messaging manual (S1), CiA
// 301. TPDO1 and TPDO2 are akron.h's position_limit_status and digital_outputs: the same bits, the same
// entries.
#pragma once

#include <array>

#include "bus/canopen.h"
#include "protocol/akron.h"
#include "protocol/j1939.h"
#include "protocol/sdo.h"

namespace deckpipe::gateway {

inline constexpr std::array<ValueName, 5> kNmtCommands{{{0x01, "start"},
                                                        {0x02, "stop"},
                                                        {0x80, "enter pre-operational"},
                                                        {0x81, "reset node"},
                                                        {0x82, "reset communication"}}};
inline constexpr std::array<ValueName, 1> kNmtNodes{{{0, "all nodes"}}};
inline constexpr std::array kNmtCommandFields{
    named(kNmtCommands, number("command", "Command", big(1, 8, 8))),
    named(kNmtNodes, number("node", "Node (0 = all)", big(2, 8, 8))),
};

inline constexpr std::uint8_t kBooting = 0x00, kOperational = 0x05;
inline constexpr std::array<ValueName, 4> kHeartbeatStates{
    {{kBooting, "boot"}, {0x04, "stopped"}, {kOperational, "operational"}, {0x7F, "pre_operational"}}};
inline constexpr std::array kHeartbeatFields{
    Field{.key = "state",
          .name = "State",
          .kind = Kind::Word,
          .bits = big(1, 7, 7),
          .words = kHeartbeatStates,
          .otherwise = "unknown"},
    aside(flag("toggle", "Toggle bit (node guarding)", 1, 8)),
};

inline constexpr Field kIndex = number("index", "Object index", little(2, 16));
inline constexpr Field kSubindex = number("subindex", "Sub-index", little(4, 8));
inline constexpr Field kValue{.key = "value", .name = "Value", .kind = Kind::SdoValue, .bits = little(5, 32)};
inline constexpr Field kSize{
    .key = "size", .name = "Size in bytes", .kind = Kind::SdoSize, .bits = little(5, 32), .view = true};
// CiA 301 pads every SDO to eight bytes; the gateway's manual does not.
constexpr Field padding(unsigned fromByte) {
  return onlyIn(lengths(8), reserved(little(fromByte, (9 - fromByte) * 8)));
}

inline constexpr std::array kSdoHeadFields{kIndex, kSubindex, padding(5)};
inline constexpr std::array kSdoWriteRequestFields{kIndex, kSubindex, kValue, kSize};
inline constexpr std::array kSdoReadResponseFields{
    kIndex,
    kSubindex,
    kValue,
    kSize,
    // The map is four bytes; an answer of another size has none.
    forObject(sdo::kFaultStatus, orLeftOut(akron::faultNames(big(5, 8, 32)))),
    forObject(sdo::kFaultStatus, orLeftOut(akron::faultNumbers(big(5, 8, 32)))),
    forObject(sdo::kOperationalError, {.key = "error_code",
                                       .name = "Operational error code",
                                       .kind = Kind::SdoValue,
                                       .bits = little(5, 32),
                                       .names = akron::kPcodeErrors}),
};
inline constexpr std::array kSdoAbortFields{
    kIndex,
    kSubindex,
    number("abort_code", "Abort code", little(5, 32)),
    Field{.key = "abort_text",
          .name = "Abort reason",
          .kind = Kind::AbortText,
          .bits = little(5, 32),
          .words = sdo::kAbortCodes,
          .view = true},
};
inline constexpr std::array kSdoOtherFields{
    number("specifier", "Command specifier", big(1, 8, 8)),
    Field{.kind = Kind::Reserved, .bits = big(2, 8, 56)},
};

constexpr Message message(MessageId id, std::string_view key, std::string_view name, CobFunction function,
                          Lengths lengths, std::span<const Field> fields, std::string_view source) {
  return {.id = id,
          .key = key,
          .name = name,
          .family = Family::Canopen,
          .selector = static_cast<std::uint32_t>(function),
          .lengths = lengths,
          .fields = fields,
          .source = source};
}
// `specifier`: byte 1. `sizeBits`: its bits that tell how many bytes of value follow.
constexpr Message sdo(int specifier, std::uint8_t sizeBits, DeviceEnd device, Message message) {
  message.firstByte = specifier;
  message.sizeBits = sizeBits;
  message.device = device;
  return message;
}
// Two bits of the specifier count the bytes that carry no value: 2F one byte, 2B two, 27 three, 23 four.
inline constexpr std::uint8_t kSizeBits = 0x0C;

inline constexpr std::array kMessages{
    watched(message(MessageId::NmtCommand, "nmt_command", "NMT command", CobFunction::Nmt, lengths(2),
                    kNmtCommandFields, "Gateway manual, CiA DS 301 Network Management")),
    watched(
        onPage(PageGroups{PageGroup::Health, PageGroup::Node},
               every(1000ms, message(MessageId::Heartbeat, "heartbeat", "Heartbeat", CobFunction::Heartbeat,
                                     lengths(1), kHeartbeatFields, "Gateway manual, CiA DS 301 Heartbeat")))),
    sdo(0x40, 0, DeviceEnd::Receiver,
        message(MessageId::SdoReadRequest, "sdo_read_request", "SDO read request", CobFunction::SdoRequest,
                lengths(4, 8), kSdoHeadFields, "Gateway manual, SDOs; CiA 301")),
    watched(onPage(PageGroups{PageGroup::Node},
                   sdo(0x43, kSizeBits, DeviceEnd::Sender,
                       message(MessageId::SdoReadResponse, "sdo_read_response", "SDO read response",
                               CobFunction::SdoResponse, lengthsFrom(5, 8), kSdoReadResponseFields,
                               "Gateway manual, SDOs; CiA 301")))),
    sdo(0x2F, kSizeBits, DeviceEnd::Receiver,
        message(MessageId::SdoWriteRequest, "sdo_write_request", "SDO write request", CobFunction::SdoRequest,
                lengthsFrom(5, 8), kSdoWriteRequestFields, "Gateway manual, SDOs; CiA 301")),
    watched(sdo(
        0x60, 0, DeviceEnd::Sender,
        message(MessageId::SdoWriteResponse, "sdo_write_response", "SDO write response",
                CobFunction::SdoResponse, lengths(4, 8), kSdoHeadFields, "Gateway manual, SDOs; CiA 301"))),
    watched(sdo(0x80, 0, DeviceEnd::Either,
                message(MessageId::SdoAbort, "sdo_abort", "SDO abort", CobFunction::SdoResponse, lengths(8),
                        kSdoAbortFields, "CiA 301, SDO abort transfer"))),
    // Every other specifier.
    sdo(-1, 0, DeviceEnd::Either,
        message(MessageId::SdoOther, "sdo_other", "SDO, other transfer", CobFunction::SdoResponse,
                lengthsFrom(1, 8), kSdoOtherFields, "CiA 301, segmented and block transfers")),
    message(MessageId::GatewayJoystick, "gateway_joystick", "Joystick command to a monitor",
            CobFunction::Rpdo1, lengths(8), j1939::kBasicJoystickFields, "Gateway manual, Monitor RPDO1"),
};

}  // namespace deckpipe::gateway
