// SPDX-License-Identifier: GPL-3.0-or-later
// A bus as it was heard, for tests of models, panels and the gallery: frames go into a State as the session
// would put them there, time passes, and a view of it all is taken.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "base/ids.h"
#include "state/log_view.h"
#include "support/frames.h"

namespace deckpipe::test {

inline constexpr char kPinA[] = "1032AE100801035";
inline constexpr char kAnnouncesA[] = "FF83150206021A0B";
inline constexpr char kAnnouncesB[] = "FF83150206021A0C";         // 1032AE100801036
inline constexpr char kNameOfA[] = "0B1AC22800420090";            // low 21 bits of A's serial
inline constexpr char kNameOfSerial2[] = "0200C02800420090";      // Akron's, of a PIN that ends in 000000002
inline constexpr char kLowerForeignName[] = "0100200000000000";   // maker 1
inline constexpr char kHigherForeignName[] = "01002001000000FF";  // maker 9
inline constexpr char kPosition[] = "011D940371000041";           // 47.3 right, 5.5 down, calibrated
inline constexpr char kSensorError[] = "01FFF4FFF4000004";        // both sensors, operational error
inline constexpr char kNotFitted[] = "01FFFFFFFF000001";
inline constexpr char kRotationLimits[] = "81FED401C200";  // -30 .. 45
inline constexpr char kOscillating[] = "81FED401C280";
inline constexpr char kElevationLimits[] = "82FF38038400";  // -20 .. 90
inline constexpr char kOutputs[] = "83C051";                // enable, active; LED, wireless, discharge
inline constexpr char kRestingStick[] = "0100010000000000";
inline constexpr char kStickRightBack[] = "107D046400100000";  // 50 % right, 40 % back
inline constexpr char kStickLeft[] = "04FA010000000000";       // 100 % left, Y neutral

class Heard {
 public:
  Heard() : m_document(std::make_shared<LogDocument>()) { m_document->frames.channel("can0"); }

  Heard& hear(std::string_view id, std::string_view data, std::uint8_t channel = 0) {
    m_state.apply(frame(id, data, channel), m_now);
    return *this;
  }
  Heard& hear(const Frame& f) {
    m_state.apply(f, m_now);
    return *this;
  }
  Heard& pass(Duration d) {
    m_now = m_now + d;
    m_state.timeCame(m_now);
    return *this;
  }
  Heard& note(const Note& note) {
    m_state.apply(note);
    return *this;
  }
  // A 6032 that sends everything.
  Heard& monitor(std::string_view position = kPosition, std::string_view limits = kRotationLimits) {
    return hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA).statuses(position, limits);
  }
  // What it repeats.
  Heard& statuses(std::string_view position = kPosition, std::string_view limits = kRotationLimits) {
    return hear("18EFFF80", position)
        .hear("18EFFF80", limits)
        .hear("18EFFF80", kElevationLimits)
        .hear("18EFFF80", kOutputs);
  }
  // It was asked for its faults, and answered.
  Heard& faults(std::string_view answer = "02000000000000") {
    return hear("18EF80F9", "02").hear("18EFF980", answer);
  }
  Instant now() const { return m_now; }
  const State& state() const { return m_state; }
  LogDocument& document() { return *m_document; }

  LogView view() const {
    LogView view;
    view.document = m_document;
    view.state = std::make_shared<State>(m_state);
    view.cursor = m_state.cursor();
    view.frameCount = m_state.cursor().frames;
    view.end = m_now;
    return view;
  }

 private:
  std::shared_ptr<LogDocument> m_document;
  State m_state;
  Instant m_now{1'000'000'000};
};

inline DeviceKey keyOfA() { return DeviceKey::of(*Pin::parse(kPinA)); }

// "FF…" of a PIN, as its device would announce it.
inline std::string announcementOf(std::string_view pin) {
  const Pin p = *Pin::parse(pin);
  const auto letter = [&](std::size_t i) { return static_cast<std::uint64_t>(p.text()[i]); };
  const std::uint64_t bits =
      letter(4) << 49 | letter(5) << 42 | std::uint64_t{p.deviceType()} << 30 | p.serial();
  char text[17];
  std::snprintf(text, sizeof text, "FF%014llX", static_cast<unsigned long long>(bits));
  return text;
}

}  // namespace deckpipe::test
