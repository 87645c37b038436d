// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/log_saving.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <latch>

#include "log/candump.h"
#include "log/journal_file.h"
#include "protocol/typed.h"
#include "state/health.h"
#include "support/file_size_limit.h"
#include "support/frames.h"
#include "support/logs.h"
#include "support/patience.h"

namespace deckpipe {
namespace {

struct LogSavingTest : testing::Test {
  QTemporaryDir dir;
  QString path = dir.filePath(QStringLiteral("part.log"));
  std::shared_ptr<LogDocument> log;

  LogSavingTest() {
    std::vector<Frame> frames;
    for (int i = 0; i < 20'000; ++i) frames.push_back(test::frame("123", "", 0, i * std::int64_t{1'000'000}));
    log = test::logOf(frames);
  }
  LogSaving::Outcome outcomeOf(LogSaving& saving) {
    QSignalSpy ended(&saving, &LogSaving::ended);
    EXPECT_TRUE(ended.wait(kPatience));
    return ended.at(0).at(0).value<LogSaving::Outcome>();
  }
  QList<QByteArray> lines() const {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    QList<QByteArray> lines = file.readAll().split('\n');
    lines.removeLast();
    return lines;
  }
};

TEST_F(LogSavingTest, WritesASpanOfFrames) {
  LogSaving saving(log, path, {.begin = 9'999, .end = 10'001});
  EXPECT_EQ(saving.frames(), 2u);
  EXPECT_EQ(outcomeOf(saving), LogSaving::Outcome::Saved);
  EXPECT_EQ(saving.written(), 2u);
  EXPECT_EQ(lines(), (QList<QByteArray>{"(0000000009.999000) can0 123#", "(0000000010.000000) can0 123#"}));
}

TEST_F(LogSavingTest, AsksOfEveryFrameFromTheFirstOn) {
  std::uint64_t next = 0;
  bool isInOrder = true;
  LogSaving saving(log, path, {.begin = 100, .end = 15'000, .passes = [&](std::uint64_t frame) {
                                 isInOrder = isInOrder && frame == next++;
                                 return frame % 5'000 == 0;
                               }});
  EXPECT_FALSE(saving.frames()) << "nobody knows before they were looked at";
  EXPECT_EQ(outcomeOf(saving), LogSaving::Outcome::Saved);
  EXPECT_TRUE(isInOrder);
  EXPECT_EQ(next, 15'000u);
  EXPECT_EQ(saving.written(), 2u);
  EXPECT_EQ(lines().size(), 2);
}

TEST_F(LogSavingTest, LeavesNoFileWhereItIsCancelled) {
  std::latch go(1);
  LogSaving saving(log, path, {.passes = [&](std::uint64_t) {
                     go.wait();
                     return true;
                   }});
  saving.cancel();
  go.count_down();
  EXPECT_EQ(outcomeOf(saving), LogSaving::Outcome::Cancelled);
  EXPECT_TRUE(QDir(dir.path()).isEmpty());
}

TEST_F(LogSavingTest, LeavesARecordingAloneThatGoesOn) {
  const MadeJournalFile growing = createJournalFile(dir.filePath(QStringLiteral("growing")).toStdString());
  ASSERT_TRUE(growing);
  LogSaving saving(log, QString::fromStdString(growing.value()->path()));
  QSignalSpy ended(&saving, &LogSaving::ended);
  ASSERT_TRUE(ended.wait(kPatience));
  EXPECT_EQ(ended.at(0).at(0).value<LogSaving::Outcome>(), LogSaving::Outcome::IsGrowing);
  EXPECT_EQ(ended.at(0).at(1).toString(), QString()) << "the window has its own words";
}

// --- With what belongs to the frames.

constexpr std::string_view kSimulator =
    "(100.000000) can0 18EEFF80#0000C02800840000\n"  // the NAME of address 80
    "(100.100000) can0 18EFFF80#FF83150206021A0B\n"  // its PIN
    "(100.200000) can1 18EFFF81#FF83150206021A0C\n"
    "(100.300000) can0 18EFFF80#011D940371000041\n"
    "(100.400000) can1 18EFFF81#011D940371000041\n"
    "(100.500000) can0 18EFFF80#01000C0371000041\n";

struct SavedPartTest : testing::Test {
  QTemporaryDir dir;
  QString path = dir.filePath(QStringLiteral("part.log"));
  std::shared_ptr<LogDocument> log = test::logOfText(kSimulator);
  const Pin monitor = *announcedPin(log->frames[1]), other = *announcedPin(log->frames[2]);

