// SPDX-License-Identifier: GPL-3.0-or-later
// The groups of values on a device's page. Each message of the catalogue says in which of them it is shown;
// the page (widgets/model) has a drawing for each.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/enum_table.h"

namespace deckpipe {

// In the order in which a page shows those of one kind.
enum class PageGroup : std::uint8_t {
  Health,
  Dial,
  Stops,
  Status,
  Outputs,
  Riser,
  Inputs,
  Permissive,
  Switches,
  Detents,
  Grip,
  Joystick,
  Faults,
  Versions,
  Node,
  Address,
  Count,
};
using PageGroups = EnumSet<PageGroup>;

// For object names; never shown.
inline constexpr EnumTable<PageGroup, std::string_view> kPageGroupKeys{{
    {PageGroup::Health, "health"},
    {PageGroup::Dial, "dial"},
    {PageGroup::Stops, "stops"},
    {PageGroup::Status, "status"},
    {PageGroup::Outputs, "outputs"},
    {PageGroup::Riser, "riser"},
    {PageGroup::Inputs, "inputs"},
    {PageGroup::Permissive, "permissive"},
    {PageGroup::Switches, "switches"},
    {PageGroup::Detents, "detents"},
    {PageGroup::Grip, "grip"},
    {PageGroup::Joystick, "joystick"},
    {PageGroup::Faults, "faults"},
    {PageGroup::Versions, "versions"},
    {PageGroup::Node, "node"},
    {PageGroup::Address, "address"},
}};

}  // namespace deckpipe
