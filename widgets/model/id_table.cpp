// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/id_table.h"

#include <algorithm>

#include "bus/j1939.h"
#include "model/frame_test.h"

namespace deckpipe {

// Channel, type byte of EF00 where there is one, identifier with its bits for extended, remote and error.
std::uint64_t IdTable::keyOf(const Frame& frame) {
  std::uint64_t key = frame.id | static_cast<std::uint64_t>(frame.channel) << 32;
  if (frame.isExtended() && !frame.isError() && !frame.isRemote() && frame.length > 0 &&
      J1939Id::of(frame.identifier()).pgn == pgn::kProprietaryA)
    key |= (std::uint64_t{0x100} | frame.data[0]) << 40;
  return key;
}

IdRow* IdTable::rowOf(std::uint64_t key) {
  constexpr std::size_t kSlots = 4 * kMax;
  if (m_slots.empty()) m_slots.resize(kSlots);
  std::size_t at = key * 0x9E37'79B9'7F4A'7C15 >> 51;
  static_assert(kSlots == std::size_t{1} << 13);
  for (;; at = (at + 1) % kSlots) {
    if (m_slots[at] == 0) break;
    IdRow& row = m_rows[m_slots[at] - 1u];
    if (row.key == key) return &row;
  }
  if (m_rows.size() == kMax) return nullptr;
  m_rows.push_back({.key = key});
  m_slots[at] = static_cast<std::uint16_t>(m_rows.size());
  return &m_rows.back();
}

void IdTable::walk(const FrameStore& frames, std::uint64_t end, FrameTest* test) {
  end = std::min(end, frames.count());
  LogTimes times(frames);
  for (; m_frames < end; ++m_frames) {
    const Frame& frame = frames[m_frames];
    const Instant now = times.at(m_frames);
    if (test != nullptr && !test->passes(m_frames, now)) continue;
    ++m_passed;
    IdRow* row = rowOf(keyOf(frame));
    if (row == nullptr) {
      ++m_others;
      continue;
    }
    if (row->count == 0) {
      row->begin = now;
    } else {
      const Frame& before = frames[row->lastFrame];
      row->before = before.data;
      row->lengthBefore = before.length;
      const Duration gap = now - row->last;
      const bool isPause = gap > 1s && row->periods > 0 && gap / kPause > *row->period();
      if (isPause) {
        row->begin = now;
        row->periods = 0;
        row->shortest = Duration::max();
        row->longest = Duration(0);
      } else {
        ++row->periods;
        row->shortest = std::min(row->shortest, gap);
        row->longest = std::max(row->longest, gap);
      }
    }
    ++row->count;
    row->last = now;
    row->lastFrame = m_frames;
  }
}

}  // namespace deckpipe
