// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/overview_panel.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPointer>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QWindow>

#include "paint/dial.h"
#include "support/child.h"
#include "widgets/panel/panel_scenes.h"

namespace deckpipe {
namespace {

using namespace test;

struct GridCase {
  const char* name;
  int count;
  QSize room;
  int columns;
  bool fits;
};
class Grid : public testing::TestWithParam<GridCase> {};

TEST_P(Grid, PutsTilesSideBySideWithoutOverlap) {
  const auto [name, count, room, columns, fits] = GetParam();
  const OverviewGrid grid = overviewGrid(count, room);
  EXPECT_EQ(grid.columns, columns);
  EXPECT_EQ(grid.height(count) <= room.height(), fits);
  EXPECT_GE(grid.tile.height(), OverviewGrid::kMin.height());
  for (int i = 0; i < count; ++i) {
    EXPECT_GE(grid.place(i).left(), OverviewGrid::kGap);
    EXPECT_LE(grid.place(i).right(), room.width() - OverviewGrid::kGap);
    EXPECT_LE(grid.place(i).bottom(), grid.height(count) - OverviewGrid::kGap);
    for (int j = 0; j < i; ++j) EXPECT_FALSE(grid.place(i).intersects(grid.place(j))) << i << ' ' << j;
  }
}
INSTANTIATE_TEST_SUITE_P(OfTiles, Grid,
                         testing::Values(GridCase{"One", 1, {1030, 500}, 1, true},
                                         GridCase{"Two", 2, {1030, 500}, 2, true},
                                         GridCase{"Four", 4, {1030, 600}, 2, true},
                                         GridCase{"SixOnA4K", 6, {3500, 1700}, 3, true},
                                         GridCase{"Thirty", 30, {1030, 500}, 3, false},
                                         GridCase{"Narrow", 5, {300, 500}, 1, false},
                                         GridCase{"NarrowerThanATile", 3, {200, 500}, 1, false}),
                         [](const auto& row) { return std::string(row.param.name); });

class OverviewTest : public testing::Test {
 protected:
  void SetUp() override {
    m_panel.resize(1030, 500);
    m_panel.show();
    m_panel.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&m_panel));
  }
  // This many monitors, the first with a PIN.
  void hear(int count) {
    m_bus.monitor();
    for (int i = 1; i < count; ++i) {
      char id[16];
      std::snprintf(id, sizeof id, "18EFFF%02X", 0x80u + static_cast<unsigned>(i));
      m_bus.hear(id, kPosition);
    }
    show();
  }
  void show() {
    m_view.log = m_bus.view();
    m_panel.setView(m_view);
    for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
  }
  MonitorTile* tile(int number) const {
    return test::child<MonitorTile>(m_panel, QStringLiteral("monitorTile%1").arg(number));
  }
  QLabel* summary() const { return test::child<QLabel>(m_panel, "overviewSummary"); }
  QLabel* empty() const { return test::child<QLabel>(m_panel, "noMonitors"); }

  Heard m_bus;
  PanelView m_view;
  OverviewPanel m_panel;
  QSignalSpy m_asked{&m_panel, &OverviewPanel::pageRequested};
};

TEST_F(OverviewTest, SaysWhyThereIsNothing) {
  EXPECT_TRUE(empty()->text().startsWith(QStringLiteral("Nothing is open.")));
  show();
  EXPECT_EQ(empty()->text(), QStringLiteral("No monitor heard up to this place of the log."));
  m_bus.hear("724", "05");
  show();
  EXPECT_EQ(empty()->text(),
            QStringLiteral("No monitor heard up to this place of the log.\nOther devices in the list: 1."));
  hear(1);
  EXPECT_FALSE(empty()->isVisible());
}

TEST_F(OverviewTest, ShowsEveryMonitorAtOnceWithItsDial) {
  hear(4);
  EXPECT_EQ(m_panel.findChildren<MonitorTile*>().size(), 4);
  EXPECT_TRUE(tile(4)->isVisible());
  EXPECT_NEAR(test::child<Dial>(*tile(1))->values().rotation.degrees, 47.3, 1e-9);
  EXPECT_EQ(tile(1)->accessibleName(),
            QStringLiteral("1032AE100801035, 6032 Universal II · 80 hex, not asked"));
  EXPECT_TRUE(
      test::child<Dial>(*tile(1))->accessibleDescription().contains(QStringLiteral("47.3 degrees right")));
  const QPointer<MonitorTile> second = tile(2);
  Heard fewer;
  fewer.monitor();
  m_panel.setView(fewer.view());
  EXPECT_TRUE(second.isNull() || second->isHidden()) << "the cursor went back";
  EXPECT_TRUE(tile(1)->isVisible());
}

