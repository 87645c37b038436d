// SPDX-License-Identifier: GPL-3.0-or-later
// Literal samples of the catalogue's messages: raw bytes and what they say, the manuals' own examples and the
// settled contradictions (protocol.md section 4) first. One test runs them all, both ways; reference
// documents print them. Every message has at least one.
#pragma once

#include <cstdint>
#include <string_view>

#include "protocol/message.h"

namespace deckpipe {

struct Sample {
  std::string_view name;  // which example
  std::string_view id;    // 8 hex digits: 29-bit, 3: 11-bit
  std::string_view data;  // hex
  MessageId message;
  std::string_view fields;  // "key=value; key=value", every field in order; ~ is null
};

inline constexpr Sample kSamples[] = {
    // The manuals' own examples.
    {"manual_basic_joystick", "0CFDD633", "107D046400100000", MessageId::BasicJoystick,
     "x_percent=50; x_right=on; x_left=off; x_neutral=off; y_percent=-40; y_forward=off; y_back=on; "
     "y_neutral=off; x_detent=off; y_detent=off; switch_1=off; switch_2=on; switch_3=off; switch_4=off; "
     "switch_5=off; switch_6=off; switch_7=off; switch_8=off; switch_9=off; switch_10=off; "
     "switch_11=off; switch_12=off"},
    {"manual_extended_joystick", "0CFDD733", "107D0464FFFF0004", MessageId::ExtendedJoystick,
     "grip_x_percent=50; grip_x_right=on; grip_x_left=off; grip_x_neutral=off; grip_y_percent=-40; "
     "grip_y_forward=off; grip_y_back=on; grip_y_neutral=off; grip_theta_percent=~; "
     "grip_theta_forward=na; grip_theta_back=na; grip_theta_neutral=na; grip_x_detent=off; "
     "grip_y_detent=off; grip_theta_detent=off; switch_13=off; switch_14=off; switch_15=on; switch_16=off"},
    {"manual_announcement_by_its_bits", "18EFFF80", "FF83150226021A0B", MessageId::AddressAnnouncement,
     "pin=1032AE637671947; device_type=1032"},
    {"manual_announcement_by_its_text", "18EFFF80", "FF83150206021A0B", MessageId::AddressAnnouncement,
     "pin=1032AE100801035; device_type=1032"},
    {"manual_diagnostic_data", "18EFFF80", "FD01000000", MessageId::DiagnosticData,
     "record_type=1; data=00 00 00"},
    {"manual_position", "18EFFF80", "011D940371000041", MessageId::PositionLimitStatus,
     "rotation_deg=47.3; rotation_plus=on; rotation_minus=off; rotation_state=ok; elevation_deg=-5.5; "
     "elevation_plus=off; elevation_minus=on; elevation_state=ok; axis1_plus_stop=off; "
     "axis1_minus_stop=off; axis2_plus_stop=off; axis2_minus_stop=off; axis3_plus_stop=off; "
     "axis3_minus_stop=off; axis4_plus_stop=off; axis4_minus_stop=off; axis5_plus_stop=on; "
     "axis5_minus_stop=off; operational_error=off; calibrated=on"},
    {"manual_rotation_limits", "18EFFF80", "81FED401C280", MessageId::RotationSoftLimits,
     "left_deg=-30; right_deg=45; oscillating=on"},
    {"manual_elevation_limits", "18EFFF80", "82FF38038400", MessageId::ElevationSoftLimits,
     "down_deg=-20; up_deg=90"},
    {"manual_outputs", "18EFFF80", "83C051", MessageId::DigitalOutputs,
     "panel_led=on; point_aim_led=off; outside_exclusion_zone=off; remote_mode=off; wireless_led=on; "
     "high_flow=off; discharge_valve=on; aux_agent=off; riser_command=0; soe_mode=off; "
     "point_aim_mode=off; stowed=off; active=on; enable=on"},
    {"manual_mini_outputs", "18EFFF81", "848002", MessageId::MiniDigitalOutputs,
     "riser_retracted=off; riser_extended=on; device_faulted=off; device_active=on"},
    {"manual_inputs_header_holds", "18EFFFF0", "8501", MessageId::DigitalInputs,
     "allowed_in_collision_zone=on; deploy=off; stow=off"},
    {"manual_permissive_three_bytes", "18EF8005", "A10009", MessageId::SoePermissive,
     "axis1_plus=on; axis1_minus=off; axis2_plus=off; axis2_minus=on"},
    {"manual_request", "18EAFFFF", "00EE00", MessageId::Request, "pgn=60928"},
    {"request_padded_to_eight_bytes", "18EAFFFF", "00EE000000000000", MessageId::Request, "pgn=60928"},
    {"manual_name", "18EEFF80", "0B1AC22800420090", MessageId::Name,
     "identity_number=137739; manufacturer_code=326; ecu_instance=0; function_instance=0; function=66; "
     "vehicle_system=0; system_instance=0; industry_group=1; arbitrary_address_capable=on"},
    {"manual_fault_poll", "18EF8005", "02", MessageId::FaultPoll, ""},
    {"manual_fault_response_seven_bytes", "18EF0580", "0200000000000B", MessageId::FaultResponse,
     "faults=; reserved_bits=; pcode_error=11"},
    {"manual_firmware_poll", "18EF8005", "03", MessageId::FirmwarePoll, ""},
    {"manual_firmware_response", "18EF0580", "03010B02040206", MessageId::FirmwareResponse,
     "fixed_boot=1.11; bootloader=2.4; system=2.6"},
    {"manual_pcode_poll", "18EF8005", "04", MessageId::PcodePoll, ""},
    {"manual_pcode_response", "18EF0580", "040D1C000E0204", MessageId::PcodeResponse,
     "style=3356; subtype=14; version=2.4"},
    {"manual_config_poll", "18EF8005", "05", MessageId::ConfigPoll, ""},
    {"manual_config_response", "18EF0580", "050398690E0204", MessageId::ConfigResponse,
     "config_type=60320014; version=2.4"},
    {"manual_vista_poll", "18EF8005", "21", MessageId::VistaPoll, ""},
    {"manual_zero_request", "18EF8005", "41", MessageId::ZeroAxesRequest, ""},
    {"manual_zero_ack", "18EF0580", "41", MessageId::ZeroAxesAck, ""},
    {"manual_reset", "18EF8005", "45", MessageId::ResetRequest, ""},
    {"manual_setup_request", "18EF8005", "46", MessageId::SetupModeRequest, ""},
    {"manual_setup_ack", "18EF0580", "46", MessageId::SetupModeAck, ""},
    {"manual_pipe_data", "18EF80F2", "FE413F0D0A", MessageId::PipeData, "text=41 3F 0D 0A"},
    {"manual_pipe_ack", "18EFF280", "FE", MessageId::PipeAck, ""},
    {"gateway_manual_nmt", "000", "0100", MessageId::NmtCommand, "command=1; node=0"},
    {"gateway_manual_heartbeat", "724", "05", MessageId::Heartbeat, "state=operational; toggle=off"},
    {"gateway_manual_read_request", "624", "40005001", MessageId::SdoReadRequest, "index=20480; subindex=1"},
    {"gateway_manual_part_number", "5A4", "4300500116699803", MessageId::SdoReadResponse,
     "index=20480; subindex=1; value=60320022; size=4"},
    {"gateway_manual_fuse_in_opposite_order", "5A4", "4301500100200000", MessageId::SdoReadResponse,
     "index=20481; subindex=1; value=8192; size=4; faults=internal_fuse; reserved_bits="},
    {"gateway_manual_error_code_six_bytes", "5A4", "4B0150020B00", MessageId::SdoReadResponse,
     "index=20481; subindex=2; value=11; size=2; error_code=11"},
    {"gateway_manual_write_request", "624", "2F02500141", MessageId::SdoWriteRequest,
     "index=20482; subindex=1; value=65; size=1"},
    {"gateway_manual_write_response", "5A4", "60025001", MessageId::SdoWriteResponse,
     "index=20482; subindex=1"},
    {"gateway_manual_joystick", "224", "107D046400100000", MessageId::GatewayJoystick,
     "x_percent=50; x_right=on; x_left=off; x_neutral=off; y_percent=-40; y_forward=off; y_back=on; "
     "y_neutral=off; x_detent=off; y_detent=off; switch_1=off; switch_2=on; switch_3=off; switch_4=off; "
     "switch_5=off; switch_6=off; switch_7=off; switch_8=off; switch_9=off; switch_10=off; "
     "switch_11=off; switch_12=off"},
    {"gateway_manual_tpdo1", "1A4", "011D940371000001", MessageId::PositionLimitStatus,
     "rotation_deg=47.3; rotation_plus=on; rotation_minus=off; rotation_state=ok; elevation_deg=-5.5; "
     "elevation_plus=off; elevation_minus=on; elevation_state=ok; axis1_plus_stop=off; "
     "axis1_minus_stop=off; axis2_plus_stop=off; axis2_minus_stop=off; axis3_plus_stop=off; "
     "axis3_minus_stop=off; axis4_plus_stop=off; axis4_minus_stop=off; axis5_plus_stop=off; "
     "axis5_minus_stop=off; operational_error=off; calibrated=on"},
    {"gateway_manual_tpdo2_as_drawn", "2A4", "83C001", MessageId::DigitalOutputs,
     "panel_led=on; point_aim_led=off; outside_exclusion_zone=off; remote_mode=off; wireless_led=off; "
     "high_flow=off; discharge_valve=off; aux_agent=off; riser_command=0; soe_mode=off; "
     "point_aim_mode=off; stowed=off; active=on; enable=on"},

    // Readings that the manuals' examples do not reach.
    {"operational_error_bits", "18EFFF80", "01FFFFFFF4800004", MessageId::PositionLimitStatus,
     "rotation_deg=~; rotation_plus=na; rotation_minus=na; rotation_state=not_fitted; elevation_deg=~; "
     "elevation_plus=on; elevation_minus=off; elevation_state=sensor_error; axis1_plus_stop=error; "
     "axis1_minus_stop=off; axis2_plus_stop=off; axis2_minus_stop=off; axis3_plus_stop=off; "
     "axis3_minus_stop=off; axis4_plus_stop=off; axis4_minus_stop=off; axis5_plus_stop=off; "
     "axis5_minus_stop=off; operational_error=on; calibrated=off"},
    {"every_output_bit", "18EFFF80", "837B82", MessageId::DigitalOutputs,
     "panel_led=off; point_aim_led=on; outside_exclusion_zone=off; remote_mode=off; wireless_led=off; "
     "high_flow=off; discharge_valve=off; aux_agent=on; riser_command=3; soe_mode=on; point_aim_mode=on; "
     "stowed=on; active=on; enable=off"},
    {"mini_faulted", "18EFFF81", "844001", MessageId::MiniDigitalOutputs,
     "riser_retracted=on; riser_extended=off; device_faulted=on; device_active=off"},
    {"five_byte_faults_of_older_firmware", "18EF0580", "0280201003", MessageId::FaultResponse,
     "faults=internal_eeprom, motor_axis_1, internal_fuse, s12_processor; reserved_bits=12; pcode_error=~"},
    {"vista_bits", "18EF0580", "21802AAA7D021925", MessageId::VistaStatus,
     "system_voltage_raw=512; k1_relay_reset=on; k1_relay_set=off; digital_output_3=on; "
     "digital_output_2=off; digital_output_1=on; digital_input_5l=off; digital_input_5h=on; "
     "digital_input_4l=off; digital_input_4h=on; digital_input_3l=off; digital_input_3h=on; "
     "digital_input_2l=off; digital_input_2h=on; digital_input_1=off; joystick_x_raw=500; "
     "joystick_sw10=on; joystick_sw3=off; joystick_y_raw=100; joystick_sw2=on; joystick_sw1=off; "
     "joystick_y_forward=off; joystick_y_back=on; joystick_x_left=off; joystick_x_right=on"},
    {"vista_position", "18EF0580", "2212348000", MessageId::VistaPosition,
     "rotation_raw=4660; elevation_raw=32768"},
    {"node_guarding_toggle", "724", "FF", MessageId::Heartbeat, "state=pre_operational; toggle=on"},
    {"read_request_padded", "624", "4001500200000000", MessageId::SdoReadRequest, "index=20481; subindex=2"},
    {"error_code_eight_bytes", "5A4", "4B0150020B000000", MessageId::SdoReadResponse,
     "index=20481; subindex=2; value=11; size=2; error_code=11"},
    {"abort_of_a_missing_object", "5A4", "8001500200000206", MessageId::SdoAbort,
     "index=20481; subindex=2; abort_code=100794368; "
     "abort_text=Object does not exist in the object dictionary"},
    {"abort_without_a_known_text", "5A4", "8001500278563412", MessageId::SdoAbort,
     "index=20481; subindex=2; abort_code=305419896; abort_text=~"},
    {"upload_segment_request", "624", "6000000000000000", MessageId::SdoOther, "specifier=96"},
    {"drive_no_operation", "18EF2105", "00", MessageId::CopleyNoOperation, ""},
    {"drive_set_16_bit_in_flash", "18EF2105", "0124101500", MessageId::CopleySetParameter,
     "parameter=36; bank=flash; value=21; size=2"},
    {"drive_set_32_bit_in_ram", "18EF2105", "012F0110270000", MessageId::CopleySetParameter,
     "parameter=303; bank=ram; value=10000; size=4"},
    {"drive_get_network_options", "18EF2105", "022101", MessageId::CopleyGetParameter,
     "parameter=289; bank=ram"},
    {"drive_set_register_packed", "18EF2105", "0305FFFFFFFF", MessageId::CopleySetRegister,
     "register=5; value=-1"},
    {"drive_set_register_as_printed", "18EF2105", "030500FEFFFFFF", MessageId::CopleySetRegister,
     "register=5; value=-2"},
    {"drive_get_register", "18EF2105", "041F", MessageId::CopleyGetRegister, "register=31"},
    {"drive_abort", "18EF2105", "1000", MessageId::CopleyTrajectory, "action=abort; axis_mask=~"},
    {"drive_unknown_action", "18EF2105", "100703", MessageId::CopleyTrajectory, "action=7; axis_mask=3"},
    {"drive_move", "18EF2105", "1160F0FFFF", MessageId::CopleyStartMove, "position=-4000"},
    {"drive_velocity", "18EF2105", "12F1D8FFFF", MessageId::CopleyVelocity, "velocity=-999.9"},
    {"drive_velocity_float", "18EF2105", "130000C0BF", MessageId::CopleyVelocityFloat, "value=-1.5"},
    {"drive_current_two_bytes", "18EF2105", "149CFF", MessageId::CopleyCurrent, "current=-1"},
    {"drive_current_four_bytes", "18EF2105", "147D000000", MessageId::CopleyCurrent, "current=1.25"},
    {"drive_current_float", "18EF2105", "1500000040", MessageId::CopleyCurrentFloat, "current=2"},
    {"drive_answers_set_parameter", "18EF0521", "8100", MessageId::CopleySetParameterResponse,
     "error_code=0"},
    {"drive_answers_options", "18EF0521", "82000200", MessageId::CopleyGetParameterResponse,
     "error_code=0; value=2; size=2"},
    {"drive_answers_error", "18EF0521", "8209", MessageId::CopleyGetParameterResponse, "error_code=9"},
    {"drive_answers_set_register", "18EF0521", "8300", MessageId::CopleySetRegisterResponse, "error_code=0"},
    {"drive_answers_register", "18EF0521", "8400FEFFFFFF", MessageId::CopleyGetRegisterResponse,
     "error_code=0; value=-2; size=4"},
    {"drive_answers_trajectory", "18EF0521", "9012", MessageId::CopleyTrajectoryResponse, "error_code=18"},
    {"drive_answers_move", "18EF0521", "9100", MessageId::CopleyStartMoveResponse, "error_code=0"},
    {"drive_answers_velocity", "18EF0521", "9200", MessageId::CopleyVelocityResponse, "error_code=0"},
    {"drive_answers_velocity_float", "18EF0521", "9300", MessageId::CopleyVelocityFloatResponse,
     "error_code=0"},
    {"drive_answers_current", "18EF0521", "9400", MessageId::CopleyCurrentResponse, "error_code=0"},
    {"drive_answers_current_float", "18EF0521", "9500", MessageId::CopleyCurrentFloatResponse,
     "error_code=0"},
};

}  // namespace deckpipe
