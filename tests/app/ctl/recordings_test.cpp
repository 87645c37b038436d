// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings as a script meets them: listed, read while they grow, read when they were cut off.
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <memory>

#include "log/journal_writer.h"
#include "log/log_format.h"
#include "run_ctl.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

using test::Outcome;

class RecordingsOfTheTool : public testing::Test {
 protected:
  Outcome run(const QStringList& arguments) {
    QProcess process;
    process.start(QStringLiteral(DECKPIPECTL), arguments);
    EXPECT_TRUE(process.waitForFinished(60'000));
    return test::outcomeOf(process);
  }
  // Frames of one monitor, with a Copley drive said to be at A0 before the last one.
  void record() {
    m_frames.channel("can0");
    for (const Frame& frame : {test::frame("18EFFF80", "FF83150206021A0B", 0, 1'000'000'000),
                               test::frame("18EFFF80", "011D940371000041", 0, 1'500'000'000)})
      EXPECT_TRUE(m_frames.append({&frame, 1}));
    m_notes.append({.frame = 2, .time = {1'500'000'000}, .value = note::DriveSaid{{}, Address{0xA0}, true}});
    const Frame drive = test::frame("18EFA0F9", "000000000024", 0, 2'000'000'000);
    EXPECT_TRUE(m_frames.append({&drive, 1}));
    m_writer->timeCame({});
  }
  QTemporaryDir m_dir;
  QString m_path = m_dir.filePath(QStringLiteral("one.deckpipe"));
  FrameStore m_frames;
  NoteStore m_notes;
  std::unique_ptr<JournalWriter> m_writer = std::make_unique<JournalWriter>(
      m_frames, m_notes,
      [this] { return createJournalFile(m_dir.filePath(QStringLiteral("one")).toStdString()); },
      [] { return JournalHead{.begin = 1'796'000'000'000'000'000}; });
};

TEST_F(RecordingsOfTheTool, AreReadByInfoAndDecodeWhileTheyGrowAndAfterAKill) {
  record();
  for (const char* command : {"info", "decode"}) {
    const Outcome r = run({QLatin1String(command), m_path});
    EXPECT_EQ(r.status, 0) << command << r.err.constData();
    EXPECT_TRUE(r.err.contains("still goes on")) << r.err.constData();
  }
  // A copy has the bytes of one that was killed: nobody writes it any more.
  const QString killed = m_dir.filePath(QStringLiteral("killed.deckpipe"));
  ASSERT_TRUE(QFile::copy(m_path, killed));
  for (const char* command : {"info", "decode"}) {
    const Outcome r = run({QLatin1String(command), killed});
    EXPECT_EQ(r.status, 1) << command << r.err.constData();
    EXPECT_TRUE(r.err.contains("its last second may be missing")) << r.err.constData();
  }
  EXPECT_EQ(run({QStringLiteral("decode"), m_path}).lines().size(), 3);
  m_writer->end();
  const Outcome r = run({QStringLiteral("decode"), m_path});
  EXPECT_EQ(r.status, 0);
  EXPECT_TRUE(r.err.isEmpty()) << r.err.constData();
  EXPECT_TRUE(r.lines()[2].contains(R"("family":"copley")")) << r.lines()[2].constData();
}

TEST_F(RecordingsOfTheTool, TellOfAMonitorThatFellSilentBeforeTheyWereKilled) {
  record();
  m_notes.append({.time = {32'000'000'000}, .value = note::RanUntil{}});
  m_writer->timeCame({1'000'000'000});
  const QJsonObject info =
      run({QStringLiteral("info"), QStringLiteral("--devices"), QStringLiteral("--json"), m_path})
          .objects()[0];
  EXPECT_EQ(info[QLatin1String("span")].toDouble(), 31.0);
  EXPECT_EQ(info[QLatin1String("devices")].toArray()[0][QLatin1String("health")], QStringLiteral("silent"));
  const QByteArray events = run({QStringLiteral("events"), m_path}).out;
  EXPECT_TRUE(events.contains("silent")) << events.constData();
  EXPECT_FALSE(events.contains("ran until")) << events.constData();
}

TEST_F(RecordingsOfTheTool, JudgeDevicesAtTheirEndAndNotWhereALinkWasClosedBefore) {
  record();
  auto health = [&, now = Instant{}]() mutable {
    m_writer->timeCame(now = {now.ns + 1'000'000'000});
    return run({QStringLiteral("info"), QStringLiteral("--devices"), QStringLiteral("--json"), m_path})
        .objects()[0][QLatin1String("devices")]
        .toArray()[0][QLatin1String("health")]
        .toString();
  };
  const QString before = health();
  m_notes.append({.frame = 3, .time = {1'100'000'000}, .value = note::LinkDown{}});
  EXPECT_EQ(health(), before);
  m_notes.append({.frame = 3, .time = {2'000'000'000}, .value = note::LinkUp{}});
  m_notes.append({.time = {3'600'000'000'000}, .value = note::RanUntil{}});
  EXPECT_NE(health(), before) << "nothing was heard of it for an hour";
}

TEST_F(RecordingsOfTheTool, AreNotListedOfWhatIsNoFolder) {
  record();
  for (const QString& folder : {m_dir.filePath(QStringLiteral("absent")), m_path}) {
    const Outcome r = run({QStringLiteral("recordings"), QStringLiteral("--folder"), folder});
    EXPECT_EQ(r.status, 3);
    EXPECT_TRUE(r.out.isEmpty());
    EXPECT_TRUE(r.err.contains(folder.toUtf8())) << r.err.constData();
  }
  EXPECT_EQ(run({QStringLiteral("recordings"), QStringLiteral("--folder"), m_dir.path()}).status, 0);
}

TEST_F(RecordingsOfTheTool, AreReadFromAPipeToo) {
  record();
  m_writer->end();
  QFile file(m_path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  for (const char* command : {"info --devices", "decode"}) {
    const QStringList words = test::words(command);
    QProcess process;
    process.start(QStringLiteral(DECKPIPECTL), words + QStringList{QStringLiteral("-")});
    file.seek(0);
    process.write(file.readAll());
    process.closeWriteChannel();
    ASSERT_TRUE(process.waitForFinished(60'000));
    const Outcome piped = test::outcomeOf(process), read = run(words + QStringList{m_path});
    EXPECT_EQ(piped.status, 0) << piped.err.constData();
    EXPECT_EQ(QByteArray(piped.out).replace("standard input", m_path.toUtf8()), read.out);
  }
}

TEST_F(RecordingsOfTheTool, SayWhatTheirNotesSayOfThem) {
  m_frames.channel("can0");
  m_notes.append({.frame = 0, .time = {}, .value = note::LinkUp{{}, "socketcan can0, 250 kbit/s"}});
  m_notes.append(
      {.frame = 0, .time = {}, .value = note::Label{*Pin::parse("1032AE100801035"), "front bumper"}});
  record();
  m_notes.append({.frame = 3, .time = {}, .value = note::LeftOut{{}, note::LeftOut::Why::CanFd, 7}});
  using Why = note::LeftOut::Why;
  m_notes.append({.frame = 3, .time = {}, .value = note::LeftOut{{}, Why::Unreadable, 2}});
  m_notes.append({.frame = 3, .time = {}, .value = note::LeftOut{{}, Why::NotWhole, 3}});
  m_notes.append({.frame = 3, .time = {}, .value = note::LeftOut{{}, Why::RecorderLost, 1}});
  m_writer->end();
  const Outcome text = run({QStringLiteral("info"), QStringLiteral("--devices"), m_path});
  EXPECT_EQ(text.status, 1) << "seven frames came that are not in it";
  EXPECT_TRUE(text.err.contains("7 frames came that it cannot hold")) << text.err.constData();
  EXPECT_TRUE(text.err.contains("2 lines of the file that it was saved from")) << text.err.constData();
  EXPECT_TRUE(text.err.contains("the recorder lost frames at 1 place,")) << text.err.constData();
  EXPECT_TRUE(text.err.contains("was not whole at 3 places")) << text.err.constData();
  EXPECT_TRUE(text.out.contains("can0 was socketcan can0, 250 kbit/s")) << text.out.constData();
  EXPECT_TRUE(text.out.contains("front bumper"));
  const QJsonObject json =
      run({QStringLiteral("info"), QStringLiteral("--json"), QStringLiteral("--devices"), m_path})
          .objects()[0];
  EXPECT_EQ(json[QStringLiteral("missed")].toInt(), 7);
  EXPECT_EQ(json[QStringLiteral("missed_lines")].toInt(), 2);
  EXPECT_EQ(json[QStringLiteral("missed_places")].toInt(), 1);
  EXPECT_EQ(json[QStringLiteral("places_not_whole")].toInt(), 3);
  const QList<QJsonObject> events =
      run({QStringLiteral("events"), QStringLiteral("--json"), m_path}).objects();
  ASSERT_GE(events.size(), 3);
  EXPECT_EQ(events[events.size() - 3][QStringLiteral("lines")].toInt(), 2);
  EXPECT_EQ(events[events.size() - 2][QStringLiteral("places")].toInt(), 3);
  EXPECT_EQ(events.back()[QStringLiteral("reason")].toString(), QStringLiteral("recorder_lost"));
  EXPECT_EQ(events.back()[QStringLiteral("places")].toInt(), 1);
  EXPECT_EQ(json[QStringLiteral("devices")].toArray()[0].toObject()[QStringLiteral("label")].toString(),
            QStringLiteral("front bumper"));
  const Outcome listed = run({QStringLiteral("recordings"), QStringLiteral("--folder"), m_dir.path()});
  EXPECT_TRUE(listed.out.contains("socketcan can0, 250 kbit/s")) << listed.out.constData();
}

TEST_F(RecordingsOfTheTool, HaveASidecarWhereTheyAreCandumpLogs) {
  record();
  const auto writer = formatToWrite("x.log").makeWriter();
  std::string text;
  writer->channel("can0", text);
  for (std::uint64_t i = 0; i < 3; ++i) {
    for (const Note& note : m_notes.between(i, i + 1)) writer->note(note, text);
    writer->frame(m_frames[i], m_frames.timeAt(i), text);
  }
  const auto put = [this](const char* name, const std::string& content) {
    QFile file(m_dir.filePath(QLatin1String(name)));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content.c_str());
    return file.fileName();
  };
  const QString path = put("mine.log", text);
  EXPECT_FALSE(run({QStringLiteral("decode"), path}).out.contains(R"("family":"copley")"));
  put("mine.log.deckpipe-notes", writer->beside());
  const Outcome with = run({QStringLiteral("decode"), path});
  EXPECT_EQ(with.status, 0) << with.err.constData();
  EXPECT_TRUE(with.lines()[2].contains(R"("family":"copley")")) << with.out.constData();
  put("mine.log.deckpipe-notes", writer->beside().substr(0, 60));
  const Outcome cut = run({QStringLiteral("decode"), path});
  EXPECT_EQ(cut.status, 1);
  EXPECT_EQ(cut.lines().size(), 3) << "the log is read all the same";
  EXPECT_TRUE(cut.err.contains("mine.log.deckpipe-notes:")) << cut.err.constData();
  EXPECT_TRUE(cut.err.contains("its end is missing")) << cut.err.constData();
}

TEST_F(RecordingsOfTheTool, ThatWereCutOffSayHowMuchIsMissing) {
  record();
  m_writer->end();
  QFile file(m_path);
  ASSERT_TRUE(file.resize(file.size() - 1));
  const Outcome r = run({QStringLiteral("info"), m_path});
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.err.contains("bytes are not whole and were left out")) << r.err.constData();
}

TEST_F(RecordingsOfTheTool, ThatAreDamagedInTheMiddleKeepWhatIsBehindAndSaySo) {
  record();
  m_writer->end();
  const Outcome whole = run({QStringLiteral("decode"), m_path});
  ASSERT_EQ(whole.status, 0) << whole.err.constData();
  QFile file(m_path);
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  file.seek(28 + 13);  // in the name of the channel
  ASSERT_EQ(file.write("!"), 1);
  file.close();
  const Outcome r = run({QStringLiteral("decode"), m_path});
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(r.lines().size(), whole.lines().size());
  EXPECT_TRUE(r.out.contains("name-lost-0")) << r.out.constData();
  EXPECT_TRUE(r.err.contains("damaged in 1 place, the first at byte 28;")) << r.err.constData();
  EXPECT_FALSE(r.err.contains("has no end")) << r.err.constData();
}

TEST_F(RecordingsOfTheTool, ThatWereCutBeforeTheirFirstFrameHoldNoneAndHaveNoReport) {
  record();
  QFile file(m_path);
  for (const qint64 size : {44, 28, 10}) {
    ASSERT_TRUE(file.resize(size));
    for (const char* command : {"info", "decode"}) {
      const Outcome r = run({QLatin1String(command), m_path});
      EXPECT_EQ(r.status, 4) << command << size;
      EXPECT_TRUE(r.out.isEmpty()) << r.out.constData();
      EXPECT_TRUE(r.err.contains("it holds no frame")) << r.err.constData();
      EXPECT_EQ(r.err.contains("bytes are not whole"), size != 28) << r.err.constData();
    }
  }
}

TEST_F(RecordingsOfTheTool, AreListedWithWhatIsInThem) {
  record();
  const QStringList list{QStringLiteral("recordings"), QStringLiteral("--json"), QStringLiteral("--folder"),
                         m_dir.path()};
  Outcome r = run(list);
  EXPECT_EQ(r.status, 0) << r.err.constData();
  ASSERT_EQ(r.objects().size(), 1);
  EXPECT_EQ(r.objects()[0][QStringLiteral("state")].toString(), QStringLiteral("growing"));
  m_writer.reset();
  r = run(list);
  const QJsonObject recording = r.objects()[0];
  EXPECT_EQ(recording[QStringLiteral("state")].toString(), QStringLiteral("unsaved"));
  EXPECT_EQ(recording[QStringLiteral("path")].toString(), m_path);
  EXPECT_EQ(recording[QStringLiteral("frames")].toInt(), 3);
  EXPECT_EQ(recording[QStringLiteral("length_s")].toDouble(), 1.0);
  EXPECT_FALSE(recording[QStringLiteral("whole")].toBool()) << "its program was killed";
  EXPECT_EQ(recording[QStringLiteral("pins")].toArray().at(0).toString(), QStringLiteral("1032AE100801035"));
}

TEST_F(RecordingsOfTheTool, OfAFolderWithoutAnyAreAnEmptyList) {
  const Outcome r = run({QStringLiteral("recordings"), QStringLiteral("--folder"), m_dir.path()});
  EXPECT_EQ(r.status, 0);
  EXPECT_TRUE(r.out.isEmpty());
}

}  // namespace
}  // namespace deckpipe
