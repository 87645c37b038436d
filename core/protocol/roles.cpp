// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/roles.h"

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "protocol/catalogue.h"
#include "protocol/classify.h"

namespace deckpipe {
namespace {

constexpr Duration kAnswerWithin = 2s;
constexpr std::uint32_t kSmallestPartNumber = 10'000'000;  // part numbers have eight digits
constexpr std::uint32_t kLargestPartNumber = 99'999'999;
constexpr BitRange kManufacturer = fieldOf(j1939::kNameFields, "manufacturer_code").bits;

bool isPartNumberAnswer(const Frame& frame, const Classified& c) {
  if (c.message != MessageId::SdoReadResponse || c.malformed) return false;
  if (sdo::valueSize(frame.data[0]) != 4) return false;
  const auto object =
      readBits(frame.data, gateway::kIndex.bits) << 8 | readBits(frame.data, gateway::kSubindex.bits);
  const auto value = readBits(frame.data, gateway::kValue.bits);
  return object == sdo::kDeviceType && value >= kSmallestPartNumber && value <= kLargestPartNumber;
}

}  // namespace

void ChannelRoles::sayDrive(Address a, bool isDrive) {
  std::uint8_t& role = m_roles[a.value];
  role = static_cast<std::uint8_t>(isDrive ? role | kDrive : role & ~kDrive);
}

bool ChannelRoles::observe(const Frame& frame, Instant time, const Classified& classified) {
  if (classified.malformed) return false;
  switch (classified.message) {
    case MessageId::Name: return observeName(J1939Id::of(frame.identifier()).source, frame);
    case MessageId::AddressAnnouncement: {
      const Address source = J1939Id::of(frame.identifier()).source;
      if (source == kNullAddress || source == kGlobalAddress || isAkron(source)) return false;
      m_roles[source.value] |= kAkron;
      return true;
    }
    case MessageId::SdoReadResponse: {
      const NodeId node = CobId::of(frame.identifier()).node;
      if (isAkronNode(node) || !isPartNumberAnswer(frame, classified)) return false;
      m_akronNodes.set(node.value);
      return true;
    }
    case MessageId::ZeroAxesRequest:
    case MessageId::ZeroAxesAck:
    case MessageId::SetupModeRequest:
    case MessageId::SetupModeAck: return observeExchange(frame, time, classified);
    default: return false;
  }
}

// J1939-81: claims from the global address or with NAME 0 mean nothing; from the null address a NAME says
// that its owner could not claim.
bool ChannelRoles::observeName(Address source, const Frame& frame) {
  const std::uint64_t name = loadLittle(frame.data);
  if (source == kGlobalAddress || name == 0) return false;
  if (source == kNullAddress) {
    bool dropped = false;
    for (std::size_t a = 0; a < m_names.size(); ++a) {
      if (m_names[a] != name) continue;
      m_names[a] = m_roles[a] = 0;
      dropped = true;
    }
    return dropped;
  }
  std::uint64_t& held = m_names[source.value];
  if (held == name) return false;
  const bool akron = readBits(frame.data, kManufacturer) == j1939::kAkronManufacturer;
  std::uint8_t& role = m_roles[source.value];
  if (held != 0) {
    role = 0;  // another NAME takes the address
  } else if (!akron) {
    role &= static_cast<std::uint8_t>(~kAkron);  // who announced itself there cannot have this NAME
  }
  held = name;
  role |= akron ? kAkron : kForeign;
  return true;
}

std::size_t ChannelRoles::findRequest(std::uint8_t type, Address from, Address to, Instant time) const {
  std::size_t oldest = kRequests;
  for (std::size_t i = 0; i < kRequests; ++i) {
    const Request& r = m_requests[i];
    if (r.time == kNotYet || r.type != type || r.from != from || r.to != to || time - r.time > kAnswerWithin)
      continue;
    if (oldest == kRequests || r.time < m_requests[oldest].time) oldest = i;
  }
  return oldest;
}

bool ChannelRoles::observeExchange(const Frame& frame, Instant time, const Classified& classified) {
  for (Request& r : m_requests) {
    if (r.time != kNotYet && time - r.time > kAnswerWithin) {
      r = {};
      --m_waiting;
    }
  }
  const J1939Id id = J1939Id::of(frame.identifier());
  const std::uint8_t type = frame.data[0];
  if (messageOf(classified.message).device == DeviceEnd::Sender) {
    const std::size_t answered = findRequest(type, id.destination, id.source, time);
    if (answered == kRequests) return false;
    m_requests[answered] = {};
    --m_waiting;
    return true;
  }
  std::size_t slot = 0;  // a free one, or the oldest
  for (std::size_t i = 0; i < kRequests; ++i) {
    if (m_requests[i].time < m_requests[slot].time) slot = i;
  }
  if (m_requests[slot].time == kNotYet) ++m_waiting;
  m_requests[slot] = {time, type, id.source, id.destination};
  return true;
}

}  // namespace deckpipe
