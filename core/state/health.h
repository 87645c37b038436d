// SPDX-License-Identifier: GPL-3.0-or-later
// How a device is: every cause that keeps it from being called fine (base/health_cause.h has the list, health.cpp
// a rule for each). A pure function of the state and so of the cursor, live or of a log. It says what was reported
// and what stopped coming; what to do about it is for the findings to say.
//
// While the link was down, which is a gap of the log, another bus may have come to the plug. A gap changes four things:
//   1. No value of before it counts.
//   2. A silence is counted from where the link came back.
//   3. Whoever was not heard since then is idle, and not silent: nobody knows whether it is at this bus.
//   4. A device that has not said its PIN since then need not send what was sent from its address before.
//
// A device is fine only if it sends all that its type sends (protocol/device_types.h), can act, and has answered
// since its last restart or silence that it has no faults. While its link is down, that alone is known.
#pragma once

#include "base/health_cause.h"
#include "state/state.h"

namespace deckpipe {

// Whether an answer may still be believed.
enum class AnswerAge : std::uint8_t {
  Current,
  BeforeRestart,   // the device restarted after it
  BeforeSilence,   // the device's periodic messages stopped after it, even if they came back
  BeforeLinkDown,  // the link went down after it, and is down
  BeforeGap,       // … and is up again
};

// What an answer said of faults.
struct NamedFaults {
  std::uint32_t map = 0;
  std::uint16_t errorCode = 0;  // of a pCode error; 0 if there is none, or it was not said

  bool isEmpty() const { return map == 0 && errorCode == 0; }
  friend bool operator==(const NamedFaults&, const NamedFaults&) = default;
};

// Which axes of a monitor.
struct Axes {
  bool rotation = false;
  bool elevation = false;

  bool isEmpty() const { return !rotation && !elevation; }
  friend bool operator==(const Axes&, const Axes&) = default;
};

struct Health {
  EnumSet<HealthCause> causes;
  // What the causes speak of.
  NamedFaults faults;             // FaultsNamed, OperationalError: of the answers that may still be believed
  NamedFaults oldFaults;          // FaultsOld
  EnumSet<MessageId> late;        // Late
  EnumSet<MessageId> neverHeard;  // StatusNeverHeard
  Axes sensorError;               // SensorError
  Axes invalid;                   // PositionInvalid
  // Silent: when a periodic message came last, kNotYet if none ever did. Idle: when it was heard last. LinkDown: when
  // the link went down.
  Instant since = kNotYet;
  // Silent, Idle: nothing of the kind came since the link came back, and `since` is when it did.
  bool isSinceLinkUp = false;
  Instant asked = kNotYet;                // FaultsNotAnswered: the first try
  Instant answered = kNotYet;             // FaultsOld: when the answer came
  AnswerAge answer = AnswerAge::Current;  // FaultsOld: why it is old
  Address sharedAddress;                  // TwoAtOneAddress: which; null otherwise
  // TwoAtOneAddress: nothing but the pace of statuses tells: there may be one, whose frames the log holds twice.
  bool isOnlyEqual = false;

  bool isFine() const { return causes.isEmpty(); }
  bool has(HealthCause cause) const { return causes.has(cause); }
  // The first one that holds; Count where it is fine.
  HealthCause worst() const;
  Severity severity() const;
  // Key of the worst cause, "fine" if there is none. Frozen contract.
  std::string_view key() const { return isFine() ? "fine" : kHealthCauses[worst()].key; }
  friend bool operator==(const Health&, const Health&) = default;
};

Health healthOf(const State& state, const Device& device);
// Of a J1939 address at which there is no device of Akron's.
Health healthOf(const State& state, Channel channel, Address address);

// Health::sharedAddress alone, for whoever asks often.
Address sharedAddressOf(const State& state, const Device& device);

// Of an answer that this device gave at `answered`.
AnswerAge ageOfAnswer(const State& state, const Device& device, Instant answered);
// An answer is missing if none came within the three tries of a poll.
inline constexpr Duration kUnansweredAfter = 1500ms;
bool isUnanswered(const Device& device, Request request, Instant now);

}  // namespace deckpipe
