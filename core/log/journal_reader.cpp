// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/journal_reader.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "log/journal_bytes.h"
#include "log/note_codec.h"

namespace deckpipe {
namespace {

using Bytes = std::span<const std::uint8_t>;

Bytes bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

class JournalReading {
 public:
  JournalReading(const LogBytes& bytes, const LogTarget& target, const ReadOptions& options)
      : m_bytes(bytes), m_target(target), m_options(options) {}

  Result<ReadSummary, ReadError> run() {
    std::string_view piece;
    const std::uint64_t size = m_bytes.size();
    if (std::string why = m_bytes.get(0, std::min<std::uint64_t>(size, JournalHead::kBytes), m_buffer, piece);
        !why.empty())
      return cannotRead(std::move(why));
    JournalHead head;
    m_summary.isOpenEnded = true;
    if (!takeJournalHead(bytesOf(piece), head)) return endAt(0);
    if (head.major > JournalHead::kMajor)
      return Failure{ReadError{ReadError::Kind::NewerVersion, std::to_string(head.major)}};
    for (std::uint64_t at = JournalHead::kBytes; at < size;) {
      if (size - at < kJournalBlockHead) return endAt(at);
      if (std::string why = m_bytes.get(at, at + kJournalBlockHead, m_buffer, piece); !why.empty())
        return cannotRead(std::move(why));
      const JournalBlockHead block = journalBlockHead(bytesOf(piece));
      const std::uint64_t next = at + kJournalBlockHead + block.length;
      if (block.length > kMostJournalContent || next > size) return endAt(at);
      if (std::string why = m_bytes.get(at, next, m_buffer, piece); !why.empty())
        return cannotRead(std::move(why));
      if (journalBlockCrc(bytesOf(piece)) != block.crc) return endAt(at);
      const Outcome outcome = take(block, bytesOf(piece).subspan(kJournalBlockHead));
      if (outcome == Outcome::Damaged) return endAt(at);
      if (outcome == Outcome::Full) return Failure{ReadError{ReadError::Kind::StoreFull, {}}};
      at = next;
      if (m_options.onProgress && !m_options.onProgress({at, size, m_target.frames.count()})) {
        m_summary.cancelled = true;
        break;
      }
    }
    return summary();
  }

 private:
  enum class Outcome : std::uint8_t { Taken, Damaged, Full };

  static Result<ReadSummary, ReadError> cannotRead(std::string why) {
    return Failure{ReadError{ReadError::Kind::CannotRead, std::move(why)}};
  }
  Result<ReadSummary, ReadError> summary() {
    m_summary.frames = m_target.frames.count();
    return m_summary;
  }
  Result<ReadSummary, ReadError> endAt(std::uint64_t at) {
    m_summary.cutBytes = m_bytes.size() - at;
    return summary();
  }

  Outcome take(const JournalBlockHead& block, Bytes content) {
    const auto type = static_cast<JournalBlock>(block.type);
    if (block.version == 0 && (!m_isBeyond || type == JournalBlock::End)) {
      switch (type) {
        case JournalBlock::Channel: return takeChannel(content);
        case JournalBlock::Clock:
          return takeClockBlock(content, m_offsets) ? Outcome::Taken : Outcome::Damaged;
        case JournalBlock::Notes: return takeNotes(content);
        case JournalBlock::Frames: return takeFrames(content);
        case JournalBlock::End: m_summary.isOpenEnded = false; return Outcome::Taken;
      }
    }
    using enum JournalBlock;
    if (type == Channel || type == Clock || type == Frames) m_isBeyond = true;
    ++m_summary.newerParts;
    return Outcome::Taken;
  }

  Outcome takeChannel(Bytes content) {
    std::uint8_t index = 0;
    std::string_view name;
    if (!takeChannelBlock(content, index, name)) return Outcome::Damaged;
    return m_target.frames.channel(name) == index ? Outcome::Taken : Outcome::Damaged;
  }

  Outcome takeNotes(Bytes content) {
    std::vector<Note> notes;
    std::uint64_t newer = 0;
    while (!content.empty()) {
      auto note = takeNote(content);
      if (!note) return Outcome::Damaged;
      if (auto* known = std::get_if<Note>(&note.value())) {
        notes.push_back(std::move(*known));
      } else {
        ++newer;
      }
    }
    m_summary.newerParts += newer;
    m_notes.insert(m_notes.end(), std::make_move_iterator(notes.begin()),
                   std::make_move_iterator(notes.end()));
    appendNotes();
    return Outcome::Taken;
  }

  // Those whose frame is the next one, or was read before.
  void appendNotes() {
    const std::uint64_t count = m_target.frames.count();
    std::vector<Note> later;
    for (Note& note : m_notes) {
      if (note.frame > count) {
        later.push_back(std::move(note));
      } else if (m_target.notes != nullptr) {
        m_target.notes->append(std::move(note));
      }
    }
    m_notes = std::move(later);
  }

  // Each note is there before its frame is, as it was live.
  Outcome takeFrames(Bytes content) {
    std::uint64_t first = 0;
    if (!takeFrameBlock(content, first, m_frames) || first != m_target.frames.count())
      return Outcome::Damaged;
    std::vector<ClockOffset> offsets;
    if (!takeOffsets(first, offsets)) return Outcome::Damaged;
    std::span<const ClockOffset> rest(offsets);
    for (std::span<const Frame> frames(m_frames); !frames.empty();) {
      const std::uint64_t at = first + (m_frames.size() - frames.size());
      std::uint64_t to = first + m_frames.size();
      for (const Note& note : m_notes) to = std::min(to, note.frame);
      const auto here = frames.first(to - at);
      if (!m_target.frames.restore(here, rest)) return Outcome::Full;
      while (!rest.empty() && rest.front().frame < to) rest = rest.subspan(1);
      frames = frames.subspan(here.size());
      appendNotes();
    }
    return Outcome::Taken;
  }

  // The offsets of this block's frames. False where they are of no such frame.
  bool takeOffsets(std::uint64_t first, std::vector<ClockOffset>& offsets) {
    for (const auto& [channel, offset] : std::exchange(m_offsets, {})) {
      const std::uint64_t i = offset.frame - first;
      const bool isAfter = offsets.empty() || offset.frame > offsets.back().frame;
      if (offset.frame < first || i >= m_frames.size() || m_frames[i].channel != channel || !isAfter)
        return false;
      offsets.push_back(offset);
    }
    return true;
  }

  const LogBytes& m_bytes;
  const LogTarget& m_target;
  const ReadOptions& m_options;
  std::vector<char> m_buffer;
  std::vector<Frame> m_frames;
  std::vector<ChannelOffset> m_offsets;  // of the next frames
  std::vector<Note> m_notes;             // of frames that were not read yet
  bool m_isBeyond = false;               // behind a block whose version is not known and is needed
  ReadSummary m_summary;
};

}  // namespace

Sniff sniffJournal(std::string_view head, bool isWhole) {
  const std::string_view magic = head.substr(0, kJournalMagic.size());
  if (magic == kJournalMagic) return Sniff::Yes;
  return !isWhole && kJournalMagic.starts_with(magic) ? Sniff::Open : Sniff::No;
}

Result<ReadSummary, ReadError> readJournal(const LogBytes& bytes, const LogTarget& target,
                                           const ReadOptions& options) {
  return JournalReading(bytes, target, options).run();
}

}  // namespace deckpipe
