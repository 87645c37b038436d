// SPDX-License-Identifier: GPL-3.0-or-later
// FrameStore: the log. Everything that came from an adapter, a simulator or a file stands here in order and
// stays. The bus thread or a reader of files appends; views, index and exports read on other threads while it
// grows: take count() once and look at anything below it.
//
// Log time (design: "Two times") is a pure function of what the store holds, so every reader sees the same:
//   time(i) = max(0, the values of all frames up to i), where the value of a frame is
//     - its stamp plus the offset in force on its channel (0 until an offset was set),
//     - the time that was set with the offset, for the frame at which an offset was set,
//     - nothing for a frame without a time of its own: it keeps the time before.
// The rules for offsets are in file_clock.h and, for live frames (append with an Arrival), in live_clock.h.
//
// Frame::kTimeJump and Frame::kLate are set here and only here: the first on each step of a channel's clock,
// the second on a live frame that belongs before what was already shown.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/time.h"
#include "bus/frame.h"
#include "log/file_clock.h"
#include "log/live_clock.h"
#include "log/mapped_memory.h"
#include "log/stable_list.h"

namespace deckpipe {

// A change of the clock of a channel: log time is stamp + `offset` from this frame of the channel on.
struct ClockOffset {
  std::uint64_t frame = 0;
  std::int64_t offset = 0;  // ns
  std::int64_t at = 0;      // log time of this very frame in ns; kNoStamp: it has no time of its own

  friend bool operator==(const ClockOffset&, const ClockOffset&) = default;
};

struct StoreLimits {
  std::uint64_t memoryBytes = std::uint64_t{2} << 30;  // frames beyond this live in a temporary file …
  std::string spillFolder = "/var/tmp";  // … in this folder (not /tmp: that often is memory too)
};

class FrameStore {
 public:
  static constexpr std::uint64_t kChunkFrames = 65'536;
  // Of a log that jumps more often the others are found by their flag alone.
  static constexpr std::size_t kMaxJumps = 10'000;
  // Names beyond the 255th share this index, so that no log has too many channels.
  static constexpr std::uint8_t kOtherChannels = 255;
  static constexpr std::string_view kOtherChannelsName = "other";

  explicit FrameStore(StoreLimits limits = {});
  ~FrameStore();
  FrameStore(const FrameStore&) = delete;
  FrameStore& operator=(const FrameStore&) = delete;

  // --- The writer; one thread at a time.

  // False where neither memory nor disk had room: then the frames up to count() are kept, the rest is not.
  // A reader that has more of the file says so: where a clock steps near the end of `frames`, up to
  // FileClock::kLookAhead frames then wait for the next call. The last call is Follows::Nothing, with no
  // frame perhaps, however the reading ended.
  [[nodiscard]] bool append(std::span<const Frame> frames, Follows follows = Follows::Nothing);
  // From now on no frame of the file has a time: what its stamps say is none.
  void takeNoTimes() { m_takesNoTimes = true; }
  // The fractions of some stamps of the file were not read.
  void loseFractions() { m_hasLostFractions.store(true, std::memory_order_relaxed); }
  // Live frames, as they arrive.
  [[nodiscard]] bool append(std::span<const Frame> frames, const Arrival& arrival);
  // Frames of a store that was written down, with the log times that they had there. `offsets` are those that
  // were set at these frames, in the order of the frames; kTimeJump and kLate are taken from the frames.
  [[nodiscard]] bool restore(std::span<const Frame> frames, std::span<const ClockOffset> offsets);

  // --- Readers, on any thread.

  std::uint64_t count() const { return m_count.load(std::memory_order_acquire); }
  const Frame& operator[](std::uint64_t i) const {
    return m_chunks[i / kChunkFrames].frames[i % kChunkFrames];
  }
  // The frames from i on that lie side by side in memory: up to the chunk's end or the count. Empty at the
  // end.
  std::span<const Frame> run(std::uint64_t i) const;

