// SPDX-License-Identifier: GPL-3.0-or-later
// What was last told of the nodes of one channel that are no devices of Akron's: drives, other makers' nodes. They are
// known by their address alone. Whether they are heard is all that is told of them. EventWalk owns one for each
// channel.
#pragma once

#include <array>
#include <vector>

#include "state/event_slot.h"

namespace deckpipe {

class NodeWatch {
 public:
  explicit NodeWatch(Channel channel) : m_channel(channel) {}

  // A J1939 frame came from `source`.
  void heard(const State& state, Address source, std::vector<Event>& out) {
    if (m_silences[source.value].isSilent()) {
      m_silences[source.value].end(state.cursor().time);
      compare(state, source, out);
    }
    if (m_due == kNever) m_due = state.cursor().time + kSilentAfter;
  }
  // The link of its channel went up or down: nothing can be heard while it is down, which is told by itself. Whoever
  // is silent once it is up again is told anew.
  void linkChanged(Instant time) {
    m_linkChanged = time;
    m_due = time + kSilentAfter;
    m_silences = {};
  }
  // Whatever is due by the state's time.
  void timeCame(const State& state, std::vector<Event>& out);

  // Nothing changes before then unless a frame comes.
  Instant due() const { return m_due; }

 private:
  void compare(const State& state, Address address, std::vector<Event>& out) {
    m_silences[address.value].compare(eventAt(state, m_channel, {}, address), m_due, out);
  }

  Channel m_channel;
  Instant m_linkChanged = kNotYet;
  Instant m_due = kNever;
  std::array<Silence, 256> m_silences;
};

}  // namespace deckpipe
