// SPDX-License-Identifier: GPL-3.0-or-later
// Akron Brass messages on PGN EF00, byte 1 = message type. Byte 2 on is described here.
// Source: CAN Messaging manual (S0); where it contradicts itself protocol.md section 4 settles it, and the
// settled readings are samples in samples.h.
#pragma once

#include <array>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "protocol/message.h"

namespace deckpipe::akron {

// Where an address announcement keeps the parts of the PIN: 7 + 7 + 12 + 30 bits, high byte first.
inline constexpr BitRange kPinLetter5 = big(2, 8, 7);
inline constexpr BitRange kPinLetter6 = big(2, 1, 7);
inline constexpr BitRange kPinType = big(3, 2, 12);
inline constexpr BitRange kPinSerial = big(5, 6, 30);

inline constexpr std::array kAddressAnnouncementFields{
    Field{.key = "pin", .name = "PIN", .kind = Kind::Pin, .bits = big(2, 8, 56)},
    viewOf(number("device_type", "Device type", kPinType)),
};

inline constexpr std::array kDiagnosticDataFields{
    number("record_type", "Record type", big(2, 8, 8)),
    Field{.key = "data", .name = "Data", .kind = Kind::Bytes, .bits = big(3, 8, 8)},
};

// Three fields a position: the angle, the two status2 that sign it, and what the combination means.
constexpr std::array<Field, 4> position(unsigned byte, std::string_view deg, std::string_view plusKey,
                                        std::string_view minusKey, std::string_view state,
                                        std::string_view degName, std::string_view plusName,
                                        std::string_view minusName, std::string_view stateName) {
  Field angle = scaled(deg, degName, Kind::Position, big(byte, 8, 12), 1, Unit::Degree);
  const Field plus = status2(plusKey, plusName, byte + 1, 4);
  const Field minus = status2(minusKey, minusName, byte + 1, 2);
  angle.plus = plus.bits;
  angle.minus = minus.bits;
  Field meaning = viewOf(angle);
  meaning.key = state;
  meaning.name = stateName;
  meaning.kind = Kind::PositionState;
  return {angle, plus, minus, meaning};
}

inline constexpr auto kPositionLimitStatusFields =
    joinFields(position(2, "rotation_deg", "rotation_plus", "rotation_minus", "rotation_state",  //
                        "Rotation", "Rotation right (+)", "Rotation left (-)", "Rotation sensor"),
               position(4, "elevation_deg", "elevation_plus", "elevation_minus", "elevation_state",  //
                        "Elevation", "Elevation up (+)", "Elevation down (-)", "Elevation sensor"),
               std::array{
                   status2("axis1_plus_stop", "Axis 1 (+) hard stop", 6, 8),
                   status2("axis1_minus_stop", "Axis 1 (-) hard stop", 6, 6),
                   status2("axis2_plus_stop", "Axis 2 (+) hard stop", 6, 4),
                   status2("axis2_minus_stop", "Axis 2 (-) hard stop", 6, 2),
                   status2("axis3_plus_stop", "Axis 3 (+) hard stop", 7, 8),
                   status2("axis3_minus_stop", "Axis 3 (-) hard stop", 7, 6),
                   status2("axis4_plus_stop", "Axis 4 (+) hard stop", 7, 4),
                   status2("axis4_minus_stop", "Axis 4 (-) hard stop", 7, 2),
                   status2("axis5_plus_stop", "Axis 5 (+) hard stop", 8, 8),
                   status2("axis5_minus_stop", "Axis 5 (-) hard stop", 8, 6),
                   status2("operational_error", "Operational error", 8, 4),
                   status2("calibrated", "Calibrated", 8, 2),
               });

inline constexpr std::array kRotationSoftLimitsFields{
    scaled("left_deg", "Left soft limit", Kind::Signed, big(2, 8, 16), 1, Unit::Degree),
    scaled("right_deg", "Right soft limit", Kind::Signed, big(4, 8, 16), 1, Unit::Degree),
    flag("oscillating", "Oscillating", 6, 8),
    reserved(big(6, 7, 7)),
};

inline constexpr std::array kElevationSoftLimitsFields{
    scaled("down_deg", "Down soft limit", Kind::Signed, big(2, 8, 16), 1, Unit::Degree),
    scaled("up_deg", "Up soft limit", Kind::Signed, big(4, 8, 16), 1, Unit::Degree),
    reserved(big(6, 8, 8)),
};

inline constexpr std::array kDigitalOutputsFields{
    flag("panel_led", "Panel LED", 3, 1),
    flag("point_aim_led", "Point-aim LED", 3, 2),
    flag("outside_exclusion_zone", "Outside the exclusion zone", 3, 3),
    flag("remote_mode", "Remote mode", 3, 4),
    flag("wireless_led", "Wireless hand-held LED", 3, 5),
    flag("high_flow", "High flow", 3, 6),
    flag("discharge_valve", "Discharge valve", 3, 7),
    flag("aux_agent", "Aux agent dispense", 3, 8),
    number("riser_command", "Electric riser command", big(2, 2, 2)),
    reserved(big(2, 3, 1)),
    flag("soe_mode", "SOE mode: permissive required", 2, 4),
    flag("point_aim_mode", "Point-aim mode", 2, 5),
    flag("stowed", "Stowed", 2, 6),
    flag("active", "Active (not stowed)", 2, 7),
    flag("enable", "Enable: motion allowed", 2, 8),
};

inline constexpr std::array kMiniDigitalOutputsFields{
    flag("riser_retracted", "Riser retracted", 3, 1),
    flag("riser_extended", "Riser extended", 3, 2),
    reserved(big(3, 8, 6)),
    reserved(big(2, 6, 6)),
    flag("device_faulted", "Device faulted", 2, 7),
    flag("device_active", "Device active", 2, 8),
};

inline constexpr std::array kDigitalInputsFields{
    flag("allowed_in_collision_zone", "Allowed in the collision zone", 2, 1),
    flag("deploy", "Deploy", 2, 2),
    flag("stow", "Stow", 2, 3),
    reserved(big(2, 8, 5)),
};

inline constexpr std::array kSoePermissiveFields{
    flag("axis1_plus", "May rotate right (+)", 3, 1),
    flag("axis1_minus", "May rotate left (-)", 3, 2),
    flag("axis2_plus", "May elevate up (+)", 3, 3),
    flag("axis2_minus", "May elevate down (-)", 3, 4),
    reserved(big(3, 8, 4)),
    reserved(big(2, 8, 8)),
};

// The 32-bit fault map, 0 = least significant bit of B5; the same in SDO 5001.01.
inline constexpr std::array<ValueName, 18> kFaultBits{{
    {0, "internal_eeprom"},
    {1, "motor_axis_1"},
    {2, "motor_axis_2"},
    {3, "motor_axis_3"},
    {4, "motor_axis_4"},
    {5, "motor_axis_5"},
    {6, "digital_output_1"},
    {7, "digital_output_2"},
    {8, "digital_output_3"},
    {13, "sci_input_overrun"},
    {14, "can_input_overrun"},
    {15, "xgate_processor"},
    {16, "pcode_syntax"},
    {21, "internal_fuse"},
    {23, "external_eeprom"},
    {29, "sci_output_overrun"},
    {30, "can_output_overrun"},
    {31, "s12_processor"},
}};
constexpr Field faultNames(BitRange bits) {
  return {.key = "faults", .name = "Faults", .kind = Kind::FaultNames, .bits = bits, .words = kFaultBits};
}
constexpr Field faultNumbers(BitRange bits) {
  return {.key = "reserved_bits",
          .name = "Fault bits without a name",
          .kind = Kind::FaultNumbers,
          .bits = bits,
          .words = kFaultBits,
          .view = true};
}

// The manuals name these numbers by example; there are many more.
inline constexpr std::array<ValueName, 1> kPcodeErrors{{{11, "rotation sensor error"}}};
inline constexpr std::array<ValueName, 1> kStyles{{{3356, "Trident"}}};
inline constexpr std::array<ValueName, 1> kSubtypes{{{14, "analog sensors"}}};
// By SDO 5000.01 and type 05. Both are of the 6032.
inline constexpr std::array<ValueName, 2> kParts{{
    {60320014, "Trident with Novotechnik sensors"},
    {60320022, "Firefox, style 3463, with Novotechnik sensors"},
}};

inline constexpr std::array kFaultResponseFields{
    faultNames(big(2, 8, 32)),
    faultNumbers(big(2, 8, 32)),
    named(kPcodeErrors, number("pcode_error", "pCode error code", big(6, 8, 16))),
};

inline constexpr std::array kFirmwareResponseFields{
    version("fixed_boot", "Fixed boot version", 2),
    version("bootloader", "Bootloader version", 4),
    version("system", "System version", 6),
};

inline constexpr std::array kPcodeResponseFields{
    named(kStyles, number("style", "Style number", big(2, 8, 16))),
    named(kSubtypes, number("subtype", "Subtype number", big(4, 8, 16))),
    version("version", "pCode version", 6),
};

inline constexpr std::array kConfigResponseFields{
    named(kParts, number("config_type", "Config type (part number)", big(2, 8, 32))),
    version("version", "Config version", 6),
};

inline constexpr std::array kVistaStatusFields{
    number("system_voltage_raw", "System voltage (raw)", big(2, 8, 10)),
    flag("k1_relay_reset", "K1 relay reset", 3, 6),
    flag("k1_relay_set", "K1 relay set", 3, 5),
    flag("digital_output_3", "Digital output 3", 3, 4),
    flag("digital_output_2", "Digital output 2", 3, 3),
    flag("digital_output_1", "Digital output 1", 3, 2),
    flag("digital_input_5l", "Digital input 5L", 3, 1),
    flag("digital_input_5h", "Digital input 5H", 4, 8),
    flag("digital_input_4l", "Digital input 4L", 4, 7),
    flag("digital_input_4h", "Digital input 4H", 4, 6),
    flag("digital_input_3l", "Digital input 3L", 4, 5),
    flag("digital_input_3h", "Digital input 3H", 4, 4),
    flag("digital_input_2l", "Digital input 2L", 4, 3),
    flag("digital_input_2h", "Digital input 2H", 4, 2),
    flag("digital_input_1", "Digital input 1", 4, 1),
    number("joystick_x_raw", "Joystick X (raw)", big(5, 8, 10)),
    reserved(big(6, 6, 4)),
    flag("joystick_sw10", "Joystick switch 10", 6, 2),
    flag("joystick_sw3", "Joystick switch 3", 6, 1),
    number("joystick_y_raw", "Joystick Y (raw)", big(7, 8, 10)),
    flag("joystick_sw2", "Joystick switch 2", 8, 6),
    flag("joystick_sw1", "Joystick switch 1", 8, 5),
    flag("joystick_y_forward", "Joystick Y forward", 8, 4),
    flag("joystick_y_back", "Joystick Y back", 8, 3),
    flag("joystick_x_left", "Joystick X left", 8, 2),
    flag("joystick_x_right", "Joystick X right", 8, 1),
};

inline constexpr std::array kVistaPositionFields{
    number("rotation_raw", "Rotation (raw, scale not given)", big(2, 8, 16)),
    number("elevation_raw", "Elevation (raw, scale not given)", big(4, 8, 16)),
};

inline constexpr std::array kPipeDataFields{
    Field{.key = "text", .name = "Characters", .kind = Kind::Bytes, .bits = big(2, 8, 8)},
};

// A status that its sender broadcasts.
constexpr Message status(MessageId id, std::string_view key, std::string_view name, int type, Lengths lengths,
                         std::span<const Field> fields, std::string_view source) {
  Message message =
      proprietary(Family::Akron, DeviceEnd::Sender, id, key, name, type, lengths, fields, source);
  message.broadcast = true;
  return message;
}
// One that it repeats, and that stands on its page.
constexpr Message periodic(Duration period, PageGroups page, Message status) {
  return watched(onPage(page, every(period, status)));
}
// Sent to the device.
constexpr Message toDevice(MessageId id, std::string_view key, std::string_view name, int type,
                           Lengths lengths, std::string_view source, std::span<const Field> fields = {}) {
  return proprietary(Family::Akron, DeviceEnd::Receiver, id, key, name, type, lengths, fields, source);
}
// The device's answer or acknowledgement.
constexpr Message fromDevice(MessageId id, std::string_view key, std::string_view name, int type,
                             Lengths lengths, std::string_view source, std::span<const Field> fields = {}) {
  return watched(proprietary(Family::Akron, DeviceEnd::Sender, id, key, name, type, lengths, fields, source));
}
constexpr Message pipe(MessageId id, std::string_view key, std::string_view name, Lengths lengths,
                       std::span<const Field> fields = {}) {
  Message message = proprietary(Family::Akron, DeviceEnd::Either, id, key, name, 0xFE, lengths, fields,
                                "CAN Messaging manual, message type FE");
  message.sharedType = true;
  message.part = Part::Pipe;
  return message;
}
// As the gateway sends it too.
constexpr Message inPdo(CobFunction function, Message message) {
  message.pdo = static_cast<std::uint32_t>(function);
  return message;
}

inline constexpr auto kMessages = [] {
  using enum MessageId;
  using Page = PageGroup;
  return std::array{
      ends(Request::Reset, onPage(PageGroups{Page::Address},
                                  status(AddressAnnouncement, "address_announcement", "Address announcement",
                                         0xFF, lengths(8), kAddressAnnouncementFields,
                                         "CAN Messaging manual, message type FF and Appendix A"))),
      watched(status(DiagnosticData, "diagnostic_data", "Diagnostic data", 0xFD, lengthsFrom(3, 8),
                     kDiagnosticDataFields, "CAN Messaging manual, message type FD")),
      periodic(100ms, PageGroups{Page::Health, Page::Dial, Page::Stops, Page::Status},
               inPdo(CobFunction::Tpdo1,
                     status(PositionLimitStatus, "position_limit_status", "Position / limit status", 0x01,
                            lengths(8), kPositionLimitStatusFields,
                            "CAN Messaging manual, message type 01; gateway manual, TPDO1"))),
      periodic(100ms, PageGroups{Page::Dial},
               status(RotationSoftLimits, "rotation_soft_limits", "Rotation soft limits", 0x81, lengths(6),
                      kRotationSoftLimitsFields, "CAN Messaging manual, message type 81")),
      periodic(100ms, PageGroups{Page::Dial},
               status(ElevationSoftLimits, "elevation_soft_limits", "Elevation soft limits", 0x82, lengths(6),
                      kElevationSoftLimitsFields, "CAN Messaging manual, message type 82")),
      periodic(
          100ms, PageGroups{Page::Health, Page::Dial, Page::Outputs},
          inPdo(CobFunction::Tpdo2, status(DigitalOutputs, "digital_outputs", "Digital outputs", 0x83,
                                           lengths(3), kDigitalOutputsFields,
                                           "CAN Messaging manual, message type 83; gateway manual, TPDO2"))),
      periodic(100ms, PageGroups{Page::Health, Page::Riser},
               status(MiniDigitalOutputs, "mini_digital_outputs", "Digital outputs (6033)", 0x84, lengths(3),
                      kMiniDigitalOutputsFields, "CAN Messaging manual, message type 84")),
      periodic(100ms, PageGroups{Page::Inputs},
               status(DigitalInputs, "digital_inputs", "Digital inputs (6039)", 0x85, lengths(2),
                      kDigitalInputsFields, "CAN Messaging manual, message type 85")),
      periodic(100ms, PageGroups{Page::Permissive},
               toDevice(SoePermissive, "soe_permissive", "SOE permissive", 0xA1, lengths(3),
                        "CAN Messaging manual, message type A1", kSoePermissiveFields)),
      requests(Request::Fault, toDevice(FaultPoll, "fault_poll", "Fault status poll", 0x02, lengths(1),
                                        "CAN Messaging manual, message type 02")),
      answers(Request::Fault,
              onPage(PageGroups{Page::Health, Page::Faults},
                     fromDevice(FaultResponse, "fault_response", "Fault status", 0x02, lengths(5, 7),
                                "CAN Messaging manual, message type 02", kFaultResponseFields))),
      requests(Request::Firmware, toDevice(FirmwarePoll, "firmware_poll", "Firmware version poll", 0x03,
                                           lengths(1), "CAN Messaging manual, message type 03")),
      answers(Request::Firmware,
              onPage(PageGroups{Page::Versions},
                     fromDevice(FirmwareResponse, "firmware_response", "Firmware version", 0x03, lengths(7),
                                "CAN Messaging manual, message type 03", kFirmwareResponseFields))),
      requests(Request::Pcode, toDevice(PcodePoll, "pcode_poll", "pCode version poll", 0x04, lengths(1),
                                        "CAN Messaging manual, message type 04")),
      answers(Request::Pcode,
              onPage(PageGroups{Page::Versions},
                     fromDevice(PcodeResponse, "pcode_response", "pCode version", 0x04, lengths(7),
                                "CAN Messaging manual, message type 04", kPcodeResponseFields))),
      requests(Request::Config, toDevice(ConfigPoll, "config_poll", "Config version poll", 0x05, lengths(1),
                                         "CAN Messaging manual, message type 05")),
      answers(Request::Config,
              onPage(PageGroups{Page::Versions},
                     fromDevice(ConfigResponse, "config_response", "Config version", 0x05, lengths(7),
                                "CAN Messaging manual, message type 05", kConfigResponseFields))),
      requests(Request::Vista, toDevice(VistaPoll, "vista_poll", "Vista poll", 0x21, lengths(1),
                                        "CAN Messaging manual, message type 21")),
      answers(Request::Vista, fromDevice(VistaStatus, "vista_status", "Vista status", 0x21, lengths(8),
                                         "CAN Messaging manual, message type 21", kVistaStatusFields)),
      answers(Request::Vista, fromDevice(VistaPosition, "vista_position", "Vista position", 0x22, lengths(5),
                                         "CAN Messaging manual, message type 22", kVistaPositionFields)),
      requests(Request::ZeroAxes, toDevice(ZeroAxesRequest, "zero_axes_request", "Zero axes request", 0x41,
                                           lengths(1), "CAN Messaging manual, message type 41")),
      acknowledges(Request::ZeroAxes, fromDevice(ZeroAxesAck, "zero_axes_ack", "Zero axes acknowledgement",
                                                 0x41, lengths(1), "CAN Messaging manual, message type 41")),
      watched(requests(Request::Reset, toDevice(ResetRequest, "reset_request", "Reset controller", 0x45,
                                                lengths(1), "CAN Messaging manual, message type 45"))),
      requests(Request::SetupMode, toDevice(SetupModeRequest, "setup_mode_request", "Setup mode request",
                                            0x46, lengths(1), "CAN Messaging manual, message type 46")),
      acknowledges(Request::SetupMode,
                   fromDevice(SetupModeAck, "setup_mode_ack", "Setup mode acknowledgement", 0x46, lengths(1),
                              "CAN Messaging manual, message type 46")),
      pipe(PipeData, "pipe_data", "Data pipe", lengthsFrom(2, 8), kPipeDataFields),
      pipe(PipeAck, "pipe_ack", "Data pipe acknowledgement", lengths(1)),
  };
}();

}  // namespace deckpipe::akron
