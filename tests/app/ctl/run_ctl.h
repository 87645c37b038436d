// SPDX-License-Identifier: GPL-3.0-or-later
// The headless tool as a script runs it: arguments and standard input in, status and output back.
#pragma once

#include <gtest/gtest.h>

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStringList>

namespace deckpipe::test {

struct Outcome {
  int status = -1;
  QByteArray out, err;
  QList<QByteArray> lines() const {
    QList<QByteArray> all = out.split('\n');
    if (!all.isEmpty() && all.last().isEmpty()) all.removeLast();
    return all;
  }
  // Each line of output; one that is no JSON is a failure.
  QList<QJsonObject> objects() const {
    QList<QJsonObject> all;
    for (const QByteArray& line : lines()) {
      const QJsonObject object = QJsonDocument::fromJson(line).object();
      EXPECT_FALSE(object.isEmpty()) << line.constData();
      all += object;
    }
    return all;
  }
};

inline Outcome outcomeOf(QProcess& process) {
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
          process.readAllStandardOutput(), process.readAllStandardError()};
}

inline QStringList words(const char* text) {
  return QString::fromLatin1(text).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

}  // namespace deckpipe::test