  Instant timeAt(std::uint64_t i) const;
  // The first frame at `t` or later, the first one later than `t`; count() where there is none.
  std::uint64_t firstAtOrAfter(Instant t) const;
  std::uint64_t firstAfter(Instant t) const;
  // The first kMaxJumps frames with Frame::kTimeJump, some of them perhaps beyond count().
  const StableList<std::uint64_t>& jumps() const { return m_jumps; }
  // The offsets that were set on a channel, some of them perhaps beyond count(). Null if there never was one.
  const StableList<ClockOffset>* offsets(std::uint8_t channel) const {
    return m_offsets[channel].load(std::memory_order_acquire);
  }
  // What log time is ahead of the stamps of a channel at a frame, in ns.
  std::int64_t offsetOf(std::uint8_t channel, std::uint64_t i) const {
    const ClockOffset* offset = offsetAt(channel, i);
    return offset == nullptr ? 0 : offset->offset;
  }
  // Log time of the last frame; 0 in an empty store.
  Instant lastTime() const;
  // Whether log time means anything. False where no frame has a time, neither a stamp other than 0 nor the time when
  // it arrived: then all of them stand at 0, and ages, rates and spans are not to be told. True in an empty store.
  bool hasTimes() const;
  // How fine log time is (time_grain.h).
  bool hasLostFractions() const { return m_hasLostFractions.load(std::memory_order_relaxed); }

  // Index of a channel's name, added where it is new. Any thread.
  std::uint8_t channel(std::string_view name);
  // Empty where there is no such channel; valid as long as the store.
  std::string_view channelName(std::uint8_t index) const;
  std::size_t channelCount() const;

  // What the store holds beside its frames, and how much of the frames lies on disk: for the budget's test.
  std::uint64_t indexBytes() const;
  std::uint64_t spilledBytes() const { return m_spilled.load(std::memory_order_relaxed); }

 private:
  friend class LogTimes;
  // Log time before the first frame of every kBlock frames: a look-up scans at most one block.
  static constexpr std::uint64_t kBlock = 32;
  static constexpr std::uint64_t kBlocks = kChunkFrames / kBlock;
  // Chunks are allocated four at a time: 6 MB, three huge pages.
  static constexpr std::uint64_t kChunksTogether = 4;

  struct Chunk {
    Frame* frames = nullptr;
    std::unique_ptr<std::int64_t[]> timeBefore;
  };
  struct Taken {
    bool isJump = false;
    bool isLate = false;
    bool mustWait = false;  // for more frames of the file
  };
  struct Appended {
    std::size_t frames = 0;  // published
    bool isFull = false;     // there was no room for the next one
    bool isWaiting = false;  // the next one waits for more frames
  };

  std::span<Frame> room();
  template <typename TakeFrame>
  Appended appendEach(std::span<const Frame> frames, TakeFrame take);
  void addOffset(std::uint8_t channel, ClockOffset offset);
  // The offset in force on a channel at a frame; null before the first.
  const ClockOffset* offsetAt(std::uint8_t channel, std::uint64_t i) const;
  // What a frame says about the time; the lowest number where it says nothing, which kNoStamp is.
  std::int64_t valueOf(std::uint64_t i, const Frame& frame) const {
    return m_offsets[frame.channel].load(std::memory_order_acquire) ? liveValueOf(i, frame) : frame.stamp;
  }
  std::int64_t liveValueOf(std::uint64_t i, const Frame& frame) const;

  const StoreLimits m_limits;
  StableList<Chunk> m_chunks;
  StableList<std::uint64_t> m_jumps;
  std::atomic<std::uint64_t> m_count = 0;
  std::array<std::atomic<StableList<ClockOffset>*>, 256> m_offsets{};  // null on channels that never had one

  // The writer's own.
  std::vector<MappedMemory> m_memory;
  SpillFile m_spill;
  std::atomic<std::uint64_t> m_spilled = 0;
  std::int64_t m_time = 0;  // log time after the last frame
  bool m_takesNoTimes = false;
  std::atomic<bool> m_hasLostFractions = false;
  FileClock m_fileClock;
  LiveClock m_liveClock;
  std::vector<Frame> m_held;  // of a file: from a step on that is not decided yet

  mutable std::mutex m_namesLock;
  std::map<std::string, std::uint8_t, std::less<>> m_indexOfName;
  std::vector<std::string_view> m_names;  // the keys of the map, which never move
};

// Log times one after another, for whoever walks through the store (state, exports): next to free where the
// frames are asked for in order, and right in any order. One user each.
class LogTimes {
 public:
  explicit LogTimes(const FrameStore& store) : m_store(store) {}
  Instant at(std::uint64_t i) {
    if (i == m_next) {
      m_time = std::max(m_time, m_store.valueOf(i, m_store[i]));
    } else if (i + 1 != m_next) {
      m_time = m_store.timeAt(i).ns;
    }
    m_next = i + 1;
    return {m_time};
  }

 private:
  const FrameStore& m_store;
  std::uint64_t m_next = 0;
  std::int64_t m_time = 0;
};

}  // namespace deckpipe
