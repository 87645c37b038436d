// SPDX-License-Identifier: GPL-3.0-or-later
// What is heard on a bus, with time passed in, for the tests of what health says of it.
#pragma once

#include <string>
#include <string_view>

#include "state/health.h"
#include "support/frames.h"

namespace deckpipe::test {

inline constexpr char kPinA[] = "1032AE100801035";
inline constexpr char kPinB[] = "1032AE100801036";
inline constexpr char kAnnouncesA[] = "FF83150206021A0B";
inline constexpr char kAnnouncesB[] = "FF83150206021A0C";
inline constexpr char kNameOfA[] = "0B1AC22800420090";
inline constexpr char kNameOfB[] = "0C1AC22800420090";
inline constexpr char kLowerForeignName[] = "0100200000000000";
inline constexpr char kHigherForeignName[] = "01002001000000FF";
inline constexpr char kAsksForNames[] = "00EE00";
inline constexpr char kPosition[] = "011D940371000041";       // 47.3 right, 5.5 down
inline constexpr char kOtherPosition[] = "0112C10644000041";  // 30.0 right
inline constexpr char kTurnedALittle[] = "011D950371000041";
inline constexpr char kSensorError[] = "01FFF4FFF4000000";
inline constexpr char kOutputs[] = "83C051";
inline constexpr char kNoFaults[] = "02000000000000";
inline constexpr char kFaultedMiniOutputs[] = "84C000";
inline constexpr char kRotationLimits[] = "8103E8FC1800";

class Bus {
 public:
  Bus& hear(std::string_view id, std::string_view data, std::uint8_t channel = 0) {
    m_state.apply(frame(id, data, channel), m_now);
    return *this;
  }
  Bus& hear(Frame f, std::uint8_t flags) {
    f.flags |= flags;
    m_state.apply(f, m_now);
    return *this;
  }
  Bus& note(const NoteValue& note) {
    m_state.apply(Note{.time = m_now, .value = note});
    return *this;
  }
  Bus& pass(Duration d) {
    m_now = m_now + d;
    m_state.timeCame(m_now);
    return *this;
  }
  // A 6032 at 80 that sends what it repeats.
  Bus& monitor(std::string_view position = kPosition, std::string_view outputs = kOutputs) {
    return hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA).statuses(position, outputs);
  }
  Bus& statuses(std::string_view position = kPosition, std::string_view outputs = kOutputs) {
    return hear("18EFFF80", position).hear("18EFFF80", outputs);
  }
  // What the gateway sends for a monitor.
  Bus& node() { return hear("724", "05").hear("1A4", kPosition).hear("2A4", kOutputs); }
  Bus& asked() { return hear("18EF80F9", "02"); }
  Bus& answered(std::string_view faults = kNoFaults) { return asked().hear("18EFF980", faults); }
  // Its statuses come on for so long.
  Bus& goOn(Duration d) {
    for (Duration t = 0s; t < d; t += 100ms) pass(100ms).statuses();
    return *this;
  }

  const State& state() const { return m_state; }
  Instant now() const { return m_now; }
  const Device* device(std::string_view pin) const { return m_state.devices().byPin(*Pin::parse(pin)); }

 private:
  State m_state;
  Instant m_now{1'000'000'000};
};

// Keys of all causes, the worst first.
inline std::string listed(const Health& health) {
  std::string text;
  for (const HealthCause cause : kAllOf<HealthCause>) {
    if (!health.has(cause)) continue;
    if (!text.empty()) text += ' ';
    text += kHealthCauses[cause].key;
  }
  return text.empty() ? "fine" : text;
}
inline std::string listed(const Bus& bus, std::string_view pin = kPinA) {
  const Device* device = bus.device(pin);
  return device == nullptr ? "no device" : listed(healthOf(bus.state(), *device));
}

}  // namespace deckpipe::test
