// SPDX-License-Identifier: GPL-3.0-or-later
// The composition root, whole: files, the demo behind its virtual bus, and the cursor over both.
#include "session/session.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include "link/virtual_bus.h"
#include "log/log_format.h"
#include "log/sidecar.h"
#include "session/bus_threads.h"
#include "session/recordings.h"
#include "support/child.h"
#include "support/frames.h"
#include "support/patience.h"
#include "support/recording_listener.h"

namespace deckpipe {
namespace {

const Pin kMonitor = *Pin::parse("1032AE100801035");

QString writeLog(const QTemporaryDir& dir, const QByteArray& text) {
  const QString path = dir.filePath(QStringLiteral("test.log"));
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
  return path;
}

const QByteArray kThreeFrames =
    "(10.000000) can0 18EFFF80#FF83150206021A0B\n"
    "(11.000000) can0 18EFFF80#011D940371000041\n"
    "(12.000000) can0 18EFFF80#01000C0371000041\n";

// The state the snapshot shows has caught up with its cursor.
bool isSettled(const Session& session) {
  return session.snapshot().view.state->cursor() == session.snapshot().view.cursor;
}

class OpenedLog : public testing::Test {
 protected:
  void SetUp() override {
    m_session.openLog(writeLog(m_dir, kThreeFrames));
    m_session.goToEnd();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return m_session.snapshot().source.progress == SourceStatus::Progress::Done && settledAt(3); },
        kPatience));
  }
  bool settledAt(std::uint64_t frames) const {
    return isSettled(m_session) && m_session.snapshot().view.cursor.frames == frames;
  }
  const LogView& view() const { return m_session.snapshot().view; }
  int rotation() const { return view().state->devices().byPin(kMonitor)->position().value().rotation.tenths; }

  QTemporaryDir m_dir;
  Session m_session;
};

// The texts of the marks of a log, as it opens anew.
QStringList marksIn(const QString& path) {
  FrameStore frames;
  NoteStore notes;
  SkippedList skipped;
  const auto read = openLog(path.toStdString(), {frames, skipped, &notes});
  EXPECT_TRUE(read && !read.value().sidecarFault);
  QStringList marks;
  for (const Note& note : notes.all()) {
    if (const auto* mark = std::get_if<note::Mark>(&note.value)) {
      const std::string_view text = mark->text.str();
      marks += QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    }
  }
  return marks;
}

bool waitForMarks(const Session& session) {
  return QTest::qWaitFor([&] { return !session.snapshot().source.isKeepingMarks; }, kPatience);
}

