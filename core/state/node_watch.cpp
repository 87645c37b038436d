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
    if (node.isSteady && !m_silent[a] && state.devices().byAddress(m_channel, address) == nullptr &&
        channel.joysticks.find(address) == nullptr) {
      const Instant due = std::max(node.lastHeard, m_linkChanged) + silentAfter(node.period);
      if (due > now) {
        m_due = std::min(m_due, due);
      } else if (healthOf(state, m_channel, address).has(HealthCause::Silent)) {
        m_silent.set(a);
        m_wereSilent.set(a);
        m_since[a] = node.lastHeard;
      }
    }
    if (m_wereSilent[a]) compare(state, address, out);
  }
}

void NodeWatch::spoke(const State& state, Address source, std::vector<Event>& out) {
  m_silent.reset(source.value);
  m_silentFor[source.value] = state.cursor().time - m_since[source.value];
  compare(state, source, out);
}

void NodeWatch::compare(const State& state, Address address, std::vector<Event>& out) {
  const bool isSilent = m_silent[address.value];
  EventSlot& slot = m_silence[address.value];
  const Instant now = state.cursor().time;
  if (!slot.moves(isSilent ? 1 : 0, now, m_due)) return;
  Event event;
  event.kind = isSilent ? EventKind::Silent : EventKind::Back;
  event.frame = state.cursor().frames;
  event.time = now;
  event.channel = m_channel;
  event.address = address;
  if (isSilent) {
    event.since = m_since[address.value];
  } else {
    event.now = m_silentFor[address.value].count();
  }
  slot.settle(event);
  out.push_back(event);
}

}  // namespace deckpipe
