// SPDX-License-Identifier: GPL-3.0-or-later
// One device as a person thinks of it: an Akron controller by its PIN, wherever its address went on its
// channel; an address that sends such messages without a PIN being known; or a CANopen node behind a gateway.
// Everything it reported, each with its time.
#pragma once

#include <array>
#include <cstdint>

#include "base/ids.h"
#include "protocol/typed.h"
#include "state/frame_rate.h"
#include "state/timed.h"

namespace deckpipe {

// Periodic values, for staleness: a value older than three of its nominal periods is stale.
enum class Periodic : std::uint8_t {
  Position,
  RotationLimits,
  ElevationLimits,
  Outputs,
  MiniOutputs,
  Inputs,
  Permissive,
  Heartbeat,
  Count,
};
inline constexpr std::size_t kPeriodics = static_cast<std::size_t>(Periodic::Count);
// Three nominal periods: 300 ms, for a heartbeat 3 s. Of the permissive it is the controller's own time-out.
constexpr Duration staleAfter(Periodic p) {
  return p == Periodic::Heartbeat ? Duration(3s) : Duration(300ms);
}

enum class HeartbeatState : std::uint8_t {
  Boot = 0x00,
  Stopped = 0x04,
  Operational = 0x05,
  PreOperational = 0x7F
};

// An address that a device had, and until when.
struct FormerAddress {
  Instant until = kNotYet;
  Address address;
  friend bool operator==(const FormerAddress&, const FormerAddress&) = default;
};

struct Device {
  enum class Kind : std::uint8_t { Free, Pin, Address, Node };

  Kind kind = Kind::Free;
  Channel channel;
  Address address;  // null while its address was lost and no other is known
  NodeId node;      // Kind::Node
  Pin pin;          // Kind::Pin
  std::uint16_t addressChanges = 0;
  Instant addressSince = kNotYet;
  std::array<FormerAddress, 3> formerAddresses;  // the latest first; null addresses where there were fewer
  Instant announced = kNotYet;
  Instant lastHeard = kNotYet;
  std::uint32_t frames = 0;
  std::uint32_t malformed = 0;
  FrameRate rate;
  std::uint16_t stale = 0;  // bit per Periodic

  Reported<&PositionLimitStatus::of> position;
  Reported<&SoftLimits::ofRotation> rotationLimits;
  Reported<&SoftLimits::ofElevation> elevationLimits;
  Reported<&DigitalOutputs::of> outputs;
  Reported<&MiniOutputs::of> miniOutputs;
  Reported<&DigitalInputs::of> inputs;
  Reported<&Permissive::of> permissive;  // as sent to it by a master controller
  Address permissiveFrom;
  Reported<&FaultStatus::of> faults;
  Reported<&FirmwareVersions::of> firmware;
  Reported<&PcodeVersion::of> pcode;
  Reported<&ConfigVersion::of> config;

  // Kind::Node
  Timed<std::uint8_t> heartbeat;  // low seven bits, HeartbeatState
  Timed<std::uint32_t> partNumber;
  Timed<std::uint16_t> operationalErrorCode;
  Reported<&BasicJoystick::of> commanded;  // RPDO1; the sender is not known

  // Null where it had none before.
  Address previousAddress() const { return formerAddresses.front().address; }
  // A frame of it came.
  void heard(Instant time) {
    rate.count(time, lastHeard);
    lastHeard = time;
    ++frames;
  }
  bool isStale(Periodic p) const { return (stale >> static_cast<unsigned>(p) & 1u) != 0; }
  // When a periodic value last came; kNotYet where it never did.
  Instant lastOf(Periodic p) const;
  Instant nextDeadline() const;
  // Marks what is due at `time` stale.
  void timeCame(Instant time);
  // Takes what a decoded frame of this device says. `id` is a message that the device sends or receives.
  void take(const Frame& frame, MessageId id, Instant time);

  friend bool operator==(const Device&, const Device&) = default;

 private:
  void fresh(Periodic p) { stale = static_cast<std::uint16_t>(stale & ~(1u << static_cast<unsigned>(p))); }
  void takeSdo(const Frame& frame, Instant time);
};

}  // namespace deckpipe
