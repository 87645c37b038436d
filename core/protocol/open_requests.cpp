// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/open_requests.h"

namespace deckpipe {
namespace {

constexpr Duration kAnswerWithin = 2s;

}  // namespace

std::size_t OpenRequests::find(std::uint8_t type, Address from, Address to, Instant time) const {
  std::size_t oldest = kRequests;
  for (std::size_t i = 0; i < kRequests; ++i) {
    const Request& r = m_requests[i];
    if (r.time == kNotYet || r.type != type || r.from != from || r.to != to || time - r.time > kAnswerWithin)
      continue;
    if (oldest == kRequests || r.time < m_requests[oldest].time) oldest = i;
  }
  return oldest;
}

bool OpenRequests::forgetOld(Instant time) {
  const std::uint8_t before = m_waiting;
  for (Request& r : m_requests) {
    if (r.time != kNotYet && time - r.time > kAnswerWithin) {
      r = {};
      --m_waiting;
    }
  }
  return m_waiting != before;
}

bool OpenRequests::answered(std::uint8_t type, Address from, Address to, Instant time) {
  const bool hasForgotten = forgetOld(time);
  const std::size_t request = find(type, to, from, time);
  if (request == kRequests) return hasForgotten;
  m_requests[request] = {};
  --m_waiting;
  return true;
}

bool OpenRequests::requested(std::uint8_t type, Address from, Address to, Instant time) {
  forgetOld(time);
  std::size_t slot = 0;  // a free one, or the oldest
  for (std::size_t i = 0; i < kRequests; ++i) {
    if (m_requests[i].time < m_requests[slot].time) slot = i;
  }
  if (m_requests[slot].time == kNotYet) ++m_waiting;
  m_requests[slot] = {time, type, from, to};
  return true;
}

}  // namespace deckpipe
