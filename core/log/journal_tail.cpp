// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/journal_tail.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "log/journal_bytes.h"

namespace deckpipe {
namespace {

using Bytes = std::span<const std::uint8_t>;

// The size of the block at the front of `bytes` with its head; 0 if there is no whole one.
std::size_t wholeBlock(Bytes bytes) {
  if (bytes.size() < kJournalBlockHead) return 0;
  const JournalBlockHead head = journalBlockHead(bytes);
  if (head.length > kMostJournalContent || head.length > bytes.size() - kJournalBlockHead) return 0;
  const std::size_t size = kJournalBlockHead + head.length;
  return journalBlockCrc(bytes.first(size)) == head.crc ? size : 0;
}

// Whether a block of this version may begin here, or so few bytes are left that nothing tells.
bool mayBegin(Bytes bytes) {
  if (bytes.size() < kJournalBlockHead) return true;
  const JournalBlockHead head = journalBlockHead(bytes);
  return head.type >= 1 && head.type <= 5 && head.version == 0 && head.length <= kMostJournalContent;
}

// The same of a whole one with something behind it that may be one: a look at few bytes, for there are many
// places to look at.
bool mayBeWhole(Bytes bytes) {
  if (bytes.size() < kJournalBlockHead || !mayBegin(bytes)) return false;
  const std::size_t size = kJournalBlockHead + journalBlockHead(bytes).length;
  return size <= bytes.size() && mayBegin(bytes.subspan(size));
}

}  // namespace

std::optional<JournalTail> readJournalTail(const LogBytes& bytes, std::uint64_t atMost) {
  const std::uint64_t size = bytes.size();
  std::vector<char> buffer;
  std::string_view piece;
  if (!bytes.get(size - std::min(size, atMost), size, buffer, piece).empty()) return {};
  Bytes rest(reinterpret_cast<const std::uint8_t*>(piece.data()), piece.size());
  while (!rest.empty() && !(mayBeWhole(rest) && wholeBlock(rest) > 0)) rest = rest.subspan(1);

  std::optional<JournalTail> tail;
  std::array<std::optional<std::int64_t>, 256> offsets;
  bool isEnded = false;
  for (std::size_t block = wholeBlock(rest); block > 0; block = wholeBlock(rest)) {
    const JournalBlockHead head = journalBlockHead(rest);
    const Bytes content = rest.first(block).subspan(kJournalBlockHead);
    rest = rest.subspan(block);
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
      case JournalBlock::Channel:
      case JournalBlock::Notes: break;
    }
  }
  if (!tail) return {};
  if (tail->last) tail->offset = offsets[tail->last->channel];
  tail->isEnded = isEnded;
  tail->cutBytes = rest.size();
  return tail;
}

}  // namespace deckpipe
