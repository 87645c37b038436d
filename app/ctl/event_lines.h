// SPDX-License-Identifier: GPL-3.0-or-later
// Events and notes of a log as lines, for `deckpipectl events`: one JSON object each, or text for people.
#pragma once

#include <string>

#include "json_line.h"
#include "log/frame_store.h"
#include "log/note.h"
#include "state/event.h"

namespace deckpipe::ctl {

class EventLines {
 public:
  EventLines(const FrameStore& frames, bool asJson) : m_frames(frames), m_asJson(asJson) {}

  // The store must hold a frame.
  void append(std::string& out, const Event& event) const;
  void append(std::string& out, const Note& note) const;
  // In nanoseconds, as the clock of a channel had it at a frame; kNoStamp in a log without stamps.
  std::int64_t stampOf(Instant time, std::uint8_t channel, std::uint64_t frame) const;

 private:
  std::string whenText(Instant time) const;
  std::string begin(std::string_view key, Severity weight, Instant time, std::string_view channel) const;
  std::string json(const Event& event) const;
  std::string text(const Event& event) const;
  std::string json(const Note& note) const;
  std::int64_t stampOf(const Event& event) const;
  std::int64_t stampOf(const Note& note) const;

  const FrameStore& m_frames;
  bool m_asJson;
};

// Adds what changed: the fields of an event beside its time and whom it is about.
void addEventFields(JsonLine& line, const Event& event);
// Adds the fields of a note beside its time, its channel and whom it is about.
void addNoteFields(JsonLine& line, const NoteValue& value);

// The paragraph of --help with every key and what it means.
std::string eventKeysHelp();

}  // namespace deckpipe::ctl
