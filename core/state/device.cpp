// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/device.h"

#include <algorithm>

#include "bus/j1939.h"
#include "protocol/gateway.h"

namespace deckpipe {

Instant Device::lastOf(Periodic p) const {
  switch (p) {
    case Periodic::Position: return position.at;
    case Periodic::RotationLimits: return rotationLimits.at;
    case Periodic::ElevationLimits: return elevationLimits.at;
    case Periodic::Outputs: return outputs.at;
    case Periodic::MiniOutputs: return miniOutputs.at;
    case Periodic::Inputs: return inputs.at;
    case Periodic::Permissive: return permissive.at;
    case Periodic::Heartbeat: return heartbeat.at;
    case Periodic::Count: break;
  }
  return kNotYet;
}

Instant Device::nextDeadline() const {
  Instant next = kNever;
  for (std::size_t i = 0; i < kPeriodics; ++i) {
    const auto p = static_cast<Periodic>(i);
    const Instant last = lastOf(p);
    if (last != kNotYet && !isStale(p)) next = std::min(next, last + staleAfter(p));
  }
  return next;
}

void Device::timeCame(Instant time) {
  for (std::size_t i = 0; i < kPeriodics; ++i) {
    const auto p = static_cast<Periodic>(i);
    const Instant last = lastOf(p);
    if (last != kNotYet && last + staleAfter(p) <= time) stale = static_cast<std::uint16_t>(stale | 1u << i);
  }
}

void Device::take(const Frame& frame, MessageId id, Instant time) {
  const auto periodic = [&](auto& value, Periodic p) {
    value.set(frame, time);
    fresh(p);
  };
  switch (id) {
    case MessageId::PositionLimitStatus: periodic(position, Periodic::Position); break;
    case MessageId::RotationSoftLimits: periodic(rotationLimits, Periodic::RotationLimits); break;
    case MessageId::ElevationSoftLimits: periodic(elevationLimits, Periodic::ElevationLimits); break;
    case MessageId::DigitalOutputs: periodic(outputs, Periodic::Outputs); break;
    case MessageId::MiniDigitalOutputs: periodic(miniOutputs, Periodic::MiniOutputs); break;
    case MessageId::DigitalInputs: periodic(inputs, Periodic::Inputs); break;
    case MessageId::SoePermissive:
      periodic(permissive, Periodic::Permissive);
      permissiveFrom = J1939Id::of(frame.identifier()).source;
      break;
    case MessageId::FaultResponse: faults.set(frame, time); break;
    case MessageId::FirmwareResponse: firmware.set(frame, time); break;
    case MessageId::PcodeResponse: pcode.set(frame, time); break;
    case MessageId::ConfigResponse: config.set(frame, time); break;
    case MessageId::Heartbeat: {
      constexpr BitRange kState = fieldOf(gateway::kHeartbeatFields, "state").bits;
      heartbeat.set(static_cast<std::uint8_t>(readBits(frame.data, kState)), time);
      fresh(Periodic::Heartbeat);
      break;
    }
    case MessageId::GatewayJoystick: commanded.set(frame, time); break;
    case MessageId::SdoReadResponse: takeSdo(frame, time); break;
    default: break;
  }
}

void Device::takeSdo(const Frame& frame, Instant time) {
  const auto object =
      readBits(frame.data, gateway::kIndex.bits) << 8 | readBits(frame.data, gateway::kSubindex.bits);
  const unsigned size = sdo::valueSize(frame.data[0]);
  if (object == sdo::kDeviceType && size == 4) {
    partNumber.set(static_cast<std::uint32_t>(readBits(frame.data, gateway::kValue.bits)), time);
  } else if (object == sdo::kFaultStatus && size == 4) {
    faults.set(frame, time);
  } else if (object == sdo::kOperationalError && size == 2) {
    operationalErrorCode.set(static_cast<std::uint16_t>(readBits(frame.data, gateway::kValue.bits)), time);
  }
}

}  // namespace deckpipe