TEST_F(OpenedLog, KeepsAMarkBesideItAtOnce) {
  const QString path = m_session.snapshot().source.name;
  m_session.mark(view().cursor, QStringLiteral("water on"));
  ASSERT_TRUE(waitForMarks(m_session));
  EXPECT_EQ(marksIn(path), QStringList{QStringLiteral("water on")});
  EXPECT_FALSE(m_session.snapshot().source.unkeptMarks);

  Session again;
  again.openLog(path);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return again.snapshot().source.progress == SourceStatus::Progress::Done; }, kPatience));
  again.mark({1, Instant{11'000'000'000}}, QStringLiteral("before"));
  ASSERT_TRUE(waitForMarks(again));
  EXPECT_EQ(marksIn(path), (QStringList{QStringLiteral("before"), QStringLiteral("water on")}));

  // The first window does not know of it, and replaces nothing.
  const QString sidecar = path + QStringLiteral(".deckpipe-notes");
  QFile file(sidecar);
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  ASSERT_TRUE(file.setFileTime(QDateTime::currentDateTime().addSecs(-60), QFileDevice::FileModificationTime));
  file.close();
  m_session.mark(view().cursor, QStringLiteral("third"));
  ASSERT_TRUE(waitForMarks(m_session));
  EXPECT_TRUE(m_session.snapshot().source.unkeptMarks);
  EXPECT_EQ(marksIn(path).size(), 2);
}

void openBesideForeignSidecar(Session& session, const QString& path) {
  QFile file(path + QStringLiteral(".deckpipe-notes"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("of somebody else\n");
  file.close();
  session.openLog(path);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return session.snapshot().source.progress == SourceStatus::Progress::Done; }, kPatience));
}

TEST(SessionMarks, NeverReplaceASidecarThatCouldNotBeRead) {
  QTemporaryDir dir;
  const QString path = writeLog(dir, kThreeFrames);
  Session session;
  openBesideForeignSidecar(session, path);
  session.mark({1, Instant{11'000'000'000}}, QStringLiteral("mine"));
  EXPECT_TRUE(session.snapshot().source.unkeptMarks);
  QFile file(path + QStringLiteral(".deckpipe-notes"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.readAll(), QByteArray("of somebody else\n"));
  session.setSaved(session.snapshot().view.document, 3, 0);
  EXPECT_TRUE(session.snapshot().source.unkeptMarks) << "it was made after the saving began";
  QSignalSpy changed(&session, &Session::changed);
  session.setSaved(session.snapshot().view.document, 3, 1);
  EXPECT_FALSE(session.snapshot().source.unkeptMarks) << "they are in the file that was saved";
  EXPECT_EQ(changed.count(), 1) << "a log at rest changes by nothing else";
}

// Between the decision to open another log and its first frame the old one is still in view.
TEST(SessionMarks, ThatCannotBeKeptAreNotLeftForALogThatIsBeingTried) {
  QTemporaryDir dir, other;
  const QString path = writeLog(dir, kThreeFrames);
  Session session;
  openBesideForeignSidecar(session, path);
  session.openLog(writeLog(other, kThreeFrames));
  session.mark({1, Instant{11'000'000'000}}, QStringLiteral("mine"));
  QTest::qWait(300);
  EXPECT_EQ(session.snapshot().source.name, path);
  EXPECT_TRUE(session.snapshot().source.unkeptMarks);
}

TEST(SessionMarks, AreNotKeptAndThatIsSaidWhereSomethingElseHasTheNameOfTheSidecar) {
  for (const bool isFolder : {true, false}) {
    QTemporaryDir dir;
    const QString path = writeLog(dir, kThreeFrames), sidecar = path + QStringLiteral(".deckpipe-notes");
    ASSERT_TRUE(isFolder ? QDir().mkdir(sidecar) : QFile::link(QStringLiteral("/no/such/file"), sidecar));
    Session session;
    session.openLog(path);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return session.snapshot().source.progress == SourceStatus::Progress::Done; }, kPatience));
    const auto& fault = session.snapshot().source.read.sidecarFault;
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->kind, SidecarFault::Kind::CannotRead);
    EXPECT_EQ(QString::fromStdString(fault->path), sidecar);
    session.mark({1, Instant{11'000'000'000}}, QStringLiteral("mine"));
    EXPECT_TRUE(session.snapshot().source.unkeptMarks);
    EXPECT_FALSE(session.snapshot().source.isKeepingMarks);
  }
}

TEST(SessionMarks, AreInTheFileOnceTheSessionHasEnded) {
  QTemporaryDir dir;
  const QString path = writeLog(dir, kThreeFrames);
  {
    Session session;
    session.openLog(path);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return session.snapshot().source.progress == SourceStatus::Progress::Done; }, kPatience));
    session.mark({1, Instant{11'000'000'000}}, QStringLiteral("mine"));
    session.closeSource();
  }
  EXPECT_EQ(marksIn(path), QStringList{QStringLiteral("mine")});
}

QByteArray recordingOfOneFrame() {
  const auto writer = formatToWrite("x.deckpipe").makeWriter();
  std::string bytes;
  writer->begin(bytes);
  writer->channel("can0", bytes);
  Frame frame = test::frame("123", "00");
  frame.stamp = 1;
  writer->frame(frame, {1}, bytes);
  writer->end(bytes);
  return QByteArray::fromStdString(bytes);
}

TEST(SessionMarks, OfARecordingThatHasEndedAreSaidToBeInMemoryAlone) {
  QTemporaryDir dir;
  Session session;
  session.openLog(writeLog(dir, recordingOfOneFrame()));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return session.snapshot().source.progress == SourceStatus::Progress::Done; }, kPatience));
  session.mark({1, {1}}, QStringLiteral("mine"));
  EXPECT_TRUE(session.snapshot().source.unkeptMarks);
  EXPECT_EQ(QDir(dir.path()).entryList(QDir::Files).size(), 1);
}

TEST(Session, MarksARecordingAsSavedWhateverItsName) {
  QTemporaryDir dir;
  const QString path = writeLog(dir, recordingOfOneFrame());
  ASSERT_FALSE(path.endsWith(QStringLiteral(".deckpipe")));
  Session session;
  session.openLog(path);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return session.snapshot().source.progress == SourceStatus::Progress::Done; }, kPatience));
  session.setSaved(session.snapshot().view.document, 1, 1);
  EXPECT_TRUE(QTest::qWaitFor([&] { return readRecording(path).isSaved; }, kPatience));
}

TEST_F(OpenedLog, StaysOpenWhereAnotherCannotBeRead) {
  const auto before = m_session.snapshot().view.document;
  m_session.openLog(QStringLiteral("/no/such/file.log"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_session.snapshot().notOpened.has_value(); }, kPatience));
  EXPECT_EQ(m_session.snapshot().notOpened->path, QStringLiteral("/no/such/file.log"));
  EXPECT_EQ(m_session.snapshot().notOpened->error->kind, ReadError::Kind::CannotOpen);
  EXPECT_EQ(m_session.snapshot().view.document, before);
  EXPECT_EQ(m_session.snapshot().source.progress, SourceStatus::Progress::Done);
  m_session.seekFrames(1);
  EXPECT_FALSE(m_session.snapshot().notOpened) << "until the next deed";
}

TEST_F(OpenedLog, GivesWayToAnotherOnceItsFramesAreThere) {
  const QString other = m_dir.filePath(QStringLiteral("other.log"));
  QFile file(other);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("(1.000000) can0 123#\n");
  file.close();
  m_session.openLog(other);
  EXPECT_EQ(m_session.snapshot().view.frameCount, 3u) << "not before";
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_session.snapshot().view.frameCount == 1; }, kPatience));
  EXPECT_EQ(m_session.snapshot().source.name, other);
}

