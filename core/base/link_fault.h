// SPDX-License-Identifier: GPL-3.0-or-later
// Why a link is not up. Shown as a sentence of the window's language, noted in the log as a number.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/enum_table.h"

namespace deckpipe {

// Numbers stand in files: never renumber one, never use one again. They count from 0 without a gap, as tables are
// indexed by them.
enum class LinkFault : std::uint8_t {
  None = 0,
  NoPlugin = 1,  // not installed, or its library is missing
  NoInterface = 2,
  InterfaceDown = 3,   // needs: ip link set NAME up type can bitrate RATE
  WrongBitRate = 4,    // the interface runs at another rate than asked for
  BitRateRefused = 5,  // the adapter cannot do the rate asked for
  NoAnswer = 6,
  Gone = 7,   // unplugged, or its other end went away
  Other = 8,  // in the adapter's words
};
template <>
inline constexpr LinkFault kLastOf<LinkFault> = LinkFault::Other;

// In machine-readable output: a word never changes once shipped.
inline constexpr EnumTable<LinkFault, std::string_view> kLinkFaultKeys{{
    {LinkFault::None, "none"},
    {LinkFault::NoPlugin, "no_plugin"},
    {LinkFault::NoInterface, "no_interface"},
    {LinkFault::InterfaceDown, "interface_down"},
    {LinkFault::WrongBitRate, "wrong_bit_rate"},
    {LinkFault::BitRateRefused, "bit_rate_refused"},
    {LinkFault::NoAnswer, "no_answer"},
    {LinkFault::Gone, "gone"},
    {LinkFault::Other, "other"},
}};

}  // namespace deckpipe
