// SPDX-License-Identifier: GPL-3.0-or-later
// What was last told of one joystick source: whether it sends, how regularly, and whether a source of higher
// priority deflects the same axis. EventWalk owns one for each place of Joysticks.
// Source: CAN Messaging manual, Appendix B (100 ms at most, input cleared after 200 ms, priority by address).
#pragma once

#include <array>
#include <vector>

#include "state/event.h"

namespace deckpipe {

// Who goes before a source, of x and of y: the first one of higher priority that deflects the same axis. Null: none.
std::array<Address, 2> whoGoesBefore(const Joysticks& all, const Joystick& stick);

class StickWatch {
 public:
  // Longer than this is a gap. A source with a period near it may be late by a quarter of it.
  static constexpr Duration kMaxGap = 100ms, kMaxSlowGap = 125ms, kSlowPeriod = 80ms;

  // A basic message came. `isNews`: the channel was heard long enough before to know that it did not send. Returns
  // whether none had come for a while, or since the link came up.
  bool look(const State& state, Channel channel, const Joystick& stick, bool isNews, std::vector<Event>& out);
  // One of a wrong length came: controllers take no input from it.
  void malformedCame(const State& state, Channel channel, const Joystick& stick, std::vector<Event>& out);
  void timeCame(const State& state, Channel channel, const Joystick& stick, std::vector<Event>& out);
  // The link of its channel went up or down: nothing can be heard while it is down, which is told by itself.
  void linkChanged(Instant time) {
    if (m_source != kNullAddress) m_due = time;
    m_wrongSince = kNotYet;
    m_isWrong = false;
    m_length.set(0);
  }
  // It is up again. One that sent before ends if it does not send behind the gap; for nobody it times out then.
  void linkCameBack();
  Instant due() const { return m_due; }

 private:
  void compareSending(const State& state, Channel channel, std::vector<Event>& out);
  void compareLength(const State& state, Channel channel, std::vector<Event>& out);
  void compareTimeout(const State& state, Channel channel, std::vector<Event>& out);
  void lookAtRank(const State& state, Channel channel, const Joystick& stick, std::vector<Event>& out);

  Address m_source;  // null: none yet
  Instant m_last = kNotYet;
  bool m_isSending = false;  // false from Joystick::kSilence after its last message on
  bool m_isNotBack = false;  // it sent before a gap of the link, and ended as it was not heard behind it
  bool m_hasTimedOut = false;
  Duration m_timeoutGap{0};  // how long it had not sent when the latter changed last
  Instant m_due = kNever;
  EventSlot m_sending, m_timeout{0}, m_length{0};
  Instant m_wrongSince = kNotYet, m_wrongLast = kNotYet;  // basic messages, with no right one since
  bool m_isWrong = false;  // … for longer than controllers wait for a right one
  TellCount m_gaps;
  // The source that goes before it, of x and of y.
  bool m_isOutranked = false;
  EventSlot m_outranked[2]{EventSlot(kNullAddress.value), EventSlot(kNullAddress.value)};
};

}  // namespace deckpipe
