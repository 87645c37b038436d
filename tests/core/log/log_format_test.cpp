// SPDX-License-Identifier: GPL-3.0-or-later
// The table of formats, and that a text format is one parser and one entry in it: a made-up one is read and
// written here through the same door as all others.
#include "log/log_format.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <fstream>

#include "log/candump.h"
#include "log/journal_reader.h"
#include "log/log_stream.h"

namespace deckpipe {
namespace {

// --- The made-up format: "@12 1A2 0011" is a frame at 12 ns, ";" begins a comment.

class TinyParser final : public TextParser {
  TextLine readLine(std::string_view line) override {
    TextLine read;
    if (line.empty() || line.front() == ';') return read;
    read.kind = TextLine::Kind::Skipped;
    if (line.front() != '@') return read;
    const char* p = line.data() + 1;
    const char* const end = line.data() + line.size();
    p = std::from_chars(p, end, read.frame.stamp).ptr;
    if (p == end) return read;
    p = std::from_chars(p + 1, end, read.frame.id, 16).ptr;
    for (++p; p + 1 < end && read.frame.length < 8; p += 2)
      std::from_chars(p, p + 2, read.frame.data[read.frame.length++], 16);
    read.kind = TextLine::Kind::Frame;
    return read;
  }
};

std::string hexOf(std::uint32_t number, unsigned digits) {
  std::string hex;
  for (unsigned i = digits; i-- > 0;) hex += "0123456789abcdef"[number >> 4 * i & 0xF];
  return hex;
}

void writeTiny(const Frame& frame, std::string_view, std::string& out) {
  out += "@" + std::to_string(frame.stamp) + " " + hexOf(frame.id, 8) + " ";
  for (const std::uint8_t byte : frame.bytes()) out += hexOf(byte, 2);
  out += "\n";
}

std::string tinyName(std::string_view) { return std::string(kUnnamedInterface); }

constexpr LogFormat kTiny = writable<writeTiny, tinyName>(textFormat<TinyParser>("tiny", "*.tiny *.t"));
constexpr LogFormat kFormats[] = {kCandumpFormat, kTiny};

std::string tinyLog(int lines) {
  std::string text = "; a comment\n";
  for (int i = 0; i < lines; ++i)
    text += "@" + std::to_string(100 + i) + " 1A2 0A" + (i % 2 ? "FF" : "") + "\n";
  return text;
}

struct Reading {
  FrameStore store;
  SkippedList skipped;
  Result<ReadSummary, ReadError> result = ReadSummary{};

