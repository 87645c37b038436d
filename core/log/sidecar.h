// SPDX-License-Identifier: GPL-3.0-or-later
// The sidecar: a text file beside a log whose format has no place for notes (candump). It is named like the log
// with kSidecarSuffix, and holds the log's notes, the labels of its devices among them, and which of its frames
// were added on saving. openLog() reads it with the log; the log does not need it.
//
//   Deckpipe notes 1                               the version
//   frames 3                                       of the log
//   first (1696000000.000000) can0 18EFFF80#FF00   its first and last frame, as candump would write them; none
//   last (1696000001.000000) can0 18EFFF80#01      of a log without a frame
//   channel can0                                   one line each; notes name a channel by its place here, from 0
//   note 0 0 16 added count=1                      the frame it stands before, the ns since the frame before (of
//   note 2 500000000 6 mark text="water on"        the first: since that itself, so 0 or less), the note (note_text.h)
//   end 8 1C291CA3                                 lines with this one; CRC of zlib of all bytes before this line
//
//  1. Lines end with LF; the text is UTF-8. What follows the known fields of a note is skipped.
//  2. A note of a kind that this version does not know is counted and left out.
//  3. A sidecar that is cut, changed, of a newer version or of another log is not used at all.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "log/frame_store.h"
#include "log/note_store.h"
#include "log/reading.h"

namespace deckpipe {

inline constexpr std::string_view kSidecarSuffix = ".deckpipe-notes";
inline std::string sidecarPath(const std::string& logPath) { return logPath + std::string(kSidecarSuffix); }

struct Sidecar {
  struct PlacedNote {
    std::uint64_t frame = 0;
    Duration after{0};
    NoteValue value{};
  };
  std::uint64_t frames = 0;
  std::string first{}, last{};  // without a line end
  std::vector<std::string> channels{};
  std::vector<PlacedNote> notes{};
  std::uint64_t newerParts = 0;  // notes of a newer version, left out
};

// Gathers what belongs into the sidecar of a log while that is written: the calls of LogWriter, with channels
// by the names that they will have when the log is read.
class SidecarMaker {
 public:
  void channel(std::string_view name) { m_sidecar.channels.emplace_back(name); }
  void note(const Note& note);
  void frame(const Frame& frame, Instant time);
  // Empty if there is no note.
  std::string text() const;
  // Of a log that is there, as it was read.
  static std::string textOf(const FrameStore& frames, const NoteStore& notes);

 private:
  Sidecar m_sidecar;
  Frame m_last;
  Instant m_time{};  // of the last frame
};

// A fault names no path.
Result<Sidecar, SidecarFault> parseSidecar(std::string_view text);
// Appends the notes of a log that was read whole. A fault, if it is the sidecar of another log.
std::optional<SidecarFault> applySidecar(const Sidecar& sidecar, FrameStore& frames, NoteStore& notes);

// Whether anything has the name of the sidecar beside a log, a folder or a link to nothing among them.
bool hasSidecar(const std::string& logPath);
// Reads the sidecar beside a log that was read whole, if there is one, and adds to the summary what came of it.
void readSidecar(const std::string& logPath, FrameStore& frames, NoteStore& notes, ReadSummary& summary);

}  // namespace deckpipe
