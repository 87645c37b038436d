// SPDX-License-Identifier: GPL-3.0-or-later
// Arbitrary bytes as a journal: as they are, and as blocks whose CRCs are right, so that every content is
// reached. No crash; and what was read, written down again, is read as the same.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "log/journal_reader.h"
#include "log/journal_writer.h"

namespace {

using namespace deckpipe;

void demand(bool condition) {
  if (!condition) std::abort();
}

struct Reading {
  // Nothing of it belongs on disk, and the usual budget would only cost time.
  FrameStore frames{{.memoryBytes = 64 << 20, .spillFolder = "/nonexistent"}};
  NoteStore notes;
  SkippedList skipped;

  Result<ReadSummary, ReadError> read(const JournalBytes& bytes) {
    return readJournal(BytesInMemory({reinterpret_cast<const char*>(bytes.data()), bytes.size()}),
                       {frames, skipped, &notes}, {});
  }
  Instant end() const { return std::max({frames.lastTime(), notes.lastTime(), notes.ranUntil()}); }
};

class MemoryFile final : public JournalFile {
 public:
  explicit MemoryFile(JournalBytes& bytes) : m_bytes(bytes) {}
  std::string path() const override { return {}; }
  JournalFault append(std::uint64_t offset, std::span<const std::uint8_t> bytes) override {
    demand(offset == m_bytes.size());
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
    return {};
  }
  JournalFault sync() override { return {}; }
  JournalFault check() override { return {}; }

 private:
  JournalBytes& m_bytes;
};

// Of two bytes type and length, then the content, again and again.
JournalBytes blocksOf(std::span<const std::uint8_t> data) {
  JournalBytes bytes;
  appendJournalHead(bytes, {});
  while (data.size() >= 2) {
    const std::size_t length = std::min<std::size_t>(data[1], data.size() - 2);
    const std::size_t begin = bytes.size();
    bytes.resize(begin + kJournalBlockHead);
    bytes[begin] = data[0] % 8;
    bytes[begin + 4] = static_cast<std::uint8_t>(length);
    bytes.insert(bytes.end(), data.begin() + 2, data.begin() + 2 + static_cast<std::ptrdiff_t>(length));
    const std::uint32_t crc = journalBlockCrc(std::span(bytes).subspan(begin));
    std::memcpy(bytes.data() + begin + 8, &crc, sizeof crc);
    data = data.subspan(2 + length);
  }
  return bytes;
}

void readAndWriteAgain(const JournalBytes& bytes) {
  Reading read;
  const auto result = read.read(bytes);
  if (!result) return;
  JournalBytes written;
  JournalWriter writer(
      read.frames, read.notes,
      [&]() -> MadeJournalFile { return MadeJournalFile(std::make_unique<MemoryFile>(written)); },
      [] { return JournalHead{}; });
  writer.timeCame({});
  writer.end();
  if (read.frames.count() == 0) return demand(written.empty());
  Reading again;
  const auto second = again.read(written);
  demand(bool(second) && second.value().cutBytes == 0 && !second.value().isOpenEnded);
  demand(again.frames.count() == read.frames.count());
  for (std::uint64_t i = 0; i < read.frames.count(); ++i) {
    demand(again.frames[i] == read.frames[i]);
    demand(again.frames.timeAt(i) == read.frames.timeAt(i));
  }
  demand(again.notes.all() == read.notes.all());
  demand(again.end() == read.end());
  demand(again.frames.channelCount() == read.frames.channelCount());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> input(data, size);
  readAndWriteAgain(blocksOf(input));
  JournalBytes bare;
  appendJournalHead(bare, {});
  bare.insert(bare.end(), input.begin(), input.end());
  readAndWriteAgain(bare);
  readAndWriteAgain(JournalBytes(input.begin(), input.end()));
  return 0;
}
