// SPDX-License-Identifier: GPL-3.0-or-later
// What SAE J1939 calls parameter groups and source addresses that Deckpipe does not decode: engines, brakes and dashboards
// share the bus with the monitors. Only names of wide public use, compared in two public lists (the ISOBUS parameter
// database's group names, Wireshark's table of J1939 addresses). An address is a preference: a device may use another,
// and anything may use it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "base/ids.h"

namespace deckpipe::j1939 {

struct StandardGroup {
  std::uint32_t first = 0, last = 0;  // PGNs
  std::string_view acronym;           // empty: it has none
  std::string_view name;
};

// In order, without overlap.
inline constexpr std::array kStandardGroups{
    StandardGroup{0x0000, 0x0000, "TSC1", "Torque / speed control 1"},
    StandardGroup{0xE800, 0xE800, "ACKM", "Acknowledgement"},
    StandardGroup{0xEB00, 0xEB00, "TP.DT", "Transport, data"},
    StandardGroup{0xEC00, 0xEC00, "TP.CM", "Transport, connection management"},
    StandardGroup{0xEF00, 0xEF00, "", "Proprietary A"},
    StandardGroup{0xF000, 0xF000, "ERC1", "Electronic retarder controller 1"},
    StandardGroup{0xF001, 0xF001, "EBC1", "Electronic brake controller 1"},
    StandardGroup{0xF002, 0xF002, "ETC1", "Electronic transmission controller 1"},
    StandardGroup{0xF003, 0xF003, "EEC2", "Electronic engine controller 2"},
    StandardGroup{0xF004, 0xF004, "EEC1", "Electronic engine controller 1"},
    StandardGroup{0xF005, 0xF005, "ETC2", "Electronic transmission controller 2"},
    StandardGroup{0xFECA, 0xFECA, "DM1", "Active diagnostic trouble codes"},
    StandardGroup{0xFECB, 0xFECB, "DM2", "Previously active diagnostic trouble codes"},
    StandardGroup{0xFECC, 0xFECC, "DM3", "Clear previously active trouble codes"},
    StandardGroup{0xFECE, 0xFECE, "DM5", "Diagnostic readiness 1"},
    StandardGroup{0xFED3, 0xFED3, "DM11", "Clear active trouble codes"},
    StandardGroup{0xFED8, 0xFED8, "", "Commanded address"},
    StandardGroup{0xFEDA, 0xFEDA, "SOFT", "Software identification"},
    StandardGroup{0xFEDF, 0xFEDF, "EEC3", "Electronic engine controller 3"},
    StandardGroup{0xFEE0, 0xFEE0, "VD", "Vehicle distance"},
    StandardGroup{0xFEE5, 0xFEE5, "HOURS", "Engine hours, revolutions"},
    StandardGroup{0xFEE6, 0xFEE6, "TD", "Time / date"},
    StandardGroup{0xFEE9, 0xFEE9, "LFC", "Fuel consumption (liquid)"},
    StandardGroup{0xFEEB, 0xFEEB, "CI", "Component identification"},
    StandardGroup{0xFEEC, 0xFEEC, "VI", "Vehicle identification"},
    StandardGroup{0xFEED, 0xFEED, "CCSS", "Cruise control / vehicle speed setup"},
    StandardGroup{0xFEEE, 0xFEEE, "ET1", "Engine temperature 1"},
    StandardGroup{0xFEEF, 0xFEEF, "EFL/P1", "Engine fluid level / pressure 1"},
    StandardGroup{0xFEF0, 0xFEF0, "PTO", "Power take-off information"},
    StandardGroup{0xFEF1, 0xFEF1, "CCVS", "Cruise control / vehicle speed"},
    StandardGroup{0xFEF2, 0xFEF2, "LFE", "Fuel economy (liquid)"},
    StandardGroup{0xFEF3, 0xFEF3, "VP", "Vehicle position"},
    StandardGroup{0xFEF5, 0xFEF5, "AMB", "Ambient conditions"},
    StandardGroup{0xFEF6, 0xFEF6, "IC1", "Intake / exhaust conditions 1"},
    StandardGroup{0xFEF7, 0xFEF7, "VEP1", "Vehicle electrical power 1"},
    StandardGroup{0xFEF8, 0xFEF8, "TRF1", "Transmission fluids 1"},
    StandardGroup{0xFEFC, 0xFEFC, "DD", "Dash display"},
    StandardGroup{0xFF00, 0xFFFF, "", "Proprietary B"},
};
static_assert(std::ranges::is_sorted(kStandardGroups, {}, &StandardGroup::first));
static_assert(std::ranges::adjacent_find(kStandardGroups, [](const auto& a, const auto& b) {
                return a.last >= b.first;
              }) == kStandardGroups.end());

// Null for a group without a name here.
constexpr const StandardGroup* standardGroupOf(std::uint32_t pgn) {
  const auto behind = std::ranges::upper_bound(kStandardGroups, pgn, {}, &StandardGroup::first);
  if (behind == kStandardGroups.begin()) return nullptr;
  const StandardGroup& group = *(behind - 1);
  return pgn <= group.last ? &group : nullptr;
}

struct PreferredAddress {
  std::uint8_t address = 0;
  std::string_view name;
};

// In order. 33..38 hex, which the standard gives to tires, ignition, seat and lights, are joysticks on a monitor's bus and
// have no name here.
inline constexpr std::array kPreferredAddresses{
    PreferredAddress{0, "engine 1"},
    PreferredAddress{1, "engine 2"},
    PreferredAddress{3, "transmission 1"},
    PreferredAddress{4, "transmission 2"},
    PreferredAddress{7, "power take-off, main or rear"},
    PreferredAddress{11, "brake system controller"},
    PreferredAddress{15, "engine retarder"},
    PreferredAddress{16, "driveline retarder"},
    PreferredAddress{17, "cruise control"},
    PreferredAddress{19, "steering controller"},
    PreferredAddress{23, "instrument cluster 1"},
    PreferredAddress{26, "electrical charging system"},
    PreferredAddress{30, "electrical system"},
    PreferredAddress{33, "body controller"},
    PreferredAddress{36, "power take-off, front or secondary"},
    PreferredAddress{37, "off-vehicle gateway"},
    PreferredAddress{39, "management computer 1"},
    PreferredAddress{40, "cab display 1"},
    PreferredAddress{47, "suspension controller 1"},
    PreferredAddress{49, "cab controller, primary"},
    PreferredAddress{50, "cab controller, secondary"},
    PreferredAddress{61, "exhaust emission controller"},
    PreferredAddress{71, "chassis controller 1"},
    PreferredAddress{72, "chassis controller 2"},
};
static_assert(std::ranges::is_sorted(kPreferredAddresses, {}, &PreferredAddress::address));
static_assert(std::ranges::none_of(kPreferredAddresses, [](const PreferredAddress& preferred) {
  return preferred.address >= 0x33 && preferred.address <= 0x38;
}));

// Empty for an address without a name here.
constexpr std::string_view preferredUseOf(Address address) {
  const auto found = std::ranges::find(kPreferredAddresses, address.value, &PreferredAddress::address);
  return found == kPreferredAddresses.end() ? std::string_view() : found->name;
}

}  // namespace deckpipe::j1939
