// SPDX-License-Identifier: GPL-3.0-or-later
// A log that a test tells frame by frame, and the events of it. Time is the story's own and starts at one second.
#pragma once

#include <string_view>

#include "state/advance.h"
#include "state/event_walk.h"
#include "support/event_lines.h"
#include "support/frames.h"

namespace deckpipe::test {

class EventStory {
 public:
  static constexpr char kPinA[] = "1032AE100801035", kPinB[] = "1032AE100801036";
  static constexpr char kAnnouncesA[] = "FF83150206021A0B", kAnnouncesB[] = "FF83150206021A0C";
  static constexpr char kNameOfA[] = "0B1AC22800420090", kNameOfB[] = "0C1AC22800420090";
  static constexpr char kLowerName[] = "0100200000000000", kHigherName[] = "01002001000000FF";
  static constexpr char kPosition[] = "011D940371000041";  // 47.3 right, 5.5 down, calibrated
  static constexpr char kOutputs[] = "83C051";
  static constexpr char kNoFaults[] = "02000000000000";

  EventStory& hear(std::string_view id, std::string_view data, std::uint8_t channel = 0) {
    return hear(frame(id, data, channel));
  }
  EventStory& hear(Frame f) {
    f.stamp = m_now.ns;
    if (!m_frames.append({&f, 1})) std::abort();
    return *this;
  }
  EventStory& errorFrame(std::uint32_t errorClass, std::uint8_t controller = 0) {
    Frame f = frame("000", "0000000000000000");
    f.id = kErrorBit | errorClass;
    f.data[1] = controller;
    return hear(f);
  }
  EventStory& note(const NoteValue& value) {
    m_notes.append({.frame = m_frames.count(), .time = m_now, .value = value});
    return *this;
  }
  EventStory& pass(Duration d) {
    m_now = m_now + d;
    return *this;
  }
  // A 6032 at 80 with what it repeats; the story begins 5 s later, when its channel has settled.
  EventStory& monitor() { return hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA).goOn(5s); }
  EventStory& statuses(std::string_view position = kPosition, std::string_view outputs = kOutputs) {
    return hear("18EFFF80", position).hear("18EFFF80", outputs);
  }
  // Its statuses come for so long, every 100 ms.
  EventStory& goOn(Duration d, std::string_view position = kPosition, std::string_view outputs = kOutputs) {
    for (Duration t = 0s; t < d; t += 100ms) statuses(position, outputs).pass(100ms);
    return *this;
  }
  // The link was down for 40 s.
  EventStory& gap() { return note(note::LinkDown{}).pass(40s).note(note::LinkUp{}); }
  EventStory& asksForNames() { return hear("18EAFFF9", "00EE00"); }
  EventStory& answers(std::string_view faults) { return hear("18EF80F9", "02").hear("18EFF980", faults); }
  // A joystick sends every 20 ms for so long.
  EventStory& stick(Duration d, std::string_view id = "0CFDD633", std::string_view data = kNeutral,
                    Duration period = 20ms) {
    for (Duration t = 0s; t < d; t += period) hear(id, data).pass(period);
    return *this;
  }
  static constexpr char kNeutral[] = "0100010000000000", kRight[] = "907D010000000000";

  Instant now() const { return m_now; }
  const FrameStore& frames() const { return m_frames; }
  const NoteStore& notes() const { return m_notes; }
  Cursor end() const { return {m_frames.count(), m_now}; }
  std::vector<Event> events() const {
    EventWalk walk;
    std::vector<Event> events;
    walk.advance(m_frames, m_notes, end(), events);
    return events;
  }
  std::vector<std::string> lines() const { return linesOf(events()); }

 private:
  FrameStore m_frames;
  NoteStore m_notes;
  Instant m_now{1'000'000'000};
};

}  // namespace deckpipe::test
