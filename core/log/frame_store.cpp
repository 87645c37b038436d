// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/frame_store.h"

#include <algorithm>
#include <limits>

namespace deckpipe {
namespace {

// Puts whatever a stamp says before the begin of time.
constexpr std::int64_t kNoTimeOffset = std::numeric_limits<std::int64_t>::min();

constexpr std::uint64_t kChunkBytes = FrameStore::kChunkFrames * sizeof(Frame);

}  // namespace

FrameStore::FrameStore(StoreLimits limits) : m_limits(std::move(limits)) {}

FrameStore::~FrameStore() {
  for (auto& offsets : m_offsets) delete offsets.load(std::memory_order_relaxed);
}

// Where the next frames go: the rest of the last chunk, or a new one. Empty where there is no room at all.
std::span<Frame> FrameStore::room() {
  const std::uint64_t count = m_count.load(std::memory_order_relaxed);
  if (count / kChunkFrames == m_chunks.size()) {
    if (m_chunks.size() % kChunksTogether == 0) {
      constexpr std::uint64_t bytes = kChunksTogether * kChunkBytes;
      const std::uint64_t held = m_memory.size() * bytes - m_spilled.load(std::memory_order_relaxed);
      MappedMemory memory;
      if (held + bytes <= m_limits.memoryBytes) memory = MappedMemory::allocate(bytes);
      if (!memory) {
        memory = m_spill.next(bytes, m_limits.spillFolder);
        if (!memory) return {};
        m_spilled.fetch_add(bytes, std::memory_order_relaxed);
      }
      m_memory.push_back(std::move(memory));
    }
    std::byte* start = m_memory.back().start() + m_chunks.size() % kChunksTogether * kChunkBytes;
    m_chunks.append({reinterpret_cast<Frame*>(start), std::make_unique<std::int64_t[]>(kBlocks)});
  }
  return {m_chunks[count / kChunkFrames].frames + count % kChunkFrames, kChunkFrames - count % kChunkFrames};
}

// Copies what fits into one chunk after the other and publishes each chunk's part at once. `take(index,
// rest)` moves log time on for the first frame of `rest`, unless that frame must wait, which ends it.
template <typename TakeFrame>
FrameStore::Appended FrameStore::appendEach(std::span<const Frame> frames, TakeFrame take) {
  Appended done;
  while (!frames.empty() && !done.isWaiting) {
    const std::span<Frame> to = room();
    if (to.empty()) return {.frames = done.frames, .isFull = true};
    const std::size_t n = std::min(to.size(), frames.size());
    const std::uint64_t first = m_count.load(std::memory_order_relaxed);
    std::int64_t* timeBefore = m_chunks[first / kChunkFrames].timeBefore.get();
    // Copied as a whole, which memory likes best; the flags are touched where they differ.
    std::copy_n(frames.begin(), n, to.begin());
    std::size_t k = 0;
    for (; k < n; ++k) {
      const std::uint64_t i = first + k;
      const std::int64_t before = m_time;
      const Taken taken = take(i, frames.subspan(k));
      if (taken.mustWait) {
        done.isWaiting = true;
        break;
      }
      if (i % kBlock == 0) timeBefore[i % kChunkFrames / kBlock] = before;
      if (taken.isJump && m_jumps.size() < kMaxJumps) m_jumps.append(i);
      constexpr unsigned kOurs = Frame::kTimeJump | Frame::kLate;
      unsigned flags = frames[k].flags & ~kOurs;
      if (taken.isJump) flags |= Frame::kTimeJump;
      if (taken.isLate) flags |= Frame::kLate;
      if (flags != frames[k].flags) to[k].flags = static_cast<std::uint8_t>(flags);
    }
    m_count.store(first + k, std::memory_order_release);
    done.frames += k;
    frames = frames.subspan(k);
  }
  return done;
}

bool FrameStore::append(std::span<const Frame> frames, Follows follows) {
  if (!m_held.empty()) {
    m_held.insert(m_held.end(), frames.begin(), frames.end());
    frames = m_held;
  }
  const Appended done = appendEach(frames, [&](std::uint64_t i, std::span<const Frame> rest) {
    if (m_takesNoTimes) {
      const std::uint8_t channel = rest.front().channel;
      if (offsets(channel) == nullptr) addOffset(channel, {i, kNoTimeOffset, kNoStamp});
      return Taken{};
    }
    const FileClock::Verdict verdict = m_fileClock.next(rest, follows, m_time);
    switch (verdict.kind) {
      case FileClock::Kind::Undecided: return Taken{.mustWait = true};
      case FileClock::Kind::Timeless:
        if (verdict.isStep) addOffset(rest.front().channel, {i, verdict.offset, kNoStamp});
        break;
      case FileClock::Kind::NewOffset:
        addOffset(rest.front().channel, {i, verdict.offset, verdict.time});
        [[fallthrough]];
      case FileClock::Kind::Plain: m_time = std::max(m_time, verdict.time); break;
    }
    return Taken{.isJump = verdict.isStep};
  });
  std::vector<Frame> held(
      frames.begin() + static_cast<std::ptrdiff_t>(done.isWaiting ? done.frames : frames.size()),
      frames.end());
  m_held = std::move(held);
  return !done.isFull;
}

bool FrameStore::append(std::span<const Frame> frames, const Arrival& arrival) {
  const Appended done = appendEach(frames, [&](std::uint64_t i, std::span<const Frame> rest) {
    const LiveClock::Verdict verdict = m_liveClock.next(rest.front(), arrival, m_time);
    if (verdict.kind == LiveClock::Kind::NewOffset)
      addOffset(rest.front().channel, {i, verdict.offset, verdict.time});
    if (verdict.kind != LiveClock::Kind::Timeless) m_time = std::max(m_time, verdict.time);
    return Taken{.isJump = verdict.isJump, .isLate = verdict.isLate};
  });
  return !done.isFull;
}

bool FrameStore::restore(std::span<const Frame> frames, std::span<const ClockOffset> offsets) {
  const Appended done = appendEach(frames, [&](std::uint64_t i, std::span<const Frame> rest) {
    const Frame& frame = rest.front();
    if (!offsets.empty() && offsets.front().frame == i) {
      addOffset(frame.channel, offsets.front());
      offsets = offsets.subspan(1);
    }
    m_time = std::max(m_time, valueOf(i, frame));
    return Taken{.isJump = (frame.flags & Frame::kTimeJump) != 0,
                 .isLate = (frame.flags & Frame::kLate) != 0};
  });
  return !done.isFull;
}

void FrameStore::addOffset(std::uint8_t channel, ClockOffset offset) {
  auto& list = m_offsets[channel];
  if (!list.load(std::memory_order_relaxed))
    list.store(new StableList<ClockOffset>, std::memory_order_release);
  list.load(std::memory_order_relaxed)->append(offset);
}

const ClockOffset* FrameStore::offsetAt(std::uint8_t channel, std::uint64_t i) const {
  const StableList<ClockOffset>* list = m_offsets[channel].load(std::memory_order_acquire);
  if (!list) return nullptr;
  std::size_t low = 0;  // the number of offsets set at i or before it
  for (std::size_t high = list->size(); low < high;) {
    const std::size_t middle = high - (high - low + 1) / 2;
    if ((*list)[middle].frame <= i) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low == 0 ? nullptr : &(*list)[low - 1];
}

std::int64_t FrameStore::liveValueOf(std::uint64_t i, const Frame& frame) const {
  const ClockOffset* offset = offsetAt(frame.channel, i);
  if (!offset) return frame.stamp;
  if (offset->frame == i) return offset->at;
  return frame.hasStamp() ? saturatedPlus(frame.stamp, offset->offset) : kNoStamp;
}

std::span<const Frame> FrameStore::run(std::uint64_t i) const {
  const std::uint64_t n = count();
  if (i >= n) return {};
  return {&(*this)[i], std::min(n - i, kChunkFrames - i % kChunkFrames)};
}

Instant FrameStore::timeAt(std::uint64_t i) const {
  const Chunk& chunk = m_chunks[i / kChunkFrames];
  const std::uint64_t block = i / kBlock * kBlock;
  std::int64_t time = chunk.timeBefore[block % kChunkFrames / kBlock];
  for (std::uint64_t k = block; k <= i; ++k)
    time = std::max(time, valueOf(k, chunk.frames[k % kChunkFrames]));
  return {time};
}

std::uint64_t FrameStore::firstAtOrAfter(Instant t) const {
  const std::uint64_t n = count();
  if (n == 0 || t.ns <= 0) return 0;  // no log time is below 0
  // The last block with an earlier time before it holds the frame, if any does: first its chunk, then itself.
  const auto lastBefore = [t](std::uint64_t places, auto timeBefore) {
    std::uint64_t low = 0;
    for (std::uint64_t high = places; high - low > 1;) {
      const std::uint64_t middle = low + (high - low) / 2;
      (timeBefore(middle) < t.ns ? low : high) = middle;
    }
    return low;
  };
  const std::uint64_t c =
      lastBefore((n - 1) / kChunkFrames + 1, [this](std::uint64_t k) { return m_chunks[k].timeBefore[0]; });
  const Chunk& chunk = m_chunks[c];
  const std::uint64_t inChunk = std::min(n - c * kChunkFrames, kChunkFrames);
  const std::uint64_t b =
      lastBefore((inChunk - 1) / kBlock + 1, [&chunk](std::uint64_t k) { return chunk.timeBefore[k]; });
  const std::uint64_t end = c * kChunkFrames + std::min((b + 1) * kBlock, inChunk);
  std::uint64_t i = c * kChunkFrames + b * kBlock;
  while (i < end && valueOf(i, chunk.frames[i % kChunkFrames]) < t.ns) ++i;
  return i;
}

std::uint64_t FrameStore::firstAfter(Instant t) const {
  return t >= kNever ? count() : firstAtOrAfter(t + Duration{1});
}

Instant FrameStore::lastTime() const {
  const std::uint64_t n = count();
  return n == 0 ? Instant{} : timeAt(n - 1);
}

bool FrameStore::hasTimes() const { return count() == 0 || lastTime() != Instant{}; }

std::uint8_t FrameStore::channel(std::string_view name) {
  const std::lock_guard lock(m_namesLock);
  if (const auto known = m_indexOfName.find(name); known != m_indexOfName.end()) return known->second;
  if (m_names.size() > kOtherChannels) return kOtherChannels;
  const auto index = static_cast<std::uint8_t>(m_names.size());
  const std::string_view added = index == kOtherChannels ? kOtherChannelsName : name;
  m_names.push_back(m_indexOfName.emplace(added, index).first->first);
  return index;
}

std::string_view FrameStore::channelName(std::uint8_t index) const {
  const std::lock_guard lock(m_namesLock);
  return index < m_names.size() ? m_names[index] : std::string_view();
}

std::size_t FrameStore::channelCount() const {
  const std::lock_guard lock(m_namesLock);
  return m_names.size();
}

std::uint64_t FrameStore::indexBytes() const {
  std::uint64_t bytes = sizeof(*this) + m_chunks.size() * (sizeof(Chunk) + kBlocks * sizeof(std::int64_t));
  for (const auto& list : m_offsets) {
    if (const auto* offsets = list.load(std::memory_order_acquire)) {
      bytes += sizeof(*offsets) + offsets->size() * sizeof(ClockOffset);
    }
  }
  return bytes;
}

}  // namespace deckpipe
