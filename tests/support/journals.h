// SPDX-License-Identifier: GPL-3.0-or-later
// Journals for tests: a recording to write down, a disk in memory that does what the test says, and what
// reading gives back.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "log/journal_reader.h"
#include "log/journal_writer.h"
#include "support/frames.h"
#include "support/note_samples.h"

namespace deckpipe::test {

// What is on a disk that a test watches.
struct FakeDisk {
  JournalBytes bytes;
  JournalBytes synced;          // what is left of it after a power cut
  std::size_t room = SIZE_MAX;  // bytes
  int failingSyncs = 0;         // so many calls of sync() fail, and forget what was not synced before
  int made = 0;
  std::size_t appends = 0;

  class File;
  JournalWriter::MakeFile maker();
};

class FakeDisk::File final : public JournalFile {
 public:
  explicit File(FakeDisk& disk) : m_disk(disk) {}
  std::string path() const override { return "fake"; }
  JournalFault append(std::uint64_t offset, std::span<const std::uint8_t> bytes) override {
    ++m_disk.appends;
    m_disk.bytes.resize(offset);
    const std::size_t fits = std::min(bytes.size(), m_disk.room - std::min<std::size_t>(m_disk.room, offset));
    // A disk writes what it has room for.
    m_disk.bytes.insert(m_disk.bytes.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(fits));
    if (fits < bytes.size()) return {JournalFault::Kind::DiskFull, "No space left on device"};
    return {};
  }
  JournalFault sync() override {
    if (m_disk.failingSyncs > 0) {
      --m_disk.failingSyncs;
      std::fill(m_disk.bytes.begin() + static_cast<std::ptrdiff_t>(m_disk.synced.size()), m_disk.bytes.end(),
                0);
      return {JournalFault::Kind::CannotWrite, "Input/output error"};
    }
    m_disk.synced = m_disk.bytes;
    return {};
  }
  JournalFault check() override { return {}; }

 private:
  FakeDisk& m_disk;
};

inline JournalWriter::MakeFile FakeDisk::maker() {
  return [this]() -> MadeJournalFile {
    ++made;
    return MadeJournalFile(std::make_unique<File>(*this));
  };
}

inline JournalHead someHead() { return {.isSimulated = false, .begin = 1'796'000'000'000'000'000}; }

// A log, from a bus or read back.
struct Recording {
  FrameStore frames;
  NoteStore notes;
  SkippedList skipped;
  Result<ReadSummary, ReadError> result = ReadSummary{};

  LogTarget target() { return {frames, skipped, &notes}; }
  void read(std::span<const std::uint8_t> bytes, const ReadOptions& options = {}) {
    result = readLog(BytesInMemory({reinterpret_cast<const char*>(bytes.data()), bytes.size()}), target(),
                     options);
  }

  // Two live channels, one of the wall clock and one with a base of its own; a clock that is set, a frame that
  // is late, one without a time; every kind of note, some before the same frame.
  void fill(std::size_t rounds = 1) {
    const std::uint8_t wall = frames.channel("can0"), own = frames.channel("can1");
    std::int64_t now = 1'000'000'000 + 50'000'000 * static_cast<std::int64_t>(frames.count());
    std::vector<NoteValue> samples = noteSamples();
    for (std::size_t round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i % 3 != 0)
          notes.append(
              {.frame = frames.count(), .time = {now}, .value = samples[(i + round) % samples.size()]});
        now += 10'000'000;
        Frame frame = test::frame("18EFFF80", i % 2 ? "0102030405060708" : "A1B2");
        frame.channel = i % 4 == 3 ? own : wall;
        const Duration wallOffset{i < 5 ? 77'000'000 : -900'000'000};
        frame.stamp = frame.channel == wall ? now - wallOffset.count() : now / 2;
        if (i == 6) frame.stamp = kNoStamp;
        if (i == 8) frame.stamp -= 60'000'000;
        frame.flags = i % 5 == 0 ? Frame::kSent | Frame::kConfirmed : 0;
        Arrival arrival{.now = {now + 1'000'000}, .reached = {now - 20'000'000}};
        if (frame.channel == wall) arrival.wallOffset = wallOffset;
        (void)frames.append({&frame, 1}, arrival);
      }
    }
    notes.append({.frame = frames.count(), .time = {now}, .value = note::Mark{"the last"}});
  }
};

inline JournalBytes journalOf(const Recording& recording, bool isEnded = true) {
  FakeDisk disk;
  JournalWriter writer(recording.frames, recording.notes, disk.maker(), someHead);
  writer.timeCame({});
  if (isEnded) writer.end();
  return disk.bytes;
}

// Everything of a frame, with its log time.
inline std::string told(const FrameStore& frames, std::uint64_t i) {
  const Frame& f = frames[i];
  std::string text = std::to_string(frames.timeAt(i).ns) + " " + std::to_string(f.stamp) + " " +
                     std::string(frames.channelName(f.channel)) + " " + std::to_string(f.id) + " " +
                     std::to_string(f.flags);
  for (const std::uint8_t byte : f.bytes()) text += " " + std::to_string(byte);
  return text;
}
inline std::vector<std::string> told(const FrameStore& frames) {
  std::vector<std::string> all;
  for (std::uint64_t i = 0; i < frames.count(); ++i) all.push_back(told(frames, i));
  return all;
}

}  // namespace deckpipe::test
