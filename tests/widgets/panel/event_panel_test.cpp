// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/event_panel.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QSignalSpy>
#include <QTest>
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

TEST_F(PanelOfEvents, SaysThatNothingHappened) {
  auto* empty = test::child<QLabel>(panel, "noEvents");
  EXPECT_FALSE(empty->isVisible());
  panel.setView(viewOf(logOfText("(1.000000) can0 123#11\n")));
  EXPECT_TRUE(empty->isVisible());
}

}  // namespace
}  // namespace deckpipe