TEST_F(OpenedLog, TakesTheNotesBesideItIntoItsState) {
  m_session.closeSource();
  const QString path = writeLog(m_dir, kThreeFrames);
  SidecarMaker maker;
  FrameStore frames;
  SkippedList skipped;
  ASSERT_TRUE(openLog(path.toStdString(), {frames, skipped}));
  maker.channel("can0");
  for (std::uint64_t i = 0; i < 3; ++i) {
    if (i == 1)
      maker.note({.frame = 1, .time = {10'500'000'000}, .value = note::DriveSaid{{0}, {0x5A}, true}});
    maker.frame(frames[i], frames.timeAt(i));
  }
  QFile sidecar(path + QStringLiteral(".deckpipe-notes"));
  ASSERT_TRUE(sidecar.open(QIODevice::WriteOnly));
  sidecar.write(maker.text().c_str());
  sidecar.close();
  m_session.openLog(path);
  m_session.goToEnd();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return isSettled(m_session) && view().state->channel({0}).book.isDrive({0x5A}); }, kPatience));
  EXPECT_TRUE(m_session.snapshot().source.read.hasSidecar);
  EXPECT_EQ(view().document->notes.all().at(0).time, Instant{10'500'000'000});
}

TEST(OpenedLogs, AreSeenFromTheirBeginWhileTheyAreReadAndAfterwards) {
  const QTemporaryDir dir;
  Session session;
  std::vector<Cursor> cursors;
  QObject::connect(&session, &Session::changed, [&] {
    if (session.snapshot().view.frameCount > 0) cursors.push_back(session.snapshot().view.cursor);
  });
  QByteArray text;
  for (int i = 0; i < 60'000; ++i)
    text += "(" + QByteArray::number(10 + i) + ".0) can0 18EFFF80#01000C0371000041\n";
  session.openLog(writeLog(dir, text));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return session.snapshot().source.progress == SourceStatus::Progress::Done && isSettled(session);
      },
      kPatience));
  EXPECT_EQ(session.snapshot().view.frameCount, 60'000u);
  const Cursor first{1, Instant{10'000'000'000}};
  EXPECT_EQ(session.snapshot().view.cursor, first);
  EXPECT_FALSE(session.snapshot().view.atEnd);
  EXPECT_TRUE(std::ranges::all_of(cursors, [&](const Cursor& cursor) { return cursor == first; }));
  session.play();
  EXPECT_TRUE(session.snapshot().playing);
}

TEST_F(OpenedLog, IsPlayedInALoopAndPastSilencesAsTheSnapshotSays) {
  m_session.setSkipsSilences(true);
  EXPECT_TRUE(m_session.snapshot().skipsSilences);
  m_session.setLoop(LoopSpan{{11'000'000'000}, {11'100'000'000}});
  EXPECT_TRUE(m_session.snapshot().isLooping);
  EXPECT_TRUE(m_session.snapshot().playing) << "a loop begins to play";
  EXPECT_EQ(view().cursor, (Cursor{2, Instant{11'000'000'000}}));
  m_session.pause();
  m_session.setLoop(LoopSpan{{10'000'000'000}, {11'100'000'000}});
  EXPECT_FALSE(m_session.snapshot().playing) << "another span of it changes nothing about that";
  m_session.setLoop({});
  EXPECT_FALSE(m_session.snapshot().isLooping);
}

TEST_F(OpenedLog, LeavesItsSpeedAndSkippedSilencesToTheNextOne) {
  m_session.setSpeed(4);
  m_session.setSkipsSilences(true);
  m_session.setLoop(LoopSpan{{10'000'000'000}, {11'100'000'000}});
  m_session.closeSource();
  EXPECT_EQ(m_session.snapshot().speed, 4);
  EXPECT_TRUE(m_session.snapshot().skipsSilences);
  m_session.setSpeed(10);
  QTemporaryDir dir;
  m_session.openLog(writeLog(dir, "(10.000000) can0 123#\n(11.000000) can0 123#\n"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return view().frameCount == 2; }, kPatience));
  EXPECT_EQ(m_session.snapshot().speed, 10);
  EXPECT_TRUE(m_session.snapshot().skipsSilences);
  EXPECT_FALSE(m_session.snapshot().isLooping) << "a span of another log";
}

TEST_F(OpenedLog, IsPlayedToItsEndAsFastAsTheStateIsFound) {
  m_session.setSpeed(Playback::kUnbounded);
  m_session.seekFrames(1);
  m_session.play();
  ASSERT_TRUE(QTest::qWaitFor([&] { return view().atEnd && settledAt(3); }, kPatience));
  EXPECT_EQ(rotation(), 0);
}

TEST_F(OpenedLog, StandsAtItsEndWithTheStateThere) {
  EXPECT_TRUE(view().atEnd);
  EXPECT_EQ(view().frameCount, 3u);
  EXPECT_EQ(view().begin, Instant{10'000'000'000});
  EXPECT_EQ(view().end, Instant{12'000'000'000});
  EXPECT_EQ(rotation(), 0);
}

TEST_F(OpenedLog, ShowsTheStateAtTheTimeSoughtForwardsAndBackwards) {
  m_session.seek({11'500'000'000});
  ASSERT_TRUE(QTest::qWaitFor([&] { return settledAt(2); }, kPatience));
  EXPECT_EQ(rotation(), 473);
  EXPECT_TRUE(view().state->devices().byPin(kMonitor)->isStale(MessageId::PositionLimitStatus));
  m_session.seek({10'000'000'000});
  ASSERT_TRUE(QTest::qWaitFor([&] { return settledAt(1); }, kPatience));
  EXPECT_FALSE(view().state->devices().byPin(kMonitor)->position().isKnown());
}

TEST_F(OpenedLog, StepsByFramesAndStopsAtBothEnds) {
  m_session.step(-1);
  EXPECT_EQ(view().cursor.frames, 2u);
  m_session.step(-10);
  EXPECT_EQ(view().cursor.frames, 0u);
  m_session.step(10);
  EXPECT_EQ(view().cursor.frames, 3u);
  m_session.seek({99'000'000'000});
  EXPECT_EQ(view().cursor.time, view().end);
}

TEST_F(OpenedLog, PlaysFromTheStartWhenItStoodAtTheEndAndStopsThere) {
  m_session.setSpeed(Playback::kFastest);
  m_session.play();
  EXPECT_TRUE(m_session.snapshot().playing);
  EXPECT_EQ(view().cursor.frames, 0u);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !m_session.snapshot().playing; }, kPatience));
  EXPECT_TRUE(view().atEnd);
  EXPECT_EQ(view().cursor.frames, 3u);
}

TEST(SessionOnABadLog, SaysThatItIsNoLog) {
  QTemporaryDir dir;
  Session session;
  session.openLog(writeLog(dir, QByteArray(5000, 'x') + '\n'));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return session.snapshot().source.progress == SourceStatus::Progress::Failed; }, kPatience));
}

TEST(SessionOnABadLog, KeepsWhatIsWholeAndCountsTheRest) {
  QTemporaryDir dir;
  Session session;
  session.openLog(writeLog(dir, kThreeFrames + "(13.0) can0 garbage\n" + "(14.0) can0 123#11\n"));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return session.snapshot().source.progress == SourceStatus::Progress::Done; }, kPatience));
  ASSERT_TRUE(QTest::qWaitFor([&] { return session.snapshot().view.frameCount == 4; }, kPatience));
  EXPECT_EQ(session.snapshot().source.unreadable, 1u);
}

bool hasMovingMonitor(const Session& session) {
  const Device* monitor = session.snapshot().view.state->devices().byPin(kMonitor);
  return monitor != nullptr && monitor->position().isKnown() && monitor->address != kNullAddress;
}

TEST(Demo, BringsTheSimulatorsMonitorThroughTheWholeRealPath) {
  Session session;
  session.openDemo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return hasMovingMonitor(session); }, kPatience));
  EXPECT_EQ(session.snapshot().source.progress, SourceStatus::Progress::Running);
  EXPECT_TRUE(session.snapshot().source.simulated);
  EXPECT_TRUE(session.snapshot().view.atEnd);
  EXPECT_EQ(session.snapshot().view.state->channel({0}).link, ChannelLink::Up);
}

TEST(Demo, GoesOnRecordingWhileTheCursorIsPaused) {
  Session session;
  session.openDemo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return hasMovingMonitor(session); }, kPatience));
  session.pause();
  const Cursor paused = session.snapshot().view.cursor;
  const std::uint64_t before = session.snapshot().view.frameCount;
  ASSERT_TRUE(QTest::qWaitFor([&] { return session.snapshot().view.frameCount > before + 50; }, kPatience));
  EXPECT_EQ(session.snapshot().view.cursor, paused);
  session.goToEnd();
  EXPECT_GT(session.snapshot().view.cursor.frames, before + 50);
}

TEST(Demo, ShowsLiveWhatAReplayOfTheSameLogShows) {
  Session session;
  session.openDemo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return hasMovingMonitor(session); }, kPatience));
  ASSERT_TRUE(QTest::qWaitFor([&] { return session.snapshot().view.frameCount > 200; }, kPatience));
  const LogView& view = session.snapshot().view;
  const auto live = view.state;
  State replayed;
  advance(replayed, view.document->frames, view.document->notes, live->cursor());
  EXPECT_EQ(replayed, *live);
}

