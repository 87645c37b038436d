// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings as a script meets them: listed, read while they grow, read when they were cut off.
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <memory>

#include "log/journal_writer.h"
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

TEST_F(RecordingsOfTheTool, AreReadByInfoAndDecodeWhileTheyGrow) {
  record();
  for (const char* command : {"info", "decode"}) {
    const Outcome r = run({QLatin1String(command), m_path});
    EXPECT_EQ(r.status, 0) << command << r.err.constData();
    EXPECT_TRUE(r.err.contains("was not ended")) << r.err.constData();
  }
  EXPECT_EQ(run({QStringLiteral("decode"), m_path}).lines().size(), 3);
  m_writer->end();
  const Outcome r = run({QStringLiteral("decode"), m_path});
  EXPECT_EQ(r.status, 0);
  EXPECT_TRUE(r.err.isEmpty()) << r.err.constData();
  EXPECT_TRUE(r.lines()[2].contains(R"("family":"copley")")) << r.lines()[2].constData();
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
  const Outcome r = run(
      {QStringLiteral("recordings"), QStringLiteral("--folder"), m_dir.filePath(QStringLiteral("absent"))});
  EXPECT_EQ(r.status, 0);
  EXPECT_TRUE(r.out.isEmpty());
}

}  // namespace
}  // namespace deckpipe
