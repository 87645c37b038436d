// SPDX-License-Identifier: GPL-3.0-or-later
// One change of what is known of a log, found by state/event_walk.h.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/event_kind.h"
#include "base/ids.h"
#include "base/time.h"
#include "state/state.h"

namespace deckpipe {

struct Event {
  EventKind kind = EventKind::ClockJump;
  std::uint8_t axis = 0;  // 1 to 5; 0: it is about none
  bool isPlus = false;    // the side of a stop or soft limit: right, up
  // Changes of the same thing right before this one that were not told, as they came too fast for a reader.
  std::uint32_t folded = 0;
  std::uint64_t frame = 0;  // so many frames had happened, as in a cursor
  Instant time;
  Channel channel;
  // Whom it concerns: the PIN, where it is known, and the address or node at that time. NotBack: those of before the gap.
  Address address;  // null: none
  NodeId node;      // 0: none
  Pin pin;
  Pin other{};           // TwoAtOneAddress: the second one, where it said who it is
  std::int64_t was = 0;  // by kEvents[kind].detail
  std::int64_t now = 0;
  std::uint32_t bitRate = 0;   // LoadHigh, LoadNormal: the load is of so many bit/s
  bool isRateAssumed = false;  // the log does not say that rate
  // Silent, NotBack, JoystickEnded: when it was heard last, or when the link came up, if that was later. Others: since when it holds, if it was told later.
  Instant since = kNotYet;
  friend bool operator==(const Event&, const Event&) = default;
};

// What is told as events, and how often. A value that flickers does not flood the list: kBurst changes are told as
// they come, further ones at most every kEach. What came between is counted, and the value that it settles at is
// told. What is another matter is no flicker: each fault has a slot of its own, and where the values of one slot are
// such matters (First::Always), each is told when it comes for the first time.
class TellLimit {
 public:
  static constexpr int kBurst = 4;
  static constexpr Duration kEach = 10s;

  Instant next() const { return m_paid == kNotYet ? kNotYet : m_paid - kEach * (kBurst - 1); }
  bool allows(Instant now) const { return next() <= now; }
  void pay(Instant now) { m_paid = std::min((m_paid < now ? now : m_paid) + kEach, now + kEach * kBurst); }

 private:
  Instant m_paid = kNotYet;  // until when what was told has been paid for
};

// What happened on a channel at the state's time.
inline Event eventAt(const State& state, Channel channel, EventKind kind = {},
                     Address address = kNullAddress) {
  Event event;
  event.kind = kind;
  event.frame = state.cursor().frames;
  event.time = state.cursor().time;
  event.channel = channel;
  event.address = address;
  return event;
}

// Something that happens, and has no value. What is not told is counted with the next one that is.
class TellCount {
 public:
  void happens(Event event, std::vector<Event>& out) {
    if (!m_limit.allows(event.time)) {
      ++m_folded;
      return;
    }
    m_limit.pay(event.time);
    event.folded = std::exchange(m_folded, 0u);
    out.push_back(event);
  }

 private:
  TellLimit m_limit;
  std::uint32_t m_folded = 0;
};

class EventSlot {
 public:
  // Whether a value that was never told is told however fast it comes.
  enum class First : bool { AsOthers, Always };

  // The first value heard is no change.
  EventSlot() = default;
  // The first value heard is a change if it is another one than `usual`.
  explicit EventSlot(std::uint64_t usual) : m_shown(usual), m_last(usual), m_isKnown(true) {}

  // Whether a change is to be told now: from shown() to `value`. Then call tell(). If it is to be told later,
  // `retry` becomes the time to ask again, if that is sooner.
  bool moves(std::uint64_t value, Instant now, Instant& retry, First first = First::AsOthers) {
    if (!m_isKnown) {
      m_isKnown = true;
      m_shown = m_last = value;
    }
    if (value == m_last && m_waiting == 0) return false;
    const bool isNew = first == First::Always && value != m_last && (m_told & bitOf(value)) == 0;
    if (!isNew && !m_limit.allows(now)) {
      take(value, now);
      if (m_limit.next() < retry) retry = m_limit.next();
      return false;
    }
    const bool isLate = m_waiting > 0;
    take(value, now);
    if (!isLate) m_waiting = 0;
    return true;
  }
  bool isKnown() const { return m_isKnown; }
  std::uint64_t shown() const { return m_shown; }
  // Sets the value without telling it.
  void set(std::uint64_t value) {
    m_shown = m_last = value;
    m_waiting = 0;
    m_isKnown = true;
  }
  // The change is told, by this event. One that is told later than it came says since when it holds.
  void tell(Event event, std::vector<Event>& out) {
    if (m_waiting > 0) {
      event.folded = m_waiting - 1;
      if (event.since == kNotYet && m_changed < event.time) event.since = m_changed;
    }
    m_shown = m_last;
    m_told |= bitOf(m_last);
    m_waiting = 0;
    m_limit.pay(event.time);
    out.push_back(event);
  }

 private:
  static std::uint64_t bitOf(std::uint64_t value) { return std::uint64_t{1} << (value & 63); }
  void take(std::uint64_t value, Instant now) {
    if (value == m_last) return;
    m_last = value;
    m_changed = now;
    ++m_waiting;
  }

  std::uint64_t m_shown = 0, m_last = 0;
  std::uint64_t m_told = 0;  // a bit for each value that was told: the value itself, or its low bits
  Instant m_changed = kNotYet;
  TellLimit m_limit;
  std::uint32_t m_waiting = 0;  // changes that are not told
  bool m_isKnown = false;
};

// Whether somebody who sent by himself is silent: told as Silent, or behind a gap of the link as NotBack, and as Back.
class Silence {
 public:
  bool isSilent() const { return m_isSilent; }
  bool isNotBack() const { return m_isSilent && m_kind == EventKind::NotBack; }
  // Before the last silence; kNotYet if there was none.
  Instant lastHeard() const { return m_lastHeard; }
  void begin(Instant lastHeard, EventKind kind = EventKind::Silent) {
    m_isSilent = true;
    m_kind = kind;
    m_lastHeard = lastHeard;
  }
  void end(Instant now) {
    m_isSilent = false;
    m_length = now - m_lastHeard;
  }
  // `event` says when and whom; `retry` is that of EventSlot::moves().
  void compare(Event event, Instant& retry, std::vector<Event>& out) {
    if (!m_slot.moves(m_isSilent ? 1 : 0, event.time, retry)) return;
    event.kind = m_isSilent ? m_kind : EventKind::Back;
    if (m_isSilent) {
      event.since = m_lastHeard;
    } else {
      event.now = m_length.count();
    }
    m_slot.tell(event, out);
  }

 private:
  bool m_isSilent = false;
  EventKind m_kind = EventKind::Silent;
  Instant m_lastHeard = kNotYet;
  Duration m_length{0};  // of the last one
  EventSlot m_slot{0};
};

}  // namespace deckpipe
