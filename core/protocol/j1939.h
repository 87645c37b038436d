// SPDX-License-Identifier: GPL-3.0-or-later
// Standard J1939 messages that Akron devices use: request, NAME and the two joystick messages.
// Source: CAN Messaging manual (S0), 'Input Messages' and 'Status Messages - Poll / Response'; SAE J1939-81.
#pragma once

#include <array>

#include "bus/j1939.h"
#include "protocol/message.h"

namespace deckpipe::j1939 {

// A request is three bytes; some tools pad it to eight.
inline constexpr unsigned kRequestLength = 3;
inline constexpr std::array<ValueName, 1> kRequestedPgns{{{pgn::kAddressClaimed, "NAME"}}};
inline constexpr std::array kRequestFields{
    named(kRequestedPgns, number("pgn", "Requested PGN", little(1, 24))),
    reserved(little(4, 40)),
};

// Akron's manufacturer code, the only part of a NAME that identifies the maker (S0, Name Field).
inline constexpr unsigned kAkronManufacturer = 326;
inline constexpr std::array<ValueName, 1> kManufacturers{{{kAkronManufacturer, "Akron Brass"}}};
// All there are by SAE J1939-81.
inline constexpr std::array<ValueName, 6> kIndustryGroups{{
    {0, "global"},
    {1, "on-highway equipment"},
    {2, "agricultural and forestry equipment"},
    {3, "construction equipment"},
    {4, "marine"},
    {5, "industrial process control"},
}};

// One 64-bit number, low byte first.
inline constexpr std::array kNameFields{
    number("identity_number", "Identity number", {ByteOrder::Little, 0, 21}),
    named(kManufacturers, number("manufacturer_code", "Manufacturer code", {ByteOrder::Little, 21, 11})),
    number("ecu_instance", "ECU instance", {ByteOrder::Little, 32, 3}),
    number("function_instance", "Function instance", {ByteOrder::Little, 35, 5}),
    number("function", "Function", {ByteOrder::Little, 40, 8}),
    reserved({ByteOrder::Little, 48, 1}),
    number("vehicle_system", "Vehicle system", {ByteOrder::Little, 49, 7}),
    number("system_instance", "System instance", {ByteOrder::Little, 56, 4}),
    named(kIndustryGroups, number("industry_group", "Industry group", {ByteOrder::Little, 60, 3})),
    flag("arbitrary_address_capable", "Arbitrary address capable", 8, 8),
};

// An axis starts at `byte`: its 10 bits are the top of a little-endian 16-bit number, below them three
// status2.
struct AxisKeys {
  std::string_view percent, plus, minus, neutral;
  std::string_view percentName, plusName, minusName, neutralName;
};
constexpr std::array<Field, 4> axis(unsigned byte, const AxisKeys& k) {
  Field percent = scaled(k.percent, k.percentName, Kind::AxisPercent, little(byte, 10, 7), 1, Unit::Percent);
  const Field plus = status2(k.plus, k.plusName, byte, 6);
  const Field minus = status2(k.minus, k.minusName, byte, 4);
  percent.plus = plus.bits;
  percent.minus = minus.bits;
  return {percent, plus, minus, status2(k.neutral, k.neutralName, byte, 2)};
}

inline constexpr auto kBasicJoystickFields =
    joinFields(axis(1, {"x_percent", "x_right", "x_left", "x_neutral",  //
                        "Stick X", "X right", "X left", "X neutral"}),
               axis(3, {"y_percent", "y_forward", "y_back", "y_neutral",  //
                        "Stick Y", "Y forward", "Y back", "Y neutral"}),
               std::array{
                   status2("x_detent", "X detent", 5, 8),
                   status2("y_detent", "Y detent", 5, 6),
                   reserved(big(5, 4, 4)),
                   status2("switch_1", "Switch 1: stream", 6, 8),
                   status2("switch_2", "Switch 2: fog", 6, 6),
                   status2("switch_3", "Switch 3: discharge on", 6, 4),
                   status2("switch_4", "Switch 4: oscillate on | set", 6, 2),
                   status2("switch_5", "Switch 5: flow high", 7, 8),
                   status2("switch_6", "Switch 6: flow low", 7, 6),
                   status2("switch_7", "Switch 7: oscillate pause | resume", 7, 4),
                   status2("switch_8", "Switch 8: deploy", 7, 2),
                   status2("switch_9", "Switch 9: stow", 8, 8),
                   status2("switch_10", "Switch 10: discharge off", 8, 6),
                   status2("switch_11", "Switch 11: CAFS dry", 8, 4),
                   status2("switch_12", "Switch 12: CAFS wet", 8, 2),
               });

inline constexpr auto kExtendedJoystickFields = joinFields(
    axis(1, {"grip_x_percent", "grip_x_right", "grip_x_left", "grip_x_neutral",  //
             "Grip X", "Grip X right", "Grip X left", "Grip X neutral"}),
    axis(3, {"grip_y_percent", "grip_y_forward", "grip_y_back", "grip_y_neutral",  //
             "Grip Y", "Grip Y forward", "Grip Y back", "Grip Y neutral"}),
    axis(5, {"grip_theta_percent", "grip_theta_forward", "grip_theta_back", "grip_theta_neutral",  //
             "Grip theta", "Grip theta forward", "Grip theta back", "Grip theta neutral"}),
    std::array{
        status2("grip_x_detent", "Grip X detent", 7, 8),
        status2("grip_y_detent", "Grip Y detent", 7, 6),
        status2("grip_theta_detent", "Grip theta detent", 7, 4),
        reserved(big(7, 2, 2)),
        status2("switch_13", "Switch 13", 8, 8),
        status2("switch_14", "Switch 14", 8, 6),
        status2("switch_15", "Switch 15", 8, 4),
        status2("switch_16", "Switch 16", 8, 2),
    });

inline constexpr std::array kMessages{
    Message{.id = MessageId::Request,
            .key = "request",
            .name = "Request for a PGN",
            .family = Family::J1939,
            .selector = pgn::kRequest,
            .lengths = lengthsFrom(kRequestLength, 8),
            .fields = kRequestFields,
            .source = "CAN Messaging manual, PGN 59904 Field Request"},
    Message{.id = MessageId::Name,
            .key = "name",
            .name = "NAME, address claimed",
            .family = Family::J1939,
            .selector = pgn::kAddressClaimed,
            .lengths = lengths(8),
            .fields = kNameFields,
            .broadcast = true,
            .source = "CAN Messaging manual, PGN 60928 Name Field",
            .page = PageGroups{PageGroup::Address}},
    Message{
        .id = MessageId::BasicJoystick,
        .key = "basic_joystick",
        .name = "Basic joystick",
        .family = Family::J1939,
        .selector = pgn::kBasicJoystick,
        .lengths = lengths(8),
        .fields = kBasicJoystickFields,
        .broadcast = true,
        .period = 20ms,
        .priority = 3,
        .source = "CAN Messaging manual, PGN 64982 and Appendix B",
        .page = PageGroups{PageGroup::Dial, PageGroup::Switches, PageGroup::Detents, PageGroup::Joystick}},
    Message{.id = MessageId::ExtendedJoystick,
            .key = "extended_joystick",
            .name = "Extended joystick",
            .family = Family::J1939,
            .selector = pgn::kExtendedJoystick,
            .lengths = lengths(8),
            .fields = kExtendedJoystickFields,
            .broadcast = true,
            .period = 20ms,
            .priority = 3,
            .source = "CAN Messaging manual, PGN 64983 and Appendix B",
            .page = PageGroups{PageGroup::Grip, PageGroup::Joystick}},
};

}  // namespace deckpipe::j1939
