// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that is told as an event of a log: what changed, and when. state/event_walk.h finds them, the words
// stand in text/event_words.h, the meanings for scripts in app/ctl/event_lines.cpp. To add a kind: an enumerator,
// its row below, its words, its meaning; the compiler names each place.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "base/enum_table.h"
#include "base/severity.h"

namespace deckpipe {

// How grave an event can be. The keys are frozen contract.
inline constexpr std::array kEventWeights{Severity::Plain, Severity::Warning, Severity::Fault};
inline constexpr KeyTable<kEventWeights, std::string_view> kEventWeightKeys{{
    {Severity::Plain, "info"},
    {Severity::Warning, "warning"},
    {Severity::Fault, "fault"},
}};
constexpr std::string_view eventWeightKey(Severity weight) { return *kEventWeightKeys.find(weight); }

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
  NotBack,
  Restarted,
  NotOperational,
  Operational,
  Malformed,
  MalformedOver,
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
  Percent,  // of Event::bitRate
  Frames,   // now: how many
};

// An event rests on one of these.
enum class EventBasis : std::uint8_t {
  Heard,    // something that came
  Silence,  // also something that did not come: not to be told where frames are left out
};

struct EventFacts {
  std::string_view key;  // in JSON: frozen contract
  Severity weight;
  EventGroup group;
  EventDetail detail;
  EventBasis basis = EventBasis::Heard;
};

