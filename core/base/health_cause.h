// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps a device from being called fine. The rules stand in state/health.h, the words in
// text/health_text.h. To add a cause: an enumerator at its place by gravity, its row below, its rule, its words;
// the compiler names each place.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/enum_table.h"

namespace deckpipe {

enum class HealthSeverity : std::uint8_t {
  Fine,
  Unknown,  // nothing is known to be wrong, but the device was not asked or not heard
  Attend,
  Fault,
  Silent,
};

// The worst first.
enum class HealthCause : std::uint8_t {
  Silent,             // its periodic messages stopped
  TwoAtOneAddress,    // another device sends from the same address, or the log holds its frames twice
  FaultsNamed,        // its answer names faults, or a pCode error
  SensorError,        // the position sensor of an axis
  OperationalError,   // as its position status says
  Faulted,            // as a 6033 says of itself
  StopError,          // a hard stop reports an error
  Disabled,           // enable is off: it cannot move
  PositionInvalid,    // the bits of a position contradict each other
  Late,               // a periodic message is older than three of its periods; others come
  NotOperational,     // NMT state of a CANopen node
  JoystickStopped,    // no joystick message for 200 ms
  AddressLost,        // and it announced no other one
  AddressContested,   // at this moment
  CannotClaim,        // any address
  Malformed,          // it sent messages of a wrong length
  FaultsNotAnswered,  // asked, and no answer came
  FaultsRefused,      // asked, and an SDO abort or an answer of a wrong length came
  Idle,               // not heard for a while, and no periodic message is expected of it
  FaultsAwaited,      // asked just now, and never answered before
  FaultsOld,          // answered before its last restart or silence
  FaultsNeverAsked,
  StatusNeverHeard,  // a periodic message that its type sends has never come
  NotAnnounced,      // Akron's by its NAME, but it has not said its PIN
  CannotBeAsked,     // no device of Akron's: it has no faults to ask for
  Count,
};

struct HealthCauseFacts {
  std::string_view key;  // in JSON: frozen contract
  HealthSeverity severity;
};

inline constexpr EnumTable<HealthCause, HealthCauseFacts> kHealthCauses{{
    {HealthCause::Silent, {"silent", HealthSeverity::Silent}},
    {HealthCause::TwoAtOneAddress, {"two_at_one_address", HealthSeverity::Fault}},
    {HealthCause::FaultsNamed, {"faults", HealthSeverity::Fault}},
    {HealthCause::SensorError, {"sensor_error", HealthSeverity::Fault}},
    {HealthCause::OperationalError, {"operational_error", HealthSeverity::Fault}},
    {HealthCause::Faulted, {"device_faulted", HealthSeverity::Fault}},
    {HealthCause::StopError, {"stop_error", HealthSeverity::Attend}},
    {HealthCause::Disabled, {"disabled", HealthSeverity::Attend}},
    {HealthCause::PositionInvalid, {"position_invalid", HealthSeverity::Attend}},
    {HealthCause::Late, {"late", HealthSeverity::Attend}},
    {HealthCause::NotOperational, {"not_operational", HealthSeverity::Attend}},
    {HealthCause::JoystickStopped, {"joystick_stopped", HealthSeverity::Attend}},
    {HealthCause::AddressLost, {"address_lost", HealthSeverity::Attend}},
    {HealthCause::AddressContested, {"address_contested", HealthSeverity::Attend}},
    {HealthCause::CannotClaim, {"cannot_claim", HealthSeverity::Attend}},
    {HealthCause::Malformed, {"malformed", HealthSeverity::Attend}},
    {HealthCause::FaultsNotAnswered, {"faults_not_answered", HealthSeverity::Attend}},
    {HealthCause::FaultsRefused, {"faults_refused", HealthSeverity::Attend}},
    {HealthCause::Idle, {"idle", HealthSeverity::Unknown}},
    {HealthCause::FaultsAwaited, {"faults_awaited", HealthSeverity::Unknown}},
    {HealthCause::FaultsOld, {"faults_old", HealthSeverity::Unknown}},
    {HealthCause::FaultsNeverAsked, {"faults_never_asked", HealthSeverity::Unknown}},
    {HealthCause::StatusNeverHeard, {"status_never_heard", HealthSeverity::Unknown}},
    {HealthCause::NotAnnounced, {"not_announced", HealthSeverity::Unknown}},
    {HealthCause::CannotBeAsked, {"cannot_be_asked", HealthSeverity::Unknown}},
}};

static_assert(
    [] {
      HealthSeverity worst = HealthSeverity::Silent;
      for (const HealthCauseFacts& facts : kHealthCauses) {
        if (facts.severity > worst) return false;
        worst = facts.severity;
      }
      return true;
    }(),
    "causes stand in the order of their severity, the worst first");

}  // namespace deckpipe
