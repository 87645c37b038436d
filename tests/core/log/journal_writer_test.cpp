// SPDX-License-Identifier: GPL-3.0-or-later
// When a journal is written and synced, and what a full disk, a failing one, a kill and a power cut cost.
#include "log/journal_writer.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "support/journals.h"

namespace deckpipe {
namespace {

using test::FakeDisk;
using test::Recording;
using test::told;

constexpr Instant at(std::int64_t ms) { return {ms * 1'000'000}; }

struct JournalWriterTest : testing::Test {
  Recording log;
  FakeDisk disk;
  JournalWriter writer{log.frames, log.notes, disk.maker(), test::someHead};

  // Of what is on the disk.
  std::uint64_t readable(const JournalBytes& bytes) const {
    Recording read;
    read.read(bytes);
    return read.result ? read.frames.count() : 0;
  }
};

TEST_F(JournalWriterTest, MakesNoFileBeforeTheFirstFrame) {
  log.notes.append({.value = note::LinkUp{}});
  writer.timeCame(at(0));
  EXPECT_EQ(disk.made, 0);
  EXPECT_EQ(writer.status(), JournalStatus{});
  log.fill();
  writer.timeCame(at(250));
  EXPECT_EQ(disk.made, 1);
  EXPECT_EQ(writer.status().path, "fake");
  EXPECT_EQ(writer.status().frames, log.frames.count());
  EXPECT_EQ(writer.status().bytes, disk.bytes.size());
}

TEST_F(JournalWriterTest, LeavesNoFileOfALogWithoutFrames) {
  log.notes.append({.value = note::LinkUp{}});
  writer.timeCame(at(0));
  writer.end();
  EXPECT_EQ(disk.made, 0);
}

TEST_F(JournalWriterTest, WritesNothingWhereNothingIsNew) {
  log.fill();
  writer.timeCame(at(0));
  const std::size_t appends = disk.appends;
  for (int i = 1; i < 10; ++i) writer.timeCame(at(250 * i));
  EXPECT_EQ(disk.appends, appends);
}

TEST_F(JournalWriterTest, OfASilenceLosesLessThanASecondWhereverItIsCut) {
  log.fill();
  const Instant last = log.notes.lastTime();
  std::size_t before = 0;
  for (Duration silence = 0s; silence <= 30s; silence += 250ms) {
    log.notes.append({.time = last + silence, .value = note::RanUntil{}});
    writer.timeCame(last + silence);
    if (silence == 0s) before = disk.bytes.size();
    Recording read;
    read.read(disk.bytes);
    ASSERT_TRUE(read.result);
    EXPECT_EQ(told(read.frames), told(log.frames));
    EXPECT_EQ(read.notes.all(), log.notes.all());
    EXPECT_LE(std::max(read.notes.ranUntil(), last), last + silence);
    EXPECT_LT(last + silence - std::max(read.notes.ranUntil(), last), 750ms) << silence.count();
  }
  EXPECT_LT(disk.bytes.size() - before, 60u * 64) << "a few bytes each half second";
  log.notes.append({.time = last + 30'100ms, .value = note::RanUntil{}});
  writer.end();
  Recording read;
  read.read(disk.bytes);
  EXPECT_EQ(read.notes.ranUntil(), last + 30'100ms) << "at the end all of it is written";
  EXPECT_FALSE(read.result.value().isOpenEnded);
}

TEST_F(JournalWriterTest, SyncsAtLeastEachSecond) {
  std::uint64_t lastSynced = 0;
  std::int64_t lastSync = 0;
  for (std::int64_t ms = 0; ms < 10'000; ms += 250) {
    log.fill();
    writer.timeCame(at(ms));
    EXPECT_EQ(readable(disk.bytes), log.frames.count()) << "written at each call";
    if (const std::uint64_t synced = readable(disk.synced); synced != lastSynced) {
      lastSynced = synced;
      lastSync = ms;
    }
    EXPECT_LT(ms - lastSync, 1'000);
  }
}

TEST_F(JournalWriterTest, GoesOnAfterAFullDiskWithoutLosingAnything) {
  log.fill();
  writer.timeCame(at(0));
  const std::uint64_t before = log.frames.count();
  for (const std::size_t more : {0u, 1u, 50u}) {
    disk.room = disk.bytes.size() + more;
    log.fill();
    writer.timeCame(at(250));
    EXPECT_EQ(writer.status().fault.kind, JournalFault::Kind::DiskFull);
    EXPECT_EQ(readable(disk.bytes), before) << "what was written before is whole";
  }
  const std::size_t appends = disk.appends;
  disk.room = SIZE_MAX;
  writer.timeCame(at(10'249));
  EXPECT_EQ(disk.appends, appends) << "not before its time";
  writer.timeCame(at(10'250));
  EXPECT_EQ(writer.status().fault, JournalFault{});
  Recording read;
  read.read(disk.bytes);
  EXPECT_EQ(told(read.frames), told(log.frames));
  EXPECT_EQ(read.notes.all(), log.notes.all());
}

TEST_F(JournalWriterTest, WritesAgainWhatAFailedSyncMayHaveLost) {
  log.fill();
  writer.timeCame(at(0));
  log.fill();
  disk.failingSyncs = 1;
  writer.timeCame(at(1'000));
  EXPECT_EQ(writer.status().fault.kind, JournalFault::Kind::CannotWrite);
  log.fill();
  writer.timeCame(at(11'000));
  EXPECT_EQ(writer.status().fault, JournalFault{});
  Recording read;
  read.read(disk.synced);
  EXPECT_EQ(told(read.frames), told(log.frames));
  EXPECT_EQ(read.notes.all(), log.notes.all());
}

TEST_F(JournalWriterTest, TriesToMakeItsFileAgain) {
  bool isAllowed = false;
  JournalWriter tried(
      log.frames, log.notes,
      [&]() -> MadeJournalFile {
        if (!isAllowed) return Failure{JournalFault{JournalFault::Kind::CannotCreate, "no folder"}};
        return disk.maker()();
      },
      test::someHead);
  log.fill();
  tried.timeCame(at(0));
  EXPECT_EQ(tried.status().fault, (JournalFault{JournalFault::Kind::CannotCreate, "no folder"}));
  isAllowed = true;
  tried.timeCame(at(10'000));
  EXPECT_EQ(readable(disk.bytes), log.frames.count());
}

TEST_F(JournalWriterTest, EndsAtOnceEvenAfterAFault) {
  log.fill();
  disk.room = 0;
  writer.timeCame(at(0));
  disk.room = SIZE_MAX;
  writer.end();
  Recording read;
  read.read(disk.synced);
  ASSERT_TRUE(read.result);
  EXPECT_FALSE(read.result.value().isOpenEnded);
  EXPECT_EQ(told(read.frames), told(log.frames));
  EXPECT_TRUE(writer.status().isEnded);
}

// --- On a real disk.

struct JournalOnDisk : testing::Test {
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
  JournalWriter::MakeFile maker() const {
    return [this] { return createJournalFile(folder + "/recording"); };
  }
  std::string folder = testing::TempDir() + "/journal-" + std::to_string(::getpid());
  std::string path = folder + "/recording.deckpipe";
};

TEST_F(JournalOnDisk, IsReadWhileItGrowsAndAfterItsEnd) {
  Recording log;
  JournalWriter writer(log.frames, log.notes, maker(), test::someHead);
  for (int i = 0; i < 3; ++i) {
    log.fill(20);
    writer.timeCame(at(250 * i));
    EXPECT_TRUE(isBeingWritten(path));
    Recording read;
    read.result = openLog(path, read.target());
    ASSERT_TRUE(read.result);
    EXPECT_TRUE(read.result.value().isOpenEnded);
    EXPECT_EQ(told(read.frames), told(log.frames));
  }
  writer.end();
  Recording read;
  read.result = openLog(path, read.target());
  EXPECT_FALSE(read.result.value().isOpenEnded);
  EXPECT_EQ(read.notes.all(), log.notes.all());
}

// What another program, or a person, does to the file while it grows.
struct TakenFile {
  const char* name;
  void (*take)(const std::string& path);
  JournalFault::Kind fault;
};
class JournalTakenAway : public JournalOnDisk, public testing::WithParamInterface<TakenFile> {
 protected:
  void expectAllIn(const std::string& file) const {
    Recording read;
    read.result = openLog(file, read.target());
    ASSERT_TRUE(read.result) << file;
    EXPECT_TRUE(read.result.value().damage.places == 0);
    EXPECT_EQ(told(read.frames), told(log.frames));
    EXPECT_EQ(read.notes.all(), log.notes.all());
  }
  Recording log;
  JournalWriter writer{log.frames, log.notes, maker(), test::someHead};
};

TEST_P(JournalTakenAway, IsSaidWithinASecondAndBegunAnewWithAllOfIt) {
  log.fill(20);
  writer.timeCame(at(0));
  GetParam().take(path);
  log.fill();
  for (int ms = 250; ms <= 1'000 && !writer.status().fault; ms += 250) writer.timeCame(at(ms));
  EXPECT_EQ(writer.status().fault, (JournalFault{GetParam().fault, path}));
  EXPECT_EQ(writer.status().frames, 0u) << "none is in a file";
  log.fill();
  writer.timeCame(at(1'250));
  EXPECT_EQ(writer.status().fault, JournalFault{});
  EXPECT_EQ(writer.status().givenUp, (JournalFault{GetParam().fault, path}));
  expectAllIn(writer.status().path);
  log.fill();
  writer.end();
  EXPECT_TRUE(writer.status().isEnded);
  expectAllIn(writer.status().path);
  EXPECT_EQ(writer.status().givenUp.detail, path);
}

TEST_P(JournalTakenAway, IsBegunAnewAtItsEndToo) {
  log.fill();
  writer.timeCame(at(0));
  GetParam().take(path);
  writer.end();
  EXPECT_TRUE(writer.status().isEnded);
  expectAllIn(writer.status().path);
}

TEST_P(JournalTakenAway, IsNotBegunAnewMoreOftenThanADiskIsTriedAgain) {
  log.fill();
  int made = 0;
  JournalWriter counted(
      log.frames, log.notes,
      [&] {
        ++made;
        return createJournalFile(folder + "/recording");
      },
      test::someHead);
  for (int ms = 0; ms < 30'000; ms += 250) {
    counted.timeCame(at(ms));
    if (!counted.status().path.empty()) GetParam().take(counted.status().path);
  }
  EXPECT_EQ(made, 4) << "the first one again at once, then every ten seconds";
}

INSTANTIATE_TEST_SUITE_P(
    By, JournalTakenAway,
    testing::Values(
        TakenFile{"Removal", [](const std::string& path) { std::filesystem::remove(path); },
                  JournalFault::Kind::Removed},
        TakenFile{"AnotherFileOfItsName",
                  [](const std::string& path) {
                    std::ofstream(path + ".other") << "something else";
                    std::filesystem::rename(path + ".other", path);
                  },
                  JournalFault::Kind::Removed},
        TakenFile{"Emptying", [](const std::string& path) { std::filesystem::resize_file(path, 0); },
                  JournalFault::Kind::Changed},
        TakenFile{"Cutting", [](const std::string& path) { std::filesystem::resize_file(path, 100); },
                  JournalFault::Kind::Changed},
        TakenFile{"WritingIntoIt", [](const std::string& path) { std::ofstream(path, std::ios::app) << "x"; },
                  JournalFault::Kind::Changed}),
    [](const auto& param) { return param.param.name; });

TEST_F(JournalOnDisk, GoesOnInAFileThatIsRenamed) {
  Recording log;
  log.fill();
  JournalWriter writer(log.frames, log.notes, maker(), test::someHead);
  writer.timeCame(at(0));
  const std::string renamed = folder + "/mine.deckpipe";
  std::filesystem::rename(path, renamed);
  log.fill();
  writer.timeCame(at(1'000));
  EXPECT_EQ(writer.status().fault, JournalFault{});
  EXPECT_TRUE(std::filesystem::equivalent(writer.status().path, renamed)) << writer.status().path;
  writer.end();
  Recording read;
  read.result = openLog(renamed, read.target());
  EXPECT_EQ(told(read.frames), told(log.frames));
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(JournalOnDisk, HasANameOfItsOwn) {
  std::vector<std::unique_ptr<JournalFile>> files;
  for (const char* name : {"recording", "recording-2", "recording-3"}) {
    MadeJournalFile made = createJournalFile(folder + "/recording");
    ASSERT_TRUE(made);
    EXPECT_EQ(made.value()->path(), folder + "/" + name + ".deckpipe");
    files.push_back(std::move(made.value()));
  }
  const MadeJournalFile none = createJournalFile(folder + "/absent/recording");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error(), (JournalFault{JournalFault::Kind::CannotCreate, "No such file or directory"}));
}

TEST_F(JournalOnDisk, IsMarkedAsSavedOnlyOnceNobodyWritesIt) {
  Recording log;
  log.fill();
  {
    JournalWriter writer(log.frames, log.notes, maker(), test::someHead);
    writer.timeCame(at(0));
    EXPECT_TRUE(markJournalSaved(path));
    writer.end();
  }
  EXPECT_FALSE(isBeingWritten(path));
  EXPECT_FALSE(markJournalSaved(path));
  Recording read;
  read.result = openLog(path, read.target());
  ASSERT_TRUE(read.result);
  EXPECT_EQ(told(read.frames), told(log.frames));
  JournalBytes head(JournalHead::kBytes);
  BytesOfFile file;
  std::vector<char> buffer;
  std::string_view piece;
  ASSERT_EQ(file.open(path), "");
  ASSERT_EQ(file.get(0, JournalHead::kBytes, buffer, piece), "");
  std::ranges::copy(piece, head.begin());
  JournalHead taken;
  ASSERT_TRUE(takeJournalHead(head, taken));
  EXPECT_TRUE(taken.isSaved);
  EXPECT_EQ(taken.begin, test::someHead().begin);
  EXPECT_TRUE(markJournalSaved(folder)) << "a folder is no journal";
}

// A frame whose bytes are its number, so that a hole or an invention shows.
Frame numbered(std::uint64_t i) {
  Frame frame = test::frame("18EFFF80", "0000000000000000");
  std::memcpy(frame.data.data(), &i, sizeof i);
  frame.stamp = static_cast<std::int64_t>(i) * 1'000;
  return frame;
}

TEST_F(JournalOnDisk, KilledAtAnyMomentHasEveryFrameThatWasWritten) {
  std::mt19937 random(1);
  for (int round = 0; round < 40; ++round) {
    std::filesystem::remove(path);
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      Recording log;
      log.frames.channel("can0");
      JournalWriter writer(log.frames, log.notes, maker(), test::someHead);
      for (std::int64_t poll = 0;; ++poll) {
        for (int i = 0; i < 50; ++i) {
          const Frame frame = numbered(log.frames.count());
          if (i % 10 == 0) log.notes.append({.frame = log.frames.count(), .value = note::Mark{"here"}});
          if (!log.frames.append({&frame, 1})) ::_exit(1);
        }
        writer.timeCame(at(250 * poll));
        const std::uint64_t written = writer.status().frames;
        if (::write(ends[1], &written, sizeof written) != sizeof written) ::_exit(1);
      }
    }
    ::close(ends[1]);
    // So many polls, and a little further into the next one.
    std::uint64_t written = 0;
    for (auto polls = random() % 30 + 1; polls > 0; --polls)
      ASSERT_EQ(::read(ends[0], &written, sizeof written), ssize_t{sizeof written});
    for (volatile std::uint64_t spin = random() % 20'000; spin > 0;) spin = spin - 1;
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    for (std::uint64_t more = 0; ::read(ends[0], &more, sizeof more) == sizeof more;) written = more;
    ::close(ends[0]);

    EXPECT_FALSE(isBeingWritten(path));
    Recording read;
    read.result = openLog(path, read.target());
    ASSERT_TRUE(read.result);
    EXPECT_GE(read.frames.count(), written);
    for (std::uint64_t i = 0; i < read.frames.count(); ++i) ASSERT_EQ(read.frames[i], numbered(i));
    for (std::size_t n = 0; const Note& note : read.notes.all()) EXPECT_EQ(note.frame, 10 * n++);
    EXPECT_GE(read.notes.count(), written / 10);
  }
}

// The limit of a file's size stands in for a disk that is full.
TEST_F(JournalOnDisk, KeepsWhatFitsOnAFullDiskAndGoesOnWhenThereIsRoom) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto ignored = ::signal(SIGXFSZ, SIG_IGN);
  Recording log;
  JournalWriter writer(log.frames, log.notes, maker(), test::someHead);
  log.fill(50);
  writer.timeCame(at(0));
  const std::uint64_t written = log.frames.count();
  const rlimit full{writer.status().bytes + 100, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &full), 0);
  log.fill(50);
  writer.timeCame(at(250));
  EXPECT_EQ(writer.status().fault.kind, JournalFault::Kind::DiskFull);
  Recording read;
  read.result = openLog(path, read.target());
  EXPECT_EQ(read.frames.count(), written);
  EXPECT_EQ(read.result.value().cutBytes, 0u);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  ::signal(SIGXFSZ, ignored);
  writer.timeCame(at(10'250));
  writer.end();
  Recording whole;
  whole.result = openLog(path, whole.target());
  EXPECT_EQ(told(whole.frames), told(log.frames));
}

}  // namespace
}  // namespace deckpipe
