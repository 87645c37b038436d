// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/events/event_panel.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "model/event_model.h"
#include "support/child.h"
#include "support/logs.h"

namespace deckpipe {
namespace {

using test::logOfText;
using test::viewOf;

constexpr auto kLog =
    "(09.000000) can0 18EFFF80#83C051\n"
    "(10.000000) can0 18EFFF80#834051\n"
    "(12.500000) can0 18EFFF80#83C051\n";

struct PanelOfEvents : testing::Test {
  void SetUp() override {
    panel.resize(600, 240);
    panel.setView(viewOf(logOfText(kLog)));
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  }
  QTreeView* list() const { return test::child<QTreeView>(panel); }
  EventPanel panel;
};

TEST_F(PanelOfEvents, PutsTheCursorWhereAPersonClicks) {
  QSignalSpy seeks(&panel, &EventPanel::seekRequested);
  const QRect row = list()->visualRect(list()->model()->index(1, EventModel::What));
  QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, row.center());
  ASSERT_EQ(seeks.size(), 1);
  EXPECT_EQ(seeks[0][0].value<Instant>(), Instant{12'500'000'000});
}

TEST_F(PanelOfEvents, PutsTheCursorByKeyboard) {
  QSignalSpy seeks(&panel, &EventPanel::seekRequested);
  list()->setCurrentIndex(list()->model()->index(0, 0));
  QTest::keyClick(list(), Qt::Key_Return);
  ASSERT_EQ(seeks.size(), 1);
  EXPECT_EQ(seeks[0][0].value<Instant>(), Instant{10'000'000'000});
}

TEST_F(PanelOfEvents, GoesToTheNextAndThePreviousEvent) {
  const auto log = logOfText(kLog);
  const auto goTo = [&](auto step, std::uint64_t cursor) {
    panel.setView(viewOf(log, cursor));
    QSignalSpy seeks(&panel, &EventPanel::seekRequested);
    (panel.*step)();
    return seeks.isEmpty() ? Instant{} : seeks[0][0].value<Instant>();
  };
  EXPECT_EQ(goTo(&EventPanel::goToNext, 1), Instant{10'000'000'000});
  EXPECT_EQ(list()->currentIndex().row(), 0);
  EXPECT_EQ(goTo(&EventPanel::goToNext, 2), Instant{12'500'000'000});
  EXPECT_EQ(goTo(&EventPanel::goToNext, 3), Instant{}) << "there is none";
  EXPECT_EQ(goTo(&EventPanel::goToPrevious, 3), Instant{10'000'000'000});
  EXPECT_EQ(goTo(&EventPanel::goToPrevious, 2), Instant{});
}

TEST_F(PanelOfEvents, GoesFiveSecondsBeforeAnEventAndStaysThere) {
  const auto log = logOfText(
      "(01.000000) can0 18EFFF80#83C051\n(09.000000) can0 18EFFF80#83C051\n"
      "(10.000000) can0 18EFFF80#834051\n(11.000000) can0 18EFFF80#834051\n");
  panel.setView(viewOf(log));
  QSignalSpy seeks(&panel, &EventPanel::seekRequested);
  panel.goBefore();
  ASSERT_EQ(seeks.size(), 1);
  EXPECT_EQ(seeks[0][0].value<Instant>(), Instant{5'000'000'000});
  LogView there = viewOf(log);
  there.cursor = cursorAt(log->frames, Instant{5'000'000'000});
  panel.setView(there);
  panel.goBefore();
  ASSERT_EQ(seeks.size(), 2);
  EXPECT_EQ(seeks[1][0].value<Instant>(), Instant{5'000'000'000}) << "still before the same event";
  panel.goToNext();
  ASSERT_EQ(seeks.size(), 3);
  EXPECT_EQ(seeks[2][0].value<Instant>(), Instant{9'000'000'000}) << "heard again";
}

TEST_F(PanelOfEvents, ListsWhatPassesTheFilter) {
  const auto log = logOfText(
      "(01.000000) can0 18EFFF80#83C051\n(01.000000) can0 18EFFF81#83C051\n(02.000000) can0 18EFFF80#834051\n"
      "(02.000000) can0 18EFFF81#83A051\n(03.000000) can0 18EFFF80#83C051\n");
  panel.setView(viewOf(log));
  const auto rows = [&] {
    QStringList texts;
    for (int row = 0; row < list()->model()->rowCount(); ++row)
      texts << list()->model()->index(row, EventModel::What).data().toString();
    return texts.join(QStringLiteral("; ")).toStdString();
  };
  EXPECT_EQ(rows(), "Disabled: it cannot move; Stowed; Enabled");
  auto* weight = test::child<QComboBox>(panel, "eventWeight");
  QTest::keyClick(weight, Qt::Key_Down);
  EXPECT_EQ(rows(), "Disabled: it cannot move");
  QTest::keyClick(weight, Qt::Key_Up);
  auto* words = test::child<QLineEdit>(panel, "eventWords");
  QTest::keyClicks(words, QStringLiteral("STOW"));
  EXPECT_EQ(rows(), "Stowed");
  words->clear();
  auto* device = test::child<QComboBox>(panel, "eventDevice");
  ASSERT_EQ(device->count(), 3);
  QTest::keyClick(device, Qt::Key_Down);
  EXPECT_EQ(rows(), "Disabled: it cannot move; Enabled");
  QTest::keyClick(device, Qt::Key_Up);
  const auto* empty = test::child<QLabel>(panel, "noEvents");
  auto* faults = test::child<QToolButton>(
      panel, qPrintable(QStringLiteral("eventGroup%1").arg(static_cast<int>(EventGroup::Fault))));
  QTest::mouseClick(faults, Qt::LeftButton);
  EXPECT_TRUE(empty->isVisible());
  EXPECT_TRUE(empty->text().contains(QStringLiteral("filter")));
  QTest::mouseClick(faults, Qt::LeftButton);
  EXPECT_EQ(rows(), "Disabled: it cannot move; Stowed; Enabled");
}

TEST_F(PanelOfEvents, SaysThatNothingHappened) {
  auto* empty = test::child<QLabel>(panel, "noEvents");
  EXPECT_FALSE(empty->isVisible());
  panel.setView(viewOf(logOfText("(1.000000) can0 123#11\n")));
  EXPECT_TRUE(empty->isVisible());
}

}  // namespace
}  // namespace deckpipe