TEST(Demo, SaysNothingWhileItIsDestroyedButWritesDownThatTheLinkEnded) {
  auto session = std::make_unique<Session>();
  session->openDemo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return hasMovingMonitor(*session); }, kPatience));
  const auto document = session->snapshot().view.document;
  int said = 0;
  QObject::connect(session.get(), &Session::changed, [&] { ++said; });
  QObject::connect(session.get(), &Session::simulatorChanged, [&] { ++said; });
  session.reset();
  EXPECT_EQ(said, 0);
  const std::vector<Note> notes = document->notes.all();
  ASSERT_FALSE(notes.empty());
  EXPECT_EQ(noteKey(notes.back().value), "link_down");
}

TEST(Demo, SaysThatTheSimulatorIsGoneWhenItIsClosed) {
  Session session;
  SimulatorStatus simulator;
  QObject::connect(&session, &Session::simulatorChanged,
                   [&](const SimulatorStatus& status) { simulator = status; });
  session.openDemo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !simulator.devices.empty(); }, kPatience));
  session.closeSource();
  EXPECT_TRUE(simulator.devices.empty());
}

TEST(Demo, RunsTwiceAtOnceWithoutMixing) {
  Session one, two;
  one.openDemo();
  two.openDemo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return hasMovingMonitor(one) && hasMovingMonitor(two); }, kPatience));
  const auto contests = [](const Session& session) {
    return session.snapshot().view.state->channel({0}).book.claimsLost({0x80});
  };
  EXPECT_EQ(contests(one), contests(two)) << "twins on one bus would fight for the same addresses";
  one.closeSource();
  const std::uint64_t before = two.snapshot().view.frameCount;
  EXPECT_TRUE(QTest::qWaitFor([&] { return two.snapshot().view.frameCount > before + 50; }, kPatience));
}

