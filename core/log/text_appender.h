// SPDX-License-Identifier: GPL-3.0-or-later
// The in-order half of reading text logs: what parsers made of one block after the other goes into the
// store, with line numbers and channels as they are in the whole text. One a reading, one thread at a time.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "log/delta_times.h"
#include "log/frame_store.h"
#include "log/reading.h"
#include "log/skipped.h"
#include "log/text_parser.h"
#include "log/time_grain.h"

namespace deckpipe {

// The store's index for each of one parser's channels.
class ChannelMap {
 public:
  void set(LocalChannel local, std::uint8_t index) {
    if (local == kUnnamedChannel) {
      m_unnamed = index;
      return;
    }
    if (local >= m_indexes.size()) m_indexes.resize(local + std::size_t{1});
    m_indexes[local] = index;
  }
  std::uint8_t operator[](LocalChannel local) const {
    return local == kUnnamedChannel ? m_unnamed : m_indexes[local];
  }

 private:
  std::vector<std::uint8_t> m_indexes;
  std::uint8_t m_unnamed = 0;
};

class TextAppender {
 public:
  TextAppender(FrameStore& store, SkippedList& skipped, bool addsUpTimes)
      : m_store(store), m_skipped(&skipped), m_addsUpTimes(addsUpTimes), m_isJudged(addsUpTimes) {}
  // Reports go there from now on.
  void reportTo(SkippedList& skipped) { m_skipped = &skipped; }

  // False where the store had no room.
  bool append(TextBlock& block, ChannelMap& channels) {
    for (const auto& [local, name] : block.channels) {
      channels.set(local, m_store.channel(local == kUnnamedChannel ? m_unnamedIs : name));
    }
    if (!block.header.empty()) m_unnamedIs = block.header;
    std::span<Frame> frames(block.frames.data(), block.count);
    for (Frame& frame : frames) {
      frame.channel = channels[static_cast<LocalChannel>(frame.channel | frame.spare << 8)];
      frame.spare = 0;
      if (m_addsUpTimes && frame.hasStamp()) frame.stamp = m_time = saturatedPlus(m_time, frame.stamp);
    }
    if (block.endsOpen && m_lines + block.lines > 1) {
      const bool isLeftOut = block.isLastFrameOpen && isShorterThanBefore(frames);
      m_lastLine = isLeftOut ? LastLine::LeftOut : LastLine::Open;
      if (isLeftOut) frames = frames.first(frames.size() - 1);
    }
    if (block.skipped.count(Skipped::Fraction) > 0) m_store.loseFractions();
    const std::uint64_t before = m_store.count();
    const bool fits = store(frames, Follows::More);
    m_skipped->add(block.skipped, m_lines);
    m_frames += m_store.count() - before;
    m_lines += block.lines;
    return fits;
  }

  // The end of the text, however it was reached. False where the store had no room.
  bool finish() {
    const std::uint64_t before = m_store.count();
    const bool fits = store({}, Follows::Nothing);
    m_frames += m_store.count() - before;
    return fits;
  }

  // A line of which a parser gets to see nothing.
  void appendTooLong() { m_skipped->add(++m_lines, Skipped::LineTooLong); }

  std::uint64_t lines() const { return m_lines; }
  std::uint64_t frames() const { return m_frames; }
  LastLine lastLine() const { return m_lastLine; }

 private:
  // The first frames wait until they tell whether their times are differences, and how fine they are.
  bool store(std::span<const Frame> frames, Follows follows) {
    if (m_isJudged) return m_store.append(frames, follows);
    m_first.insert(m_first.end(), frames.begin(), frames.end());
    const bool isOpen = sniffDeltaTimes(m_first) == Sniff::Open ||
                        (m_first.size() < kFewestGrains && areAtWholeSeconds(m_first));
    if (follows == Follows::More && isOpen) return true;
    m_isJudged = true;
    if (areDeltaTimes(m_first)) m_store.takeNoTimes();
    const bool fits = m_store.append(m_first, follows);
    m_first = {};
    return fits;
  }
  // Whether the last frame, whose line has no end, has fewer bytes than the same message had before, so that the rest
  // of it is missing. The same message: the last one of its identifier with its first byte, which tells most messages
  // of one identifier apart, or else the last one of its identifier.
  bool isShorterThanBefore(std::span<const Frame> frames) const;

  FrameStore& m_store;
  SkippedList* m_skipped;
  bool m_addsUpTimes;
  std::int64_t m_time = 0;  // ns; sum of the times so far
  std::string m_unnamedIs{kUnnamedInterface};
  std::uint64_t m_lines = 0;
  std::uint64_t m_frames = 0;
  bool m_isJudged;
  std::vector<Frame> m_first;  // before that
  LastLine m_lastLine = LastLine::Whole;
};

}  // namespace deckpipe
