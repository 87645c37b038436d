// SPDX-License-Identifier: GPL-3.0-or-later
// What is received is written down behind the store, on a disk that works and on one that hangs; and what a
// folder of recordings says of itself.
#include "session/recorder.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <condition_variable>
#include <mutex>

#include "log/log_format.h"
#include "session/recordings.h"
#include "session/session.h"
#include "state/advance.h"
#include "state/health.h"
#include "support/journals.h"
#include "support/patience.h"

namespace deckpipe {
namespace {

const Frame kAnnouncement = test::frame("18EFFF80", "FF83150206021A0B");
const Frame kPosition = test::frame("18EFFF80", "011D940371000041");

template <typename Condition>
bool waitFor(Condition condition) {
  return QTest::qWaitFor(condition, kPatience);
}

bool append(LogDocument& log, Frame frame) {
  frame.channel = log.frames.channel("can0");
  return log.frames.append({&frame, 1}, Arrival{.now = Instant{1'000'000'000}});
}

struct InAFolder : testing::Test {
  QTemporaryDir dir;
  QString folder = dir.filePath(QStringLiteral("data/recordings"));

  QStringList files() const { return QDir(folder).entryList(QDir::Files, QDir::Name); }
  // A recording that ended, with so many frames.
  QString record(int count, bool isSimulated = false, bool isSaved = false) {
    const auto log = std::make_shared<LogDocument>();
    for (int i = 0; i < count; ++i) EXPECT_TRUE(append(*log, i == 0 ? kAnnouncement : kPosition));
    Recorder recorder(log, recordingIn(folder), isSimulated);
    if (isSaved) recorder.setSaved(static_cast<std::uint64_t>(count), log->notes.count());
    recorder.end();
    EXPECT_TRUE(waitFor([&] { return recorder.hasEnded(); }));
    return QString::fromStdString(recorder.status().path);
  }
};

TEST_F(InAFolder, ARecordingBeginsWithItsFirstFrameAndCanBeReadWhileItGrows) {
  const auto log = std::make_shared<LogDocument>();
  log->notes.append({.value = note::LinkUp{}});
  Recorder recorder(log, recordingIn(folder), false);
  EXPECT_TRUE(recorder.status().path.empty());
  ASSERT_TRUE(append(*log, kAnnouncement));
  ASSERT_TRUE(waitFor([&] { return recorder.status().frames == 1; }));
  ASSERT_EQ(files().size(), 1);
  EXPECT_TRUE(QRegularExpression(QStringLiteral("^\\d{4}-\\d\\d-\\d\\d_\\d\\d-\\d\\d-\\d\\d\\.deckpipe$"))
                  .match(files().first())
                  .hasMatch())
      << files().first().toStdString();
  const Recording growing = readRecording(folder + QLatin1Char('/') + files().first());
  EXPECT_TRUE(growing.isGrowing);
  EXPECT_FALSE(growing.isUnsaved());
  EXPECT_EQ(growing.frames, 1u);
  EXPECT_EQ(growing.pins, QStringList{QStringLiteral("1032AE100801035")});
  ASSERT_TRUE(append(*log, kPosition));
  recorder.end();
  ASSERT_TRUE(waitFor([&] { return recorder.hasEnded(); }));
  const Recording ended = readRecording(growing.path);
  EXPECT_EQ(ended.frames, 2u) << "what came last is written before the end";
  EXPECT_TRUE(ended.isWhole);
  EXPECT_TRUE(ended.isUnsaved());
  EXPECT_FALSE(ended.isGrowing);
  EXPECT_LE(qAbs(ended.begin.secsTo(QDateTime::currentDateTime())), 3'600);
}

// As a kill would leave it: it is read while it is being written.
TEST_F(InAFolder, ASilenceAtTheEndOfAKilledRecordingIsReadBack) {
  const auto log = std::make_shared<LogDocument>();
  log->notes.append({.value = note::LinkUp{{0}}});
  ASSERT_TRUE(append(*log, kAnnouncement));
  ASSERT_TRUE(append(*log, kPosition));
  log->notes.append({.time = log->frames.lastTime() + 30s, .value = note::RanUntil{}});
  const Recorder recorder(log, recordingIn(folder), false);
  ASSERT_TRUE(waitFor([&] { return recorder.status().frames == 2; }));
  const QString path = QString::fromStdString(recorder.status().path);
  test::Recording read;
  read.result = openLog(path.toStdString(), read.target());
  ASSERT_TRUE(read.result);
  State state;
  advance(state, read.frames, read.notes, endOf(read.frames, read.notes));
  const Device* monitor = state.devices().byPin(*Pin::parse("1032AE100801035"));
  ASSERT_NE(monitor, nullptr);
  const Health health = healthOf(state, *monitor);
  EXPECT_TRUE(health.has(HealthCause::Silent));
  EXPECT_EQ(health.since, log->frames.timeAt(1));
  EXPECT_EQ(readRecording(path).length, Duration{30s});
}

TEST_F(InAFolder, ARecordingWhoseFolderIsRemovedIsWrittenAnew) {
  const auto log = std::make_shared<LogDocument>();
  ASSERT_TRUE(append(*log, kAnnouncement));
  Recorder recorder(log, recordingIn(folder), false);
  ASSERT_TRUE(waitFor([&] { return recorder.status().frames == 1; }));
  ASSERT_TRUE(QDir(folder).removeRecursively());
  ASSERT_TRUE(waitFor([&] { return recorder.status().givenUp.kind == JournalFault::Kind::Removed; }));
  ASSERT_TRUE(append(*log, kPosition));
  recorder.end();
  ASSERT_TRUE(waitFor([&] { return recorder.hasEnded(); }));
  ASSERT_EQ(files().size(), 1);
  const Recording anew = readRecording(folder + QLatin1Char('/') + files().first());
  EXPECT_EQ(anew.frames, 2u);
  EXPECT_TRUE(anew.isWhole);
}

TEST_F(InAFolder, ALogWithoutFramesLeavesNoFile) {
  const auto log = std::make_shared<LogDocument>();
  log->notes.append({.value = note::LinkUp{}});
  { const Recorder recorder(log, recordingIn(folder), false); }
  EXPECT_TRUE(files().isEmpty());
}

TEST_F(InAFolder, ARecordingIsSavedOnlyWhenAllOfItWas) {
  struct Row {
    const char* name;
    std::uint64_t savedBefore, savedAfter;  // frames, before it ended and after; of three
    bool isSaved;
    std::size_t notes = 1;  // that were saved; of one, and one of leaving the link
  };
  for (const Row& row :
       {Row{"none", 0, 0, false}, Row{"not the last", 2, 0, false}, Row{"all", 3, 0, true},
        Row{"all, once it had ended", 0, 3, true}, Row{"part, once", 0, 2, false},
        Row{"not the mark", 3, 0, false, 0}, Row{"not the mark, once it had ended", 0, 3, false, 0}}) {
    SCOPED_TRACE(row.name);
    const auto log = std::make_shared<LogDocument>();
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(append(*log, kPosition));
    log->notes.append({.frame = 3, .value = note::Mark{"spray"}});
    log->notes.append({.frame = 3, .value = note::LinkDown{}});
    Recorder recorder(log, recordingIn(folder), false);
    if (row.savedBefore > 0) recorder.setSaved(row.savedBefore, row.notes);
    recorder.end();
    ASSERT_TRUE(waitFor([&] { return recorder.hasEnded(); }));
    const QString path = QString::fromStdString(recorder.status().path);
    if (row.savedAfter > 0) recorder.setSaved(row.savedAfter, row.notes);
    if (row.isSaved) {
      EXPECT_TRUE(waitFor([&] { return readRecording(path).isSaved; }));
    } else {
      EXPECT_FALSE(readRecording(path).isSaved);
    }
  }
}

// A disk on which each write hangs until the test lets it go on.
struct HangingDisk {
  std::mutex lock;
  std::condition_variable released;
  bool isHanging = true;
  bool isReached = false;
  test::FakeDisk disk;

  class File;
  JournalWriter::MakeFile maker();
  bool reached() {
    const std::lock_guard guard(lock);
    return isReached;
  }
  void release() {
    const std::lock_guard guard(lock);
    isHanging = false;
    released.notify_all();
  }
};
class HangingDisk::File final : public JournalFile {
 public:
  explicit File(HangingDisk& disk) : m_disk(disk), m_file(disk.disk) {}
  std::string path() const override { return "hanging"; }
  JournalFault append(std::uint64_t offset, std::span<const std::uint8_t> bytes) override {
    std::unique_lock guard(m_disk.lock);
    m_disk.isReached = true;
    m_disk.released.wait(guard, [&] { return !m_disk.isHanging; });
    return m_file.append(offset, bytes);
  }
  JournalFault sync() override { return m_file.sync(); }
  JournalFault check() override { return m_file.check(); }

 private:
  HangingDisk& m_disk;
  test::FakeDisk::File m_file;
};
JournalWriter::MakeFile HangingDisk::maker() {
  return [this]() -> MadeJournalFile { return MadeJournalFile(std::make_unique<File>(*this)); };
}

TEST(ADiskThatHangs, HoldsUpNeitherFramesNorNotes) {
  HangingDisk disk;
  const auto log = std::make_shared<LogDocument>();
  Recorder recorder(log, disk.maker(), false);
  ASSERT_TRUE(append(*log, kAnnouncement));
  ASSERT_TRUE(waitFor([&] { return disk.reached(); }));
  // The recorder is in the middle of a write, and stays there, while this thread appends.
  for (int i = 0; i < 10'000; ++i) {
    ASSERT_TRUE(append(*log, kPosition));
    if (i % 100 == 0) log->notes.append({.frame = log->frames.count(), .value = note::Mark{"here"}});
    log->frames.channel("can1");
  }
  EXPECT_EQ(recorder.status().frames, 0u);
  disk.release();
  EXPECT_TRUE(waitFor([&] { return recorder.status().frames == 10'001; }));
  recorder.end();
  ASSERT_TRUE(waitFor([&] { return recorder.hasEnded(); }));
  test::Recording read;
  read.read(disk.disk.bytes);
  EXPECT_EQ(read.frames.count(), 10'001u);
  EXPECT_EQ(read.notes.count(), 100u);
}

TEST(ADiskThatHangs, IsSaidNotToAnswer) {
  HangingDisk disk;
  const auto log = std::make_shared<LogDocument>();
  Recorder recorder(log, disk.maker(), false);
  ASSERT_TRUE(append(*log, kAnnouncement));
  EXPECT_TRUE(waitFor([&] { return recorder.status().fault.kind == JournalFault::Kind::NoAnswer; }));
  disk.release();
  EXPECT_TRUE(waitFor([&] { return !recorder.status().fault && recorder.status().frames == 1; }));
}

TEST(ADiskThatIsFull, HoldsTheLogInMemoryAfterItsEndToo) {
  auto log = std::make_shared<LogDocument>();
  const std::weak_ptr<LogDocument> held = log;
  ASSERT_TRUE(append(*log, kAnnouncement));
  Recorder recorder(
      std::move(log),
      []() -> MadeJournalFile {
        return Failure{JournalFault{JournalFault::Kind::DiskFull, "no room"}};
      },
      false);
  recorder.end();
  ASSERT_TRUE(waitFor([&] { return bool(recorder.status().fault); }));
  EXPECT_FALSE(recorder.hasEnded());
  EXPECT_FALSE(held.expired()) << "it is tried again";
}

// --- A folder of them.

TEST_F(InAFolder, AreListedNewestFirstWithWhatIsInThem) {
  record(3);
  record(2, true);
  QFile damaged(folder + QStringLiteral("/2020-01-02_03-04-05.deckpipe"));
  ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
  damaged.write("rubbish\n");
  damaged.close();
  QFile other(folder + QStringLiteral("/notes.txt"));
  ASSERT_TRUE(other.open(QIODevice::WriteOnly));
  other.close();
  const std::vector<Recording> all = recordingsIn(folder);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_TRUE(all[0].isSimulated);
  EXPECT_FALSE(all[0].isUnsaved()) << "nobody misses a simulated truck";
  EXPECT_EQ(all[1].frames, 3u);
  EXPECT_TRUE(all[1].isUnsaved());
  EXPECT_EQ(all[1].bytes, static_cast<std::uint64_t>(QFileInfo(all[1].path).size()));
  EXPECT_FALSE(all[2].isReadable);
  EXPECT_EQ(all[2].begin, QDateTime(QDate(2020, 1, 2), QTime(3, 4, 5))) << "of its name";
}

TEST_F(InAFolder, OneThatWasCutOffIsNotWhole) {
  QFile file(record(100));
  ASSERT_TRUE(file.resize(file.size() - 50));
  const Recording cut = readRecording(file.fileName());
  EXPECT_TRUE(cut.isReadable);
  EXPECT_FALSE(cut.isWhole);
  EXPECT_TRUE(cut.isUnsaved());
}

TEST_F(InAFolder, ALargeOneIsOnlyGlancedAtAndItsNumbersAreRight) {
  const auto log = std::make_shared<LogDocument>();
  log->frames.channel("can0");
  log->notes.append({.value = note::LinkUp{{}, "socketcan can0, 250 kbit/s"}});
  JournalWriter writer(log->frames, log->notes, recordingIn(folder), [] { return recordingHead(false); });
  for (int i = 0; i < 2'000; ++i) {
    Frame frame = i == 0 ? kAnnouncement : kPosition;
    frame.stamp = i * std::int64_t{100'000'000};
    ASSERT_TRUE(log->frames.append({&frame, 1}));
    if (i % 20 == 0) writer.timeCame(Instant{} + i * 100ms);
  }
  log->notes.append({.time = log->frames.lastTime() + 30s, .value = note::RanUntil{}});
  writer.end();
  const QString path = QString::fromStdString(writer.status().path);
  Recording whole = readRecording(path);
  EXPECT_FALSE(whole.isGlanced);
  EXPECT_EQ(whole.adapters, QStringList{QStringLiteral("socketcan can0, 250 kbit/s")});
  const Recording glanced = readRecording(path, 20'000);
  EXPECT_TRUE(glanced.isGlanced);
  whole.isGlanced = true;
  EXPECT_EQ(glanced, whole);
  EXPECT_EQ(glanced.frames, 2'000u);
  EXPECT_EQ(glanced.length, Duration(1'999 * 100ms + 30s));
}

TEST(RecordingLimits, NeverDeleteWhatWasNotSavedAndTheOldestFirst) {
  const QDateTime now(QDate(2026, 11, 28), QTime(12, 0));
  const auto at = [&](const char* path, int days, std::uint64_t bytes, bool isSaved) {
    Recording recording;
    recording.path = QString::fromLatin1(path);
    recording.begin = now.addDays(-days);
    recording.bytes = bytes;
    recording.isSaved = isSaved;
    return recording;
  };
  const Recording unsaved = at("unsaved", 400, 5'000, false), old = at("old", 31, 10, true),
                  young = at("young", 1, 100, true), middle = at("middle", 5, 100, true);
  Recording growing = at("growing", 40, 10, true), simulated = at("simulated", 31, 10, false);
  growing.isGrowing = true;
  simulated.isSimulated = true;
  struct Row {
    const char* name;
    std::vector<Recording> recordings;
    std::uint64_t most;
    QStringList deleted;
  };
  const auto list = [](std::initializer_list<const char*> names) {
    QStringList all;
    for (const char* name : names) all += QString::fromLatin1(name);
    return all;
  };
  for (const Row& row : {Row{"nothing is over a limit", {young, middle}, 1'000, {}},
                         Row{"age", {young, old, growing}, 1'000, list({"old"})},
                         Row{"a simulated truck ages too", {simulated, young}, 1'000, list({"simulated"})},
                         Row{"size, the oldest first", {young, middle}, 150, list({"middle"})},
                         Row{"size, all that may go", {young, middle}, 50, list({"middle", "young"})},
                         Row{"what was not saved stays", {unsaved}, 10, {}},
                         Row{"and counts", {unsaved, young}, 5'000, list({"young"})}}) {
    EXPECT_EQ(recordingsToDelete(row.recordings, {.maxBytes = row.most, .maxDays = 30}, now), row.deleted)
        << row.name;
  }
}

// --- In the session.

struct RecordedDemo : InAFolder {
  void SetUp() override {
    session.setRecordingFolder(folder);
    session.openDemo();
    ASSERT_TRUE(waitFor([&] { return session.snapshot().source.isRecorded(); }));
  }
  Session session;
};

TEST_F(RecordedDemo, IsWrittenDownAndReadsAsItWasLive) {
  ASSERT_TRUE(waitFor([&] { return session.snapshot().source.recording->frames > 100; }));
  const auto log = session.snapshot().view.document;
  const QString path = QString::fromStdString(session.snapshot().source.recording->path);
  EXPECT_TRUE(path.startsWith(folder));
  session.closeSource();
  ASSERT_TRUE(waitFor([&] { return !readRecording(path).isGrowing; }));
  test::Recording read;
  read.result = openLog(path.toStdString(), read.target());
  ASSERT_TRUE(read.result);
  EXPECT_FALSE(read.result.value().isOpenEnded);
  EXPECT_EQ(test::told(read.frames), test::told(log->frames));
  EXPECT_EQ(read.notes.all(), log->notes.all()) << "that the link ended, too";
  const Recording recording = readRecording(path);
  EXPECT_TRUE(recording.isSimulated);
  EXPECT_TRUE(recording.pins.contains(QStringLiteral("1032AE100801035")));
}

TEST_F(RecordedDemo, HasThePersonsLabelsWhateverEndsIt) {
  const Pin pin = *Pin::parse("1032AE100801035"), other = *Pin::parse("1032AE100801099");
  const QString path = QString::fromStdString(session.snapshot().source.recording->path);
  // As a kill would leave it.
  const auto labels = [&] {
    const QString cut = dir.filePath(QStringLiteral("cut.deckpipe"));
    QFile::remove(cut);
    EXPECT_TRUE(QFile::copy(path, cut));
    test::Recording read;
    read.result = openLog(cut.toStdString(), read.target());
    std::vector<std::string> texts;
    for (const Note& note : read.notes.all()) {
      const auto* label = std::get_if<note::Label>(&note.value);
      if (label == nullptr) continue;
      EXPECT_EQ(label->pin, pin) << "no other is heard";
      texts.push_back(label->text.str());
    }
    return texts;
  };
  using Texts = std::vector<std::string>;
  session.setLabels({{pin, "front bumper"}, {other, "of another truck"}});
  EXPECT_TRUE(waitFor([&] { return labels() == Texts{"front bumper"}; }));
  session.setLabels({{pin, "roof"}});
  EXPECT_TRUE(waitFor([&] { return labels() == (Texts{"front bumper", "roof"}); }));
  session.setLabels({});
  EXPECT_TRUE(waitFor([&] { return labels() == (Texts{"front bumper", "roof", ""}); }));
  session.setLabels({{pin, "roof"}});
  session.openDemo();
  ASSERT_TRUE(waitFor([&] {
    return std::ranges::any_of(session.snapshot().view.document->notes.all(),
                               [](const Note& note) { return noteKey(note.value) == "label"; });
  })) << "the next recording has those that were given before";
}

TEST_F(RecordedDemo, IsMarkedAsSavedAlsoOnceAnotherSourceIsOpen) {
  const auto log = session.snapshot().view.document;
  const QString path = QString::fromStdString(session.snapshot().source.recording->path);
  session.closeSource();
  ASSERT_TRUE(waitFor([&] {
    const std::vector<Note> notes = log->notes.all();
    return !notes.empty() && noteKey(notes.back().value) == "link_down";
  })) << "no frame comes after that";
  session.setSaved(log, log->frames.count(), log->notes.count());
  EXPECT_TRUE(waitFor([&] { return readRecording(path).isSaved; }));
}

TEST_F(InAFolder, ASessionWithoutAFolderRecordsNothing) {
  Session session;
  session.openDemo();
  ASSERT_TRUE(waitFor([&] { return session.snapshot().view.frameCount > 0; }));
  EXPECT_FALSE(session.snapshot().source.recording.has_value());
  EXPECT_FALSE(session.snapshot().source.isRecorded());
}

}  // namespace
}  // namespace deckpipe
