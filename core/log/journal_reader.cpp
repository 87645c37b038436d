// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/journal_reader.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "log/journal_blocks.h"
#include "log/note_codec.h"

namespace deckpipe {
namespace {

using Bytes = std::span<const std::uint8_t>;

// Read at a time.
constexpr std::uint64_t kPiece = 64 * 1024;
// A channel of which neither the clock nor the silence before it is known, as its blocks may be lost, goes on
// where its stamps do so within this time; otherwise at the time of the frame before.
constexpr std::int64_t kMaxUnsure = 3'600'000'000'000;

// Puts what is in the blocks of a journal into a log, one block after another. Frames, notes and clock offsets
// name a frame by its place in the whole recording; where blocks are lost the log's own places are lower.
class JournalContent {
 public:
  enum class Outcome : std::uint8_t { Taken, Damaged, Full };

  explicit JournalContent(const LogTarget& target) : m_target(target) { m_summary.isOpenEnded = true; }

  // Of head and content, whole. Nothing of a damaged one is taken.
  Outcome takeBlock(Bytes bytes) { return take(journalBlockHead(bytes), bytes.subspan(kJournalBlockHead)); }
  // Here blocks of any kind may be missing.
  void setGap() {
    m_isGap = true;
    m_noted.reset();
    m_unsure.set();
  }
  // The summary without the damaged places, of which `damagedBytes` is the size.
  ReadSummary ended(std::uint64_t damagedBytes) {
    // A note behind the gap tells how many frames are lost there, if so many bytes can hold them.
    const std::uint64_t noted = m_noted.value_or(0);
    const bool isTold = m_noted && noted >= m_next && noted - m_next <= damagedBytes / sizeof(Frame);
    if (m_isGap && isTold && noted > m_next) lose(noted);
    m_summary.damage.isOpen = m_isGap && !isTold;
    // Their frames are lost; they are not.
    if (m_isGap) m_next = std::numeric_limits<std::uint64_t>::max();
    appendNotes();
    m_summary.frames = m_target.frames.count();
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
    FrameStore& frames = m_target.frames;
    if (index < frames.channelCount())
      return frames.channelName(index) == name ? Outcome::Taken : Outcome::Damaged;
    nameChannelsBefore(index);
    return frames.channel(name) == index ? Outcome::Taken : Outcome::Damaged;
  }

  // The blocks that named them are lost.
  void nameChannelsBefore(std::size_t end) {
    FrameStore& frames = m_target.frames;
    while (frames.channelCount() < end) {
      const std::size_t index = frames.channelCount();
      std::string name = "name-lost-" + std::to_string(index);
      while (frames.channel(name) != index) name += '-';
    }
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
    for (Note& note : notes) {
      const std::uint64_t frame = note.frame;
      m_noted = std::max(m_noted.value_or(0), frame);
      m_notes.emplace(frame, std::move(note));
    }
    appendNotes();
    return Outcome::Taken;
  }

  // Those whose frame is the next one, or was read before.
  void appendNotes() {
    const auto later = m_notes.upper_bound(m_next);
    for (auto at = m_notes.begin(); at != later && m_target.notes != nullptr; ++at) {
      at->second.frame = placeInLog(at->first);
      m_target.notes->append(std::move(at->second));
    }
    m_notes.erase(m_notes.begin(), later);
  }

  // A frame that is lost has the place of the next one that is there.
  std::uint64_t placeInLog(std::uint64_t frame) const {
    const auto after = std::ranges::upper_bound(m_lost, frame, {}, &Lost::begin);
    std::uint64_t place = frame;
    if (after != m_lost.begin()) {
      const Lost& lost = *std::prev(after);
      place = std::max(frame, lost.end) - lost.total;
    }
    return std::min(place, m_target.frames.count());
  }

