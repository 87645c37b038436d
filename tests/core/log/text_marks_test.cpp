// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/text_marks.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "log/log_format.h"
#include "log/log_stream.h"

namespace deckpipe {
namespace {

const std::string kTwoLines =
    "(1700000000.000000) can0 18EFFF80#0138410644000041\n"
    "(1700000000.100000) can0 18EFFF80#0137E10654000041\n";

std::string wide(const std::string& text, bool littleFirst) {
  std::string out = littleFirst ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : text) {
    if (littleFirst) out += {c, '\0'};
    if (!littleFirst) out += {'\0', c};
  }
  return out;
}

std::string withEnds(const std::string& end) {
  std::string out;
  for (const char c : kTwoLines) c == '\n' ? out += end : out += c;
  return out;
}

struct MarkedText {
  const char* name;
  std::string bytes;
};

std::vector<MarkedText> markedTexts() {
  return {{"plain", kTwoLines},
          {"UTF-8 mark", "\xEF\xBB\xBF" + kTwoLines},
          {"UTF-16, low byte first", wide(kTwoLines, true)},
          {"UTF-16, high byte first", wide(kTwoLines, false)},
          {"UTF-16, CR LF, as PowerShell writes", wide(withEnds("\r\n"), true)},
          {"CR LF", withEnds("\r\n")}};
}

void expectTwoFrames(const FrameStore& store, const SkippedList& skipped) {
  ASSERT_EQ(store.count(), 2u);
  EXPECT_EQ(store[1].id, kExtendedBit | 0x18EFFF80);
  EXPECT_EQ(store[1].stamp - store[0].stamp, 100'000'000);
  EXPECT_EQ(store[1].data[7], 0x41);
  EXPECT_EQ(skipped.content().unreadable(), 0u);
}

TEST(TextMarks, EveryFrameIsReadFromAFile) {
  for (const MarkedText& row : markedTexts()) {
    for (const unsigned threads : {1u, 2u}) {
      for (const std::size_t block : {std::size_t{7}, std::size_t{256 * 1024}}) {
        SCOPED_TRACE(row.name);
        FrameStore store;
        SkippedList skipped;
        ReadOptions options;
        options.threads = threads;
        options.blockBytes = block;
        ASSERT_TRUE(readLog(BytesInMemory(row.bytes), {store, skipped}, options));
        expectTwoFrames(store, skipped);
      }
    }
  }
}

TEST(TextMarks, EveryFrameIsReadFromAPipeHoweverItIsCut) {
  for (const MarkedText& row : markedTexts()) {
    for (const std::size_t piece :
         {std::size_t{1}, std::size_t{3}, std::size_t{52}, std::size_t{53}, row.bytes.size()}) {
      SCOPED_TRACE(row.name);
      SCOPED_TRACE(piece);
      FrameStore store;
      SkippedList skipped;
      LogStream stream({store, skipped});
      for (std::size_t at = 0; at < row.bytes.size(); at += piece)
        EXPECT_TRUE(stream.feed(std::string_view(row.bytes).substr(at, piece)));
      ASSERT_TRUE(stream.finish());
      expectTwoFrames(store, skipped);
    }
  }
}

TEST(TextMarks, AMarkAloneIsAnEmptyLog) {
  for (const std::string bytes : {"\xEF\xBB\xBF", "\xFF\xFE", "\xFE\xFF"}) {
    FrameStore store;
    SkippedList skipped;
    EXPECT_TRUE(readLog(BytesInMemory(bytes), {store, skipped}));
    LogStream stream({store, skipped});
    stream.feed(bytes);
    EXPECT_TRUE(stream.finish());
    EXPECT_EQ(store.count(), 0u);
  }
}

TEST(TextMarks, ASecondMarkIsText) {
  const std::string bytes = "\xEF\xBB\xBF\xFE\xFF" + kTwoLines;
  FrameStore file, pipe;
  SkippedList ofFile, ofPipe;
  ASSERT_TRUE(readLog(BytesInMemory(bytes), {file, ofFile}));
  LogStream stream({pipe, ofPipe});
  stream.feed(bytes);
  ASSERT_TRUE(stream.finish());
  EXPECT_EQ(file.count(), 1u);
  EXPECT_EQ(pipe.count(), 1u);
  EXPECT_EQ(ofFile.content().unreadable(), 1u);
}

TEST(TextMarks, HalfACharacterAtTheEndIsNone) {
  const std::string bytes = wide(kTwoLines, true) + "(";
  FrameStore store;
  SkippedList skipped;
  ASSERT_TRUE(readLog(BytesInMemory(bytes), {store, skipped}));
  expectTwoFrames(store, skipped);
}

}  // namespace
}  // namespace deckpipe