TEST(Demo, GoesOnWhereALogCannotBeReadOrHoldsNoFrame) {
  const QTemporaryDir dir;
  Session session;
  session.openDemo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return hasMovingMonitor(session); }, kPatience));
  for (const QString& path : {QStringLiteral("/no/such/file.log"), writeLog(dir, "no log\n")}) {
    session.openLog(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session.snapshot().notOpened.has_value(); }, kPatience));
    EXPECT_EQ(session.snapshot().notOpened->path, path);
    EXPECT_EQ(session.snapshot().source.kind, SourceStatus::Kind::Link);
    const std::uint64_t before = session.snapshot().view.frameCount;
    EXPECT_TRUE(QTest::qWaitFor([&] { return session.snapshot().view.frameCount > before; }, kPatience));
  }
}

// The first on its port is virtualcan's server, also after its own link was opened anew.
TEST(Link, ConnectedAgainAsTheServerOfItsPortHears) {
  QTcpServer probe;
  ASSERT_TRUE(probe.listen(QHostAddress::LocalHost));
  const QString bus = QStringLiteral("tcp://127.0.0.1:%1/can0").arg(probe.serverPort());
  probe.close();
  Session session;
  const auto isRunning = [&] {
    return session.snapshot().source.progress == SourceStatus::Progress::Running;
  };
  session.openLink({QStringLiteral("virtualcan"), bus, 250'000, {}});
  ASSERT_TRUE(QTest::qWaitFor(isRunning, kPatience));
  session.reconnect();
  ASSERT_TRUE(QTest::qWaitFor(isRunning, kPatience));
  RecordingListener peer;
  CanLink peerLink({QStringLiteral("virtualcan"), bus, 250'000, {}});
  peerLink.open(peer);
  ASSERT_TRUE(QTest::qWaitFor([&] { return peer.state() == LinkState::Up; }, kPatience));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        peerLink.write(test::frame("18EFFF80", "FF83150206021A0B"));
        return session.snapshot().view.frameCount > 0;
      },
      kPatience));
}

TEST(Link, ConnectedAgainGoesOnInTheSameLogAndFileAfterAGap) {
  const QTemporaryDir dir;
  VirtualBus bus;
  ASSERT_TRUE(bus.start());
  RecordingListener peer;
  CanLink peerLink({QStringLiteral("virtualcan"), bus.interfaceName(0), 250'000, {}});
  peerLink.open(peer);
  Session session;
  session.setRecordingFolder(dir.path());
  session.openLink({QStringLiteral("virtualcan"), bus.interfaceName(0), 250'000, {}});
  const auto isRunning = [&] {
    return session.snapshot().source.progress == SourceStatus::Progress::Running;
  };
  const auto hears = [&](std::uint64_t frames) {
    peerLink.write(test::frame("18EFFF80", "FF83150206021A0B"));
    return QTest::qWaitFor([&] { return session.snapshot().view.frameCount == frames; }, kPatience);
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return isRunning() && peer.state() == LinkState::Up; }, kPatience));
  ASSERT_TRUE(hears(1));
  const auto document = session.snapshot().view.document;
  session.reconnect();
  EXPECT_EQ(session.snapshot().source.progress, SourceStatus::Progress::Opening);
  ASSERT_TRUE(QTest::qWaitFor(isRunning, kPatience));
  EXPECT_EQ(session.snapshot().view.document, document);
  const auto hasMonitor = [&] { return session.snapshot().view.state->devices().byPin(kMonitor) != nullptr; };
  EXPECT_FALSE(hasMonitor()) << "of before the gap";
  ASSERT_TRUE(hears(2));
  EXPECT_TRUE(QTest::qWaitFor(hasMonitor, kPatience)) << "heard anew";
  std::vector<std::string_view> keys;
  for (const Note& note : document->notes.all()) keys.push_back(noteKey(note.value));
  EXPECT_EQ(keys, (std::vector<std::string_view>{"link_up", "link_down", "link_up"}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return session.snapshot().source.recording->frames == 2; }, kPatience));
  session.closeSource();
  ASSERT_TRUE(session.snapshot().leftRecording);
  EXPECT_TRUE(session.snapshot().leftRecording->path.starts_with(dir.path().toStdString()));
  EXPECT_EQ(QDir(dir.path()).entryList(QDir::Files).size(), 1);
}

TEST(Link, ThatEndsWithTheSessionIsRecordedToItsEndWithoutASignal) {
  const QTemporaryDir dir;
  auto session = std::make_unique<Session>();
  session->setRecordingFolder(dir.path());
  session->openDemo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return session->snapshot().source.isRecorded(); }, kPatience));
  const QString path = QFile::decodeName(session->snapshot().source.recording->path.c_str());
  const QSignalSpy ended(test::child<BusThreads>(*session), &BusThreads::ended);
  session.reset();
  EXPECT_EQ(ended.count(), 0);
  EXPECT_TRUE(readRecording(path).isWhole);
}

