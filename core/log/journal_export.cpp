// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/journal_export.h"

#include <algorithm>
#include <array>
#include <vector>

#include "log/journal_bytes.h"

namespace deckpipe {
namespace {

// So many are lost by one wrong bit.
constexpr std::size_t kFramesOfBlock = 256;
static_assert(kFramesOfBlock <= kMaxJournalFrames);

// Of the log only frames and their log times are known: an offset is written wherever a frame's time does not
// follow from its stamp and the offset before (FrameStore says how it does).
class JournalExport final : public LogWriter {
 public:
  void begin(std::string& out) override {
    appendJournalHead(m_bytes, {});
    moveTo(out);
  }

  void channel(std::string_view name, std::string& out) override {
    flush();
    appendChannelBlock(m_bytes, m_channels++, name);
    moveTo(out);
  }

  void note(const Note& note, std::string&) override { m_notes.push_back(note); }

  void frame(const Frame& frame, Instant time, std::string& out) override {
    std::int64_t& offset = m_offsetOf[frame.channel];
    const std::int64_t told = frame.hasStamp() ? saturatedPlus(frame.stamp, offset) : m_time;
    if (std::max(m_time, told) != time.ns) {
      if (frame.hasStamp()) offset = saturatedMinus(time.ns, frame.stamp);
      m_offsets.push_back({frame.channel, {m_first + m_frames.size(), offset, time.ns}});
    }
    m_time = time.ns;
    m_frames.push_back(frame);
    if (m_frames.size() < kFramesOfBlock) return;
    flush();
    moveTo(out);
  }

  void end(std::string& out) override {
    flush();
    appendEndBlock(m_bytes);
    moveTo(out);
  }

 private:
  // What stands before frames comes first.
  void flush() {
    appendNoteBlocks(m_bytes, m_notes);
    appendClockBlocks(m_bytes, m_offsets);
    appendFrameBlock(m_bytes, m_first, m_frames);
    m_first += m_frames.size();
    m_notes.clear();
    m_offsets.clear();
    m_frames.clear();
  }
  void moveTo(std::string& out) {
    out.append(reinterpret_cast<const char*>(m_bytes.data()), m_bytes.size());
    m_bytes.clear();
  }

  JournalBytes m_bytes;
  std::uint8_t m_channels = 0;
  std::uint64_t m_first = 0;  // of m_frames
  std::vector<Frame> m_frames;
  std::vector<Note> m_notes;
  std::vector<ChannelOffset> m_offsets;
  std::array<std::int64_t, 256> m_offsetOf{};
  std::int64_t m_time = 0;  // log time of the last frame
};

}  // namespace

std::unique_ptr<LogWriter> makeJournalExport() { return std::make_unique<JournalExport>(); }

}  // namespace deckpipe
