// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/node_watch.h"

#include <algorithm>

#include "state/health.h"

namespace deckpipe {

// A joystick's messages have events of their own.
void NodeWatch::timeCame(const State& state, std::vector<Event>& out) {
  const ChannelState& channel = state.channel(m_channel);
  const Instant now = state.cursor().time;
  if (m_due > now) return;
  m_due = kNever;
  if (channel.link == ChannelLink::Down) return;
  for (std::size_t a = 0; a < kNullAddress.value; ++a) {
    const Address address{static_cast<std::uint8_t>(a)};
    const Node node = channel.nodes[address];
    if (node.isSteady && !m_silences[a].isSilent() &&
        state.devices().byAddress(m_channel, address) == nullptr &&
        channel.joysticks.find(address) == nullptr) {
      const Instant due = std::max(node.lastHeard, m_linkChanged) + silentAfter(node.period);
      if (due > now) {
        m_due = std::min(m_due, due);
      } else if (healthOf(state, m_channel, address).has(HealthCause::Silent)) {
        m_silences[a].begin(std::max(node.lastHeard, m_linkChanged));
      }
    }
    if (m_silences[a].lastHeard() != kNotYet) compare(state, address, out);
  }
}

}  // namespace deckpipe