// Keeps a bus thread from its event loop, as an adapter's library can that does not return.
class HeldBus {
 public:
  explicit HeldBus(Session& session) : m_thread(test::child<QThread>(session, "bus")) {
    auto* onThread = new QObject;
    onThread->moveToThread(m_thread);
    QObject::connect(m_thread, &QThread::finished, onThread, &QObject::deleteLater);
    QMetaObject::invokeMethod(
        onThread, [released = m_released] { released->acquire(); }, Qt::QueuedConnection);
  }
  ~HeldBus() { release(); }
  void release() {
    if (!std::exchange(m_isReleased, true)) m_released->release();
  }
  QThread* thread() const { return m_thread; }

 private:
  QThread* m_thread;
  std::shared_ptr<std::binary_semaphore> m_released = std::make_shared<std::binary_semaphore>(0);
  bool m_isReleased = false;
};

class LinkThatHangs : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(m_bus.start());
    m_settings = {QStringLiteral("virtualcan"), m_bus.interfaceName(0), 250'000, {}};
    m_session.openLink(m_settings);
    ASSERT_TRUE(isRunning());
  }
  bool isRunning() {
    return QTest::qWaitFor(
        [this] { return m_session.snapshot().source.progress == SourceStatus::Progress::Running; },
        kPatience);
  }
  VirtualBus m_bus;
  LinkSettings m_settings;
  Session m_session;
};

TEST_F(LinkThatHangs, IsNotWaitedForAndTheNextOneOpensWhenItHasEnded) {
  HeldBus held(m_session);
  m_session.openLink(m_settings);
  EXPECT_EQ(m_session.snapshot().source.progress, SourceStatus::Progress::Opening);
  EXPECT_EQ(m_session.findChildren<QThread*>(QStringLiteral("bus")), QList<QThread*>{held.thread()})
      << "the adapter is not free, and the bus not given up";
  held.release();
  EXPECT_TRUE(isRunning());
}

TEST_F(LinkThatHangs, KeepsNoLogFromBeingOpened) {
  const QTemporaryDir dir;
  HeldBus held(m_session);
  m_session.openLog(writeLog(dir, "(1.000000) can0 18EFFF80#FF83150206021A0B\n"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return m_session.snapshot().view.frameCount == 1; }, kPatience));
  EXPECT_NE(held.thread()->parent(), nullptr) << "given up, after a while";
}

TEST_F(LinkThatHangs, WaitsUnseenWhileALogIsTriedThatCannotBeRead) {
  HeldBus held(m_session);
  m_session.openLink(m_settings);
  m_session.openLog(QStringLiteral("/no/such/file.log"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_session.snapshot().notOpened.has_value(); }, kPatience));
  held.release();
  EXPECT_TRUE(isRunning());
}

TEST_F(LinkThatHangs, IsLockedWhileItIsConnectedAgain) {
  m_session.intend(intent::Unlock{});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !m_session.snapshot().services->locked; }, kPatience));
  HeldBus held(m_session);
  m_session.reconnect();
  EXPECT_TRUE(m_session.snapshot().services->locked);
  EXPECT_EQ(m_session.intend(intent::Lock{}), 0u);
  EXPECT_EQ(m_session.snapshot().notSent, Refusal::None) << "it is locked";
}

TEST_F(LinkThatHangs, IsGivenUpAndLeavesItsLogToItself) {
  const auto document = m_session.snapshot().view.document;
  HeldBus held(m_session);
  m_session.reconnect();
  EXPECT_EQ(m_session.snapshot().view.document, document);
  ASSERT_TRUE(isRunning());
  EXPECT_NE(m_session.snapshot().view.document, document) << "the old bus may still write there";
}