TEST_F(OverviewTest, MovesAMonitorInTroubleToTheFrontWithItsFocus) {
  hear(4);
  MonitorTile* third = tile(3);
  third->setFocus();
  m_bus.hear("18EFFF82", kSensorError);
  show();
  EXPECT_EQ(tile(1), third);
  EXPECT_TRUE(third->hasFocus());
  EXPECT_EQ(third->y(), tile(2)->y());
  EXPECT_LT(third->x(), tile(2)->x());
  EXPECT_EQ(summary()->text(), QStringLiteral("4 monitor(s): 1 fault(s), 3 not asked"));
  QTest::keyClick(third, Qt::Key_Right);
  EXPECT_TRUE(tile(2)->hasFocus()) << "keys follow the places";
}

TEST_F(OverviewTest, KeepsPlacesWhileThePointerIsAmongTheTiles) {
  hear(4);
  MonitorTile* first = tile(1);
  QWindow* window = m_panel.windowHandle();
  for (const QPoint& step : {QPoint(0, 0), QPoint(3, 3)})
    QTest::mouseMove(window, tile(2)->mapTo(&m_panel, tile(2)->rect().center() + step));
  m_bus.hear("18EFFF82", kSensorError).hear("18EFFF84", kPosition);
  show();
  EXPECT_EQ(tile(1), first);
  EXPECT_EQ(summary()->text(), QStringLiteral("5 monitor(s): 1 fault(s), 4 not asked"));
  QTest::mouseMove(window, summary()->mapTo(&m_panel, summary()->rect().center()));
  show();
  EXPECT_EQ(tile(2), first);
}

TEST_F(OverviewTest, SaysWhatIsNotShown) {
  hear(1);
  auto* untracked = test::child<QLabel>(m_panel, "untrackedMonitors");
  EXPECT_FALSE(untracked->isVisible());
  m_bus.hear("18EFFF80", kPosition, kMaxChannels);
  show();
  EXPECT_TRUE(untracked->isVisible());
  EXPECT_TRUE(untracked->text().contains(QStringLiteral("beyond the first 16")))
      << untracked->text().toStdString();
}

TEST_F(OverviewTest, AsksForAPageByClickAndByKeys) {
  hear(4);
  QTest::mouseClick(tile(2), Qt::LeftButton, {}, tile(2)->rect().center());
  ASSERT_EQ(m_asked.size(), 1) << "on the dial too";
  EXPECT_EQ(m_asked[0][0].value<DeviceKey>(), DeviceKey::at(Channel{0}, Address{0x81}));
  tile(1)->setFocus();
  QTest::keyClick(tile(1), Qt::Key_Return);
  ASSERT_EQ(m_asked.size(), 2);
  EXPECT_EQ(m_asked[1][0].value<DeviceKey>(), keyOfA());
  QTest::keyClick(tile(1), Qt::Key_Space);
  EXPECT_EQ(m_asked.size(), 3);
}

TEST_F(OverviewTest, GoesFromTileToTileByArrows) {
  hear(30);
  tile(1)->setFocus();
  QTest::keyClick(tile(1), Qt::Key_Right);
  EXPECT_TRUE(tile(2)->hasFocus());
  QTest::keyClick(tile(2), Qt::Key_Down);
  EXPECT_TRUE(tile(5)->hasFocus());
  QTest::keyClick(tile(5), Qt::Key_End);
  EXPECT_TRUE(tile(30)->hasFocus());
  auto* scroll = test::child<QScrollArea>(m_panel, "overviewScroll");
  EXPECT_TRUE(scroll->viewport()->rect().contains(
      QRect(tile(30)->mapTo(scroll->viewport(), QPoint()), tile(30)->size())));
  EXPECT_EQ(scroll->horizontalScrollBar()->maximum(), 0);
  QTest::keyClick(tile(30), Qt::Key_Down);
  EXPECT_TRUE(tile(30)->hasFocus());
  QTest::keyClick(tile(30), Qt::Key_Home);
  EXPECT_TRUE(tile(1)->hasFocus());
}

TEST_F(OverviewTest, FlowsAnewWhenItsSizeChanges) {
  hear(4);
  m_panel.resize(300, 900);
  show();
  EXPECT_EQ(tile(1)->x(), tile(2)->x());
  m_panel.resize(1200, 400);
  show();
  EXPECT_EQ(tile(1)->y(), tile(2)->y());
}

TEST_F(OverviewTest, SaysHealthStopsAndWhoseIsThePage) {
  m_bus.monitor("011D940371004141");
  show();
  m_view.labels.set(keyOfA().pin, QStringLiteral("Roof"));
  m_view.device = keyOfA();
  show();
  EXPECT_TRUE(tile(1)->accessibleName().startsWith(QStringLiteral("Roof, 1032AE100801035")));
  EXPECT_TRUE(tile(1)->accessibleDescription().contains(QStringLiteral("Stands at: Pattern Stream")));
  EXPECT_TRUE(tile(1)->accessibleDescription().contains(QStringLiteral("Its page is shown.")));
  m_bus.pass(5s);
  show();
  EXPECT_TRUE(tile(1)->accessibleName().endsWith(QStringLiteral("silent")));
}

}  // namespace
}  // namespace deckpipe
