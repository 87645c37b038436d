// SPDX-License-Identifier: GPL-3.0-or-later
// The address books, and so the roles, at any frame of a log, from the few frames, notes and times that
// changed them. A worker calls build() while the log grows; the trace takes a walk() from its first visible
// row on. Rows beyond what is built yet are classified with what is known so far. The worker looks at frames
// without the lock, for the window asks on every tick.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "log/frame_store.h"
#include "log/note_store.h"
#include "state/role_notes.h"

namespace deckpipe {

class RoleIndex {
 public:
  RoleIndex(const FrameStore& frames, const NoteStore& notes) : m_frames(frames), m_notes(notes) {}

  // Looks at up to so many further frames. False where there was none.
  bool build(std::uint64_t atMost);
  std::uint64_t built() const;
  // A walk that stands before frame `i`: its next() wants exactly that one.
  RoleWalk walk(std::uint64_t i) const;
  // Where somebody who goes through a log, but classifies few of its frames, stands: going on is cheap.
  struct Stand {
    RoleWalk walk;
    std::size_t changes = 0;  // that are in the walk
    std::uint64_t generation = 0;
  };
  // What frame `i` of the log is, as the first next() of its walk() says.
  Classified classify(std::uint64_t i, const Frame& frame, Instant time, Stand& stand) const;
  // What is known of a channel when frame `i` comes, and once it has come; valid until the stand moves.
  const AddressBook& bookBefore(std::uint64_t i, Channel channel, Stand& stand) const;
  const AddressBook& bookAfter(std::uint64_t i, Channel channel, Stand& stand) const;
  // A drive was said or unsaid before a frame that was built already: everything behind is built anew.
  void invalidateAfter(std::uint64_t frame);

 private:
  // Replaying the frames, notes and times that changed a book gives the same books as replaying all: what a
  // frame is depends on its book alone. A walk is kept every so many of them.
  static constexpr std::size_t kKeepEvery = 512;
  struct Change {
    enum class Kind : std::uint8_t {
      Time,  // a contest was decided: first of what happens before the frame or note at that time
      Note,
      Frame,
    };
    std::uint64_t frame;  // the frame; of the other kinds the one that they stand before
    Instant time;
    Kind kind;
    RoleNote said;  // Kind::Note
  };
  void take(RoleWalk& walk, const Change& change) const;
  // The changes before frame `i`: its time and its notes come before it, its own lesson does not.
  std::size_t changesBefore(std::uint64_t i) const;
  std::size_t changesAfter(std::uint64_t i) const;
  void walkTo(std::size_t changes, Stand& stand) const;

  const FrameStore& m_frames;
  const NoteStore& m_notes;
  mutable std::mutex m_lock;
  std::vector<Change> m_changes;
  std::vector<RoleWalk> m_kept;  // [i] is after (i + 1) * kKeepEvery changes
  RoleWalk m_end;                // after all changes
  std::uint64_t m_built = 0;
  std::uint64_t m_generation = 0;  // of what was built: invalidating begins another
};

}  // namespace deckpipe