// A bus that gives no frame back, as an adapter whose queue stands still.
class StuckBus : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(m_server.listen(QHostAddress::LocalHost));
    m_link = {QStringLiteral("virtualcan"),
              QStringLiteral("tcp://127.0.0.1:%1/can0?echo").arg(m_server.serverPort()),
              250'000,
              {}};
    m_session.openLink(m_link);
    ASSERT_TRUE(
        waitFor([&] { return m_session.snapshot().source.progress == SourceStatus::Progress::Running; }));
    m_session.intend(intent::Unlock{});
    ASSERT_TRUE(waitFor([&] { return m_session.snapshot().services->unconfirmed > 0; }));
  }
  template <typename Condition>
  static bool waitFor(Condition condition) {
    return QTest::qWaitFor(condition, kPatience);
  }
  bool saysWhatWaits() const {
    const auto& waiting = m_session.snapshot().leftWaiting;
    return waiting && waiting->frames > 0 && waiting->interfaceName == m_link.interfaceName;
  }

  QTcpServer m_server;
  LinkSettings m_link;
  Session m_session;
};

TEST_F(StuckBus, IsLeftWithAWordOfWhatWaits) {
  EXPECT_FALSE(saysWhatWaits());
  m_session.closeSource();
  EXPECT_TRUE(saysWhatWaits());
  const QTemporaryDir dir;
  m_session.openLog(writeLog(dir, kThreeFrames));
  ASSERT_TRUE(waitFor([&] { return m_session.snapshot().source.progress == SourceStatus::Progress::Done; }));
  EXPECT_TRUE(saysWhatWaits()) << "still";
}

TEST_F(StuckBus, ConnectedAgainSaysWhatWaitedUntilTheInterfaceIsGone) {
  m_session.reconnect();
  EXPECT_TRUE(saysWhatWaits());
  ASSERT_TRUE(
      waitFor([&] { return m_session.snapshot().source.progress == SourceStatus::Progress::Running; }));
  EXPECT_TRUE(saysWhatWaits());
  for (QTcpSocket* socket : m_server.findChildren<QTcpSocket*>()) socket->abort();
  EXPECT_TRUE(waitFor([&] { return m_session.snapshot().source.progress == SourceStatus::Progress::Lost; }));
  EXPECT_FALSE(saysWhatWaits());
}

TEST_F(StuckBus, WhoseLinkIsLostIsNotHiddenByWhatWasSaidBefore) {
  m_session.openLog(QStringLiteral("/no/such/file.log"));
  ASSERT_TRUE(waitFor([&] { return m_session.snapshot().notOpened.has_value(); }));
  for (QTcpSocket* socket : m_server.findChildren<QTcpSocket*>()) socket->abort();
  ASSERT_TRUE(waitFor([&] { return m_session.snapshot().source.progress == SourceStatus::Progress::Lost; }));
  EXPECT_FALSE(m_session.snapshot().notOpened) << "it was said before";
  m_session.openLog(QStringLiteral("/no/such/file.log"));
  ASSERT_TRUE(waitFor([&] { return m_session.snapshot().notOpened.has_value(); }));
  m_session.dismiss();
  EXPECT_FALSE(m_session.snapshot().notOpened);
}

TEST(Link, SaysWhyAnAdapterCannotBeOpened) {
  Session session;
  session.openLink({QStringLiteral("socketcan"), QStringLiteral("no_such_can"), 250'000, {}});
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return session.snapshot().source.progress == SourceStatus::Progress::Failed; }, kPatience));
  const auto* error = std::get_if<LinkError>(&session.snapshot().source.error);
  ASSERT_NE(error, nullptr);
  EXPECT_EQ(error->fault, LinkFault::NoInterface);
  EXPECT_FALSE(error->detail.empty());
}

// What the console sends goes the whole way: intent, services, link, simulator, and back into the log.
class SendingDemo : public testing::Test {
 protected:
  void SetUp() override {
    m_session.openDemo();
    ASSERT_TRUE(waitFor([&] { return state().devices().byPin(kMonitor) != nullptr; }));
  }
  template <typename Condition>
  bool waitFor(Condition condition) {
    return QTest::qWaitFor(condition, kPatience);
  }
  const State& state() const { return *m_session.snapshot().view.state; }
  const ServiceStatus& services() const { return *m_session.snapshot().services; }
  const FrameStore& frames() const { return m_session.snapshot().view.document->frames; }
  std::size_t sentFrames() const {
    std::size_t sent = 0;
    for (std::uint64_t i = 0; i < frames().count(); ++i) {
      if ((frames()[i].flags & Frame::kSent) == 0) continue;
      ++sent;
      EXPECT_NE(frames()[i].flags & Frame::kConfirmed, 0) << "stored once, on its echo";
    }
    return sent;
  }
  bool unlock() {
    m_session.intend(intent::Unlock{});
    return waitFor([&] { return services().canRequest(); });
  }
  const DeviceKey m_monitor = DeviceKey::of(kMonitor);
  Session m_session;
};

TEST_F(SendingDemo, SendsNothingWhileLocked) {
  EXPECT_TRUE(services().locked);
  const std::uint64_t serial = m_session.intend(intent::SendRequests{m_monitor, kPolls});
  ASSERT_TRUE(waitFor([&] { return services().refusedSerial == serial; }));
  EXPECT_EQ(services().refusal, Refusal::Locked);
  EXPECT_EQ(sentFrames(), 0u);
}

