// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/device.h"

#include <algorithm>

#include "bus/j1939.h"
#include "protocol/gateway.h"

namespace deckpipe {

Instant Device::nextDeadline() const {
  Instant next = kNever;
  for (const MessageId id : kPeriodicReports) {
    const Instant last = report(id).at;
    if (last != kNotYet && !isStale(id)) next = std::min(next, last + staleAfter(id));
  }
  return next;
}

void Device::timeCame(Instant time) {
  for (const MessageId id : kPeriodicReports) {
    const Instant last = report(id).at;
    if (last != kNotYet && last + staleAfter(id) <= time) m_stale.add(id);
  }
}

void Device::take(const Frame& frame, MessageId id, Instant time) {
  if (const std::size_t place = kReportPlaces[id]; place < kReports.size()) {
    m_reports[place].set(frame, time);
    m_stale.remove(id);
  }
  switch (id) {
    case MessageId::SoePermissive: permissiveFrom = J1939Id::of(frame.identifier()).source; break;
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
    m_reports[kReportPlaces[MessageId::FaultResponse]].set(frame, time);
  } else if (object == sdo::kOperationalError && size == 2) {
    operationalErrorCode.set(static_cast<std::uint16_t>(readBits(frame.data, gateway::kValue.bits)), time);
  }
}

}  // namespace deckpipe
