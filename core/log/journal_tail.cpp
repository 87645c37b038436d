// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/journal_tail.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "log/journal_blocks.h"
#include "log/note_codec.h"

namespace deckpipe {
std::optional<JournalTail> readJournalTail(const LogBytes& bytes, std::uint64_t atMost) {
  const std::uint64_t size = bytes.size();
  std::vector<char> buffer;
  std::string_view piece;
  if (!bytes.get(size - std::min(size, atMost), size, buffer, piece).empty()) return {};
  JournalBlocks blocks(JournalBlocks::From::Anywhere);
  blocks.append(piece);
  blocks.end();

  std::optional<JournalTail> tail;
  std::array<std::optional<std::int64_t>, 256> offsets;
  std::vector<Note> notes;
  bool isEnded = false;
  for (auto block = blocks.next(); !block.empty(); block = blocks.next()) {
    const JournalBlockHead head = journalBlockHead(block);
    const auto content = block.subspan(kJournalBlockHead);
    if (head.version != 0) continue;
    std::vector<ChannelOffset> set;
    std::vector<Frame> frames;
    std::uint64_t first = 0;
    switch (static_cast<JournalBlock>(head.type)) {
      case JournalBlock::Clock:
        if (!takeClockBlock(content, set)) return {};
        for (const ChannelOffset& one : set) offsets[one.channel] = one.offset.offset;
        break;
      case JournalBlock::Frames: {
        if (!takeFrameBlock(content, first, frames)) return {};
        if (!tail) tail.emplace();
        tail->frames = first + frames.size();
        const auto last =
            std::find_if(frames.rbegin(), frames.rend(), [](const Frame& f) { return f.hasStamp(); });
        if (last != frames.rend()) tail->last = *last;
        break;
      }
      case JournalBlock::End: isEnded = true; break;
      case JournalBlock::Notes:
        for (auto rest = content; !rest.empty();) {
          const auto note = takeNote(rest);
          if (!note) break;
          if (const auto* known = std::get_if<Note>(&note.value())) notes.push_back(*known);
        }
        break;
      case JournalBlock::Channel: break;
    }
  }
  // A long silence leaves notes alone.
  if (!tail && !notes.empty()) {
    tail.emplace();
    tail->frames = std::ranges::max(notes, {}, &Note::frame).frame;
  }
  if (!tail) return {};
  if (tail->last) tail->offset = offsets[tail->last->channel];
  for (const Note& note : notes) {
    if (note.frame > tail->frames) continue;
    Instant& at = std::holds_alternative<note::RanUntil>(note.value) ? tail->ranUntil : tail->noted;
    at = std::max(at, note.time);
  }
  tail->isEnded = isEnded;
  tail->cutBytes = blocks.cutBytes();
  tail->isDamaged = blocks.damage().places > 0;
  return tail;
}

}  // namespace deckpipe
