// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/stick_watch.h"

#include <algorithm>
#include <array>
#include <utility>

namespace deckpipe {
namespace {

bool deflects(const StickAxis& axis) { return axis.tenths.value_or(0) != 0; }

}  // namespace

std::array<Address, 2> whoGoesBefore(const Joysticks& all, const Joystick& stick) {
  std::array<Address, 2> first{kNullAddress, kNullAddress};
  if (!stick.isActive()) return first;
  for (const Joystick& other : all.all()) {
    if (other.source >= stick.source || !other.priority() || !other.isActive()) continue;
    const BasicJoystick own = stick.basic.value(), its = other.basic.value();
    if (deflects(own.x) && deflects(its.x)) first[0] = std::min(first[0], other.source);
    if (deflects(own.y) && deflects(its.y)) first[1] = std::min(first[1], other.source);
  }
  return first;
}

bool StickWatch::look(const State& state, Channel channel, const Joystick& stick, bool isNews,
                      std::vector<Event>& out) {
  if (stick.source != m_source) {
    *this = {};
    m_source = stick.source;
    if (isNews) m_sending = EventSlot(0);
  }
  const Instant now = state.cursor().time;
  m_wrongSince = kNotYet;
  m_isWrong = false;
  compareLength(state, channel, out);
  const bool wasDeaf = m_last < state.channel(channel).linkUp;
  const Duration gap = m_last == kNotYet ? Duration{0} : now - state.channel(channel).missedFrom(m_last);
  const bool wasSending = std::exchange(m_isSending, true), hadTimedOut = std::exchange(m_hasTimedOut, false);
  m_last = now;
  m_isNotBack = false;
  const Duration slack = state.slack();
  m_due = std::min(m_due, now + kInputTimeout + slack);
  if (!wasSending) {
    m_timeout.set(0);
    compareSending(state, channel, out);
  } else if (hadTimedOut) {
    m_timeoutGap = gap;
    compareTimeout(state, channel, out);
  } else if (!wasDeaf && slack == Duration{0} && gap > (stick.period > kSlowPeriod ? kMaxSlowGap : kMaxGap)) {
    Event event = eventAt(state, channel, EventKind::JoystickGap, m_source);
    event.now = gap.count();
    m_gaps.happens(event, out);
  }
  if (stick.priority()) lookAtRank(state, channel, stick, out);
  return !wasSending || wasDeaf;
}

void StickWatch::malformedCame(const State& state, Channel channel, const Joystick& stick,
                               std::vector<Event>& out) {
  if (stick.source != m_source) {
    *this = {};
    m_source = stick.source;
  }
  const Instant now = state.cursor().time;
  if (m_wrongSince == kNotYet || now - m_wrongLast > Joystick::kSilence) m_wrongSince = now;
  m_wrongLast = now;
  m_isWrong = m_isWrong || now - m_wrongSince >= kInputTimeout + state.slack();
  // It is known now that it does not send.
  if (m_isWrong && !m_sending.isKnown()) m_sending.set(0);
  compareLength(state, channel, out);
}

void StickWatch::compareLength(const State& state, Channel channel, std::vector<Event>& out) {
  if (!m_length.moves(m_isWrong ? 1 : 0, state.cursor().time, m_due)) return;
  Event event =
      eventAt(state, channel, m_isWrong ? EventKind::Malformed : EventKind::MalformedOver, m_source);
  event.since = m_isWrong ? m_wrongSince : kNotYet;
  m_length.tell(event, out);
}

void StickWatch::compareSending(const State& state, Channel channel, std::vector<Event>& out) {
  const Instant now = state.cursor().time;
  if (!m_sending.moves(m_isSending ? 1 : 0, now, m_due)) return;
  Event event =
      eventAt(state, channel, m_isSending ? EventKind::JoystickBegan : EventKind::JoystickEnded, m_source);
  if (!m_isSending) event.since = state.channel(channel).missedFrom(m_last);
  m_sending.tell(event, out);
}

void StickWatch::compareTimeout(const State& state, Channel channel, std::vector<Event>& out) {
  const Instant now = state.cursor().time;
  if (!m_timeout.moves(m_hasTimedOut ? 1 : 0, now, m_due)) return;
  Event event = eventAt(state, channel, m_hasTimedOut ? EventKind::JoystickTimedOut : EventKind::JoystickBack,
                        m_source);
  event.now = m_timeoutGap.count();
  m_timeout.tell(event, out);
}

void StickWatch::lookAtRank(const State& state, Channel channel, const Joystick& stick,
                            std::vector<Event>& out) {
  const Joysticks& all = state.channel(channel).joysticks;
  const bool isAlone = all.all()[1].source == kNullAddress;
  if (isAlone && !m_isOutranked) return;
  const std::array<Address, 2> before = whoGoesBefore(all, stick);
  const bool isOutranked = before[0] != kNullAddress || before[1] != kNullAddress;
  if (!isOutranked && !m_isOutranked) return;
  m_isOutranked = isOutranked;
  for (std::size_t axis = 0; axis < before.size(); ++axis) {
    const Address by = before[axis];
    EventSlot& slot = m_outranked[axis];
    if (!slot.moves(by.value, state.cursor().time, m_due, EventSlot::First::Always)) continue;
    Event event = eventAt(
        state, channel, by == kNullAddress ? EventKind::JoystickOutrankedOver : EventKind::JoystickOutranked,
        m_source);
    event.axis = static_cast<std::uint8_t>(axis + 1);
    event.now = by.value;
    slot.tell(event, out);
  }
}

void StickWatch::linkCameBack() {
  const StickWatch before = std::exchange(*this, {});
  if (!before.m_isSending && !before.m_isNotBack) return;
  m_source = before.m_source;
  m_last = before.m_last;
  m_isSending = before.m_isSending;
  m_isNotBack = before.m_isNotBack;
  m_sending.set(m_isSending ? 1 : 0);
}

void StickWatch::timeCame(const State& state, Channel channel, const Joystick& stick,
                          std::vector<Event>& out) {
  const Instant now = state.cursor().time;
  if (m_due > now) return;
  m_due = kNever;
  const bool isDeaf = state.channel(channel).link == ChannelLink::Down;
  const Instant from = state.channel(channel).missedFrom(m_last);
  const bool isUnheard = m_last < state.channel(channel).linkUp;
  const Instant timeout = isDeaf || isUnheard ? kNever : from + kInputTimeout + state.slack();
  const Instant end = isDeaf ? kNever : from + Joystick::kSilence;
  if (m_isSending && !m_hasTimedOut && timeout <= now) {
    m_hasTimedOut = true;
    m_timeoutGap = now - from;
  }
  if (m_isSending) {
    m_isSending = now < end;
    m_isNotBack = isUnheard && !m_isSending;
  }
  compareTimeout(state, channel, out);
  compareSending(state, channel, out);
  compareLength(state, channel, out);
  if (stick.priority()) lookAtRank(state, channel, stick, out);
  if (m_isSending) m_due = std::min(m_due, m_hasTimedOut || isUnheard ? end : timeout);
}

}  // namespace deckpipe