  // Each note is there before its frame is, as it was live.
  Outcome takeFrames(Bytes content) {
    std::uint64_t first = 0;
    if (!takeFrameBlock(content, first, m_frames) || first < m_next || (first > m_next && !m_isGap) ||
        first > std::numeric_limits<std::uint64_t>::max() - m_frames.size())
      return Outcome::Damaged;
    std::vector<ClockOffset> offsets;
    if (!takeOffsets(first, offsets)) return Outcome::Damaged;
    std::size_t channels = 0;
    for (const Frame& frame : m_frames) channels = std::max<std::size_t>(channels, frame.channel + 1u);
    nameChannelsBefore(channels);
    if (first > m_next) lose(first);
    m_isGap = false;
    appendNotes();
    if (m_unsure.any() || !offsets.empty()) followClocks(offsets);
    std::span<const ClockOffset> rest(offsets);
    for (std::span<const Frame> frames(m_frames); !frames.empty();) {
      std::uint64_t to = first + m_frames.size();
      if (!m_notes.empty()) to = std::min(to, m_notes.begin()->first);
      const auto here = frames.first(to - m_next);
      if (!m_target.frames.restore(here, rest)) return Outcome::Full;
      while (!rest.empty() && rest.front().frame < m_target.frames.count()) rest = rest.subspan(1);
      frames = frames.subspan(here.size());
      m_next = to;
      appendNotes();
    }
    return Outcome::Taken;
  }

  // The frames up to this one are missing.
  void lose(std::uint64_t first) {
    m_summary.damage.frames += first - m_next;
    m_lost.push_back({m_next, first, m_summary.damage.frames});
    if (m_target.notes != nullptr)
      m_target.notes->append({.frame = m_target.frames.count(),
                              .time = m_target.frames.lastTime(),
                              .value = note::LeftOut{{}, note::LeftOut::Why::Damaged, first - m_next}});
    m_next = first;
  }

  // The offsets of this block's frames, at their places in the log. False where they are of no such frame.
  // Those of lost frames are remembered.
  bool takeOffsets(std::uint64_t first, std::vector<ClockOffset>& offsets) {
    for (const auto& [channel, offset] : std::exchange(m_offsets, {})) {
      const std::uint64_t i = offset.frame - first;
      const std::uint64_t place = m_target.frames.count() + i;
      const bool isLost = m_isGap && offset.frame >= m_next && offset.frame < first;
      const bool isAfter = offsets.empty() || place > offsets.back().frame;
      if (isLost) {
        m_knownTime = std::max(m_knownTime, offset.at);
        m_offsetOf[channel] = offset.offset;
        continue;
      }
      if (offset.frame < first || i >= m_frames.size() || m_frames[i].channel != channel || !isAfter)
        return false;
      offsets.push_back({place, offset.offset, offset.at});
    }
    return true;
  }

  // Follows the clocks through this block. Behind a gap each channel whose clock is not sure is given an offset at its
  // first frame. Log times never fall, so none may come to lie behind one that a later block tells.
  void followClocks(std::vector<ClockOffset>& offsets) {
    const std::uint64_t place = m_target.frames.count();
    std::int64_t time = m_target.frames.lastTime().ns;
    if (m_unsure.any()) time = std::max(time, m_knownTime);
    std::vector<ClockOffset> all;
    auto own = offsets.begin();
    for (std::size_t i = 0; i < m_frames.size(); ++i) {
      const Frame& frame = m_frames[i];
      std::int64_t& offset = m_offsetOf[frame.channel];
      if (own != offsets.end() && own->frame == place + i) {
        m_unsure.reset(frame.channel);
        offset = own->offset;
        time = std::max(time, own->at);
        all.push_back(*own++);
        continue;
      }
      if (!frame.hasStamp()) continue;
      if (m_unsure.test(frame.channel)) {
        m_unsure.reset(frame.channel);
        const std::int64_t away = saturatedMinus(saturatedPlus(frame.stamp, offset), time);
        if (away > kMaxUnsure || away < -kMaxUnsure) offset = saturatedMinus(time, frame.stamp);
        all.push_back({place + i, offset, saturatedPlus(frame.stamp, offset)});
      }
      time = std::max(time, saturatedPlus(frame.stamp, offset));
    }
    offsets = std::move(all);
  }

  const LogTarget m_target;
  // Frames [begin, end) of the recording, and how many are lost with all before them.
  struct Lost {
    std::uint64_t begin, end, total;
  };