inline constexpr EnumTable<EventKind, EventFacts> kEvents{{
    {EventKind::Appeared,
     {"appeared", Severity::Plain, EventGroup::Presence, EventDetail::None, EventBasis::Silence}},
    {EventKind::Silent,
     {"silent", Severity::Fault, EventGroup::Presence, EventDetail::None, EventBasis::Silence}},
    {EventKind::Back,
     {"back", Severity::Plain, EventGroup::Presence, EventDetail::Length, EventBasis::Silence}},
    {EventKind::NotBack,
     {"not_back", Severity::Warning, EventGroup::Presence, EventDetail::None, EventBasis::Silence}},
    {EventKind::Restarted,
     {"restarted", Severity::Warning, EventGroup::Presence, EventDetail::None, EventBasis::Silence}},
    {EventKind::NotOperational,
     {"not_operational", Severity::Warning, EventGroup::Presence, EventDetail::Flag}},
    {EventKind::Operational, {"operational", Severity::Plain, EventGroup::Presence, EventDetail::Flag}},
    {EventKind::Malformed,
     {"malformed", Severity::Warning, EventGroup::Presence, EventDetail::None, EventBasis::Silence}},
    {EventKind::MalformedOver,
     {"malformed_over", Severity::Plain, EventGroup::Presence, EventDetail::None, EventBasis::Silence}},
    {EventKind::MovedAddress,
     {"moved_address", Severity::Warning, EventGroup::Address, EventDetail::Address}},
    {EventKind::AddressLost, {"address_lost", Severity::Warning, EventGroup::Address, EventDetail::Name}},
    {EventKind::CannotClaim, {"cannot_claim", Severity::Fault, EventGroup::Address, EventDetail::Name}},
    {EventKind::TwoAtOneAddress,
     {"two_at_one_address", Severity::Fault, EventGroup::Address, EventDetail::None}},
    {EventKind::TwoAtOneAddressOver,
     {"two_at_one_address_over", Severity::Plain, EventGroup::Address, EventDetail::None,
      EventBasis::Silence}},
    {EventKind::Fault, {"fault", Severity::Fault, EventGroup::Fault, EventDetail::Fault}},
    {EventKind::FaultCleared, {"fault_cleared", Severity::Plain, EventGroup::Fault, EventDetail::Fault}},
    {EventKind::DeviceFaulted, {"device_faulted", Severity::Fault, EventGroup::Fault, EventDetail::Flag}},
    {EventKind::DeviceFaultedOver,
     {"device_faulted_over", Severity::Plain, EventGroup::Fault, EventDetail::Flag}},
    {EventKind::OperationalError,
     {"operational_error", Severity::Fault, EventGroup::Fault, EventDetail::Code}},
    {EventKind::OperationalErrorOver,
     {"operational_error_over", Severity::Plain, EventGroup::Fault, EventDetail::Code}},
    {EventKind::ErrorCode, {"error_code", Severity::Fault, EventGroup::Fault, EventDetail::Code}},
    {EventKind::ErrorCodeCleared,
     {"error_code_cleared", Severity::Plain, EventGroup::Fault, EventDetail::Code}},
    {EventKind::SensorError, {"sensor_error", Severity::Fault, EventGroup::Fault, EventDetail::Flag}},
    {EventKind::SensorErrorOver,
     {"sensor_error_over", Severity::Plain, EventGroup::Fault, EventDetail::Flag}},
    {EventKind::Disabled, {"disabled", Severity::Warning, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::Enabled, {"enabled", Severity::Plain, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::PermissiveLost,
     {"permissive_lost", Severity::Warning, EventGroup::Mode, EventDetail::Flag, EventBasis::Silence}},
    {EventKind::PermissiveBack,
     {"permissive_back", Severity::Plain, EventGroup::Mode, EventDetail::Flag, EventBasis::Silence}},
    {EventKind::RemoteMode, {"remote_mode", Severity::Plain, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::RemoteModeOver, {"remote_mode_over", Severity::Plain, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::Stowed, {"stowed", Severity::Plain, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::NotStowed, {"not_stowed", Severity::Plain, EventGroup::Mode, EventDetail::Flag}},
    {EventKind::StopReached, {"stop_reached", Severity::Plain, EventGroup::Stop, EventDetail::Stop}},
    {EventKind::StopLeft, {"stop_left", Severity::Plain, EventGroup::Stop, EventDetail::Stop}},
    {EventKind::StopError, {"stop_error", Severity::Warning, EventGroup::Stop, EventDetail::Stop}},
    {EventKind::SoftLimitChanged,
     {"soft_limit_changed", Severity::Plain, EventGroup::Stop, EventDetail::Degrees}},
    {EventKind::JoystickBegan,
     {"joystick_began", Severity::Plain, EventGroup::Joystick, EventDetail::None, EventBasis::Silence}},
    {EventKind::JoystickEnded,
     {"joystick_ended", Severity::Plain, EventGroup::Joystick, EventDetail::None, EventBasis::Silence}},
    {EventKind::JoystickGap,
     {"joystick_gap", Severity::Warning, EventGroup::Joystick, EventDetail::Length, EventBasis::Silence}},
    {EventKind::JoystickTimedOut,
     {"joystick_timed_out", Severity::Warning, EventGroup::Joystick, EventDetail::None, EventBasis::Silence}},
    {EventKind::JoystickBack,
     {"joystick_back", Severity::Plain, EventGroup::Joystick, EventDetail::Length, EventBasis::Silence}},
    {EventKind::JoystickOutranked,
     {"joystick_outranked", Severity::Plain, EventGroup::Joystick, EventDetail::Source}},
    {EventKind::JoystickOutrankedOver,
     {"joystick_outranked_over", Severity::Plain, EventGroup::Joystick, EventDetail::None,
      EventBasis::Silence}},
    {EventKind::LoadHigh,
     {"load_high", Severity::Warning, EventGroup::Bus, EventDetail::Percent, EventBasis::Silence}},
    {EventKind::LoadNormal,
     {"load_normal", Severity::Plain, EventGroup::Bus, EventDetail::Percent, EventBasis::Silence}},
    {EventKind::ErrorFrames, {"error_frames", Severity::Warning, EventGroup::Bus, EventDetail::None}},
    {EventKind::ErrorFramesOver,
     {"error_frames_over", Severity::Plain, EventGroup::Bus, EventDetail::Frames, EventBasis::Silence}},
    {EventKind::BusOff, {"bus_off", Severity::Fault, EventGroup::Bus, EventDetail::None}},
    {EventKind::ErrorPassive, {"error_passive", Severity::Warning, EventGroup::Bus, EventDetail::None}},
    {EventKind::ErrorActive, {"error_active", Severity::Plain, EventGroup::Bus, EventDetail::None}},
    {EventKind::ClockJump, {"clock_jump", Severity::Warning, EventGroup::Bus, EventDetail::None}},
}};

static_assert(
    [] {
      for (const EventFacts& facts : kEvents) {
        // Whether a pointer is null is no constant under the sanitizers.
        if (std::find(kEventWeights.begin(), kEventWeights.end(), facts.weight) == kEventWeights.end())
          return false;
      }
      return true;
    }(),
    "a weight has a key");

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
