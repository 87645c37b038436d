// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <ostream>
#include <random>

#include "log/delta_times.h"
#include "log/log_stream.h"
#include "log/text_parser.h"

namespace deckpipe {

// For messages of failed tests.
void PrintTo(const SkippedPlace& place, std::ostream* out) {
  *out << place.place << ": " << skippedText(place.reason);
}

namespace {

struct Outcome {
  std::string error;
  std::uint64_t lines = 0;
  std::vector<Frame> frames;
  std::vector<std::string> channels;
  std::vector<SkippedPlace> skipped;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome outcomeOf(const Result<ReadSummary, ReadError>& result, const FrameStore& store,
                  const SkippedList& skipped) {
  Outcome outcome;
  if (result) {
    outcome.lines = result.value().lines;
    EXPECT_EQ(result.value().frames, store.count());
  } else {
    outcome.error = readErrorText(result.error().kind);
  }
  for (std::uint64_t i = 0; i < store.count(); ++i) outcome.frames.push_back(store[i]);
  for (std::size_t i = 0; i < store.channelCount(); ++i) {
    outcome.channels.emplace_back(store.channelName(static_cast<std::uint8_t>(i)));
  }
  outcome.skipped = skipped.content().places();
  return outcome;
}

Outcome readText(const std::string& text, const ReadOptions& options = {}) {
  FrameStore store;
  SkippedList skipped;
  const auto result = readLog(BytesInMemory(text), {store, skipped}, options);
  return outcomeOf(result, store, skipped);
}

Outcome readStream(const std::string& text, std::size_t piece) {
  FrameStore store;
  SkippedList skipped;
  LogStream stream({store, skipped});
  for (std::size_t at = 0; at < text.size(); at += piece) {
    if (!stream.feed(std::string_view(text).substr(at, piece))) break;
  }
  return outcomeOf(stream.finish(), store, skipped);
}

// However the text is cut and whoever reads it: always the same.
Outcome readEveryWay(const std::string& text) {
  Outcome outcome = readText(text);
  for (const unsigned threads : {1u, 2u}) {
    for (const std::size_t block : {1u, 7u, 100u, 4096u}) {
      if (text.size() / block > 2'000) continue;
      ReadOptions options;
      options.threads = threads;
      options.blockBytes = block;
      EXPECT_EQ(readText(text, options), outcome) << threads << " threads, blocks of " << block;
    }
  }
  for (const std::size_t piece : {1u, 13u, 5000u})
    EXPECT_EQ(readStream(text, piece), outcome) << "pieces of " << piece;
  return outcome;
}

std::string usualLine(int i) {
  char line[80];
  std::snprintf(line, sizeof line, "(%d.%06d) can%d 18EFFF80#%016X\n", 1'700'000'000 + i / 1000,
                i % 1000 * 1000, i % 3, static_cast<unsigned>(i));
  return line;
}
std::string usualText(int lines) {
  std::string text;
  for (int i = 0; i < lines; ++i) text += usualLine(i);
  return text;
}

TEST(CandumpReader, ReadsEveryLineInOrder) {
  const Outcome outcome = readEveryWay(usualText(3000));
  ASSERT_EQ(outcome.frames.size(), 3000u);
  EXPECT_EQ(outcome.lines, 3000u);
  EXPECT_EQ(outcome.channels, (std::vector<std::string>{"can0", "can1", "can2"}));
  EXPECT_TRUE(outcome.skipped.empty());
  for (std::size_t i = 0; i < 3000; ++i) {
    ASSERT_EQ(loadBig(outcome.frames[i].data), i);
    ASSERT_EQ(outcome.frames[i].channel, i % 3);
    ASSERT_EQ(outcome.frames[i].spare, 0);
  }
}

TEST(CandumpReader, ReportsUnreadableLinesByTheirNumberAndGoesOn) {
  std::string text = "# comment\n\n" + usualLine(0) + "rubbish\n" + usualLine(1);
  text += "(1.0) can0 123##1AABB\r\n(1.0) can0 123#1\n" + usualText(100) + "(1.0) can0 800#\n" + usualLine(2);
  const Outcome outcome = readEveryWay(text);
  EXPECT_EQ(outcome.frames.size(), 103u);
  EXPECT_EQ(outcome.lines, 109u);
  EXPECT_EQ(outcome.skipped,
            (std::vector<SkippedPlace>{
                {4, Skipped::Layout}, {6, Skipped::CanFd}, {7, Skipped::Data}, {108, Skipped::Identifier}}));
}

TEST(CandumpReader, TakesALoneCarriageReturnForALineEnd) {
  const std::string usual = usualText(3000);
  const Outcome expected = readEveryWay(usual);
  std::string lone = usual, pairs, mixed;
  std::ranges::replace(lone, '\n', '\r');
  for (int i = 0; const char c : usual) {
    pairs += c == '\n' ? std::string("\r\n") : std::string(1, c);
    static constexpr const char* kEnds[] = {"\r", "\n", "\r\n"};
    mixed += c == '\n' ? std::string(kEnds[i++ % 3]) : std::string(1, c);
  }
  EXPECT_EQ(readEveryWay(lone), expected);
  EXPECT_EQ(readEveryWay(pairs), expected);
  EXPECT_EQ(readEveryWay(mixed), expected);
}

TEST(CandumpReader, CountsLinesByWhateverEndsThem) {
  const Outcome outcome =
      readEveryWay("(1.0) can0 123#11\r\r\nrubbish\r(2.0) can0 123#22\n\rrubbish\r\n(3.0) can0 123#33\r");
  EXPECT_EQ(outcome.frames.size(), 3u);
  EXPECT_EQ(outcome.lines, 7u);
  EXPECT_EQ(outcome.skipped, (std::vector<SkippedPlace>{{3, Skipped::Layout}, {6, Skipped::Layout}}));
}

TEST(CandumpReader, SkipsATooLongLineUpToItsCarriageReturn) {
  for (const std::size_t length :
       {kMaxTextLine - 1, kMaxTextLine, kMaxTextLine + 1, kMaxTextLine + 2, std::size_t{70'000}}) {
    for (const char* end : {"\r", "\n", "\r\n", "\r\r\n"}) {
      SCOPED_TRACE(length);
      const std::string text =
          usualLine(0) + std::string(length, 'x') + end + usualLine(1) + std::string(length, 'y') + end;
      const Outcome outcome = readEveryWay(text);
      EXPECT_EQ(outcome.frames.size(), 2u);
      EXPECT_EQ(outcome.skipped.size(), 2u);
    }
  }
}

// 32-bit boards whose time has 64 bits print such stamps.
TEST(CandumpReader, KeepsTheSecondOfATimeWithMoreThanNineDecimals) {
  const Outcome outcome = readEveryWay("(1700000000.4011223344) can0 123#11\n(1700000001.5) can0 123#22\n");
  ASSERT_EQ(outcome.frames.size(), 2u);
  EXPECT_EQ(outcome.frames[0].stamp, 1'700'000'000'000'000'000);
  EXPECT_EQ(outcome.frames[1].stamp, 1'700'000'001'500'000'000);
  EXPECT_EQ(outcome.skipped, (std::vector<SkippedPlace>{{1, Skipped::Fraction}}));
}

TEST(DeltaTimes, AreToldFromTimes) {
  struct Row {
    const char* name;
    std::vector<const char*> times;
    bool areDeltas;
  };
  for (const Row& row : std::vector<Row>{
           {"periodic", {"000.000000", "000.100200", "000.099700", "000.100100", "000.099800"}, true},
           {"few, with a little jitter", {"0.0", "0.1002", "0.0998", "0.1000"}, true},
           {"the same each time", {"0.0", "0.1", "0.1", "0.1"}, true},
           {"from 0 on (-t z)", {"000.000000", "000.100200", "000.199900", "000.300000"}, false},
           {"times of day", {"1700000000.0", "1700000000.0", "1700000000.0"}, false},
           {"two buses out of order, from 0 on", {"0.0", "0.100001", "0.1", "0.2", "0.3"}, false},
           {"all 0", {"0.0", "0.0", "0.0"}, false},
           {"too few", {"0.0", "0.1"}, false},
           {"without the first line",
            {"0.0005", "0.0990", "0.0005", "0.0005", "0.0990", "0.0005", "0.0005", "0.0990", "0.0005",
             "0.0005", "0.0990", "0.0005", "0.0005", "0.0990", "0.0005", "0.0005"},
            true},
           {"too few without the first line", {"0.1", "0.0005", "0.1", "0.0005", "0.1", "0.0005"}, false},
           {"two buses out of order, from an uptime on",
            {"5.1", "5.09", "5.2", "5.19", "5.3", "5.29", "5.4", "5.39", "5.5", "5.49", "5.6", "5.59", "5.7",
             "5.69", "5.8", "5.79", "5.9"},
            false},
           {"an uptime that begins anew once",
            {"500.1", "500.2", "500.3", "500.4", "500.5", "500.6", "500.7", "500.8", "0.1", "0.2", "0.3",
             "0.4", "0.5", "0.6", "0.7", "0.8", "0.9"},
            false},
           {"an uptime", {"5.0", "5.0", "5.0", "5.0"}, false}}) {
    std::string text;
    for (const char* time : row.times) text += "(" + std::string(time) + ") can0 123#11\n";
    FrameStore store;
    SkippedList skipped;
    ASSERT_TRUE(readLog(BytesInMemory(text), {store, skipped}));
    EXPECT_EQ(hasDeltaTimes(store), row.areDeltas) << row.name;
  }
}

TEST(DeltaTimes, AreAddedUpAlikeOfFileAndPipe) {
  const std::string text =
      "(0.0) can0 123#11\n(0.1002) can1 123#11\nrubbish\n(0.0997) can0 123#11\n(0.1001) can0 123#11\n";
  ReadOptions options;
  options.addsUpTimes = true;
  options.blockBytes = 8;
  const Outcome file = readText(text, options);
  ASSERT_EQ(file.frames.size(), 4u);
  EXPECT_EQ(file.frames[1].stamp, 100'200'000);
  EXPECT_EQ(file.frames[3].stamp, 300'000'000);
  EXPECT_TRUE(
      std::ranges::none_of(file.frames, [](const Frame& f) { return (f.flags & Frame::kTimeJump) != 0; }));
  FrameStore store;
  SkippedList skipped;
  LogStream stream({store, skipped}, logFormats(), options);
  for (const char c : text) stream.feed({&c, 1});
  EXPECT_EQ(outcomeOf(stream.finish(), store, skipped), file);
}

TEST(DeltaTimes, AreNoTimesUntilTheyAreAddedUp) {
  std::string text;
  for (int i = 0; i < 3000; ++i)
    text += i == 0 ? "(0.0) can0 123#11\n" : i % 7 == 0 ? "(5.1) can1 124#11\n" : "(0.1) can0 123#11\n";
  ReadOptions options;
  options.blockBytes = 100;
  for (const bool isAddedUp : {false, true}) {
    options.addsUpTimes = isAddedUp;
    FrameStore frames;
    SkippedList skipped;
    ASSERT_TRUE(readLog(BytesInMemory(text), {frames, skipped}, options));
    ASSERT_EQ(frames.count(), 3000u);
    EXPECT_EQ(frames.hasTimes(), isAddedUp);
    EXPECT_EQ(frames.timeAt(1500) > Instant{}, isAddedUp);
    EXPECT_EQ(frames.firstAfter(Instant{}), isAddedUp ? 1u : 3000u);
    EXPECT_EQ(frames.jumps().size(), 0u);
    EXPECT_EQ(frames[1].stamp, 100'000'000) << "as they stand in the file";
  }
}

// The rest of the last line may be missing.
TEST(LastLine, IsLeftOutIfItsFrameIsShorterThanBefore) {
  struct Row {
    const char* name;
    std::string text;
    LastLine last;
    std::uint64_t frames;
  };
  const std::string whole = "(1.5) can0 0CFDD633#0100010000000000\n(1.6) can0 18EFFF80#83C051\n";
  for (const Row& row : std::vector<Row>{
           {"with its end", whole, LastLine::Whole, 2},
           {"with the end of a Macintosh", "(1.5) can0 123#11\r(1.6) can0 123#11\r", LastLine::Whole, 2},
           {"whole but for its end", whole + "(1.7) can0 0CFDD633#0100010000000000", LastLine::Open, 3},
           {"a byte less", whole + "(1.7) can0 0CFDD633#01000100000000", LastLine::LeftOut, 2},
           {"with another first byte", whole + "(1.7) can0 0CFDD633#02000100000000", LastLine::LeftOut, 2},
           {"no bytes", whole + "(1.7) can0 0CFDD633#", LastLine::LeftOut, 2},
           {"another message of the identifier",
            whole + "(1.7) can0 18EFFF80#011D940371000041\n(1.8) can0 18EFFF80#83C051", LastLine::Open, 4},
           {"never heard before", whole + "(1.7) can0 123#", LastLine::Open, 3},
           {"of another interface", whole + "(1.7) can1 0CFDD633#0100", LastLine::Open, 3},
           {"half an identifier", whole + "(1.7) can0 0CFD", LastLine::Open, 2},
           {"a line alone", "(1.5) can0 0CFDD633#01", LastLine::Whole, 1},
           {"times that are differences",
            "(0.0) can0 123#1122\n(0.1) can0 123#1122\n(0.1) can0 123#1122\n(0.1) can0 123#1122\n(0.1) can0 "
            "123#11",
            LastLine::LeftOut, 4},
       }) {
    FrameStore file, pipe;
    SkippedList fileSkipped, pipeSkipped;
    ReadOptions options;
    options.threads = 2;
    options.blockBytes = 32;
    const auto ofFile = readLog(BytesInMemory(row.text), {file, fileSkipped}, options);
    ASSERT_TRUE(ofFile) << row.name;
    EXPECT_EQ(ofFile.value().lastLine, row.last) << row.name;
    EXPECT_EQ(file.count(), row.frames) << row.name;
    EXPECT_EQ(ofFile.value().isWhole(), row.last != LastLine::LeftOut) << row.name;
    LogStream stream({pipe, pipeSkipped});
    for (const char c : row.text) stream.feed({&c, 1});
    const auto ofPipe = stream.finish();
    ASSERT_TRUE(ofPipe) << row.name;
    EXPECT_EQ(ofPipe.value().lastLine, row.last) << row.name;
    EXPECT_EQ(pipe.count(), row.frames) << row.name;
  }
}

TEST(CandumpReader, ReadsALastLineWithoutLineFeed) {
  const Outcome outcome = readEveryWay("(1.0) can0 123#11\n(2.0) can0 123#22");
  ASSERT_EQ(outcome.frames.size(), 2u);
  EXPECT_EQ(outcome.frames[1].stamp, 2'000'000'000);
  EXPECT_EQ(outcome.lines, 2u);
}

TEST(CandumpReader, ReportsALastLineThatIsCutOff) {
  const Outcome outcome = readEveryWay("(1.0) can0 123#11\n(2.0) can0 12");
  EXPECT_EQ(outcome.frames.size(), 1u);
  EXPECT_EQ(outcome.skipped, (std::vector<SkippedPlace>{{2, Skipped::Layout}}));
}

TEST(CandumpReader, TakesAnEmptyTextForAnEmptyLog) {
  for (const char* text : {"", "\n", "# only a comment\n", "\r\n\r\n"}) {
    const Outcome outcome = readEveryWay(text);
    EXPECT_EQ(outcome.error, "");
    EXPECT_TRUE(outcome.frames.empty() && outcome.skipped.empty());
  }
}

TEST(CandumpReader, RefusesWhatIsNoCandumpLogWithOneError) {
  std::string rubbish, binary;
  for (int i = 0; i < 20'000; ++i) rubbish += "{\"json\": " + std::to_string(i) + "}\n";
  std::mt19937 random(1);
  for (int i = 0; i < 200'000; ++i) binary += static_cast<char>(random());
  for (const std::string& text :
       {rubbish, binary, std::string(100'000, '\0'), std::string("no\n"), std::string(300'000, 'x'),
        std::string(300'000, 'x') + "\n(1.0) can0 123#11\n", rubbish + "(1.0) can0 123#11\n"}) {
    const Outcome outcome = readEveryWay(text);
    EXPECT_EQ(outcome.error, "not a log of a known format") << text.substr(0, 20);
    EXPECT_TRUE(outcome.frames.empty() && outcome.skipped.empty());
  }
}

TEST(CandumpReader, AcceptsALogWhoseFirstReadableLineComesLate) {
  const std::string before(40'000, 'x');
  const Outcome outcome = readEveryWay(before + "\n(1.0) can0 123#11\n");
  EXPECT_EQ(outcome.frames.size(), 1u);
  EXPECT_EQ(outcome.skipped, (std::vector<SkippedPlace>{{1, Skipped::LineTooLong}}));
  // Comments for longer than anybody looks, then frames.
  std::string comments;
  while (comments.size() < 100'000) comments += "# nothing yet\n";
  EXPECT_EQ(readEveryWay(comments + "(1.0) can0 123#11\n").frames.size(), 1u);
  // Nothing but CAN FD is a log too.
  EXPECT_EQ(readEveryWay("x\n(1.0) can0 123##011\n").skipped.size(), 2u);
}

TEST(CandumpReader, ReportsALineTooLongAndReadsTheNext) {
  const std::string frame = "(1.0) can0 123#11\n";
  for (const std::size_t length : {kMaxTextLine - 1, kMaxTextLine, kMaxTextLine + 1, 3 * kMaxTextLine}) {
    const Outcome outcome = readEveryWay(frame + std::string(length, 'x') + "\n" + frame + frame);
    ASSERT_EQ(outcome.frames.size(), 3u) << length;
    EXPECT_EQ(
        outcome.skipped,
        (std::vector<SkippedPlace>{{2, length > kMaxTextLine ? Skipped::LineTooLong : Skipped::Layout}}));
    const Outcome last = readEveryWay(frame + std::string(length, 'x'));
    EXPECT_EQ(last.skipped, outcome.skipped) << "without line feed";
  }
}

TEST(CandumpReader, NamesFramesWithoutInterfaceAfterTheLastHeader) {
  const Outcome outcome = readEveryWay(
      "<0x123> [1] 00\n(1.0) can7 124#\ninterface = can1, family = 29\n<0x123> [1] 01\n<0x123> [1] 02\n"
      "interface = can7, family = 29\n<0x123> [1] 03\n");
  ASSERT_EQ(outcome.frames.size(), 5u);
  EXPECT_EQ(outcome.channels, (std::vector<std::string>{std::string(kUnnamedInterface), "can7", "can1"}));
  EXPECT_EQ(outcome.frames[0].channel, 0);
  EXPECT_EQ(outcome.frames[2].channel, 2);
  EXPECT_EQ(outcome.frames[3].channel, 2);
  EXPECT_EQ(outcome.frames[4].channel, 1);
}

TEST(CandumpReader, GivesALogOfTooManyInterfacesOneChannelForTheRest) {
  std::string text;
  for (int i = 0; i < 900; ++i) text += "(1.0) i" + std::to_string(i) + " 123#\n";
  const Outcome outcome = readEveryWay(text);
  ASSERT_EQ(outcome.frames.size(), 900u);
  EXPECT_EQ(outcome.frames[254].channel, 254);
  EXPECT_EQ(outcome.frames[255].channel, FrameStore::kOtherChannels);
  EXPECT_EQ(outcome.frames[899].channel, FrameStore::kOtherChannels);
}

TEST(CandumpReader, KeepsStampsThatRepeatOrGoBackAsTheyAre) {
  const Outcome outcome =
      readEveryWay("(5.0) can0 123#\n(5.0) can0 123#\n(3.5) can0 123#\n(6.0) can0 123#\n");
  ASSERT_EQ(outcome.frames.size(), 4u);
  EXPECT_EQ(outcome.frames[2].stamp, 3'500'000'000);
  EXPECT_EQ(outcome.frames[2].flags, Frame::kTimeJump);
  EXPECT_EQ(outcome.frames[1].flags, 0);
  EXPECT_EQ(outcome.frames[3].flags, 0);
}

TEST(CandumpReader, BoundsTheReportOfAHostileText) {
  std::string text = usualLine(0);
  for (int i = 0; i < 50'000; ++i) text += "x\n";
  FrameStore store;
  SkippedList skipped;
  ASSERT_TRUE(readLog(BytesInMemory(text), {store, skipped}));
  EXPECT_EQ(skipped.content().places().size(), SkippedPlaces::kMaxPlaces);
  EXPECT_EQ(skipped.content().count(Skipped::Layout), 50'000u);
}

TEST(CandumpReader, AgreesWithItselfOnRandomMixtures) {
  std::mt19937_64 random(5);
  const std::vector<std::string> parts = {"(1.0) can0 123#11\n",
                                          "(1700000000.123456) can1 18EFFF80#011D940371000041\r\n",
                                          "<0x123> [1] 05\n",
                                          "interface = can9, x\n",
                                          "\n",
                                          "# c\n",
                                          "x\n",
                                          "(",
                                          "can0",
                                          std::string(1, '\0'),
                                          " ",
                                          "123#",
                                          "11",
                                          "\n",
                                          std::string(9000, 'y'),
                                          "(1.0) long_name_here 123#R T\n"};
  std::map<Skipped, int> reasons;
  for (int round = 0; round < 60; ++round) {
    std::string text;
    for (std::uint64_t n = random() % 40; n > 0; --n) text += parts[random() % parts.size()];
    for (const SkippedPlace& place : readEveryWay(text).skipped) ++reasons[place.reason];
  }
  for (const Skipped reason : {Skipped::Layout, Skipped::Binary, Skipped::LineTooLong})
    EXPECT_GT(reasons[reason], 0) << skippedText(reason) << ": the mixtures lack what makes it";
}

TEST(CandumpReader, PublishesTheFirstRowsBeforeItReadsOn) {
  const std::string text = usualText(40'000);
  std::vector<ReadProgress> steps;
  ReadOptions options;
  options.onProgress = [&steps](const ReadProgress& progress) {
    steps.push_back(progress);
    return true;
  };
  readText(text, options);
  ASSERT_GT(steps.size(), 2u);
  EXPECT_LE(steps[0].bytesDone, 64u * 1024);
  EXPECT_GT(steps[0].frames, 0u);
  EXPECT_EQ(steps.back().bytesDone, text.size());
  EXPECT_EQ(steps.back().frames, 40'000u);
}

TEST(CandumpReader, StopsWhenToldAndKeepsWhatWasPublished) {
  const std::string text = usualText(40'000);
  for (const unsigned threads : {1u, 2u}) {
    FrameStore store;
    SkippedList skipped;
    ReadOptions options;
    options.threads = threads;
    int calls = 0;
    options.onProgress = [&calls](const ReadProgress&) { return ++calls < 3; };
    const auto result = readLog(BytesInMemory(text), {store, skipped}, options);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result.value().cancelled);
    EXPECT_EQ(calls, 3);
    EXPECT_EQ(result.value().frames, store.count());
    EXPECT_GT(store.count(), 0u);
    EXPECT_LT(store.count(), 40'000u);
  }
}

TEST(CandumpReader, SaysThatTheStoreIsFull) {
  FrameStore store({.memoryBytes = 0, .spillFolder = "/nonexistent"});
  SkippedList skipped;
  const auto result = readLog(BytesInMemory(usualText(10)), {store, skipped});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ReadError::Kind::StoreFull);
  LogStream stream({store, skipped});
  EXPECT_FALSE(stream.feed(std::string_view("(1700000000.5) can0 123#11\n")));
  EXPECT_EQ(stream.finish().error().kind, ReadError::Kind::StoreFull);
}

TEST(CandumpReader, SaysWhyAFileCannotBeOpened) {
  FrameStore store;
  SkippedList skipped;
  for (const char* path : {"/nonexistent/file.log", "/tmp"}) {
    const auto result = openLog(path, {store, skipped});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ReadError::Kind::CannotOpen);
    EXPECT_FALSE(result.error().detail.empty());
  }
}

TEST(CandumpReader, ReportsAFileThatShrinksWhileItIsRead) {
  const std::string path = testing::TempDir() + "/shrinking-" + std::to_string(::getpid()) + ".log";
  std::ofstream(path) << usualText(40'000);
  FrameStore store;
  SkippedList skipped;
  ReadOptions options;
  options.onProgress = [&path](const ReadProgress&) {
    std::filesystem::resize_file(path, 100'000);
    return true;
  };
  const auto result = openLog(path, {store, skipped}, options);
  std::filesystem::remove(path);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ReadError::Kind::CannotRead);
  EXPECT_EQ(result.error().format, "candump");
  EXPECT_GT(store.count(), 0u);
}

TEST(LogStream, PutsWholeLinesIntoTheStoreAtOnce) {
  FrameStore store;
  SkippedList skipped;
  LogStream stream({store, skipped});
  EXPECT_TRUE(stream.feed(std::string_view("(1700000000.5) can0 123#11\n(1700000000.6) can0 123#2")));
  EXPECT_EQ(store.count(), 1u);
  EXPECT_TRUE(stream.feed(std::string_view("2\n")));
  EXPECT_EQ(store.count(), 2u);
}

TEST(LogStream, GivesUpOnWhatIsNoLogBeforeItEnds) {
  FrameStore store;
  SkippedList skipped;
  LogStream stream({store, skipped});
  std::uint64_t fed = 0;
  const std::string rubbish = "this is not a line of any log\n";
  while (fed < 1'000'000 && stream.feed(std::string_view(rubbish))) fed += rubbish.size();
  EXPECT_LT(fed, 70'000u);
  EXPECT_EQ(stream.finish().error().kind, ReadError::Kind::UnknownFormat);
}

// --- Logs that nobody here wrote

struct SharedLog {
  const char* name;
  std::size_t frames;
  std::map<Skipped, std::uint64_t> skipped;
};

TEST(CandumpReader, ReadsLogsOfOthers) {
  const std::filesystem::path folder = DECKPIPE_SHARED_DATA;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data";
  for (const SharedLog& log :
       {SharedLog{"candump-old-form.txt", 6026, {}}, SharedLog{"candump-odd-line-ends.txt", 23, {}},
        SharedLog{"candump-short.log", 106, {}}, SharedLog{"car-candump.log", 12'974, {}},
        SharedLog{"multiple_CAN.log", 36, {{Skipped::CanFd, 128}}}}) {
    SCOPED_TRACE(log.name);
    std::ifstream file(folder / log.name, std::ios::binary);
    ASSERT_TRUE(file);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const Outcome outcome = text.size() < 10'000 ? readEveryWay(text) : readText(text);
    EXPECT_EQ(outcome.frames.size(), log.frames);
    std::map<Skipped, std::uint64_t> reasons;
    for (const SkippedPlace& place : outcome.skipped) ++reasons[place.reason];
    EXPECT_EQ(reasons, log.skipped);

    FrameStore store;
    SkippedList skipped;
    ReadOptions options;
    options.threads = 2;
    ASSERT_TRUE(openLog(folder / log.name, {store, skipped}, options));
    EXPECT_EQ(store.count(), log.frames);
  }
}

TEST(CandumpReader, RefusesLogsOfOtherFormats) {
  const std::filesystem::path folder = DECKPIPE_SHARED_DATA;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (name.find("candump") != std::string::npos || name == "multiple_CAN.log") continue;
    SCOPED_TRACE(name);
    FrameStore store;
    SkippedList skipped;
    const auto result = openLog(entry.path(), {store, skipped});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ReadError::Kind::UnknownFormat);
  }
}

}  // namespace
}  // namespace deckpipe
