// SPDX-License-Identifier: GPL-3.0-or-later
// NoteStore: the facts of a log that no frame carries, ordered by the frame they stand before: the link came
// or went, frames were lost, the transmit lock, marks, 'this address is a drive'. What a person sees is a
// function of frames, notes and cursor, so whatever else changes the picture is written down here. One writer
// at a time, readers on any thread; notes are few, so a lock is all it takes.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/ids.h"
#include "base/time.h"

namespace deckpipe {

enum class NoteKind : std::uint8_t {
  LinkUp,       // channel
  LinkDown,     // channel; text: the adapter's own words
  Dropped,      // channel; number: frames lost before this place
  Locked,       // transmit lock set
  Unlocked,     // transmit lock released
  Mark,         // text: the person's
  DriveSaid,    // channel, address: a person said that a Copley drive is there
  DriveUnsaid,  // channel, address: … and took it back
  OwnAddress,   // channel; address: ours from here on, null = none; text: how it came to that
  Asked,        // channel, address; number: Ask; text: the PIN
  AskEnded,     // channel, address; number: Ask, in its second byte RequestEnd; text: the PIN
  AskWaits,     // channel, address; number: Ask; text: the PIN. Handed over, but not on the bus yet
  StillWaits,   // channel; number: frames handed over and not on the bus yet, at a lock or the like
  Pipe,         // channel, address; number: PipeEvent; text: the PIN, and the file's name
};

// The word for a kind in files; never changes once shipped. Back: nothing where there is no such word.
std::string_view noteKey(NoteKind kind);
std::optional<NoteKind> noteKind(std::string_view key);

struct Note {
  std::uint64_t frame = 0;  // stands before this frame; the store's count where it is the last thing so far
  Instant time{};
  NoteKind kind = NoteKind::Mark;
  Channel channel{};
  Address address{};
  std::uint64_t number = 0;
  std::string text{};

  friend bool operator==(const Note&, const Note&) = default;
};

class NoteStore {
 public:
  // Of the text only so much is kept.
  static constexpr std::size_t kMaxText = 200;

  // At the end of the notes that stand before the same frame; earlier frames are allowed (marks in a replay).
  void append(Note note);
  std::size_t count() const;
  // The notes that stand before a frame in [from, to), in order.
  std::vector<Note> between(std::uint64_t from, std::uint64_t to) const;
  std::vector<Note> all() const;

 private:
  mutable std::mutex m_lock;
  std::vector<Note> m_notes;
};

}  // namespace deckpipe
