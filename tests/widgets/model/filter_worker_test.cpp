// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/filter_worker.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "model/trace_cells.h"
#include "model/trace_model.h"
#include "support/frames.h"
#include "support/logs.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

TraceFilter filterOf(const char* text) { return TraceFilter::parse(QString::fromUtf8(text)).value(); }

// Every tenth frame is from 81, the others from 80.
std::vector<Frame> traffic(std::size_t count, std::size_t from = 0) {
  std::vector<Frame> frames;
  for (std::size_t i = from; i < from + count; ++i)
    frames.push_back(test::frame(i % 10 == 0 ? "18EFFF81" : "18EFFF80", "011D940371000041", 0,
                                 static_cast<std::int64_t>(i) * 1'000'000));
  return frames;
}

bool isThrough(const FilterWorker& worker, const LogDocument& log) {
  return QTest::qWaitFor([&] { return worker.rows().scanned() == log.frames.count(); });
}

TEST(MatchedRows, LeadFromRowToFrameAndBack) {
  MatchedRows rows;
  const std::uint16_t first[] = {0, 5, 65'535}, third[] = {7};
  rows.append(first, MatchedRows::kBlock);
  rows.append({}, 2 * MatchedRows::kBlock);
  rows.append(third, 2 * MatchedRows::kBlock + 100);
  EXPECT_EQ(rows.rows(), 4u);
  EXPECT_EQ(rows.frames(0, 100), (std::vector<std::uint64_t>{0, 5, 65'535, 131'079}));
  EXPECT_EQ(rows.frames(3, 2), (std::vector<std::uint64_t>{131'079}));
  EXPECT_TRUE(rows.frames(4, 1).empty());
  EXPECT_EQ(rows.rowOf(0), 0u);
  EXPECT_EQ(rows.rowOf(1), 1u);
  EXPECT_EQ(rows.rowOf(5), 1u);
  EXPECT_EQ(rows.rowOf(65'536), 3u);
  EXPECT_EQ(rows.rowOf(131'080), 4u);
  EXPECT_EQ(rows.rowOf(1'000'000), 4u);
  rows.clear();
  EXPECT_EQ(rows.rows(), 0u);
  EXPECT_TRUE(rows.frames(0, 5).empty());
}

TEST(FilterWorker, FindsWhatAPlainLoopFinds) {
  const auto log = test::logOf(traffic(200'000));
  FilterWorker worker(log, filterOf("sa=81"));
  ASSERT_TRUE(isThrough(worker, *log));
  ASSERT_EQ(worker.rows().rows(), 20'000u);
  const auto frames = worker.rows().frames(0, 20'000);
  for (std::size_t i = 0; i < frames.size(); ++i) ASSERT_EQ(frames[i], i * 10);
}

TEST(FilterWorker, GoesOnAsTheLogGrows) {
  const auto log = test::logOf(traffic(1000));
  FilterWorker worker(log, filterOf("sa=81"));
  ASSERT_TRUE(isThrough(worker, *log));
  ASSERT_TRUE(log->frames.append(traffic(70'000, 1000)));
  worker.wake();
  ASSERT_TRUE(isThrough(worker, *log));
  EXPECT_EQ(worker.rows().rows(), 7'100u);
  EXPECT_EQ(worker.rows().rowOf(70'991), 7'100u);
}

// The index of roles is not built here: what frames are is learned on the way.
TEST(FilterWorker, KnowsWhoIsWhoAtEachFrame) {
  const auto log = std::make_shared<LogDocument>();
  log->frames.channel("can0");
  const Frame pipe = test::frame("18EF80F2", "FE48454C4C4F");
  ASSERT_TRUE(log->frames.append(std::vector{pipe, test::frame("18EFFF80", "FF83150206021A0B"), pipe}));
  FilterWorker worker(log, filterOf("name=pipe_data"));
  ASSERT_TRUE(isThrough(worker, *log));
  EXPECT_EQ(worker.rows().frames(0, 10), std::vector<std::uint64_t>{2});
}

TEST(FilterWorker, LooksAgainWhenADriveIsSaidInThePast) {
  const auto log = std::make_shared<LogDocument>();
  log->frames.channel("can0");
  ASSERT_TRUE(log->frames.append(std::vector(20, test::frame("18EF2080", "02210002"))));
  FilterWorker worker(log, filterOf("family=copley"));
  ASSERT_TRUE(isThrough(worker, *log));
  ASSERT_EQ(worker.rows().rows(), 0u);
  log->notes.append({.frame = 5, .value = note::DriveSaid{{}, {0x20}}});
  worker.wake();
  ASSERT_TRUE(QTest::qWaitFor([&] { return worker.rows().rows() == 15; }));
  EXPECT_EQ(worker.rows().frames(0, 1), std::vector<std::uint64_t>{5});
}

struct FilteredTrace : testing::Test {
  TraceModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
  std::shared_ptr<LogDocument> log;

  void open(std::size_t frames, std::optional<std::uint64_t> cursor = {}) {
    log = test::logOf(traffic(frames));
    model.setView(test::viewOf(log, cursor));
  }
  void filter(const char* text) {
    model.setFilter(filterOf(text));
    wait();
  }
  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] {
      model.refresh();
      return !model.isFiltering();
    }));
  }
  QString cell(int row, int column) const { return model.index(row, column).data().toString(); }
};

TEST_F(FilteredTrace, HasTheRowsThatPass) {
  open(1000);
  model.setWindow(0, 50);
  filter("sa=81");
  model.setWindow(0, 50);
  EXPECT_EQ(model.rows(), 100u);
  EXPECT_EQ(model.rowCount(), 50);
  EXPECT_EQ(model.frameOf(7), 70u);
  EXPECT_EQ(model.rowOf(70), 7u);
  EXPECT_EQ(model.rowOf(71), 8u);
  EXPECT_FALSE(model.frameOf(100));
  EXPECT_EQ(model.index(3, 0).data(TraceModel::FrameRole).toULongLong(), 30u);
  filter("");
  EXPECT_EQ(model.rows(), 1000u);
  EXPECT_FALSE(model.isFiltered());
}

TEST_F(FilteredTrace, MeasuresTheTimeSinceTheRowBefore) {
  open(1000);
  filter("sa=81");
  model.setWindow(0, 10);
  EXPECT_EQ(cell(0, TraceModel::Delta), QString());
  EXPECT_EQ(cell(1, TraceModel::Delta), QStringLiteral("0.010000"));
  model.setWindow(5, 10);
  EXPECT_EQ(cell(0, TraceModel::Delta), QStringLiteral("0.010000"));
}

TEST_F(FilteredTrace, MarksTheLastRowThatHasHappened) {
  open(1000, 35);
  filter("sa=81");
  model.setWindow(0, 10);
  const auto marks = [this](int row) {
    return TraceModel::Marks::fromInt(model.index(row, 0).data(TraceModel::MarksRole).toUInt());
  };
  EXPECT_TRUE(marks(3).testFlag(TraceModel::AtCursor));
  EXPECT_FALSE(marks(3).testFlag(TraceModel::AfterCursor));
  EXPECT_TRUE(marks(4).testFlag(TraceModel::AfterCursor));
  const QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  model.setView(test::viewOf(log, 36));
  EXPECT_EQ(changed.count(), 0);
  model.setView(test::viewOf(log, 41));
  EXPECT_EQ(changed.count(), 1);
  EXPECT_TRUE(marks(4).testFlag(TraceModel::AtCursor));
}

TEST_F(FilteredTrace, GrowsWithTheLogAndGoesToAnotherLog) {
  open(1000);
  filter("sa=81");
  model.setWindow(0, 200);
  EXPECT_EQ(model.rowCount(), 100);
  ASSERT_TRUE(log->frames.append(traffic(500, 1000)));
  model.setView(test::viewOf(log));
  wait();
  EXPECT_EQ(model.rowCount(), 150);
  open(20);
  wait();
  model.setWindow(0, 200);
  EXPECT_EQ(model.rowCount(), 2);
  model.setView({});
  EXPECT_EQ(model.rows(), 0u);
}

TEST_F(FilteredTrace, SaysTimesSinceTheBeginUntilToldOtherwise) {
  open(100);
  model.setWindow(0, 100);
  QSignalSpy header(&model, &QAbstractItemModel::headerDataChanged);
  EXPECT_EQ(cell(42, TraceModel::Time), QStringLiteral("0.042000"));
  model.setTimeMode(TraceModel::TimeMode::SinceRowBefore);
  EXPECT_EQ(cell(42, TraceModel::Time), QStringLiteral("0.001000"));
  EXPECT_EQ(header.count(), 1);
  filter("frame>40");
  model.setWindow(0, 100);
  model.setTimeMode(TraceModel::TimeMode::SinceBegin);
  EXPECT_EQ(cell(0, TraceModel::Time), QStringLiteral("0.040000"));
  model.setTimeMode(TraceModel::TimeMode::Clock);
  EXPECT_EQ(cell(0, TraceModel::Time), QStringLiteral("0.040000")) << "no date";
  model.setTimeMode(TraceModel::TimeMode::Stamp);
  EXPECT_EQ(cell(0, TraceModel::Time), stampText(model.view().document->frames[40]));
}

TEST(TraceClock, IsTheLocalTimeOfTheStamp) {
  const QString text = clockText(1'795'358'019'184'225'999);
  EXPECT_EQ(text.size(), 15);
  EXPECT_EQ(text.mid(5), QStringLiteral(":39.184225")) << "whatever the zone of this computer is";
}

}  // namespace
}  // namespace deckpipe
