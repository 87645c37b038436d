// SPDX-License-Identifier: GPL-3.0-or-later
// Arbitrary bytes through the block reader, on one thread and on two, and through the stream: the same
// frames, channels, reports and ends, and no crash. The first two bytes choose how the text is cut.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "log/candump.h"
#include "log/log_stream.h"

namespace {

using namespace deckpipe;

struct Reading {
  // Nothing of it belongs on disk, and the usual budget would only cost time.
  FrameStore store{{.memoryBytes = 64 << 20, .spillFolder = "/nonexistent"}};
  SkippedList skipped;
  Result<ReadSummary, ReadError> result = ReadSummary{};
};

void demand(bool condition) {
  if (!condition) std::abort();
}

void demandEqual(const Reading& a, const Reading& b) {
  demand(bool(a.result) == bool(b.result));
  if (a.result) {
    demand(a.result.value() == b.result.value());
  } else {
    demand(a.result.error() == b.result.error());
  }
  demand(a.store.count() == b.store.count());
  for (std::uint64_t i = 0; i < a.store.count(); ++i) {
    demand(a.store[i] == b.store[i]);
    demand(a.store.timeAt(i) == b.store.timeAt(i));
  }
  demand(a.store.channelCount() == b.store.channelCount());
  for (std::size_t i = 0; i < a.store.channelCount(); ++i) {
    const auto index = static_cast<std::uint8_t>(i);
    demand(a.store.channelName(index) == b.store.channelName(index));
  }
  demand(a.skipped.content().places() == b.skipped.content().places());
  demand(a.skipped.content().unreadable() == b.skipped.content().unreadable());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const std::size_t block = data[0] * 8u + 1, piece = data[1] * 4u + 1;
  const std::string_view text(reinterpret_cast<const char*>(data) + 2, size - 2);

  Reading whole;
  whole.result = readLog(BytesInMemory(text), {whole.store, whole.skipped});

  Reading blocks;
  ReadOptions options;
  options.threads = 1 + data[0] % 2;
  options.blockBytes = block;
  blocks.result = readLog(BytesInMemory(text), {blocks.store, blocks.skipped}, options);
  demandEqual(whole, blocks);

  Reading pieces;
  LogStream stream({pieces.store, pieces.skipped});
  for (std::size_t at = 0; at < text.size() && stream.feed(text.substr(at, piece)); at += piece) {
  }
  pieces.result = stream.finish();
  const bool needsFile = !pieces.result && pieces.result.error().kind == ReadError::Kind::NoPipe;
  if (needsFile) return 0;  // it looks like a recording
  demandEqual(whole, pieces);

  // What was read can be written, and reads back as itself.
  std::string written;
  for (std::uint64_t i = 0; i < whole.store.count(); ++i) {
    const Frame& frame = whole.store[i];
    writeCandump(frame, whole.store.channelName(frame.channel), written);
  }
  Reading back;
  back.result = readLog(BytesInMemory(written), {back.store, back.skipped});
  demand(back.store.count() == whole.store.count());
  for (std::uint64_t i = 0; i < back.store.count(); ++i) {
    Frame read = back.store[i], expected = whole.store[i];
    if (expected.hasStamp()) expected.stamp -= expected.stamp % 1000;  // six decimals are written
    // What is cut off may decide whether a clock steps.
    read.flags &= static_cast<std::uint8_t>(~Frame::kTimeJump);
    expected.flags &= static_cast<std::uint8_t>(~Frame::kTimeJump);
    demand(read == expected);
  }
  return 0;
}
