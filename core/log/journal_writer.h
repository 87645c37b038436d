// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a log down while it grows: reads store and notes as any reader does, so that whoever fills them
// never waits for a disk. A worker calls timeCame() a few times a second, and end() when the log has ended and
// takes no more. One thread at a time.
//
// 1. The file is made when the first frame is there. A log without a frame leaves none.
// 2. What was written is on the disk within a second, if timeCame() comes every 250 ms.
// 3. A fault loses nothing: the log is in memory, and what the disk did not take is written again kRetry
//    later, from the last block that is known to be whole. status() says so meanwhile.
// 4. While the log goes on and nothing comes (NoteStore::ranUntil()), the file is told so before each sync: what ends
//    without an end ends within a second of where it was cut.
// 5. The file is looked at each second. If it was removed, or another program wrote into it, all of the log is
//    written to a new file: at the next call, or, if the file had been made for that reason, kRetry after it was made if
//    that is later.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/time.h"
#include "log/journal_bytes.h"
#include "log/journal_file.h"
#include "log/note_store.h"

namespace deckpipe {

struct JournalStatus {
  std::string path{};        // empty until there is a file
  std::uint64_t frames = 0;  // written
  std::uint64_t bytes = 0;   // written
  JournalFault fault{};      // why nothing is written at the moment
  bool isEnded = false;
  // Why the file before this one was given up: Removed or Changed. All that was in it is in this one.
  JournalFault givenUp{};

  friend bool operator==(const JournalStatus&, const JournalStatus&) = default;
};

class JournalWriter {
 public:
  static constexpr Duration kSync = 500ms;
  static constexpr Duration kRetry = 10s;

  using MakeFile = std::function<MadeJournalFile()>;
  // `begin` of the head is asked for when the file is made.
  using MakeHead = std::function<JournalHead()>;

  JournalWriter(const FrameStore& frames, const NoteStore& notes, MakeFile makeFile, MakeHead makeHead)
      : m_frames(frames), m_notes(notes), m_makeFile(std::move(makeFile)), m_makeHead(std::move(makeHead)) {}

  // Writes what is new. `now` is of any clock that never goes back.
  void timeCame(Instant now);
  // Writes what is left and that this is the end, at once even after a fault. After a fault it may be called
  // again.
  void end();

  JournalStatus status() const;

 private:
  // How far the log is in the file.
  struct Place {
    std::uint64_t bytes = 0;
    std::uint64_t frames = 0;
    std::size_t notes = 0;
    std::size_t channels = 0;
    Instant ranUntil = kNotYet;
    std::array<std::size_t, 256> offsets{};
  };

  // All that is new; with `tellsSilence` also how long nothing has come since.
  JournalFault write(bool tellsSilence);
  JournalFault writeRanUntil(Instant time);
  JournalFault writeEnd();
  JournalFault create();
  // Appends to m_buffer what is new of the first `count` frames, of frames a block at most, and of `notes`
  // those that stand before these. True if more is left.
  bool collect(Place& place, std::uint64_t count, std::span<const Note>& notes);
  void collectOffsets(Place& place, std::span<const Frame> frames);
  JournalFault sync();
  JournalFault check();
  void tryEnd();

  const FrameStore& m_frames;
  const NoteStore& m_notes;
  MakeFile m_makeFile;
  MakeHead m_makeHead;

  std::unique_ptr<JournalFile> m_file;
  JournalHead m_head;
  Place m_written;
  Place m_safe;  // on the disk for certain
  JournalBytes m_buffer;
  std::vector<ChannelOffset> m_offsets;
  JournalFault m_fault;
  JournalFault m_givenUp;
  Instant m_madeAt = kNotYet;
  bool m_isAnew = false;  // the file was made as the one before it was given up
  Instant m_retryAt = kNotYet;
  Instant m_syncAt = kNotYet;
  bool m_isEnded = false;
};

}  // namespace deckpipe
