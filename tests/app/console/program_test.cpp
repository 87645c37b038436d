// SPDX-License-Identifier: GPL-3.0-or-later
// The program itself, as a terminal without a display meets it.
#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>

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

TEST(Program, RefusesUnusableArgumentsWithoutADisplay) {
  EXPECT_EQ(runWithoutDisplay(QStringLiteral("--nope")).status, 2);
}

TEST(Program, SaysWhenItsHelpCannotBeWritten) {
  const QString full = QStringLiteral("/dev/full");
  if (!QFile::exists(full)) GTEST_SKIP() << "no /dev/full";
  EXPECT_EQ(runWithoutDisplay(QStringLiteral("--help"), full).status, 1);
  EXPECT_EQ(runWithoutDisplay(QStringLiteral("--version"), full).status, 1);
}

}  // namespace
