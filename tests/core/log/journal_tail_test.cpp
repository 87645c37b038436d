// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a journal tells what reading all of it would, wherever it is cut.
#include "log/journal_tail.h"

#include <gtest/gtest.h>

#include "support/journals.h"

namespace deckpipe {
namespace {

BytesInMemory bytesOf(std::span<const std::uint8_t> bytes) {
  return BytesInMemory({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

struct JournalTailTest : testing::Test {
  void SetUp() override {
    JournalWriter writer(written.frames, written.notes, disk.maker(), test::someHead);
    for (int i = 0; i < 6; ++i) {
      written.fill();
      if (i % 2 == 1)
        written.notes.append({.time = written.frames.lastTime() + 700ms, .value = note::RanUntil{}});
      writer.timeCame(Instant{} + i * 250ms);
    }
    writer.end();
  }
  test::Recording written;
  test::FakeDisk disk;
};

TEST_F(JournalTailTest, TellsTheNumberOfAllFramesAndTheLastOne) {
  const auto tail = readJournalTail(bytesOf(disk.bytes), disk.bytes.size() / 3);
  ASSERT_TRUE(tail);
  EXPECT_EQ(tail->frames, written.frames.count());
  EXPECT_TRUE(tail->isEnded);
  EXPECT_EQ(tail->cutBytes, 0u);
  ASSERT_TRUE(tail->last);
  EXPECT_EQ(*tail->last, written.frames[written.frames.count() - 1]);
}

TEST_F(JournalTailTest, OfOneThatWasCutAnywhereTellsWhatReadingItWould) {
  for (std::size_t size = disk.bytes.size() / 2; size < disk.bytes.size(); size += 5) {
    const auto part = std::span(disk.bytes).first(size);
    test::Recording read;
    read.read(part);
    ASSERT_TRUE(read.result);
    const auto tail = readJournalTail(bytesOf(part), disk.bytes.size() / 3);
    ASSERT_TRUE(tail) << size;
    EXPECT_EQ(tail->frames, read.frames.count()) << size;
    EXPECT_EQ(tail->cutBytes, read.result.value().cutBytes) << size;
    EXPECT_EQ(tail->isEnded, !read.result.value().isOpenEnded) << size;
    EXPECT_EQ(std::max(tail->noted, tail->ranUntil), std::max(read.notes.lastTime(), read.notes.ranUntil()))
        << size;
  }
}

TEST_F(JournalTailTest, TellsTheNumberOfAllFramesBehindALongSilence) {
  test::Recording silent;
  test::FakeDisk file;
  JournalWriter writer(silent.frames, silent.notes, file.maker(), test::someHead);
  silent.fill();
  for (int second = 0; second < 200; ++second) {
    silent.notes.append({.time = silent.frames.lastTime() + second * 1s, .value = note::RanUntil{}});
    writer.timeCame(Instant{} + second * 1s);
  }
  const auto tail = readJournalTail(bytesOf(file.bytes), 1'000);
  ASSERT_TRUE(tail);
  EXPECT_FALSE(tail->last);
  EXPECT_EQ(tail->frames, silent.frames.count());
  EXPECT_EQ(tail->ranUntil, silent.notes.ranUntil());
}

TEST_F(JournalTailTest, TellsNothingWhereNoFrameIsFound) {
  EXPECT_FALSE(readJournalTail(bytesOf(disk.bytes), 5));
  EXPECT_FALSE(readJournalTail(BytesInMemory("")));
  EXPECT_FALSE(readJournalTail(BytesInMemory(std::string(5'000, '\x01'))));
}

}  // namespace
}  // namespace deckpipe
