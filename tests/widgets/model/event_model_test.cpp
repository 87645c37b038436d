// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/event_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "support/logs.h"

namespace deckpipe {
namespace {

using test::logOfText;
using test::viewOf;

constexpr auto kLog =
    "(10.000000) can0 18EFFF80#FF83150206021A0B\n"
    "(12.500000) can0 724#00\n";

struct ModelOfEvents : testing::Test {
  std::string what(int row) const {
    return model.index(row, EventModel::What).data().toString().toStdString();
  }
  EventModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(ModelOfEvents, SaysWhatHappenedAndWhen) {
  model.setView(viewOf(logOfText(kLog)));
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(what(0), "1032AE100801035 appeared at address 80");
  EXPECT_EQ(what(1), "Node 24 started");
  EXPECT_EQ(model.index(1, EventModel::When).data().toString().toStdString(), "0:00:02.500");
  EXPECT_EQ(model.index(1, EventModel::Bus).data().toString().toStdString(), "can0");
}

TEST_F(ModelOfEvents, PutsAMarkWhereItBelongs) {
  const auto log = logOfText(kLog);
  model.setView(viewOf(log));
  QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
  log->notes.append(
      {.frame = 1, .time = Instant{11'000'000'000}, .kind = NoteKind::Mark, .text = "valve opened"});
  model.setView(viewOf(log));
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(what(1), "valve opened");
  ASSERT_EQ(inserted.size(), 1);
  EXPECT_EQ(inserted[0][1].toInt(), 1);
  EXPECT_EQ(inserted[0][2].toInt(), 1);
}

TEST_F(ModelOfEvents, KnowsWhatHasHappenedAtTheCursor) {
  const auto log = logOfText(kLog);
  model.setView(viewOf(log, 0));
  EXPECT_EQ(model.rowAtCursor(), -1);
  model.setView(viewOf(log, 1));
  EXPECT_EQ(model.rowAtCursor(), 0);
  model.setView(viewOf(log));
  EXPECT_EQ(model.rowAtCursor(), 1);
}

TEST_F(ModelOfEvents, ForgetsAnotherLog) {
  model.setView(viewOf(logOfText(kLog)));
  model.setView(viewOf(logOfText("(1.000000) can0 123#11\n")));
  EXPECT_EQ(model.rowCount(), 0);
}

}  // namespace
}  // namespace deckpipe