TEST_F(SendingDemo, UnlockedItClaimsAnAddressAndIsAnswered) {
  ASSERT_TRUE(unlock());
  EXPECT_EQ(state().channel(Channel{}).ownAddress, Address{0xF9});
  EXPECT_FALSE(state().isLocked());
  m_session.intend(intent::SendRequests{m_monitor, kPolls});
  ASSERT_TRUE(waitFor([&] {
    const DeviceServices* device = services().find(m_monitor);
    return device != nullptr && device->of(Request::Vista).end == RequestEnd::Answered &&
           device->of(Request::Config).end == RequestEnd::Answered;
  }));
  EXPECT_TRUE(waitFor([&] { return state().devices().byPin(kMonitor)->config().isKnown(); }));
  EXPECT_EQ(sentFrames(), 2u + 5u) << "a request for NAMEs, a claim, five polls";
}

TEST_F(SendingDemo, TalksOverThePipeAndLocksAgain) {
  ASSERT_TRUE(unlock());
  m_session.intend(intent::PipeWrite{m_monitor, "A?\r\n"});
  ASSERT_TRUE(waitFor([&] {
    const DeviceServices* device = services().find(m_monitor);
    return device != nullptr && device->pipe && device->pipe->sent == 4 && device->pipe->received > 0;
  }));
  m_session.intend(intent::Lock{});
  ASSERT_TRUE(waitFor([&] { return state().isLocked(); }));
  EXPECT_EQ(state().channel(Channel{}).ownAddress, kNullAddress);
}

TEST_F(SendingDemo, OffTheLiveEdgeOnlyWhatStopsSomethingIsHeard) {
  using What = intent::PipeAction::What;
  ASSERT_TRUE(unlock());
  const Intent starts[] = {intent::Unlock{},
                           intent::RequestNames{},
                           intent::SendRequests{m_monitor, kPolls},
                           intent::Repeat{m_monitor, kPolls, 1s},
                           intent::PipeWrite{m_monitor, "x"},
                           intent::PipeFile{m_monitor, "x", std::make_shared<const std::string>("x")},
                           intent::PipeAction{m_monitor, What::Resume},
                           intent::PipeAction{m_monitor, What::Resend},
                           intent::PipeAction{m_monitor, What::Skip}};
  const Intent stops[] = {
      intent::Repeat{m_monitor, kPolls, 0s},      intent::Cancel{m_monitor},
      intent::PipeAction{m_monitor, What::Pause}, intent::PipeAction{m_monitor, What::Cancel},
      intent::PipeAction{m_monitor, What::Abort}, intent::Lock{}};
  m_session.pause();
  for (const Intent& intent : starts) EXPECT_EQ(m_session.intend(intent), 0u) << intent.index();
  EXPECT_EQ(m_session.snapshot().notSent, Refusal::NotLive);
  for (const Intent& intent : stops) EXPECT_NE(m_session.intend(intent), 0u) << intent.index();
  EXPECT_TRUE(waitFor([&] { return services().locked; }));
}

TEST_F(SendingDemo, WhatIsRepeatedEndsOffTheLiveEdgeToo) {
  ASSERT_TRUE(unlock());
  m_session.intend(intent::Repeat{m_monitor, RequestSet{Request::Fault}, 500ms});
  const auto period = [&] {
    const DeviceServices* device = services().find(m_monitor);
    return device == nullptr ? Duration{0} : device->of(Request::Fault).period;
  };
  ASSERT_TRUE(waitFor([&] { return period() > 0s; }));
  m_session.pause();
  m_session.intend(intent::Repeat{m_monitor, RequestSet{Request::Fault}, 0s});
  EXPECT_TRUE(waitFor([&] { return period() == 0s; }));
}

TEST_F(SendingDemo, ThatNothingWasSentIsSaidUntilTheNextDeed) {
  ASSERT_TRUE(unlock());
  m_session.pause();
  QSignalSpy changed(&m_session, &Session::changed);
  m_session.intend(intent::SendRequests{m_monitor, kPolls});
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(m_session.snapshot().notSent, Refusal::NotLive);
  m_session.goToEnd();
  EXPECT_EQ(m_session.snapshot().notSent, Refusal::None);
  m_session.closeSource();
  m_session.intend(intent::SendRequests{m_monitor, kPolls});
  EXPECT_EQ(m_session.snapshot().notSent, Refusal::NoLink);
}

TEST_F(SendingDemo, WhoIsSaidToBeADriveIsOneUntilThatIsTakenBack) {
  const Address address = state().devices().byPin(kMonitor)->address;
  m_session.sayDrive(address, true);
  EXPECT_TRUE(waitFor([&] { return state().channel(Channel{}).book.isDrive(address); }));
  m_session.sayDrive(address, false);
  EXPECT_TRUE(waitFor([&] { return !state().channel(Channel{}).book.isDrive(address); }));
}

TEST_F(SendingDemo, AFreshOneIsLockedAgain) {
  ASSERT_TRUE(unlock());
  m_session.openDemo();
  EXPECT_TRUE(services().locked);
  ASSERT_TRUE(waitFor([&] { return state().devices().byPin(kMonitor) != nullptr; }));
  EXPECT_TRUE(services().locked);
}

}  // namespace
}  // namespace deckpipe
