// SPDX-License-Identifier: GPL-3.0-or-later
// The program itself, as a terminal without a display meets it.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "session/recordings.h"

namespace {

struct Outcome {
  int status = -1;
  QByteArray out, err;
};

Outcome runWithoutDisplay(const QString& argument, const QString& outputFile = {}) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    environment.remove(QLatin1String(name));
  process.setProcessEnvironment(environment);
  if (!outputFile.isEmpty()) process.setStandardOutputFile(outputFile);
  process.start(QStringLiteral(DECKPIPE), {argument});
  EXPECT_TRUE(process.waitForFinished(60'000));
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
          process.readAllStandardOutput(), process.readAllStandardError()};
}

TEST(Program, SaysItsHelpAndVersionWithoutADisplay) {
  const Outcome help = runWithoutDisplay(QStringLiteral("--help"));
  EXPECT_EQ(help.status, 0) << help.err.constData();
  EXPECT_TRUE(help.out.startsWith("Usage: ")) << help.out.constData();
  const Outcome version = runWithoutDisplay(QStringLiteral("--version"));
  EXPECT_EQ(version.status, 0) << version.err.constData();
  EXPECT_TRUE(version.out.startsWith("deckpipe ")) << version.out.constData();
}

TEST(Program, EndsARecordingWhenItIsStopped) {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    SCOPED_TRACE(signal);
    const QTemporaryDir home;
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
    environment.insert(QStringLiteral("XDG_DATA_HOME"), home.path());
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), home.path());
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(DECKPIPE), {QStringLiteral("--demo")});
    const QDir folder(home.filePath(QStringLiteral("Deckpipe/deckpipe/recordings")));
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          const auto recordings = deckpipe::recordingsIn(folder.path());
          return !recordings.empty() && recordings[0].frames > 0;
        },
        60'000));
    ASSERT_EQ(::kill(static_cast<pid_t>(process.processId()), signal), 0);
    ASSERT_TRUE(process.waitForFinished(60'000));
    EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(process.exitCode(), 0);
    const auto recordings = deckpipe::recordingsIn(folder.path());
    ASSERT_EQ(recordings.size(), 1u);
    EXPECT_TRUE(recordings[0].isWhole);
  }
}

TEST(Program, RefusesUnusableArgumentsWithoutADisplay) {
  EXPECT_EQ(runWithoutDisplay(QStringLiteral("--nope")).status, 2);
}

TEST(Program, DrawsAPictureOfTheSizeThatWasAskedFor) {
  const QTemporaryDir folder;
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
  process.setProcessEnvironment(environment);
  const QString file = folder.filePath(QStringLiteral("window.png"));
  process.start(QStringLiteral(DECKPIPE),
                {QStringLiteral("--grab"), file, QStringLiteral("--size"), QStringLiteral("1024x600"),
                 QStringLiteral("--after"), QStringLiteral("0")});
  EXPECT_TRUE(process.waitForFinished(60'000));
  EXPECT_EQ(QImage(file).size(), QSize(1024, 600)) << process.readAllStandardError().constData();
  for (const char* size : {"1024", "0x600", "1024x", "wide", "1024x600x2", "99999x600"}) {
    EXPECT_EQ(runWithoutDisplay(QStringLiteral("--size=") + QLatin1String(size)).status, 2) << size;
  }
}

TEST(Program, SaysWhenItsHelpCannotBeWritten) {
  const QString full = QStringLiteral("/dev/full");
  if (!QFile::exists(full)) GTEST_SKIP() << "no /dev/full";
  EXPECT_EQ(runWithoutDisplay(QStringLiteral("--help"), full).status, 1);
  EXPECT_EQ(runWithoutDisplay(QStringLiteral("--version"), full).status, 1);
}

}  // namespace
