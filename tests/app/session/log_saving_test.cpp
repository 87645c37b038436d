// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/log_saving.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <latch>

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

}  // namespace
}  // namespace deckpipe
