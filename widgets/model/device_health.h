// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a device is well, as one word for a list and as reasons for who asks. It says what was reported and
// what stopped coming; what to do about it is for the findings to say.
#pragma once

#include <QStringList>
#include <cstdint>

#include "state/state.h"

namespace deckpipe {

// Quiet: not heard for a while, and nothing of it is due: whether it is there only a question would tell.
enum class HealthLevel : std::uint8_t { Fine, Quiet, Attend, Fault, Silent };

enum class HealthReason : std::uint8_t {
  // silent
  NothingHeard,
  // fault
  FaultBits,
  PcodeError,
  RotationSensor,
  ElevationSensor,
  DeviceFaulted,
  // attend
  OperationalError,
  StopError,
  PositionInvalid,
  PositionOverdue,
  LimitsOverdue,
  OutputsOverdue,
  InputsOverdue,
  HeartbeatOverdue,
  NotOperational,
  JoystickOverdue,
  AddressLost,
  AddressContested,
  CannotClaim,
  Malformed,
  // quiet
  NothingDue,
  Count,
};

struct DeviceHealth {
  HealthLevel level = HealthLevel::Fine;
  EnumSet<HealthReason> reasons;

  bool has(HealthReason reason) const { return reasons.has(reason); }
  friend bool operator==(const DeviceHealth&, const DeviceHealth&) = default;
};

DeviceHealth healthOf(const State& state, const Device& device);
// Of a J1939 address that is no Akron device.
DeviceHealth healthOf(const State& state, Channel channel, Address address);

QString healthWord(HealthLevel level);
// One sentence a reason, the gravest first.
QStringList healthReasons(const DeviceHealth& health);

}  // namespace deckpipe
