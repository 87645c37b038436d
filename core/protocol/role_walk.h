// SPDX-License-Identifier: GPL-3.0-or-later
// Classifies the frames of a log one after another, keeping the roles of every channel it has. For whoever
// walks a log without a State: the headless decode, and the index that lets the trace start anywhere.
#pragma once

#include <map>

#include "protocol/classify.h"

namespace deckpipe {

class RoleWalk {
 public:
  // The next frame of the log; what it teaches holds from the one after it.
  Classified next(const Frame& frame, Instant time) {
    ChannelRoles& roles = m_channels[frame.channel];
    const Classified what = classify(frame, time, roles);
    m_learned = roles.observe(frame, time, what);
    return what;
  }
  // What next() would say, without going on.
  Classified peek(const Frame& frame, Instant time) const {
    static const ChannelRoles kNothingKnown;
    const auto roles = m_channels.find(frame.channel);
    return classify(frame, time, roles == m_channels.end() ? kNothingKnown : roles->second);
  }
  // Whether the last frame changed any role.
  bool learned() const { return m_learned; }
  void sayDrive(Channel channel, Address address, bool isDrive) {
    m_channels[channel.value].sayDrive(address, isDrive);
  }

 private:
  std::map<std::uint8_t, ChannelRoles> m_channels;
  bool m_learned = false;
};

}  // namespace deckpipe
