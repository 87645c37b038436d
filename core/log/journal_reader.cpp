// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/journal_reader.h"

#include <algorithm>
#include <optional>
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

// Takes the head and the blocks of a journal one after another, wherever they come from.
class JournalContent {
 public:
  enum class Outcome : std::uint8_t { Taken, Damaged, Full, NewerVersion };

  explicit JournalContent(const LogTarget& target) : m_target(target) { m_summary.isOpenEnded = true; }

  // `bytes`: as many as a head has, or all there are.
  Outcome takeHead(Bytes bytes) {
    if (!takeJournalHead(bytes, m_head)) return Outcome::Damaged;
    return m_head.major > JournalHead::kMajor ? Outcome::NewerVersion : Outcome::Taken;
  }
  // Of head and content.
  Outcome takeBlock(Bytes bytes) {
    const JournalBlockHead block = journalBlockHead(bytes);
    if (journalBlockCrc(bytes) != block.crc) return Outcome::Damaged;
    return take(block, bytes.subspan(kJournalBlockHead));
  }
  // How reading ended, if so many bytes at the end were not taken.
  Result<ReadSummary, ReadError> ended(Outcome outcome, std::uint64_t left) {
    if (outcome == Outcome::NewerVersion)
      return Failure{ReadError{ReadError::Kind::NewerVersion, std::to_string(m_head.major)}};
    if (outcome == Outcome::Full) return Failure{ReadError{ReadError::Kind::StoreFull, {}}};
    m_summary.frames = m_target.frames.count();
    m_summary.cutBytes = left;
    return m_summary;
  }
  void setCancelled() { m_summary.cancelled = true; }

 private:
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

  const LogTarget m_target;
  JournalHead m_head;
  std::vector<Frame> m_frames;
  std::vector<ChannelOffset> m_offsets;  // of the next frames
  std::vector<Note> m_notes;             // of frames that were not read yet
  bool m_isBeyond = false;               // behind a block whose version is not known and is needed
  ReadSummary m_summary;
};

using Outcome = JournalContent::Outcome;

// Of a block with its head, at the front of `bytes`; nothing if its head is not whole, or none.
std::optional<std::uint64_t> blockSize(Bytes bytes) {
  if (bytes.size() < kJournalBlockHead) return {};
  const std::uint64_t length = journalBlockHead(bytes).length;
  if (length > kMostJournalContent) return {};
  return kJournalBlockHead + length;
}

class JournalStream final : public StreamReader {
 public:
  explicit JournalStream(const LogTarget& target) : m_content(target) {}

  // What comes behind damage is counted.
  bool feed(std::string_view bytes) override {
    m_pending.append(bytes);
    std::size_t at = 0;
    while (m_outcome == Outcome::Taken) {
      const Bytes rest = bytesOf(m_pending).subspan(at);
      if (!m_hasHead) {
        if (rest.size() < JournalHead::kBytes) break;
        m_outcome = m_content.takeHead(rest.first(JournalHead::kBytes));
        m_hasHead = true;
        if (m_outcome == Outcome::Taken) at += JournalHead::kBytes;
        continue;
      }
      if (rest.size() < kJournalBlockHead) break;
      const auto size = blockSize(rest);
      if (size && rest.size() < *size) break;
      m_outcome = size ? m_content.takeBlock(rest.first(*size)) : Outcome::Damaged;
      if (m_outcome == Outcome::Taken) at += *size;
    }
    m_pending.erase(0, at);
    if (m_outcome == Outcome::Damaged) {
      m_left += m_pending.size();
      m_pending.clear();
    }
    return m_outcome == Outcome::Taken || m_outcome == Outcome::Damaged;
  }

  Result<ReadSummary, ReadError> finish() override {
    return m_content.ended(m_outcome, m_left + m_pending.size());
  }

 private:
  JournalContent m_content;
  std::string m_pending;  // from a head or block on that is not whole yet
  bool m_hasHead = false;
  Outcome m_outcome = Outcome::Taken;
  std::uint64_t m_left = 0;
};

}  // namespace

Sniff sniffJournal(std::string_view head, bool isWhole) {
  const std::string_view magic = head.substr(0, kJournalMagic.size());
  if (magic == kJournalMagic) return Sniff::Yes;
  return !isWhole && kJournalMagic.starts_with(magic) ? Sniff::Open : Sniff::No;
}

Result<ReadSummary, ReadError> readJournal(const LogBytes& bytes, const LogTarget& target,
                                           const ReadOptions& options) {
  JournalContent content(target);
  std::vector<char> buffer;
  std::string_view piece;
  const std::uint64_t size = bytes.size();
  std::uint64_t at = 0;
  const auto get = [&](std::uint64_t length) { return bytes.get(at, at + length, buffer, piece); };
  const auto cannotRead = [](std::string why) {
    return Failure{ReadError{ReadError::Kind::CannotRead, std::move(why)}};
  };
  if (std::string why = get(std::min<std::uint64_t>(size, JournalHead::kBytes)); !why.empty())
    return cannotRead(std::move(why));
  Outcome outcome = content.takeHead(bytesOf(piece));
  if (outcome == Outcome::Taken) at = JournalHead::kBytes;
  while (outcome == Outcome::Taken && at < size) {
    if (std::string why = get(std::min<std::uint64_t>(size - at, kJournalBlockHead)); !why.empty())
      return cannotRead(std::move(why));
    const auto length = blockSize(bytesOf(piece));
    if (!length || *length > size - at) break;
    if (std::string why = get(*length); !why.empty()) return cannotRead(std::move(why));
    outcome = content.takeBlock(bytesOf(piece));
    if (outcome != Outcome::Taken) break;
    at += *length;
    if (options.onProgress && !options.onProgress({at, size, target.frames.count()})) {
      content.setCancelled();
      return content.ended(outcome, 0);
    }
  }
  return content.ended(outcome, size - at);
}

std::unique_ptr<StreamReader> streamJournal(const LogTarget& target, const ReadOptions&) {
  return std::make_unique<JournalStream>(target);
}

}  // namespace deckpipe
