// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/joysticks.h"

#include <algorithm>

namespace deckpipe {

const Joystick* Joysticks::find(Address source) const {
  const auto found = std::ranges::find(m_sticks, source, &Joystick::source);
  return found == m_sticks.end() || source == kNullAddress ? nullptr : &*found;
}

// A source that controllers listen to always has a place: it takes one from a source they do not listen to.
Joystick* Joysticks::at(Address source) {
  if (source == kNullAddress) return nullptr;
  for (const Address wanted : {source, kNullAddress}) {
    const auto found = std::ranges::find(m_sticks, wanted, &Joystick::source);
    if (found == m_sticks.end()) continue;
    found->source = source;
    return &*found;
  }
  if (!isJoystickAddress(source)) return nullptr;
  const auto other = std::ranges::find_if(m_sticks, [](const Joystick& j) { return !j.priority(); });
  if (other == m_sticks.end()) return nullptr;
  *other = {};
  other->source = source;
  return &*other;
}

void Joysticks::heardBasic(Address source, const Frame& frame, Instant time) {
  Joystick* stick = at(source);
  if (stick == nullptr) return;
  if (stick->basic.isKnown() && stick->basic.at >= m_listensSince) {
    const Duration gap = time - stick->basic.at;
    if (gap <= Joystick::kSilence) {
      stick->worstGap = std::max(stick->worstGap, gap);
      stick->period = stick->period.count() == 0 ? gap : stick->period + (gap - stick->period) / 8;
    }
  }
  stick->basic.set(frame, time);
  stick->timedOut = stick->isFormer = false;
  ++stick->frames;
}

void Joysticks::heardExtended(Address source, const Frame& frame, Instant time) {
  Joystick* stick = at(source);
  if (stick == nullptr) return;
  stick->extended.set(frame, time);
  ++stick->frames;
}

void Joysticks::linkCameBack() {
  for (Joystick& stick : m_sticks) {
    stick.timedOut = false;
    stick.isFormer = stick.basic.isKnown();
  }
}

Instant Joysticks::timeoutOf(const Joystick& stick) const {
  if (!stick.isActive() || m_listensSince == kNever) return kNever;
  return std::max(stick.basic.at, m_listensSince) + kInputTimeout +
         (m_areCoarse ? kSecondGrain : Duration{0});
}

Instant Joysticks::nextDeadline() const {
  Instant next = kNever;
  for (const Joystick& stick : m_sticks) next = std::min(next, timeoutOf(stick));
  return next;
}

void Joysticks::timeCame(Instant time) {
  for (Joystick& stick : m_sticks) {
    if (timeoutOf(stick) > time) continue;
    stick.timedOut = true;
    ++stick.timeouts;
  }
}

}  // namespace deckpipe
