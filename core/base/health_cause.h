// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps a device from being called fine. The rules stand in state/health.h, the words in
// text/health_text.h. To add a cause: an enumerator at its place by gravity, its row below, its rule, its words;
// the compiler names each place.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/enum_table.h"
#include "base/severity.h"

namespace deckpipe {

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
  LinkDown,           // nothing can be heard, so that nothing else holds any more
  Filtered,           // the log was saved through a filter: what is missing in it is not known to be missing
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
  Severity severity;
};

inline constexpr EnumTable<HealthCause, HealthCauseFacts> kHealthCauses{{
    {HealthCause::Silent, {"silent", Severity::Silent}},
    {HealthCause::TwoAtOneAddress, {"two_at_one_address", Severity::Fault}},
    {HealthCause::FaultsNamed, {"faults", Severity::Fault}},
    {HealthCause::SensorError, {"sensor_error", Severity::Fault}},
    {HealthCause::OperationalError, {"operational_error", Severity::Fault}},
    {HealthCause::Faulted, {"device_faulted", Severity::Fault}},
    {HealthCause::StopError, {"stop_error", Severity::Warning}},
    {HealthCause::Disabled, {"disabled", Severity::Warning}},
    {HealthCause::PositionInvalid, {"position_invalid", Severity::Warning}},
    {HealthCause::Late, {"late", Severity::Warning}},
    {HealthCause::NotOperational, {"not_operational", Severity::Warning}},
    {HealthCause::JoystickStopped, {"joystick_stopped", Severity::Warning}},
    {HealthCause::AddressLost, {"address_lost", Severity::Warning}},
    {HealthCause::AddressContested, {"address_contested", Severity::Warning}},
    {HealthCause::CannotClaim, {"cannot_claim", Severity::Warning}},
    {HealthCause::Malformed, {"malformed", Severity::Warning}},
    {HealthCause::FaultsNotAnswered, {"faults_not_answered", Severity::Warning}},
    {HealthCause::FaultsRefused, {"faults_refused", Severity::Warning}},
    {HealthCause::LinkDown, {"link_down", Severity::Unknown}},
    {HealthCause::Filtered, {"filtered", Severity::Unknown}},
    {HealthCause::Idle, {"idle", Severity::Unknown}},
    {HealthCause::FaultsAwaited, {"faults_awaited", Severity::Unknown}},
    {HealthCause::FaultsOld, {"faults_old", Severity::Unknown}},
    {HealthCause::FaultsNeverAsked, {"faults_never_asked", Severity::Unknown}},
    {HealthCause::StatusNeverHeard, {"status_never_heard", Severity::Unknown}},
    {HealthCause::NotAnnounced, {"not_announced", Severity::Unknown}},
    {HealthCause::CannotBeAsked, {"cannot_be_asked", Severity::Unknown}},
}};

static_assert(
    [] {
      Severity worst = Severity::Silent;
      for (const HealthCauseFacts& facts : kHealthCauses) {
        if (facts.severity > worst) return false;
        worst = facts.severity;
      }
      return true;
    }(),
    "causes stand in the order of their severity, the worst first");

}  // namespace deckpipe
