// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/trace_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "support/frames.h"
#include "support/logs.h"
#include "support/raw_frames.h"

namespace deckpipe {
namespace {

using enum TraceModel::Column;

constexpr std::string_view kSmall =
    "(1700000000.000000) can0 18EFFF80#FF83150206021A0B\n"
    "(1700000000.100250) can0 18EFFF80#011D940371000041\n"
    "(1700000000.120000) can1 0CFDD633#107D046400100000 T\n"
    "(1700000000.130000) can0 18EFFF80#011D94\n"
    "(1699999990.000000) can1 724#05\n"
    "(1700000000.140000) can0 1A4#R\n"
    "(1700000000.150000) can0 20000040#0000000000000000\n"
    "(1700000000.160000) can0 18EF81A0#FE0102\n"
    "(1700000000.170000) can0 18F00503#0102\n";

struct TraceModelTest : testing::Test {
  TraceModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};

  QString cell(int row, int column, int role = Qt::DisplayRole) const {
    return model.index(row, column).data(role).toString();
  }
  TraceModel::Marks marks(int row) const {
    return TraceModel::Marks::fromInt(model.index(row, 0).data(TraceModel::MarksRole).toUInt());
  }
  std::uint64_t frame(int row) const { return model.index(row, 0).data(TraceModel::FrameRole).toULongLong(); }
};

std::vector<Frame> manyFrames(std::size_t count, std::size_t from = 0) {
  std::vector<Frame> frames;
  for (std::size_t i = from; i < from + count; ++i)
    frames.push_back(
        test::frame("18EFFF80", "011D940371000041", 0, static_cast<std::int64_t>(i) * 1'000'000));
  return frames;
}

TEST_F(TraceModelTest, SaysNothingWithoutALog) {
  model.setWindow(0, 50);
  EXPECT_EQ(model.rowCount(), 0);
  EXPECT_EQ(model.rows(), 0u);
  model.setView(test::viewOf(nullptr));
  EXPECT_EQ(model.rowCount(), 0);
  model.setWindow(1000, 50);
  EXPECT_EQ(model.rowCount(), 0);
}

TEST_F(TraceModelTest, WritesEveryColumnForPeople) {
  model.setTimeMode(TraceModel::TimeMode::Stamp);
  model.setWindow(0, 50);
  model.setView(test::viewOf(test::logOfText(kSmall)));
  ASSERT_EQ(model.rowCount(), 9);
  const char* expected[9][TraceModel::ColumnCount] = {
      {"1700000000.000000", "", "can0", "Rx", "18EFFF80", "EF00", "80→FF", "8", "FF 83 15 02 06 02 1A 0B",
       "Address announcement", "PIN 1032AE100801035, 6032 Universal II"},
      {"1700000000.100250", "0.100250", "can0", "Rx", "18EFFF80", "EF00", "80→FF", "8",
       "01 1D 94 03 71 00 00 41", "Position / limit status",
       "Rotation 47.3°, Elevation −5.5°, Axis 5 (+) hard stop"},
      {"1700000000.120000", "0.019750", "can1", "Tx", "0CFDD633", "FDD6", "33", "8",
       "10 7D 04 64 00 10 00 00", "Basic joystick", "X 50.0 %, Y −40.0 %, Fog"},
      {"1700000000.130000", "0.010000", "can0", "Rx", "18EFFF80", "EF00", "80→FF", "3", "01 1D 94",
       "Malformed: Position / limit status", "8 bytes wanted, 3 came"},
      {"1699999990.000000", "0.000000", "can1", "Rx", "724", "", "node 24", "1", "05", "Heartbeat",
       "Operational"},
      {"1700000000.140000", "0.010000", "can0", "Rx", "1A4", "", "node 24", "0", "remote, length 0",
       "Remote request", ""},
      {"1700000000.150000", "0.010000", "can0", "Rx", "20000040", "", "", "8", "00 00 00 00 00 00 00 00",
       "Error frame", "Bus off"},
      {"1700000000.160000", "0.010000", "can0", "Rx", "18EF81A0", "EF00", "A0→81", "3", "FE 01 02",
       "Ambiguous", ""},
      {"1700000000.170000", "0.010000", "can0", "Rx", "18F00503", "F005", "03", "2", "01 02",
       "Electronic transmission controller 2 (ETC2)", ""},
  };
  for (int row = 0; row < 9; ++row) {
    for (int column = 0; column < TraceModel::ColumnCount; ++column)
      EXPECT_EQ(cell(row, column).toStdString(), expected[row][column])
          << "row " << row << " column " << column;
  }
}

TEST_F(TraceModelTest, HasNoTimesWhereTheLogHasNone) {
  model.setView(test::viewOf(test::logOfText("can0 123 [1] 11\ncan0 123 [1] 12\n")));
  model.setWindow(0, 50);
  for (const int row : {0, 1}) EXPECT_EQ(cell(row, Delta).toStdString(), "") << row;
  for (const auto mode : {TraceModel::TimeMode::SinceBegin, TraceModel::TimeMode::Clock,
                          TraceModel::TimeMode::Stamp, TraceModel::TimeMode::SinceRowBefore}) {
    model.setTimeMode(mode);
    EXPECT_FALSE(cell(1, Time).contains(u'0')) << cell(1, Time).toStdString();
  }
}

TEST_F(TraceModelTest, MarksWhatAPersonMustNotMiss) {
  model.setWindow(0, 50);
  model.setView(test::viewOf(test::logOfText(kSmall), 2));
  using M = TraceModel;
  EXPECT_EQ(marks(0), M::Marks(M::Presumed));
  EXPECT_EQ(marks(1), M::Marks(M::AtCursor));
  EXPECT_EQ(marks(2), M::AfterCursor | M::Own);
  EXPECT_EQ(marks(3), M::AfterCursor | M::Malformed);
  EXPECT_EQ(marks(4), M::AfterCursor | M::TimeJump);
  EXPECT_EQ(marks(5), M::AfterCursor | M::Remote);
  EXPECT_EQ(marks(6), M::AfterCursor | M::Error);
  EXPECT_EQ(marks(7), M::AfterCursor | M::Ambiguous);
  EXPECT_EQ(M::marksText(marks(4)).toStdString(), "after the cursor, the clock jumps here");
  EXPECT_EQ(cell(4, Time, Qt::AccessibleTextRole).toStdString(),
            "frame 5, after the cursor, the clock jumps here, time 0.130000, can1, identifier 724, "
            "Heartbeat, Operational");
}

TEST_F(TraceModelTest, MovesTheMarksOfTheCursorAndSaysOfWhichRows) {
  const auto log = test::logOf(manyFrames(100));
  model.setView(test::viewOf(log, 20));
  model.setWindow(10, 30);
  EXPECT_TRUE(marks(9).testFlag(TraceModel::AtCursor));
  QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  model.setView(test::viewOf(log, 25));
  ASSERT_EQ(changed.count(), 1);
  EXPECT_EQ(changed[0][0].toModelIndex().row(), 9);
  EXPECT_EQ(changed[0][1].toModelIndex().row(), 14);
  EXPECT_FALSE(marks(9).testFlag(TraceModel::AtCursor));
  EXPECT_TRUE(marks(14).testFlag(TraceModel::AtCursor));
  EXPECT_TRUE(marks(15).testFlag(TraceModel::AfterCursor));
  model.setView(test::viewOf(log, 80));
  EXPECT_EQ(changed.count(), 2);
  model.setView(test::viewOf(log, 90));
  EXPECT_EQ(changed.count(), 2) << "no row of the window is concerned";
}

TEST_F(TraceModelTest, HoldsAWindowOfRowsAndNoMore) {
  model.setView(test::viewOf(test::logOf(manyFrames(10'000))));
  model.setWindow(500, 40);
  EXPECT_EQ(model.rowCount(), 40);
  EXPECT_EQ(model.rows(), 10'000u);
  EXPECT_EQ(frame(0), 500u);
  EXPECT_EQ(frame(39), 539u);
  EXPECT_EQ(cell(0, Time).toStdString(), "0.500000");
  EXPECT_EQ(cell(0, Delta).toStdString(), "0.001000");
}

TEST_F(TraceModelTest, MovesItsWindowAsRowsThatComeAndGo) {
  model.setView(test::viewOf(test::logOf(manyFrames(10'000))));
  model.setWindow(500, 40);
  const QPersistentModelIndex kept(model.index(20, Name));
  QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
  QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
  QSignalSpy removed(&model, &QAbstractItemModel::rowsRemoved);
  for (const std::uint64_t first : {510u, 505u, 500u}) {
    model.setWindow(first, 40);
    EXPECT_EQ(model.rowCount(), 40);
    EXPECT_EQ(frame(0), first);
    EXPECT_EQ(frame(39), first + 39);
    ASSERT_TRUE(kept.isValid());
    EXPECT_EQ(kept.data(TraceModel::FrameRole).toULongLong(), 520u);
  }
  EXPECT_EQ(inserted.count(), 3);
  EXPECT_EQ(removed.count(), 3);
  EXPECT_EQ(reset.count(), 0);
  model.setWindow(9'990, 40);
  EXPECT_EQ(reset.count(), 1);
  EXPECT_EQ(model.rowCount(), 10);
  EXPECT_EQ(frame(9), 9'999u);
  model.setWindow(500, 10);
  model.setWindow(495, 30);
  EXPECT_EQ(model.rowCount(), 30);
  EXPECT_EQ(frame(0), 495u);
}

TEST_F(TraceModelTest, GrowsOnceATickHoweverManyFramesCame) {
  const auto log = test::logOf(manyFrames(10));
  model.setWindow(0, 1'000);
  model.setView(test::viewOf(log));
  QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
  QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
  ASSERT_TRUE(log->frames.append(manyFrames(500, 10)));
  model.setView(test::viewOf(log));
  EXPECT_EQ(inserted.count(), 1);
  EXPECT_EQ(model.rowCount(), 510);
  ASSERT_TRUE(log->frames.append(manyFrames(100'000, 510)));
  model.setView(test::viewOf(log));
  EXPECT_EQ(inserted.count(), 2);
  EXPECT_EQ(model.rowCount(), 1'000);
  EXPECT_EQ(model.rows(), 100'510u);
  model.setView(test::viewOf(log));
  EXPECT_EQ(inserted.count(), 2);
  EXPECT_EQ(reset.count(), 0);
}

TEST_F(TraceModelTest, ReadsRowsAnewOnceMoreIsKnownOfTheirNodes) {
  const auto log = std::make_shared<LogDocument>();
  log->frames.channel("can0");
  std::vector<Frame> frames{test::frame("18EFFF80", "FF83150206021A0B", 0, 1)};
  const std::vector<Frame> rest = manyFrames(50, 1);
  frames.insert(frames.end(), rest.begin(), rest.end());
  ASSERT_TRUE(log->frames.append(frames));
  model.setView(test::viewOf(log));
  model.setWindow(30, 10);
  EXPECT_EQ(cell(0, Name).toStdString(), "Position / limit status");
  EXPECT_TRUE(marks(0).testFlag(TraceModel::Presumed));
  test::buildIndexes(*log);
  QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  model.setView(test::viewOf(log));
  EXPECT_FALSE(marks(0).testFlag(TraceModel::Presumed));
  EXPECT_EQ(changed.count(), 1);
}

TEST_F(TraceModelTest, TakesNotesWithinItsWindow) {
  const auto log =
      test::logOf({test::frame("18EF2105", "1160F0FFFF", 0, 1), test::frame("18EF2105", "1160F0FFFF", 0, 2)});
  log->notes.append({.frame = 1, .value = note::DriveSaid{{}, {0x21}}});
  log->roles.invalidateAfter(1);
  test::buildIndexes(*log);
  model.setWindow(0, 10);
  model.setView(test::viewOf(log));
  EXPECT_EQ(cell(0, Name).toStdString(), "Proprietary A");
  EXPECT_EQ(cell(1, Name).toStdString(), "Drive: start move");
  EXPECT_EQ(cell(1, Decoded).toStdString(), "Position −4000");
}

TEST_F(TraceModelTest, SaysWhichFramesWereAddedOnSaving) {
  const auto log = test::logOf(manyFrames(3));
  model.setWindow(0, 10);
  model.setView(test::viewOf(log));
  EXPECT_FALSE(marks(0).testFlag(TraceModel::Added));
  log->notes.append({.frame = 0, .value = note::Added{2}});
  QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  model.setView(test::viewOf(log));
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(cell(1, TraceModel::Direction).toStdString(), "+");
  EXPECT_TRUE(marks(1).testFlag(TraceModel::Added));
  EXPECT_FALSE(marks(2).testFlag(TraceModel::Added));
  EXPECT_EQ(cell(2, TraceModel::Direction).toStdString(), "Rx");
}

TEST_F(TraceModelTest, StartsAnewWithAnotherLog) {
  model.setWindow(0, 50);
  model.setView(test::viewOf(test::logOfText(kSmall)));
  QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
  model.setView(test::viewOf(test::logOf(manyFrames(3))));
  EXPECT_EQ(reset.count(), 1);
  EXPECT_EQ(model.rowCount(), 3);
  model.setView(test::viewOf(nullptr));
  EXPECT_EQ(model.rowCount(), 0);
}

TEST_F(TraceModelTest, TellsTheWholeStoryInTheToolTip) {
  model.setWindow(0, 50);
  model.setView(test::viewOf(test::logOfText(kSmall)));
  EXPECT_TRUE(cell(3, Decoded, Qt::ToolTipRole)
                  .startsWith(QStringLiteral(
                      "Malformed: Position / limit status\nMalformed: 8 bytes wanted, 3 came.\n"
                      "Source: ")));
  EXPECT_TRUE(cell(1, Decoded, Qt::ToolTipRole)
                  .startsWith(QStringLiteral("Position / limit status\nRotation: 47.3°\n")));
  EXPECT_EQ(cell(1, Pgn, Qt::ToolTipRole).toStdString(), "PGN 61184");
}

TEST_F(TraceModelTest, ShowsLogsWithoutTimes) {
  Frame frame = test::frame("123", "AA");
  frame.stamp = kNoStamp;
  model.setWindow(0, 5);
  model.setView(test::viewOf(test::logOf({frame, frame})));
  EXPECT_EQ(cell(0, Time).toStdString(), "–");
  EXPECT_EQ(cell(1, Delta).toStdString(), "");
}

}  // namespace
}  // namespace deckpipe
