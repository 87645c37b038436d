// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of a journal: a recording with its frames, their log times, channels and notes, in one file that
// is whole up to its last block at any moment. JournalWriter writes it, readJournal() reads it. Numbers are
// little-endian; a CRC is that of zlib.
//
//   head, 28 bytes: 8 magic, 2 major and 2 minor version, 4 flags (1 simulated, 2 saved),
//                   8 begin (ns since 1970, UTC), 4 CRC of the 24 bytes before
//   block:          2 type, 2 version of the type, 4 length of the content, 4 CRC of the 8 bytes before and
//                   the content; then the content
//
//   Channel  1 index, then the name to the end of the block
//   Clock    25 bytes each: 1 channel, 8 frame, 8 offset, 8 log time of that frame (ClockOffset)
//   Notes    notes, one behind the other (note_codec.h)
//   Frames   8 index of the first, then 24 bytes each as in Frame: 8 stamp, 4 identifier, 8 data, 1 channel,
//            1 length, 1 flags, 1 spare
//   End      nothing: the recording was ended on purpose
//
//  1. Everything is appended. Only the head is written anew, in place, once the recording was saved.
//  2. A channel and the notes before a frame stand before the block of that frame. A clock block tells all
//     offsets that were set at the frames of the next frame block, in their order. Where no frame follows a
//     note, it stands at the end of the log; a note at an earlier frame was written down later.
//  3. A block whose CRC is wrong is left out; the next one is found by its own CRC (journal_blocks.h). A block
//     that is cut ends the journal. The head has this layout in every version; if its CRC is wrong, blocks that
//     are whole are read as those of this version.
//  4. Types and layouts are never changed and never used again. A later minor version may add types, and
//     versions of types. This one skips a type or a version of notes that it does not know; a version of
//     channels, clocks or frames that it does not know ends what it reads, since what follows depends on them.
//     All that was left out is counted as parts of a newer version. A later major version is refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "bus/frame.h"
#include "log/frame_store.h"
#include "log/note.h"

namespace deckpipe {

using JournalBytes = std::vector<std::uint8_t>;

struct JournalHead {
  static constexpr std::size_t kBytes = 28;
  static constexpr std::uint16_t kMajor = 1, kMinor = 0;

  std::uint16_t major = kMajor;
  bool isSimulated = false;  // of a simulated truck: never missed by anybody
  std::int64_t begin = 0;    // ns since 1970, UTC; 0 = not known
  bool isSaved = false;      // all of it was saved elsewhere, after it had ended

  friend bool operator==(const JournalHead&, const JournalHead&) = default;
};

inline constexpr std::string_view kJournalMagic{
    "\x89"
    "DPJ\r\n\x1A\n",
    8};

void appendJournalHead(JournalBytes& out, const JournalHead& head);
// The head at the beginning of `bytes`. False, and nothing of it is taken, if there is none or its CRC is wrong.
bool takeJournalHead(std::span<const std::uint8_t> bytes, JournalHead& head);

enum class JournalBlock : std::uint16_t { Channel = 1, Clock = 2, Notes = 3, Frames = 4, End = 5 };

inline constexpr std::size_t kJournalBlockHead = 12;
// Longer content is no content.
inline constexpr std::size_t kMaxJournalContent = std::size_t{1} << 20;
inline constexpr std::size_t kMaxJournalFrames = 8'192;  // of one block

// Each appends a whole block, or several if one does not suffice; nothing if there is nothing to write.
void appendChannelBlock(JournalBytes& out, std::uint8_t index, std::string_view name);
struct ChannelOffset {
  std::uint8_t channel = 0;
  ClockOffset offset;
};
void appendClockBlocks(JournalBytes& out, std::span<const ChannelOffset> offsets);
void appendNoteBlocks(JournalBytes& out, std::span<const Note> notes);
// At most kMaxJournalFrames.
void appendFrameBlock(JournalBytes& out, std::uint64_t first, std::span<const Frame> frames);
void appendEndBlock(JournalBytes& out);

struct JournalBlockHead {
  std::uint16_t type = 0;
  std::uint16_t version = 0;  // of the type; this program knows 0 of each
  std::uint32_t length = 0;
  std::uint32_t crc = 0;
};
// `bytes` has kJournalBlockHead.
JournalBlockHead journalBlockHead(std::span<const std::uint8_t> bytes);
// What the CRC of a block must be; `block` is head and content.
std::uint32_t journalBlockCrc(std::span<const std::uint8_t> block);

// What is in the content of a block. False if no version writes such content.
bool takeChannelBlock(std::span<const std::uint8_t> content, std::uint8_t& index, std::string_view& name);
bool takeClockBlock(std::span<const std::uint8_t> content, std::vector<ChannelOffset>& offsets);
bool takeFrameBlock(std::span<const std::uint8_t> content, std::uint64_t& first, std::vector<Frame>& frames);

}  // namespace deckpipe