  std::string written(const LogFormat& format) const {
    std::string text;
    const auto writer = format.makeWriter();
    writer->begin(text);
    for (std::uint8_t i = 0; i < store.channelCount(); ++i) writer->channel(store.channelName(i), text);
    for (std::uint64_t i = 0; i < store.count(); ++i) writer->frame(store[i], store.timeAt(i), text);
    writer->end(text);
    return text;
  }
};

TEST(LogFormats, OneEntryMakesATextFormatReadInBlocksOnTwoThreadsAndFromAPipe) {
  const std::string text = tinyLog(5'000);
  Reading whole;
  whole.result = readLog(BytesInMemory(text), {whole.store, whole.skipped}, {}, kFormats);
  ASSERT_TRUE(whole.result);
  ASSERT_EQ(whole.store.count(), 5'000u);
  EXPECT_EQ(whole.store[1].stamp, 101);
  EXPECT_EQ(whole.store[1].id, 0x1A2u);
  EXPECT_EQ(whole.store[1].length, 2);

  ReadOptions options;
  options.threads = 2;
  options.blockBytes = 100;
  Reading blocks;
  blocks.result = readLog(BytesInMemory(text), {blocks.store, blocks.skipped}, options, kFormats);
  ASSERT_TRUE(blocks.result);
  EXPECT_EQ(blocks.result.value(), whole.result.value());
  EXPECT_EQ(blocks.written(kTiny), whole.written(kTiny));

  const std::string path = testing::TempDir() + "/format-" + std::to_string(::getpid()) + ".any";
  std::ofstream(path) << text;
  Reading file;
  file.result = openLog(path, {file.store, file.skipped}, {}, kFormats);
  std::filesystem::remove(path);
  ASSERT_TRUE(file.result);
  EXPECT_EQ(file.written(kTiny), whole.written(kTiny));

  for (const std::size_t piece : {1u, 1'000u, 1'000'000u}) {
    Reading pipe;
    LogStream stream({pipe.store, pipe.skipped}, kFormats);
    for (std::size_t at = 0; at < text.size(); at += piece)
      EXPECT_TRUE(stream.feed(std::string_view(text).substr(at, piece)));
    pipe.result = stream.finish();
    ASSERT_TRUE(pipe.result) << piece;
    EXPECT_EQ(pipe.result.value(), whole.result.value());
    EXPECT_EQ(pipe.written(kTiny), whole.written(kTiny));
  }
}

TEST(LogFormats, ContentDecidesNotTheOrderOrTheName) {
  const std::string candump = "rubbish\n(1.0) can0 123#11\n", tiny = "rubbish\n" + tinyLog(1);
  constexpr LogFormat kReversed[] = {kTiny, kCandumpFormat};
  for (const std::span<const LogFormat> formats :
       {std::span<const LogFormat>(kFormats), std::span<const LogFormat>(kReversed)}) {
    for (const std::string& text : {candump, tiny}) {
      Reading reading;
      ASSERT_TRUE(readLog(BytesInMemory(text), {reading.store, reading.skipped}, {}, formats));
      EXPECT_EQ(reading.store.count(), 1u);
      EXPECT_EQ(reading.skipped.content().unreadable(), 1u);
      Reading pipe;
      LogStream stream({pipe.store, pipe.skipped}, formats);
      for (const char c : text) stream.feed({&c, 1});
      ASSERT_TRUE(stream.finish());
      EXPECT_EQ(pipe.store.count(), 1u);
    }
  }
}

TEST(LogFormats, WhatNoneKnowsIsOneErrorThatNamesNone) {
  Reading reading;
  reading.result = readLog(BytesInMemory("rubbish\n"), {reading.store, reading.skipped}, {}, kFormats);
  ASSERT_FALSE(reading.result);
  EXPECT_EQ(reading.result.error(), ReadError{ReadError::Kind::UnknownFormat});
}

TEST(LogFormats, WhatAnotherProgramWroteIsNamedAlikeOfFileAndPipe) {
  const std::string asc = "date Fri Apr 27 08:24:13 am 2018\nBase HEX  timestamps absolute\n";
  for (const auto& [content, name] : {std::pair<std::string, std::string>{"LOGG\x90", "Vector BLF"},
                                      {asc, "Vector ASC"},
                                      {asc + std::string(200'000, '\x01'), "Vector ASC"},
                                      {";$FILEVERSION=2.1\n;   Start time\n", "PEAK TRC"},
                                      {"Time Stamp,ID,Extended,Bus,LEN\n", "SavvyCAN CSV"}}) {
    SCOPED_TRACE(name);
    Reading reading;
    reading.result = readLog(BytesInMemory(content), {reading.store, reading.skipped});
    ASSERT_FALSE(reading.result);
    EXPECT_EQ(reading.result.error(), (ReadError{ReadError::Kind::UnknownFormat, {}, name}));
    Reading pipe;
    LogStream stream({pipe.store, pipe.skipped});
    for (std::size_t at = 0; at < content.size() && stream.feed(content.substr(at, 5)); at += 5) {
    }
    pipe.result = stream.finish();
    ASSERT_FALSE(pipe.result);
    EXPECT_EQ(pipe.result.error(), reading.result.error());
  }
}

TEST(LogFormats, AnErrorNamesTheFormatThatTheContentSeemedToBe) {
  LogFormat broken = kTiny;
  broken.read = [](const LogBytes&, const LogTarget&, const ReadOptions&) -> Result<ReadSummary, ReadError> {
    return Failure{ReadError{ReadError::Kind::CannotRead, "no luck"}};
  };
  Reading reading;
  reading.result = readLog(BytesInMemory(tinyLog(3)), {reading.store, reading.skipped}, {}, {&broken, 1});
  ASSERT_FALSE(reading.result);
  EXPECT_EQ(reading.result.error(), (ReadError{ReadError::Kind::CannotRead, "no luck", "tiny"}));
}

TEST(LogFormats, OneThatCannotBeReadFromAPipeSaysSo) {
  LogFormat fileOnly = kTiny;
  fileOnly.stream = nullptr;
  const LogFormat formats[] = {kCandumpFormat, fileOnly};
  Reading reading;
  LogStream stream({reading.store, reading.skipped}, formats);
  bool wantsMore = true;
  for (int i = 0; i < 1'000 && wantsMore; ++i) wantsMore = stream.feed(tinyLog(100));
  EXPECT_FALSE(wantsMore) << "and does not wait for the end";
  reading.result = stream.finish();
  ASSERT_FALSE(reading.result);
  EXPECT_EQ(reading.result.error(), (ReadError{ReadError::Kind::NoPipe, {}, "tiny"}));
  EXPECT_EQ(formatNames(LogUse::ReadFromPipe, formats), "candump");
}

TEST(LogFormats, AreNamedAndChosenForWritingByTheTable) {
  EXPECT_EQ(formatNames(LogUse::Read, kFormats), "candump, tiny");
  EXPECT_EQ(formatToWrite("truck.tiny", kFormats).name, "tiny");
  EXPECT_EQ(formatToWrite("truck.t", kFormats).name, "tiny");
  EXPECT_EQ(formatToWrite("truck.log", kFormats).name, "candump");
  EXPECT_EQ(formatToWrite("no suffix", kFormats).name, "candump") << "the first";
  LogFormat readOnly = kCandumpFormat;
  readOnly.makeWriter = nullptr;
  const LogFormat formats[] = {readOnly, kTiny};
  EXPECT_EQ(formatToWrite("truck.log", formats).name, "tiny");
  EXPECT_EQ(formatNames(LogUse::Write, formats), "tiny");
}

TEST(LogFormats, OfTheTableAreWhole) {
  for (const LogFormat& format : logFormats()) {
    SCOPED_TRACE(format.name);
    EXPECT_FALSE(format.name.empty());
    EXPECT_TRUE(format.patterns.starts_with("*."));
    EXPECT_TRUE(format.sniff != nullptr && format.read != nullptr);
    if (format.makeWriter != nullptr) {
      const auto writer = format.makeWriter();
      std::string text;
      writer->begin(text);
      writer->channel("can0", text);
      writer->frame({}, {}, text);
      writer->end(text);
      EXPECT_EQ(format.sniff(text, true), Sniff::Yes) << "it knows what it wrote";
    }
  }
  EXPECT_EQ(formatToWrite("x.deckpipe").name, kJournalFormat.name);
  EXPECT_EQ(formatToWrite("x.log").name, "candump");
  EXPECT_EQ(formatToWrite("no suffix").name, "candump") << "what other programs read too";
}

}  // namespace
}  // namespace deckpipe