  struct Outcome {
    LogSaving::Outcome outcome;
    QString reason, sidecar;
    std::uint64_t written = 0, added = 0;
  };
  std::shared_ptr<KnownSidecars> sidecars = std::make_shared<KnownSidecars>();
  Outcome save(SavedPart part = {}) {
    LogSaving saving(log, path, std::move(part), sidecars);
    QSignalSpy ended(&saving, &LogSaving::ended);
    EXPECT_TRUE(ended.wait(kPatience));
    return {ended.at(0).at(0).value<LogSaving::Outcome>(), ended.at(0).at(1).toString(), saving.sidecar(),
            saving.written(), saving.added()};
  }
  std::shared_ptr<LogDocument> reopened() const {
    auto read = std::make_shared<LogDocument>();
    const auto result = openLog(path.toStdString(), {read->frames, read->skipped, &read->notes});
    EXPECT_TRUE(result);
    EXPECT_TRUE(!result || !result.value().sidecarFault);
    return read;
  }
  static std::vector<std::string> told(const LogDocument& document) {
    std::vector<std::string> all;
    for (const Note& note : document.notes.all())
      all.push_back(std::to_string(note.frame) + " " + std::string(noteKey(note.value)));
    return all;
  }
  static State stateOf(const LogDocument& document) {
    State state;
    advance(state, document.frames, document.notes, cursorAfter(document.frames, document.frames.count()));
    return state;
  }
  static std::string line(const LogDocument& document, std::uint64_t i) {
    std::string text;
    writeCandump(document.frames[i], document.frames.channelName(document.frames[i].channel), text);
    return text;
  }
  QStringList files() const { return QDir(dir.path()).entryList(QDir::Files, QDir::Name); }
};

TEST_F(SavedPartTest, ALogWithoutNotesHasNoSidecar) {
  EXPECT_EQ(save().outcome, LogSaving::Outcome::Saved);
  EXPECT_EQ(files(), QStringList{QStringLiteral("part.log")});
  EXPECT_EQ(reopened()->frames.count(), 6u);
}

TEST_F(SavedPartTest, MarksLabelsAndDrivesComeBackWithTheLog) {
  log->notes.append({.frame = 0, .time = {99'000'000'000}, .value = note::LinkUp{{0}, "socketcan can0"}});
  log->notes.append({.frame = 4, .time = {100'350'000'000}, .value = note::Mark{"valve opened"}});
  log->notes.append({.frame = 4, .time = {100'350'000'000}, .value = note::DriveSaid{{1}, {0x5A}, true}});
  log->notes.append({.frame = 6, .time = {101'000'000'000}, .value = note::LinkDown{{1}, LinkFault::Gone}});
  const Outcome outcome =
      save({.labels = {{monitor, "front bumper"}, {*Pin::parse("1032AE999999999"), "elsewhere"}}});
  EXPECT_EQ(outcome.reason, QString());
  EXPECT_EQ(outcome.sidecar, path + QStringLiteral(".deckpipe-notes"));
  const auto read = reopened();
  EXPECT_EQ(told(*read),
            (std::vector<std::string>{"0 link_up", "1 label", "4 mark", "4 drive_said", "6 link_down"}));
  std::vector<Note> notes = read->notes.all();
  std::erase_if(notes, [](const Note& note) { return std::holds_alternative<note::Label>(note.value); });
  EXPECT_EQ(notes, log->notes.all());
  EXPECT_EQ(read->notes.between(1, 2).at(0).value, NoteValue(note::Label{monitor, "front bumper"}));
  for (std::uint64_t i = 0; i < 6; ++i) EXPECT_EQ(line(*read, i), line(*log, i));
}

TEST_F(SavedPartTest, ThatALogRanOnBehindItsLastFrameComesBackWithWhatReachesTheEnd) {
  const Instant ranUntil = log->frames.lastTime() + 30s;
  log->notes.append({.time = ranUntil, .value = note::RanUntil{}});
  const auto endOfSaved = [&](SavedPart part) {
    EXPECT_EQ(save(std::move(part)).outcome, LogSaving::Outcome::Saved);
    const auto read = reopened();
    return endOf(read->frames, read->notes).time;
  };
  for (const char* name : {"part.log", "part.deckpipe"}) {
    SCOPED_TRACE(name);
    path = dir.filePath(QString::fromLatin1(name));
    EXPECT_EQ(endOfSaved({}), ranUntil);
    EXPECT_TRUE(reopened()->notes.all().empty());
    EXPECT_EQ(endOfSaved({.begin = 3}), ranUntil);
    EXPECT_EQ(endOfSaved({.passes = [](std::uint64_t frame) { return frame < 4; }}), ranUntil);
    EXPECT_EQ(endOfSaved({.begin = 1, .end = 5}), log->frames.timeAt(4)) << "a selection before the end";
  }
  log = reopened();
  EXPECT_EQ(log->notes.ranUntil(), kNotYet);
  EXPECT_EQ(endOfSaved({}), log->frames.lastTime()) << "a log that does not say so";
}

TEST_F(SavedPartTest, AMonitorThatFellSilentBeforeTheEndIsSilentInTheCopyToo) {
  log->notes.append({.frame = 0, .time = {99'000'000'000}, .value = note::LinkUp{{0}}});
  log->notes.append({.time = log->frames.lastTime() + 30s, .value = note::RanUntil{}});
  for (const char* name : {"part.log", "part.deckpipe"}) {
    SCOPED_TRACE(name);
    path = dir.filePath(QString::fromLatin1(name));
    save();
    const auto read = reopened();
    const auto isSilentAt = [&](Cursor cursor) {
      State state;
      advance(state, read->frames, read->notes, cursor);
      return healthOf(state, *state.devices().byPin(monitor)).has(HealthCause::Silent);
    };
    EXPECT_FALSE(isSilentAt(cursorAfter(read->frames, 6)));
    EXPECT_TRUE(isSilentAt(endOf(read->frames, read->notes)));
  }
}

TEST_F(SavedPartTest, ASelectionBeginsWithWhoHeldWhichAddressThen) {
  log->notes.append({.frame = 1, .time = {100'050'000'000}, .value = note::DriveSaid{{0}, {0x5A}, true}});
  log->notes.append({.frame = 2, .time = {100'150'000'000}, .value = note::Mark{"before"}});
  log->notes.append({.frame = 5, .time = {100'450'000'000}, .value = note::Mark{"in it"}});
  const Outcome outcome = save({.begin = 4, .end = 6, .labels = {{other, "tail"}}});
  EXPECT_EQ(outcome.written, 2u);
  EXPECT_EQ(outcome.added, 3u);
  const auto read = reopened();
  ASSERT_EQ(read->frames.count(), 5u);
  EXPECT_EQ(line(*read, 0), "(0000000100.400000) can0 18EEFF80#0000C02800840000\n");
  EXPECT_EQ(line(*read, 1), "(0000000100.400000) can0 18EFFF80#FF83150206021A0B\n");
  EXPECT_EQ(line(*read, 2), "(0000000100.400000) can1 18EFFF81#FF83150206021A0C\n");
  EXPECT_EQ(line(*read, 3), line(*log, 4));
  EXPECT_EQ(line(*read, 4), line(*log, 5));
  EXPECT_EQ(told(*read), (std::vector<std::string>{"0 drive_said", "0 added", "2 label", "4 mark"}));
  EXPECT_EQ(read->notes.all()[1].value, NoteValue(note::Added{3}));
  const State state = stateOf(*read);
  ASSERT_NE(state.devices().byPin(monitor), nullptr);
  ASSERT_NE(state.devices().byPin(other), nullptr);
  EXPECT_EQ(state.devices().byPin(other)->address, Address{0x81});
  EXPECT_EQ(state.channel({0}).book.holder({0x80}), stateOf(*log).channel({0}).book.holder({0x80}));
}

TEST_F(SavedPartTest, WhatPassesAFilterBeginsSoTooAndIsMarkedFrameByFrameWhenSavedAgain) {
  const Outcome first = save({.passes = [](std::uint64_t frame) { return frame >= 3; }, .filter = "late"});
  EXPECT_EQ(first.written, 3u);
  EXPECT_EQ(first.added, 3u);
  log = reopened();
  EXPECT_TRUE(stateOf(*log).isFiltered());
  const Outcome again = save({.passes = [](std::uint64_t frame) { return frame != 3; }, .filter = "not t=3"});
  EXPECT_EQ(again.written, 5u);
  EXPECT_EQ(again.added, 0u);
  const auto read = reopened();
  EXPECT_EQ(told(*read),
            (std::vector<std::string>{"0 filtered", "0 filtered", "0 added", "1 added", "2 added"}));
  EXPECT_EQ(read->notes.filters(), (std::vector<std::string>{"late", "not t=3"}));
  EXPECT_EQ(read->notes.all()[2].value, NoteValue(note::Added{1}));
  log = read;
  save({.begin = 4, .end = 5});
  EXPECT_EQ(reopened()->notes.filters(), (std::vector<std::string>{"late", "not t=3"})) << "a part of it";
}

TEST_F(SavedPartTest, AFilterIsNotedInARecordingTooAndWhereNothingPassesIt) {
  const auto none = [](std::uint64_t) { return false; };
  save({.passes = none, .filter = "pgn=FECA"});
  EXPECT_EQ(reopened()->frames.count(), 0u);
  EXPECT_EQ(reopened()->notes.filters(), std::vector<std::string>{"pgn=FECA"});
  path = dir.filePath(QStringLiteral("part.deckpipe"));
  save({.passes = [](std::uint64_t frame) { return frame == 5; }, .filter = "sa=80"});
  EXPECT_EQ(reopened()->notes.filters(), std::vector<std::string>{"sa=80"});
}

TEST_F(SavedPartTest, ASelectionIsWholeWithinItself) {
  save({.begin = 2, .end = 6});
  EXPECT_FALSE(stateOf(*reopened()).isFiltered());
}

TEST_F(LogSavingTest, SaysWhyADiskTakesOnlyAPartOfIt) {
  const test::FileSizeLimit limit(100'000);
  for (const char* name : {"part.log", "part.deckpipe"}) {
    LogSaving saving(log, dir.filePath(QString::fromLatin1(name)));
    QSignalSpy ended(&saving, &LogSaving::ended);
    ASSERT_TRUE(ended.wait(kPatience));
    EXPECT_EQ(ended.at(0).at(0).value<LogSaving::Outcome>(), LogSaving::Outcome::Failed);
    EXPECT_EQ(ended.at(0).at(1).toString(), QStringLiteral("File too large"));
  }
  EXPECT_EQ(writeWholeFile(path, std::string(150'000, 'x')), QStringLiteral("File too large"));
  EXPECT_TRUE(QDir(dir.path()).isEmpty());
}

// Without the claim the second monitor's status would be the first one's.
TEST_F(SavedPartTest, WhoComesLaterIsAddedThoughAFilterHoldsItBack) {
  log = test::logOfText(
      "(100.000000) can0 18EFFF80#FF83150206021A0B\n"
      "(100.100000) can0 18EFFF80#011D940371000041\n"
      "(100.200000) can0 18EEFF80#0100200000000000\n"  // another NAME takes the address
      "(100.300000) can0 18EF80F9#02\n"
      "(100.800000) can0 18EFFF80#01000C0371000041\n");
  const Outcome outcome = save({.passes = [](std::uint64_t frame) { return frame == 1 || frame == 4; }});
  EXPECT_EQ(outcome.written, 2u);
  EXPECT_EQ(outcome.added, 2u);
  const auto read = reopened();
  EXPECT_EQ(told(*read), (std::vector<std::string>{"0 filtered", "0 added", "2 added"}));
  EXPECT_EQ(line(*read, 2), line(*log, 2));
  EXPECT_EQ(stateOf(*read).channel({0}).book.holder({0x80}), stateOf(*log).channel({0}).book.holder({0x80}));
}

// What the filter held back was said behind the gap, and what is added at the begin must be behind it too.
TEST_F(SavedPartTest, APinThatWasSaidBehindAGapIsNotFormer) {
  log = test::logOfText(
      "(100.000000) can0 18EFFF80#011D940371000041\n"
      "(100.100000) can0 18EFFF80#011D940371000041\n"
      "(102.000000) can0 18EFFF80#FF83150206021A0B\n"
      "(102.100000) can0 18EFFF80#011D940371000041\n");
  log->notes.append({.frame = 0, .time = {99'000'000'000}, .value = note::LinkUp{}});
  log->notes.append({.frame = 2, .time = {101'000'000'000}, .value = note::LinkDown{}});
  log->notes.append({.frame = 2, .time = {101'900'000'000}, .value = note::LinkUp{}});
  for (const std::uint64_t begin : {0u, 1u, 2u}) {
    EXPECT_EQ(
        save({.begin = begin, .passes = [](std::uint64_t frame) { return frame == 3; }, .filter = "late"})
            .added,
        1u);
    EXPECT_NE(stateOf(*reopened()).devices().byPin(monitor), nullptr) << begin;
  }
}

TEST_F(SavedPartTest, APinThatWasSaidBeforeAGapIsFormerInAPartThatBeginsBehindIt) {
  log->notes.append({.frame = 4, .time = {100'310'000'000}, .value = note::LinkDown{}});
  log->notes.append({.frame = 4, .time = {100'390'000'000}, .value = note::LinkUp{}});
  EXPECT_EQ(save({.begin = 4, .end = 6}).added, 1u) << "of the other channel";
  const State state = stateOf(*reopened());
  EXPECT_EQ(state.devices().byPin(monitor), nullptr);
  EXPECT_NE(state.devices().byPin(other), nullptr);
}

TEST_F(SavedPartTest, FramesThatTheFilesReaderSkippedAreNoted) {
  const std::string text = std::string(kSimulator) + "(100.600000) can0 123##1001122\n";
  log = test::logOfText(text);
  ASSERT_EQ(log->skipped.content().skipped(), 1u);
  save({.begin = 3, .end = 5});
  EXPECT_EQ(reopened()->notes.missedFrames(), 0u) << "nobody knows whether it was one of the part's";
  save();
  log = reopened();
  EXPECT_EQ(told(*log), std::vector<std::string>{"6 left_out"});
  EXPECT_EQ(log->notes.missedFrames(), 1u);
  save();
  EXPECT_EQ(reopened()->notes.missedFrames(), 1u) << "once";
}

TEST_F(SavedPartTest, SkippedFramesKeepTheirKind) {
  log->skipped.add(7, Skipped::CanFd);
  log->skipped.add(8, Skipped::CanXl);
  log->skipped.add(9, Skipped::CanXl);
  save();
  std::vector<note::LeftOut> leftOut;
  for (const Note& note : reopened()->notes.all()) leftOut.push_back(std::get<note::LeftOut>(note.value));
  using Why = note::LeftOut::Why;
  EXPECT_EQ(leftOut, (std::vector<note::LeftOut>{{Channel{0}, Why::CanFd, 1}, {Channel{0}, Why::CanXl, 2}}));
}

TEST_F(SavedPartTest, ThatItsFileHadUnreadableLinesAndPlacesWhereTheRecorderLostFramesIsNoted) {
  log->skipped.add(7, Skipped::Data);
  log->skipped.add(8, Skipped::Layout);
  log->skipped.add(9, Skipped::RecorderDropped);
  save({.begin = 3, .end = 5});
  EXPECT_EQ(told(*reopened()), std::vector<std::string>{"0 added"}) << "nobody knows whether it was there";
  for (const char* name : {"part.log", "part.deckpipe"}) {
    path = dir.filePath(QString::fromLatin1(name));
    save();
    EXPECT_EQ(told(*reopened()), (std::vector<std::string>{"6 left_out", "6 left_out"}));
    EXPECT_EQ(reopened()->notes.missedFrames(), 0u) << "they are no frames that can be counted";
  }
}

TEST_F(SavedPartTest, ThatItsFileWasNotWholeIsNoted) {
  save({.begin = 3, .end = 5, .missing = 2});
  EXPECT_EQ(told(*reopened()).back().substr(1), " left_out") << "it may have been there";
  for (const char* name : {"part.log", "part.deckpipe"}) {
    path = dir.filePath(QString::fromLatin1(name));
    save({.missing = 2});
    EXPECT_EQ(told(*reopened()), std::vector<std::string>{"6 left_out"});
    EXPECT_EQ(reopened()->notes.missedFrames(), 0u);
  }
}

TEST_F(SavedPartTest, WhoLeftItsAddressIsNotAddedThere) {
  log = test::logOfText(
      "(100.000000) can0 18EFFF80#FF83150206021A0B\n"
      "(100.100000) can0 18EFFF82#FF83150206021A0B\n"  // the same PIN at another address
      "(100.200000) can0 18EFFF83#FF83150206021A0C\n"
      "(100.300000) can0 18EFFF83#FF83150206021A0D\n"  // another PIN at the same
      "(100.400000) can0 18EFFF82#011D940371000041\n");
  EXPECT_EQ(save({.begin = 4, .end = 5}).added, 2u);
  const auto read = reopened();
  EXPECT_EQ(line(*read, 0), "(0000000100.400000) can0 18EFFF82#FF83150206021A0B\n");
  EXPECT_EQ(line(*read, 1), "(0000000100.400000) can0 18EFFF83#FF83150206021A0D\n");
}

TEST_F(SavedPartTest, VersionsAreThoseOfWhoHasTheAddressThen) {
  log = test::logOfText(
      "(100.000000) can0 18EFFF80#FF83150206021A0B\n"
      "(100.100000) can0 18EFF980#03010203040506\n"  // its firmware
      "(100.200000) can0 18EFFF83#FF83150206021A0C\n"
      "(100.300000) can0 18EFF983#03010203040506\n"
      "(100.400000) can0 18EFFF83#FF83150206021A0D\n"  // another PIN at the same
      "(100.500000) can0 18EFFF80#011D940371000041\n");
  EXPECT_EQ(save({.begin = 5, .end = 6}).added, 3u);
  const auto read = reopened();
  EXPECT_EQ(line(*read, 0), "(0000000100.500000) can0 18EFFF80#FF83150206021A0B\n");
  EXPECT_EQ(line(*read, 1), "(0000000100.500000) can0 18EFF980#03010203040506\n");
  EXPECT_EQ(line(*read, 2), "(0000000100.500000) can0 18EFFF83#FF83150206021A0D\n");
}

TEST_F(SavedPartTest, AddedFramesHaveTheStampThatTheirChannelsClockShows) {
  log = std::make_shared<LogDocument>();
  const std::uint8_t wall = log->frames.channel("can0"), own = log->frames.channel("can1");
  const auto hear = [&](Frame frame, std::uint8_t channel, std::int64_t stamp, Instant now) {
    frame.channel = channel;
    frame.stamp = stamp;
    Arrival arrival{.now = now, .reached = now - 1s};
    if (channel == wall) arrival.wallOffset = Duration{-1'700'000'000'000'000'000};
    ASSERT_TRUE(log->frames.append({&frame, 1}, arrival));
  };
  const Frame announced = test::frame("18EFFF80", "FF83150206021A0B");
  const Frame position = test::frame("18EFFF80", "011D940371000041");
  hear(announced, wall, 1'700'000'010'000'000'000, {10'000'000'000});
  hear(announced, own, 5'000'000'000, {11'000'000'000});
  hear(position, wall, 1'700'000'020'000'000'000, {20'000'000'000});
  hear(position, own, 14'500'000'000, {20'500'000'000});
  EXPECT_EQ(save({.begin = 2, .end = 4}).added, 2u);
  const auto read = reopened();
  EXPECT_EQ(read->frames[0].stamp, 1'700'000'020'000'000'000);
  EXPECT_EQ(read->frames[1].stamp, 14'000'000'000);
  EXPECT_EQ(read->frames.jumps().size(), 0u);
  EXPECT_EQ(read->frames.lastTime() - read->frames.timeAt(0), Duration{500ms});
}

TEST_F(SavedPartTest, ARecordingHoldsItsNotesItself) {
  path = dir.filePath(QStringLiteral("part.deckpipe"));
  log->notes.append({.frame = 5, .time = {100'450'000'000}, .value = note::Mark{"in it"}});
  const Outcome outcome = save({.begin = 4, .end = 6, .labels = {{monitor, "front"}}});
  EXPECT_EQ(outcome.added, 3u);
  EXPECT_EQ(outcome.sidecar, QString());
  EXPECT_EQ(files(), QStringList{QStringLiteral("part.deckpipe")});
  const auto read = reopened();
  EXPECT_EQ(told(*read), (std::vector<std::string>{"0 added", "1 label", "4 mark"}));
  EXPECT_EQ(read->notes.all()[2].time, Instant{100'450'000'000});
  EXPECT_EQ(read->frames.timeAt(3), log->frames.timeAt(4));
  EXPECT_EQ(line(*read, 4), line(*log, 5));
}

TEST_F(SavedPartTest, SavingOverALogReplacesOrRemovesItsSidecar) {
  log->notes.append({.frame = 6, .time = {100'500'000'000}, .value = note::Mark{"old"}});
  save();
  ASSERT_EQ(files().size(), 2);
  EXPECT_EQ(save({.begin = 0, .end = 3}).sidecar, QString());
  EXPECT_EQ(files(), QStringList{QStringLiteral("part.log")});
  EXPECT_EQ(reopened()->notes.count(), 0u);
}

TEST_F(SavedPartTest, NothingIsReplacedWhereMarksStandBesideItThatAreNotKnownHere) {
  log->notes.append({.frame = 6, .time = {100'500'000'000}, .value = note::Mark{"old"}});
  save();
  const QString sidecar = path + QStringLiteral(".deckpipe-notes");
  const auto contents = [&] {
    QByteArray all;
    for (const QString& name : {path, sidecar}) {
      QFile file(name);
      if (file.open(QIODevice::ReadOnly)) all += file.readAll();
    }
    return all;
  };
  EXPECT_EQ(save({.begin = 0, .end = 5}).outcome, LogSaving::Outcome::Saved) << "they are our own";
  save();
  QFile another(sidecar);
  ASSERT_TRUE(another.open(QIODevice::WriteOnly));
  another.write("marks of another window\n");
  ASSERT_TRUE(another.flush());  // or closing it would be the last change
  ASSERT_TRUE(another.setFileTime(QDateTime::currentDateTime().addSecs(5), QFile::FileModificationTime));
  another.close();
  const QByteArray before = contents();
  const Outcome changed = save({.begin = 0, .end = 3});
  EXPECT_EQ(changed.outcome, LogSaving::Outcome::SidecarUnknown);
  EXPECT_EQ(changed.reason, QString()) << "the window has its own words";
  EXPECT_EQ(contents(), before);
  sidecars = std::make_shared<KnownSidecars>();
  EXPECT_EQ(save().outcome, LogSaving::Outcome::SidecarUnknown) << "it was never read";
  EXPECT_EQ(contents(), before);
  ASSERT_TRUE(another.remove());
  EXPECT_EQ(save().outcome, LogSaving::Outcome::Saved) << "there is nothing to lose";
}

TEST_F(SavedPartTest, ASidecarThatCannotBeWrittenIsSaidAndTheLogStays) {
  log->notes.append({.frame = 6, .time = {100'500'000'000}, .value = note::Mark{"old"}});
  ASSERT_TRUE(QDir(dir.path()).mkdir(QStringLiteral("part.log.deckpipe-notes")));
  const Outcome outcome = save();
  EXPECT_EQ(outcome.outcome, LogSaving::Outcome::Saved);
  EXPECT_NE(outcome.reason, QString());
  EXPECT_EQ(outcome.sidecar, QString());
  QDir(dir.path()).rmdir(QStringLiteral("part.log.deckpipe-notes"));
  EXPECT_EQ(reopened()->frames.count(), 6u);
}

}  // namespace
}  // namespace deckpipe
