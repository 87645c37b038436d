// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/id_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QTest>

#include "support/frames.h"
#include "support/logs.h"
#include "widgets/panel/panel_samples.h"

namespace deckpipe {
namespace {

using test::frame;
constexpr std::int64_t kMs = 1'000'000;

IdTable tableOf(const std::vector<Frame>& frames) {
  const auto log = test::logOf(frames);
  IdTable table;
  table.walk(log->frames, log->frames.count());
  return table;
}

TEST(IdTable, HasARowForEachChannelIdentifierAndTypeByte) {
  const IdTable table =
      tableOf({frame("18EFFF80", "01"), frame("18EFFF80", "83C051"), frame("18EFFF80", "01"),
               frame("18EFFF80", "01", 1), frame("0CFDD633", "107D"), frame("0CFDD633", "117D"),
               frame("5A4", "43"), frame("5A4", "60")});
  ASSERT_EQ(table.rows().size(), 5u);
  EXPECT_EQ(table.rows()[0].count, 2u);
  EXPECT_EQ(table.rows()[3].count, 2u);
  EXPECT_EQ(table.rows()[3].before[0], 0x10);
  EXPECT_EQ(table.others(), 0u);
}

TEST(IdTable, MeasuresMeanPeriodAndTheWorstBesideIt) {
  const IdTable table = tableOf({frame("5A4", "", 0, 0), frame("5A4", "", 0, 100 * kMs),
                                 frame("5A4", "", 0, 190 * kMs), frame("5A4", "", 0, 300 * kMs)});
  EXPECT_EQ(table.rows()[0].period(), Duration(100 * kMs));
  EXPECT_EQ(table.rows()[0].jitter(), Duration(10 * kMs));
}

TEST(IdTable, BeginsANewRunAfterALongPause) {
  std::vector<Frame> frames;
  for (int i = 0; i < 10; ++i) frames.push_back(frame("5A4", "", 0, i * 100 * kMs));
  for (int i = 0; i < 10; ++i) frames.push_back(frame("5A4", "", 0, (60'000 + i * 50) * kMs));
  const IdTable table = tableOf(frames);
  EXPECT_EQ(table.rows()[0].count, 20u);
  EXPECT_EQ(table.rows()[0].period(), Duration(50 * kMs));
  EXPECT_EQ(table.rows()[0].jitter(), Duration(0));
}

TEST(IdTable, CountsWhatItHasNoRowFor) {
  std::vector<Frame> frames;
  for (unsigned i = 0; i < IdTable::kMax + 5; ++i) {
    Frame one = frame("18000000", "");
    one.id |= i;
    frames.push_back(one);
  }
  const IdTable table = tableOf(frames);
  EXPECT_EQ(table.rows().size(), IdTable::kMax);
  EXPECT_EQ(table.others(), 5u);
}

std::shared_ptr<LogDocument> longLog() {
  std::vector<Frame> frames;
  for (std::int64_t i = 0; i < 400'000; ++i)
    frames.push_back(frame(i % 3 == 0 ? "18EFFF80" : i % 7 == 0 ? "5A4" : "0CFDD633", "0102", 0, i * kMs));
  return test::logOf(frames);
}

// The one that a plain walk from the begin gives, whatever way the cursor came.
TEST(IdTableWalker, FindsTheSameTableFromEveryDirection) {
  const auto log = longLog();
  IdTableWalker walker(log);
  for (const std::uint64_t wanted : {1000u, 399'000u, 200'000u, 131'072u, 131'071u, 0u, 400'000u}) {
    walker.request(wanted);
    ASSERT_TRUE(QTest::qWaitFor([&] { return walker.latest()->frames() == wanted; }));
    IdTable plain;
    plain.walk(log->frames, wanted);
    EXPECT_EQ(walker.latest()->rows(), plain.rows());
  }
}

// The table of the frames that pass alone, also where their meaning decides.
TEST(IdTableWalker, CountsWhatPassesAFilterFromEveryDirection) {
  const auto log = longLog();
  for (const char* expression :
       {"id=5A4", "sa=80 or sa=33 and t>=100 and t<300", "family=canopen or pgn=EF00"}) {
    const TraceFilter filter = TraceFilter::parse(QString::fromLatin1(expression)).value();
    IdTableWalker walker(log, filter);
    for (const std::uint64_t wanted : {399'000u, 200'000u, 131'073u, 400'000u}) {
      walker.request(wanted);
      ASSERT_TRUE(QTest::qWaitFor([&] { return walker.latest()->frames() == wanted; }));
      IdTable plain;
      FrameTest test(log, filter);
      plain.walk(log->frames, wanted, &test);
      EXPECT_EQ(walker.latest()->rows(), plain.rows());
      EXPECT_EQ(walker.latest()->passed(), plain.passed());
      EXPECT_GT(plain.passed(), 0u);
      EXPECT_LT(plain.passed(), wanted);
    }
  }
}

TEST(IdTableWalker, LooksAgainWhenADriveIsSaidInThePast) {
  const auto log = std::make_shared<LogDocument>();
  log->frames.channel("can0");
  ASSERT_TRUE(log->frames.append(std::vector(20, frame("18EF2080", "02210002"))));
  IdTableWalker walker(log, TraceFilter::parse(QStringLiteral("family=copley")).value());
  walker.request(20);
  ASSERT_TRUE(QTest::qWaitFor([&] { return walker.latest()->frames() == 20; }));
  EXPECT_EQ(walker.latest()->passed(), 0u);
  log->notes.append({.frame = 5, .value = note::DriveSaid{{}, {0x20}}});
  walker.request(20);
  EXPECT_TRUE(QTest::qWaitFor([&] { return walker.latest()->passed() == 15; }));
}

struct IdModelTest : testing::Test {
  IdModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};

  void show(const LogView& view) {
    model.setView(view);
    ASSERT_TRUE(QTest::qWaitFor([&] {
      model.setView(view);
      return !model.isBehind();
    }));
  }
  QString cell(int row, int column) const { return model.index(row, column).data().toString(); }
};

TEST_F(IdModelTest, ShowsTheLastFrameWithItsMeaningAndWhatChanged) {
  const auto log =
      test::logOf({frame("18EFFF80", "FF83150206021A0B"), frame("18EFFF80", "011D940371000041", 0, 10 * kMs),
                   frame("18EFFF80", "011DA40371000001", 0, 110 * kMs)});
  show(test::viewOf(log));
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(cell(1, IdModel::Name), QStringLiteral("Position / limit status"));
  EXPECT_EQ(cell(1, IdModel::Data), QStringLiteral("01 1D A4 03 71 00 00 01"));
  EXPECT_EQ(cell(1, IdModel::Period), QStringLiteral("100.0 ms"));
  EXPECT_EQ(cell(1, IdModel::Jitter), QString());
  EXPECT_EQ(model.index(1, 0).data(IdModel::ChangedRole).toUInt(), 0b10000100u);
  EXPECT_EQ(model.index(1, IdModel::Data).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("01 1D A4 03 71 00 00 01; changed: byte 3, 8"));
  EXPECT_EQ(model.index(1, 0).data(IdModel::FilterRole).toString(),
            QStringLiteral("ch=\"can0\" and id=18EFFF80 and type=01"));
}

TEST_F(IdModelTest, TellsNoPeriodWhereTimesAreGoodToTheSecondOnly) {
  std::vector<Frame> frames;
  for (int i = 0; i < 40; ++i) frames.push_back(frame("123", "", 0, i / 10 * std::int64_t{1'000'000'000}));
  show(test::viewOf(test::logOf(frames)));
  ASSERT_EQ(model.rowCount(), 1);
  EXPECT_EQ(cell(0, IdModel::Period), QString());
  EXPECT_EQ(cell(0, IdModel::Jitter), QString());
}

TEST_F(IdModelTest, ShowsOnlyWhatPassesTheFilter) {
  const auto log = test::logOfText(test::busyText(200));
  show(test::viewOf(log));
  const int all = model.rowCount();
  model.setFilter(TraceFilter::parse(QStringLiteral("sa=80 and malformed")).value());
  show(test::viewOf(log));
  EXPECT_GT(model.rowCount(), 0);
  EXPECT_LT(model.rowCount(), all);
  EXPECT_EQ(model.lookedAt(), log->frames.count());
  std::uint64_t counted = 0;
  for (int row = 0; row < model.rowCount(); ++row) {
    counted += model.index(row, IdModel::Count).data(IdModel::SortRole).toULongLong();
    EXPECT_TRUE(cell(row, IdModel::Name).startsWith(QStringLiteral("Malformed")));
  }
  EXPECT_EQ(counted, model.passed());
  model.setFilter({});
  show(test::viewOf(log));
  EXPECT_EQ(model.rowCount(), all);
}

TEST_F(IdModelTest, StandsWhereTheCursorStands) {
  const auto log = test::logOfText(test::busyText(200));
  show(test::viewOf(log));
  const int all = model.rowCount();
  EXPECT_GT(all, 10);
  show(test::viewOf(log, 4));
  EXPECT_LT(model.rowCount(), 5);
  show(test::viewOf(log, 0));
  EXPECT_EQ(model.rowCount(), 0);
  show(test::viewOf(log));
  EXPECT_EQ(model.rowCount(), all);
  for (int row = 0; row < all; ++row) {
    for (int column = 0; column < IdModel::ColumnCount; ++column) {
      model.index(row, column).data();
      model.index(row, column).data(IdModel::SortRole);
    }
  }
  show({});
  EXPECT_EQ(model.rowCount(), 0);
}

}  // namespace
}  // namespace deckpipe