  std::uint64_t m_next = 0;  // frame of the recording
  std::vector<Lost> m_lost;
  bool m_isGap = false;                        // blocks are missing since the last frames
  std::optional<std::uint64_t> m_noted;        // behind them: the last place of a note
  std::bitset<256> m_unsure;                   // channels whose clock may have been in a block that is lost
  std::int64_t m_knownTime = 0;                // log time of a frame that is lost
  std::array<std::int64_t, 256> m_offsetOf{};  // in force on each channel
  std::vector<Frame> m_frames;
  std::vector<ChannelOffset> m_offsets;        // of the next frames
  std::multimap<std::uint64_t, Note> m_notes;  // by their frames, which were not read yet
  bool m_isBeyond = false;                     // behind a block whose version is not known and is needed
  ReadSummary m_summary;
};

using Outcome = JournalContent::Outcome;

class JournalStream final : public StreamReader {
 public:
  explicit JournalStream(const LogTarget& target) : m_content(target) {}

  bool feed(std::string_view bytes) override {
    m_blocks.append(bytes);
    takeAll();
    return m_outcome != Outcome::Full && !m_blocks.newerVersion();
  }

  Result<ReadSummary, ReadError> finish() override {
    m_blocks.end();
    takeAll();
    if (const auto version = m_blocks.newerVersion())
      return Failure{ReadError{ReadError::Kind::NewerVersion, std::to_string(*version)}};
    if (m_outcome == Outcome::Full) return Failure{ReadError{ReadError::Kind::StoreFull, {}}};
    if (m_blocks.isNothingWhole()) return Failure{ReadError{ReadError::Kind::Damaged, {}}};
    return summary();
  }
  // Reading ends before the log does.
  ReadSummary cancel() {
    ReadSummary read = summary();
    read.cancelled = true;
    return read;
  }

 private:
  void takeAll() {
    while (m_outcome != Outcome::Full) {
      const Bytes block = m_blocks.next();
      if (std::exchange(m_damagedBytes, m_blocks.damage().bytes) != m_blocks.damage().bytes)
        m_content.setGap();
      if (block.empty()) return;
      m_outcome = m_content.takeBlock(block);
      if (m_outcome == Outcome::Damaged) m_blocks.reject();
    }
  }
  ReadSummary summary() {
    ReadSummary read = m_content.ended(m_blocks.damage().bytes);
    const Damage missing = read.damage;
    read.damage = m_blocks.damage();
    read.damage.frames = missing.frames;
    read.damage.isOpen = missing.isOpen;
    read.cutBytes = m_blocks.cutBytes();
    return read;
  }

  JournalBlocks m_blocks;
  JournalContent m_content;
  Outcome m_outcome = Outcome::Taken;
  std::uint64_t m_damagedBytes = 0;  // so far
};

// A file that has a block of a journal is one, even if its first bytes are not whole.
Sniff sniffDamaged(std::string_view head, bool isWhole) {
  // The head and the first block have zeroes; a text, which may be a pipe that is to be shown at once, has none.
  if (head.substr(0, JournalHead::kBytes + kJournalBlockHead).find('\0') == std::string_view::npos)
    return Sniff::No;
  JournalBlocks blocks(JournalBlocks::From::Anywhere);
  blocks.append(head.substr(0, kSniffBytes));
  blocks.end();
  if (!blocks.next().empty()) return Sniff::Yes;
  return isWhole || head.size() >= kSniffBytes ? Sniff::No : Sniff::Open;
}

}  // namespace

Sniff sniffJournal(std::string_view head, bool isWhole) {
  const std::string_view magic = head.substr(0, kJournalMagic.size());
  if (magic == kJournalMagic) return Sniff::Yes;
  if (!isWhole && kJournalMagic.starts_with(magic)) return Sniff::Open;
  return sniffDamaged(head, isWhole);
}

Result<ReadSummary, ReadError> readJournal(const LogBytes& bytes, const LogTarget& target,
                                           const ReadOptions& options) {
  JournalStream stream(target);
  std::vector<char> buffer;
  std::string_view piece;
  const std::uint64_t size = bytes.size();
  for (std::uint64_t at = 0; at < size;) {
    const std::uint64_t end = std::min(size, at + kPiece);
    if (std::string why = bytes.get(at, end, buffer, piece); !why.empty())
      return Failure{ReadError{ReadError::Kind::CannotRead, std::move(why)}};
    if (!stream.feed(piece)) break;
    at = end;
    if (options.onProgress && !options.onProgress({at, size, target.frames.count()})) return stream.cancel();
  }
  return stream.finish();
}

std::unique_ptr<StreamReader> streamJournal(const LogTarget& target, const ReadOptions&) {
  return std::make_unique<JournalStream>(target);
}

}  // namespace deckpipe
