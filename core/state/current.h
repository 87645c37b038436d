// SPDX-License-Identifier: GPL-3.0-or-later
// What of a state is current: one rule for whatever draws a value as live. A value is current if its message comes in
// time and its link did not go down after it. Behind a link that is down nothing goes stale by itself, as nothing could
// be heard (State::linkIs).
#pragma once

#include "base/time.h"
#include "state/state.h"

namespace deckpipe {

// Whether the link of a channel is down. At the very moment it goes down, which is where a recording ends, everything
// is still as it was.
inline bool isLinkDown(const ChannelState& channel, Instant now) {
  return channel.link == ChannelLink::Down && now > channel.linkDown;
}
inline bool isLinkDown(const State& state, Channel channel) {
  return isLinkDown(state.channel(channel), state.cursor().time);
}

// Whether the link went down after something that was heard at `at`. Whether that still holds shows once it is heard
// again.
inline bool isCutOff(const State& state, Channel channel, Instant at) {
  return (at != kNotYet && isLinkDown(state, channel)) || state.channel(channel).isBeforeGap(at);
}

// Whether what one of kPeriodicReports said last is old.
inline bool isStale(const State& state, const Device& device, MessageId id) {
  return device.isStale(id) || isCutOff(state, device.channel, device.report(id).at);
}

// Whether what a joystick asked for last is old.
inline bool isStale(const State& state, Channel channel, const Joystick& stick) {
  return stick.timedOut || isCutOff(state, channel, stick.basic.at);
}
// Of its extended message no time-out is given; with the source's own it is old too.
inline bool isExtendedStale(const State& state, Channel channel, const Joystick& stick) {
  return stick.timedOut || isCutOff(state, channel, stick.extended.at) ||
         state.cursor().time - stick.extended.at >= kInputTimeout + state.slack();
}
// Whether monitors act on its input now, as far as is known.
inline bool isInForce(const State& state, Channel channel, const Joystick& stick) {
  return stick.isActive() && !isStale(state, channel, stick);
}

// Of what was heard at `at` on a channel; kNotYet: it was not.
inline Age ageOf(const State& state, Channel channel, Instant at) {
  if (at == kNotYet) return {};
  const Instant now = state.cursor().time;
  if (isLinkDown(state, channel)) return Age::linkDown(now - state.channel(channel).linkDown);
  const std::optional<Duration> ago = ageAt(at, now);
  return ago ? Age::ago(*ago) : Age{Age::Kind::NoTimes};
}

}  // namespace deckpipe
