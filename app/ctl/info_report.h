// SPDX-License-Identifier: GPL-3.0-or-later
// What `deckpipectl info` says of a log: gathered in one walk, printed as text or JSON.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "log/frame_store.h"
#include "log/link_gaps.h"
#include "log/reading.h"
#include "log/skipped.h"
#include "state/state.h"

namespace deckpipe::ctl {

class InfoReport {
 public:
  InfoReport(const FrameStore& frames, const NoteStore& notes, bool withDevices)
      : m_frames(frames), m_notes(notes), m_withDevices(withDevices) {}

  // Counts what has come since the last call.
  void countNew();
  enum class Times : std::uint8_t { Known, Deltas, None };
  // Evaluates the notes. Call it once, after the whole log was read. `times`: Deltas if those of its frames look like
  // differences.
  void takeNotes(Times times);
  std::string text(const std::string& file, const SkippedPlaces& skipped) const;
  std::string json(const std::string& file, const SkippedPlaces& skipped, LastLine lastLine) const;

 private:
  struct Key {  // in order of channel, then as candump sorts: 11-bit before 29-bit
    std::uint8_t channel;
    std::uint32_t id;
    friend auto operator<=>(const Key&, const Key&) = default;
  };

  struct Adapter {
    std::uint8_t channel;
    std::string words;
    std::uint32_t bitRate;  // 0: not known
    friend auto operator<=>(const Adapter&, const Adapter&) = default;
  };

  std::vector<LinkGap> gaps() const;
  std::string gapText(const LinkGap& gap) const;
  std::string gapJson(const LinkGap& gap) const;
  // Calls `take` with the channel, the source and the channel's name of every joystick source.
  template <typename Take>
  void eachStick(Take take) const;
  std::string_view labelOf(const Device& device) const;
  void appendNotes(std::string& out) const;
  Frame frameOf(const Key& key) const;
  std::uint64_t framesOfOthers() const;
  double spanSeconds() const;
  std::string spanText() const;
  Cursor endOfRecording() const;

  const FrameStore& m_frames;
  const NoteStore& m_notes;
  bool m_withDevices;
  std::uint64_t m_next = 0;
  std::map<Key, std::uint64_t> m_byId;
  std::uint64_t m_timeJumps = 0;
  Times m_times = Times::Known;
  // What the notes say of the log as a whole.
  std::set<Adapter> m_adapters;
  std::map<Pin, std::string> m_labels;
  std::uint64_t m_marks = 0, m_added = 0, m_missed = 0, m_missedLines = 0, m_missedPlaces = 0,
                m_placesNotWhole = 0;
  State m_state;
};

}  // namespace deckpipe::ctl
