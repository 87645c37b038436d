// SPDX-License-Identifier: GPL-3.0-or-later
// A controller says these states of its parts: a stop, a switch, a sensor of position. The keys are frozen contract.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/enum_table.h"

namespace deckpipe {

// By the number on the bus.
enum class Status2 : std::uint8_t { Off, On, Error, NotAvailable };
template <>
inline constexpr Status2 kLastOf<Status2> = Status2::NotAvailable;
inline constexpr EnumTable<Status2, std::string_view> kStatus2Keys{{
    {Status2::Off, "off"},
    {Status2::On, "on"},
    {Status2::Error, "error"},
    {Status2::NotAvailable, "na"},
}};

enum class PositionState : std::uint8_t {
  Ok,
  SensorError,  // the controller says that its sensor failed
  NotFitted,    // the controller says that it has no sensor
  Invalid,      // the bits contradict one another
};
template <>
inline constexpr PositionState kLastOf<PositionState> = PositionState::Invalid;
inline constexpr EnumTable<PositionState, std::string_view> kPositionStateKeys{{
    {PositionState::Ok, "ok"},
    {PositionState::SensorError, "sensor_error"},
    {PositionState::NotFitted, "not_fitted"},
    {PositionState::Invalid, "invalid"},
}};

}  // namespace deckpipe
