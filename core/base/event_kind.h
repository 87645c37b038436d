// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that is told as an event of a log: what changed, and when. state/event_walk.h finds them, the words
// stand in text/event_words.h, the meanings for scripts in app/ctl/event_lines.cpp. To add a kind: an enumerator,
// its row below, its words, its meaning; the compiler names each place.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/enum_table.h"

namespace deckpipe {

enum class EventWeight : std::uint8_t {
  Info,     // how things go
  Warning,  // worth a look
  Fault,    // something stopped working
  Count,
};

inline constexpr EnumTable<EventWeight, std::string_view> kEventWeightKeys{{
    {EventWeight::Info, "info"},
    {EventWeight::Warning, "warning"},
    {EventWeight::Fault, "fault"},
}};

// What an event is about. Each group has a mark of its own on the timeline, and a filter shows it alone.
enum class EventGroup : std::uint8_t {
  Presence,  // who is heard
  Address,
  Fault,
  Mode,  // whether it may move, and how it is led
  Stop,  // hard stops and soft limits
  Joystick,
  Bus,
  Note,  // what no frame carries: marks, the link, what the console asked
  Count,
};

enum class EventKind : std::uint8_t {
  Appeared,
  Silent,
  Back,
  Restarted,
  NotOperational,
  Operational,
  MovedAddress,
  AddressLost,
  CannotClaim,
  TwoAtOneAddress,
  TwoAtOneAddressOver,
  Fault,
  FaultCleared,
  DeviceFaulted,
  DeviceFaultedOver,
  OperationalError,
  OperationalErrorOver,
  ErrorCode,
  ErrorCodeCleared,
  SensorError,
  SensorErrorOver,
  Disabled,
  Enabled,
  PermissiveLost,
  PermissiveBack,
  RemoteMode,
  RemoteModeOver,
  Stowed,
  NotStowed,
  StopReached,
  StopLeft,
  StopError,
  SoftLimitChanged,
  JoystickBegan,
  JoystickEnded,
  JoystickGap,
  JoystickTimedOut,
  JoystickBack,
  JoystickOutranked,
  JoystickOutrankedOver,
  LoadHigh,
  LoadNormal,
  ErrorFrames,
  ErrorFramesOver,
  BusOff,
  ErrorPassive,
  ErrorActive,
  ClockJump,
  Count,
};

// What Event::was and Event::now are.
enum class EventDetail : std::uint8_t {
  None,
  Flag,     // false or true
  Address,  // J1939 addresses
  Name,     // NAMEs; 0 is none
  Fault,    // one bit of the fault map
  Code,     // pCode error codes; 0 is none
  Stop,     // status2 of one side of an axis
  Degrees,  // tenths of a degree
  Length,   // ns; now alone
  Source,   // now: the address of the joystick that goes before
  Percent,  // of 250 kbit/s
  Frames,   // now: how many
};

struct EventFacts {
  std::string_view key;  // in JSON: frozen contract
  EventWeight weight;
  EventGroup group;
  EventDetail detail;
};

inline constexpr EnumTable<EventKind, EventFacts> kEvents{{
    {EventKind::Appeared, {"appeared", EventWeight::Info, EventGroup::Presence, EventDetail::None}},
    {EventKind::Silent, {"silent", EventWeight::Fault, EventGroup::Presence, EventDetail::None}},
    {EventKind::Back, {"back", EventWeight::Info, EventGroup::Presence, EventDetail::Length}},
    {EventKind::Restarted, {"restarted", EventWeight::Warning, EventGroup::Presence, EventDetail::None}},
    {EventKind::NotOperational,
     {"not_operational", EventWeight::Warning, EventGroup::Presence, EventDetail::Flag}},
    {EventKind::Operational, {"operational", EventWeight::Info, EventGroup::Presence, EventDetail::Flag}},
    {EventKind::MovedAddress,
     {"moved_address", EventWeight::Warning, EventGroup::Address, EventDetail::Address}},
    {EventKind::AddressLost, {"address_lost", EventWeight::Warning, EventGroup::Address, EventDetail::Name}},
    {EventKind::CannotClaim, {"cannot_claim", EventWeight::Fault, EventGroup::Address, EventDetail::Name}},
    {EventKind::TwoAtOneAddress,
     {"two_at_one_address", EventWeight::Fault, EventGroup::Address, EventDetail::None}},
    {EventKind::TwoAtOneAddressOver,
     {"two_at_one_address_over", EventWeight::Info, EventGroup::Address, EventDetail::None}},
    {EventKind::Fault, {"fault", EventWeight::Fault, EventGroup::Fault, EventDetail::Fault}},
    {EventKind::FaultCleared, {"fault_cleared", EventWeight::Info, EventGroup::Fault, EventDetail::Fault}},
    {EventKind::DeviceFaulted, {"device_faulted", EventWeight::Fault, EventGroup::Fault, EventDetail::Flag}},
    {EventKind::DeviceFaultedOver,
     {"device_faulted_over", EventWeight::Info, EventGroup::Fault, EventDetail::Flag}},
    {EventKind::OperationalError,
     {"operational_error", EventWeight::Fault, EventGroup::Fault, EventDetail::Code}},
    {EventKind::OperationalErrorOver,
     {"operational_error_over", EventWeight::Info, EventGroup::Fault, EventDetail::Code}},
    {EventKind::ErrorCode, {"error_code", EventWeight::Fault, EventGroup::Fault, EventDetail::Code}},
    {EventKind::ErrorCodeCleared,
     {"error_code_cleared", EventWeight::Info, EventGroup::Fault, EventDetail::Code}},
    {EventKind::SensorError, {"sensor_error", EventWeight::Fault, EventGroup::Fault, EventDetail::Flag}},
    {EventKind::SensorErrorOver,
     {"sensor_error_over", EventWeight::Info, EventGroup::Fault, EventDetail::Flag}},
    {EventKind::Disabled, {"disabled", EventWeight::Warning, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::Enabled, {"enabled", EventWeight::Info, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::PermissiveLost,
     {"permissive_lost", EventWeight::Warning, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::PermissiveBack, {"permissive_back", EventWeight::Info, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::RemoteMode, {"remote_mode", EventWeight::Info, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::RemoteModeOver, {"remote_mode_over", EventWeight::Info, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::Stowed, {"stowed", EventWeight::Info, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::NotStowed, {"not_stowed", EventWeight::Info, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::StopReached, {"stop_reached", EventWeight::Info, EventGroup::Stop, EventDetail::Stop}},
    {EventKind::StopLeft, {"stop_left", EventWeight::Info, EventGroup::Stop, EventDetail::Stop}},
    {EventKind::StopError, {"stop_error", EventWeight::Warning, EventGroup::Stop, EventDetail::Stop}},
    {EventKind::SoftLimitChanged,
     {"soft_limit_changed", EventWeight::Info, EventGroup::Stop, EventDetail::Degrees}},
    {EventKind::JoystickBegan,
     {"joystick_began", EventWeight::Info, EventGroup::Joystick, EventDetail::None}},
    {EventKind::JoystickEnded,
     {"joystick_ended", EventWeight::Info, EventGroup::Joystick, EventDetail::None}},
    {EventKind::JoystickGap,
     {"joystick_gap", EventWeight::Warning, EventGroup::Joystick, EventDetail::Length}},
    {EventKind::JoystickTimedOut,
     {"joystick_timed_out", EventWeight::Warning, EventGroup::Joystick, EventDetail::None}},
    {EventKind::JoystickBack,
     {"joystick_back", EventWeight::Info, EventGroup::Joystick, EventDetail::Length}},
    {EventKind::JoystickOutranked,
     {"joystick_outranked", EventWeight::Info, EventGroup::Joystick, EventDetail::Source}},
    {EventKind::JoystickOutrankedOver,
     {"joystick_outranked_over", EventWeight::Info, EventGroup::Joystick, EventDetail::None}},
    {EventKind::LoadHigh, {"load_high", EventWeight::Warning, EventGroup::Bus, EventDetail::Percent}},
    {EventKind::LoadNormal, {"load_normal", EventWeight::Info, EventGroup::Bus, EventDetail::Percent}},
    {EventKind::ErrorFrames, {"error_frames", EventWeight::Warning, EventGroup::Bus, EventDetail::None}},
    {EventKind::ErrorFramesOver,
     {"error_frames_over", EventWeight::Info, EventGroup::Bus, EventDetail::Frames}},
    {EventKind::BusOff, {"bus_off", EventWeight::Fault, EventGroup::Bus, EventDetail::None}},
    {EventKind::ErrorPassive, {"error_passive", EventWeight::Warning, EventGroup::Bus, EventDetail::None}},
    {EventKind::ErrorActive, {"error_active", EventWeight::Info, EventGroup::Bus, EventDetail::None}},
    {EventKind::ClockJump, {"clock_jump", EventWeight::Warning, EventGroup::Bus, EventDetail::None}},
}};

static_assert(
    [] {
      for (const EventKind a : kAllOf<EventKind>) {
        for (const EventKind b : kAllOf<EventKind>) {
          if (a != b && kEvents[a].key == kEvents[b].key) return false;
        }
      }
      return true;
    }(),
    "a key names one kind");

}  // namespace deckpipe
