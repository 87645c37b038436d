// SPDX-License-Identifier: GPL-3.0-or-later
// What `deckpipectl info` says of a log: gathered in one walk, printed as text or JSON.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "log/frame_store.h"
#include "log/unkept.h"
#include "state/state.h"

namespace deckpipe::ctl {

class InfoReport {
 public:
  InfoReport(const FrameStore& frames, const NoteStore& notes, bool withDevices)
      : m_frames(frames), m_notes(notes), m_times(frames), m_withDevices(withDevices) {}

  // Counts what has come since the last call.
  void countNew();
  std::string text(const std::string& file, const UnkeptPlaces& unkept) const;
  std::string json(const std::string& file, const UnkeptPlaces& unkept) const;

 private:
  struct Key {  // in order of channel, then as candump sorts: 11-bit before 29-bit
    std::uint8_t channel;
    std::uint32_t id;
    friend auto operator<=>(const Key&, const Key&) = default;
  };

  Frame frameOf(const Key& key) const;
  bool hasTimes() const;
  double spanSeconds() const;

  const FrameStore& m_frames;
  const NoteStore& m_notes;
  LogTimes m_times;
  bool m_withDevices;
  std::uint64_t m_next = 0;
  std::map<Key, std::uint64_t> m_byId;
  std::uint64_t m_timeJumps = 0;
  State m_state;
};

}  // namespace deckpipe::ctl
