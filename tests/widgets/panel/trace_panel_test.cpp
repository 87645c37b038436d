// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/trace_panel.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QCompleter>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>
#include <QToolButton>

#include "panel/common/flat_header.h"
#include "panel/trace/id_view.h"
#include "panel/trace/trace_filter_edit.h"
#include "panel/trace/trace_search_bar.h"
#include "support/child.h"
#include "support/frames.h"
#include "support/logs.h"
#include "support/look.h"
#include "widgets/panel/panel_samples.h"

namespace deckpipe {
namespace {

// Every tenth frame is from 81, the others from 80; a millisecond apart.
std::vector<Frame> traffic(std::size_t count, std::size_t from = 0) {
  std::vector<Frame> frames;
  for (std::size_t i = from; i < from + count; ++i)
    frames.push_back(test::frame(i % 10 == 0 ? "18EFFF81" : "18EFFF80", "011D940371000041", 0,
                                 static_cast<std::int64_t>(i) * 1'000'000));
  return frames;
}

struct TracePanelTest : testing::Test {
  TracePanel panel;
  std::shared_ptr<LogDocument> log;

  TracePanelTest() {
    panel.resize(1366, 480);
    panel.show();
    QApplication::setActiveWindow(&panel);
    panel.view()->setFocus();
  }
  void open(const std::vector<Frame>& frames, std::optional<std::uint64_t> cursor = {}) {
    log = test::logOf(frames);
    panel.setView(test::viewOf(log, cursor));
  }
  TraceView& view() { return *panel.view(); }
  TraceModel& model() { return *panel.model(); }
  template <typename T>
  T* child(const char* name) {
    return test::child<T>(panel, name);
  }
  TraceFilterEdit* filter() { return child<TraceFilterEdit>("traceFilter"); }
  QString count() { return child<QLabel>("traceCount")->text(); }
  void type(const char* text) {
    filter()->setFocus();
    filter()->selectAll();
    QTest::keyClicks(filter(), QString::fromUtf8(text));
    pressEnter();
  }
  // While the list of words is open, it gets the keys.
  void pressEnter() {
    QAbstractItemView* words = filter()->completions()->popup();
    QTest::keyClick(words->isVisible() ? static_cast<QWidget*>(words) : filter(), Qt::Key_Return);
  }
  void waitForFilter() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model().isFiltering(); }));
  }
  QString said() { return child<QLabel>("traceSearchSaid")->text(); }
  void search(const char* text) {
    QTest::keyClick(&view(), Qt::Key_F, Qt::ControlModifier);
    child<QLineEdit>("traceSearch")->clear();
    QTest::keyClicks(child<QLineEdit>("traceSearch"), QString::fromUtf8(text));
    waitForSearch();
  }
  void waitForSearch() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !said().startsWith(QStringLiteral("Searching…")); }));
  }
  // The entry of the open menu that begins with this.
  QAction* entry(const char* menu, const char* text) {
    auto* open = child<QMenu>(menu);
    QList<QAction*> actions = open->actions();
    for (QMenu* sub : open->findChildren<QMenu*>()) actions += sub->actions();
    for (QAction* action : actions) {
      if (action->text().startsWith(QString::fromUtf8(text))) return action;
    }
    return nullptr;
  }
  void openMenu(std::uint64_t row, int column) {
    const QPoint at(view().header()->sectionViewportPosition(column) + 4,
                    static_cast<int>(row - view().topRow()) * view().rowHeight() + 5);
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, view().viewport()->mapToGlobal(at));
    QApplication::sendEvent(view().viewport(), &event);
  }
  void closeMenu(const char* name) { delete child<QMenu>(name); }
};

TEST_F(TracePanelTest, ShowsOnlyWhatPassesTheTypedFilter) {
  open(traffic(1000));
  QSignalSpy filtered(&panel, &TracePanel::filteredChanged);
  type("sa=81");
  waitForFilter();
  EXPECT_EQ(model().rows(), 100u);
  EXPECT_TRUE(QTest::qWaitFor([this] { return count().startsWith(QStringLiteral("100 of")); }));
  EXPECT_EQ(filtered.count(), 1);
  panel.goToFilter();
  EXPECT_TRUE(filter()->hasFocus());
  QTest::keyClick(filter(), Qt::Key_Delete);
  EXPECT_EQ(model().rows(), 1000u);
  EXPECT_EQ(filtered.count(), 2);
  const QSignalSpy left(filter(), &TraceFilterEdit::left);
  QTest::keyClick(filter(), Qt::Key_Escape);
  EXPECT_EQ(left.count(), 1);
  EXPECT_EQ(panel.focusWidget(), &view());  // the list of words leaves no window active here
}

TEST_F(TracePanelTest, SaysWhatIsWrongAndKeepsTheFilterInForce) {
  open(traffic(1000));
  type("sa=81");
  waitForFilter();
  type("sa=81 and rotation_deg>left");
  EXPECT_TRUE(child<QLabel>("traceFilterError")->isVisible());
  EXPECT_EQ(child<QLabel>("traceFilterError")->text(),
            QStringLiteral("Character 24: A number was expected here."));
  EXPECT_EQ(filter()->selectedText(), QStringLiteral("left"));
  EXPECT_EQ(model().rows(), 100u);
  type("sa=80");
  waitForFilter();
  EXPECT_FALSE(child<QLabel>("traceFilterError")->isVisible());
  EXPECT_EQ(model().rows(), 900u);
}

TEST_F(TracePanelTest, CompletesKeysWhileOneTypes) {
  open(traffic(10));
  filter()->setFocus();
  QTest::keyClicks(filter(), QStringLiteral("rotation_d"));
  QAbstractItemView* words = filter()->completions()->popup();
  ASSERT_TRUE(words->isVisible());
  EXPECT_TRUE(words->model()->index(0, 0).data().toString().startsWith(QStringLiteral("rotation_deg")));
  QTest::keyClick(words, Qt::Key_Down);
  QTest::keyClick(words, Qt::Key_Return);
  EXPECT_EQ(filter()->text(), QStringLiteral("rotation_deg"));
  QTest::keyClicks(filter(), QStringLiteral(" ch="));
  ASSERT_TRUE(words->isVisible());
  EXPECT_EQ(words->model()->index(0, 0).data().toString(), QStringLiteral("can0"));
  QTest::keyClick(filter(), Qt::Key_Escape);
  EXPECT_FALSE(words->isVisible());
}

TEST_F(TracePanelTest, TakesWhatStandsInTheLineOnEnterWhateverIsOffered) {
  open(traffic(10));
  for (const char* text :
       {"name~\"soft limits\"", "type=01 and rotation_deg>30", "rotation", "soft limits"}) {
    const QSignalSpy typed(filter(), &TraceFilterEdit::filterTyped);
    type(text);
    EXPECT_EQ(filter()->text(), QString::fromUtf8(text));
    EXPECT_EQ(typed.count(), 1) << text;
    EXPECT_FALSE(filter()->completions()->popup()->isVisible());
    EXPECT_FALSE(filter()->error()) << text;
  }
}

TEST_F(TracePanelTest, OffersAnExampleOfAFilterThatWorks) {
  const QString example = filter()->placeholderText().section(QStringLiteral("  "), 1);
  EXPECT_FALSE(example.isEmpty());
  EXPECT_TRUE(TraceFilter::parse(example)) << example.toStdString();
}

TEST_F(TracePanelTest, LeavesTheFrameThatIsLookedAtInItsPlace) {
  open(traffic(10'000), 5000);
  view().setCurrentFrame(5003);
  const std::uint64_t place = 5003 - view().topRow();
  panel.setFilter(QStringLiteral("sa=80"));
  waitForFilter();
  EXPECT_EQ(view().currentFrame(), 5003u);
  EXPECT_EQ(model().rowOf(5003) - view().topRow(), place);
  panel.setFilter({});
  EXPECT_EQ(view().currentFrame(), 5003u);
  EXPECT_EQ(5003 - view().topRow(), place);
}

TEST_F(TracePanelTest, FollowsTheEndOfWhatPasses) {
  open(traffic(1000));
  ASSERT_TRUE(view().isFollowing());
  panel.setFilter(QStringLiteral("sa=81"));
  waitForFilter();
  EXPECT_TRUE(view().isFollowing());
  EXPECT_TRUE(view().scroll().isAtEnd());
  ASSERT_TRUE(log->frames.append(traffic(500, 1000)));
  panel.setView(test::viewOf(log));
  waitForFilter();
  EXPECT_EQ(model().rows(), 150u);
  EXPECT_TRUE(view().scroll().isAtEnd());
  QTest::mouseClick(child<QAbstractButton>("traceFollow"), Qt::LeftButton);
  EXPECT_FALSE(view().isFollowing());
  QTest::keyClick(&view(), Qt::Key_Home);
  EXPECT_EQ(view().currentFrame(), 0u);
  QTest::keyClick(&view(), Qt::Key_Down);
  EXPECT_EQ(view().currentFrame(), 10u);
  QTest::mouseClick(child<QAbstractButton>("traceFollow"), Qt::LeftButton);
  EXPECT_TRUE(view().scroll().isAtEnd());
}

TEST_F(TracePanelTest, CopiesOnlyTheRowsThatPass) {
  open(traffic(100));
  panel.setFilter(QStringLiteral("sa=81"));
  waitForFilter();
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_Home);
  QTest::keyClick(&view(), Qt::Key_Down, Qt::ShiftModifier);
  QTest::keyClick(&view(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text().toStdString(),
            "(0000000000.000000) can0 18EFFF81#011D940371000041\n"
            "(0000000000.010000) can0 18EFFF81#011D940371000041\n");
}

TEST_F(TracePanelTest, AsksForAFileOfTheSelectionOrOfAllThatPasses) {
  open(traffic(100));
  const QSignalSpy wanted(&panel, &TracePanel::saveRequested);
  const auto asked = [&wanted] {
    return std::pair(wanted.back()[0].value<std::uint64_t>(), wanted.back()[1].value<std::uint64_t>());
  };
  openMenu(model().rows(), -1);
  EXPECT_FALSE(entry("traceMenu", "Save the selection")->isEnabled());
  EXPECT_EQ(entry("traceMenu", "Save all"), nullptr) << "that is the log";
  closeMenu("traceMenu");
  panel.setFilter(QStringLiteral("sa=81"));
  waitForFilter();
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_Home);
  QTest::keyClick(&view(), Qt::Key_Down, Qt::ShiftModifier);
  openMenu(1, TraceModel::Name);
  entry("traceMenu", "Save the selection")->trigger();
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(asked(), std::pair(std::uint64_t{0}, std::uint64_t{11}));
  EXPECT_FALSE(wanted.back()[2].value<TraceFilter>().isEmpty());
  entry("traceMenu", "Save all")->trigger();
  ASSERT_EQ(wanted.count(), 2);
  EXPECT_EQ(asked(), std::pair(std::uint64_t{0}, std::uint64_t{100}));
  closeMenu("traceMenu");
}

TEST_F(TracePanelTest, FiltersByPointingAtACell) {
  open(traffic(1000), 5);
  QTest::keyClick(&view(), Qt::Key_Home);
  openMenu(0, TraceModel::Data);
  ASSERT_NE(entry("traceMenu", "ID 18EFFF81"), nullptr);
  EXPECT_NE(entry("traceMenu", "PGN EF00"), nullptr);
  EXPECT_NE(entry("traceMenu", "Source 81"), nullptr);
  EXPECT_NE(entry("traceMenu", "Message: Position"), nullptr);
  EXPECT_NE(entry("traceMenu", "This value: 01 1D 94"), nullptr);
  EXPECT_EQ(entry("traceMenu", "Show all"), nullptr);
  entry("traceMenu", "Source 81")->trigger();
  closeMenu("traceMenu");
  waitForFilter();
  EXPECT_EQ(panel.filter(), QStringLiteral("sa=81"));
  openMenu(0, TraceModel::Name);
  auto* hide = test::child<QMenu>(*child<QMenu>("traceMenu"));
  hide->actions().first()->trigger();
  closeMenu("traceMenu");
  EXPECT_EQ(panel.filter(), QStringLiteral("sa=81 and id!=18EFFF81"));
  waitForFilter();
  EXPECT_EQ(model().rows(), 0u);
  view().grab();
  panel.setFilter(QStringLiteral("err or sa=81"));
  waitForFilter();
  openMenu(0, TraceModel::Name);
  entry("traceMenu", "PGN")->trigger();
  EXPECT_EQ(panel.filter(), QStringLiteral("(err or sa=81) and pgn=EF00"));
  closeMenu("traceMenu");
}

TEST_F(TracePanelTest, CopiesACellAndPutsTheCursor) {
  open(traffic(100), 5);
  QTest::keyClick(&view(), Qt::Key_Home);
  openMenu(2, TraceModel::Identifier);
  entry("traceMenu", "Copy the cell")->trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), QStringLiteral("18EFFF80"));
  QSignalSpy cursor(&panel, &TracePanel::cursorRequested);
  entry("traceMenu", "Put the cursor here")->trigger();
  ASSERT_EQ(cursor.count(), 1);
  EXPECT_EQ(cursor.front().front().toULongLong(), 2u);
}

TEST_F(TracePanelTest, SaysTimeSinceTheBeginAndOffersTheOtherWaysAtItsHeader) {
  open(traffic(100));
  EXPECT_EQ(model().timeMode(), TraceModel::TimeMode::SinceBegin);
  Q_EMIT view().header()->customContextMenuRequested({10, 10});
  EXPECT_TRUE(entry("traceColumnMenu", "Time since the begin")->isChecked());
  entry("traceColumnMenu", "Stamp")->trigger();
  closeMenu("traceColumnMenu");
  EXPECT_EQ(model().timeMode(), TraceModel::TimeMode::Stamp);
  EXPECT_EQ(child<QComboBox>("traceTime")->currentText(), QStringLiteral("Stamp as in the log"));
  Q_EMIT view().header()->customContextMenuRequested({10, 10});
  EXPECT_TRUE(entry("traceColumnMenu", "Stamp")->isChecked());
  closeMenu("traceColumnMenu");
  TracePanel other;
  EXPECT_TRUE(other.restoreState(panel.saveState()));
  EXPECT_EQ(other.model()->timeMode(), TraceModel::TimeMode::Stamp);
}

TEST_F(TracePanelTest, HasRowsForGlovesInTheField) {
  open(traffic(100));
  for (const Density density : {Density::Desk, Density::Field}) {
    const test::Look look(Theme::Light, density);
    QCoreApplication::sendPostedEvents();
    EXPECT_EQ(view().rowHeight() >= 44, density == Density::Field) << view().rowHeight();
    EXPECT_EQ(panel.ids()->verticalHeader()->defaultSectionSize() >= 44, density == Density::Field);
  }
}

TEST_F(TracePanelTest, ShowsTheColumnsThatWereChosen) {
  open(traffic(100));
  Q_EMIT view().header()->customContextMenuRequested({10, 10});
  entry("traceColumnMenu", "PGN")->setChecked(false);
  closeMenu("traceColumnMenu");
  EXPECT_TRUE(view().header()->isSectionHidden(TraceModel::Pgn));
  child<QComboBox>("traceTime")->setFocus();
  QTest::keyClick(child<QComboBox>("traceTime"), Qt::Key_Down);
  EXPECT_EQ(model().timeMode(), TraceModel::TimeMode::Clock);
  TracePanel other;
  EXPECT_TRUE(other.restoreState(panel.saveState()));
  EXPECT_TRUE(other.view()->header()->isSectionHidden(TraceModel::Pgn));
  EXPECT_EQ(other.model()->timeMode(), TraceModel::TimeMode::Clock);
  EXPECT_FALSE(other.restoreState("nonsense"));
  Q_EMIT view().header()->customContextMenuRequested({10, 10});
  entry("traceColumnMenu", "Columns as")->trigger();
  EXPECT_FALSE(view().header()->isSectionHidden(TraceModel::Pgn));
}

TEST_F(TracePanelTest, KeepsTheColumnsByIdentifierAsAPersonMadeThem) {
  open(traffic(100));
  test::child<QTabBar>(panel, "traceOrder")->setCurrentIndex(1);
  FlatHeader& header = *panel.ids()->header();
  const int usual = header.sectionSize(IdModel::Name);
  Q_EMIT header.customContextMenuRequested({10, 10});
  entry("traceColumnMenu", "Jitter")->setChecked(false);
  closeMenu("traceColumnMenu");
  header.resizeSection(IdModel::Name, usual + 30);
  header.moveSection(header.visualIndex(IdModel::Data), 0);
  TracePanel other;
  ASSERT_TRUE(other.restoreState(panel.saveState()));
  const FlatHeader& restored = *other.ids()->header();
  EXPECT_TRUE(restored.isSectionHidden(IdModel::Jitter));
  EXPECT_EQ(restored.sectionSize(IdModel::Name), usual + 30);
  EXPECT_EQ(restored.visualIndex(IdModel::Data), 0);
  Q_EMIT header.customContextMenuRequested({10, 10});
  entry("traceColumnMenu", "Columns as")->trigger();
  EXPECT_FALSE(header.isSectionHidden(IdModel::Jitter));
  EXPECT_EQ(header.sectionSize(IdModel::Name), usual);
  EXPECT_EQ(header.visualIndex(IdModel::Data), IdModel::Data);
}

TEST_F(TracePanelTest, MakesRoomForLargerLetters) {
  open(traffic(100));
  FlatHeader& rows = *view().header();
  FlatHeader& ids = *panel.ids()->header();
  const int identifier = rows.sectionSize(TraceModel::Identifier), data = ids.sectionSize(IdModel::Data);
  rows.resizeSection(TraceModel::Name, 100);
  const QFont before = panel.font();
  QFont large = before;
  large.setPointSizeF(before.pointSizeF() * 2);
  panel.setFont(large);
  EXPECT_GT(rows.sectionSize(TraceModel::Identifier), 1.7 * identifier);
  EXPECT_GT(ids.sectionSize(IdModel::Data), 1.7 * data);
  EXPECT_NEAR(rows.sectionSize(TraceModel::Name), 200, 20) << "what a person chose keeps its share";
  EXPECT_GE(rows.height(), QFontMetrics(large).height() + 12);
  EXPECT_GE(panel.ids()->verticalHeader()->defaultSectionSize(), QFontMetrics(large).height());
  panel.setFont(before);
  EXPECT_EQ(rows.sectionSize(TraceModel::Identifier), identifier);
  EXPECT_EQ(ids.sectionSize(IdModel::Data), data);
}

TEST_F(TracePanelTest, FindsForwardsBackwardsAndAroundTheEnds) {
  open(traffic(100'000), 5);
  QTest::keyClick(&view(), Qt::Key_Home);
  search("sa=81");
  EXPECT_EQ(view().currentFrame(), 0u);
  QTest::keyClick(&panel, Qt::Key_F3);
  waitForSearch();
  EXPECT_EQ(view().currentFrame(), 10u);
  QTest::keyClick(child<QLineEdit>("traceSearch"), Qt::Key_Return);
  waitForSearch();
  EXPECT_EQ(view().currentFrame(), 20u);
  EXPECT_EQ(said(), QStringLiteral("Found"));
  for (const std::uint64_t frame : {10u, 0u, 99'990u}) {
    QTest::keyClick(&panel, Qt::Key_F3, Qt::ShiftModifier);
    waitForSearch();
    EXPECT_EQ(view().currentFrame(), frame);
  }
  EXPECT_EQ(said(), QStringLiteral("Found, on from the end of the log"));
  search("nowhere to be found");
  EXPECT_EQ(said(), QStringLiteral("Not found"));
  EXPECT_EQ(view().currentFrame(), 99'990u);
  QTest::keyClick(child<QLineEdit>("traceSearch"), Qt::Key_Escape);
  EXPECT_FALSE(child<QWidget>("traceSearchBar")->isVisible());
  EXPECT_TRUE(view().hasFocus());
}

// What was found meanwhile is told by an event, which does not come before the keys here.
TEST_F(TracePanelTest, SaysHowFarTheSearchIsAndGivesItUpByEscape) {
  open(traffic(100'000), 5);
  QTest::keyClick(&view(), Qt::Key_Home);
  search("sa=81");
  auto* edit = child<QLineEdit>("traceSearch");
  QTest::keyClick(edit, Qt::Key_Return);
  EXPECT_TRUE(said().startsWith(QStringLiteral("Searching… ")) && said().endsWith(u'%'))
      << said().toStdString();
  QTest::keyClick(edit, Qt::Key_Escape);
  EXPECT_EQ(said(), QStringLiteral("Search given up"));
  EXPECT_TRUE(child<QWidget>("traceSearchBar")->isVisible());
  QCoreApplication::sendPostedEvents();
  EXPECT_EQ(said(), QStringLiteral("Search given up"));
  EXPECT_EQ(view().currentFrame(), 0u);
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_F3);
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_EQ(said(), QStringLiteral("Search given up"));
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_FALSE(child<QWidget>("traceSearchBar")->isVisible());
}

TEST_F(TracePanelTest, FindsOnlyAmongWhatIsShown) {
  open(traffic(1000), 5);
  panel.setFilter(QStringLiteral("sa=81"));
  waitForFilter();
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_Home);
  search("frame>95");
  EXPECT_EQ(view().currentFrame(), 100u);
  search("sa=80");
  EXPECT_EQ(said(), QStringLiteral("Not found"));
}

TEST_F(TracePanelTest, TellsWhereTheNextRowIs) {
  open(traffic(100), 35);
  EXPECT_EQ(panel.cursorRowsOn(1), 36u);
  panel.setFilter(QStringLiteral("sa=81"));
  waitForFilter();
  EXPECT_EQ(panel.cursorRowsOn(1), 41u);
  EXPECT_EQ(panel.cursorRowsOn(-1), 21u);
  EXPECT_EQ(panel.cursorRowsOn(-4), 0u);
  EXPECT_FALSE(panel.cursorRowsOn(-5));
  panel.setView(test::viewOf(log, 95));
  EXPECT_FALSE(panel.cursorRowsOn(1));
}

TEST_F(TracePanelTest, ShowsTrafficByIdentifierAndLeadsBackToItsFrames) {
  open(traffic(1000));
  QSignalSpy looked(&panel, &TracePanel::currentFrameChanged);
  QTabBar* order = child<QTabBar>("traceOrder");
  QTest::mouseClick(order, Qt::LeftButton, {}, order->tabRect(1).center());
  ASSERT_TRUE(panel.isById());
  ASSERT_TRUE(QTest::qWaitFor([this] { return panel.ids()->model()->rowCount() == 2; }));
  panel.ids()->grab();
  QTest::keyClick(panel.ids(), Qt::Key_Down);
  QTest::keyClick(panel.ids(), Qt::Key_Down);
  EXPECT_EQ(panel.currentFrame(), 990u);  // of 18EFFF81
  EXPECT_EQ(looked.back().front().value<std::optional<std::uint64_t>>(), 990u);
  QTest::keyClick(panel.ids(), Qt::Key_Return);
  EXPECT_FALSE(panel.isById());
  EXPECT_EQ(panel.filter(), QStringLiteral("ch=\"can0\" and id=18EFFF81 and type=01"));
  waitForFilter();
  EXPECT_EQ(model().rows(), 100u);
}

TEST_F(TracePanelTest, FiltersTrafficByIdentifierAndSaysSo) {
  open(traffic(500));
  panel.setFilter(QStringLiteral("sa=81"));
  QTabBar* order = child<QTabBar>("traceOrder");
  QTest::mouseClick(order, Qt::LeftButton, {}, order->tabRect(1).center());
  EXPECT_TRUE(QTest::qWaitFor([this] { return count() == QStringLiteral("50 of 500 frames, 1 rows"); }))
      << count().toStdString();
  type("sa=80");
  ASSERT_TRUE(panel.isById());
  EXPECT_TRUE(QTest::qWaitFor([this] { return count() == QStringLiteral("450 of 500 frames, 1 rows"); }))
      << count().toStdString();
  type("rotation_deg>left");
  EXPECT_TRUE(child<QLabel>("traceFilterError")->isVisible());
  QTest::keyClick(filter(), Qt::Key_Escape);
  EXPECT_EQ(panel.focusWidget(), panel.ids());
}

TEST_F(TracePanelTest, ComesBackFromTheFramesOfOneIdentifierToTheRowsAsTheyWere) {
  open(traffic(1000));
  panel.setFilter(QStringLiteral("pgn=EF00"));
  QTabBar* order = child<QTabBar>("traceOrder");
  const auto drillDown = [&] {
    order->setCurrentIndex(1);
    ASSERT_TRUE(QTest::qWaitFor([this] { return panel.ids()->model()->rowCount() == 2; }));
    panel.ids()->selectRow(0);
    QTest::keyClick(panel.ids(), Qt::Key_Return);
    EXPECT_EQ(panel.filter(), QStringLiteral("pgn=EF00 and ch=\"can0\" and id=18EFFF80 and type=01"));
  };
  drillDown();
  order->setCurrentIndex(1);
  EXPECT_EQ(panel.filter(), QStringLiteral("pgn=EF00"));
  drillDown();
  panel.setFilter(QStringLiteral("sa=81"));
  order->setCurrentIndex(1);
  EXPECT_EQ(panel.filter(), QStringLiteral("sa=81")) << "what a person wrote since stays";
}

TEST_F(TracePanelTest, LivesWithoutALog) {
  panel.grab();
  type("sa=81");
  search("x");
  openMenu(0, 0);
  closeMenu("traceMenu");
  panel.grab();
  EXPECT_FALSE(panel.cursorRowsOn(1));
}

TEST_F(TracePanelTest, NamesEveryControl) {
  for (const QWidget* widget : panel.findChildren<QWidget*>()) {
    const bool isControl = qobject_cast<const QToolButton*>(widget) != nullptr ||
                           qobject_cast<const QLineEdit*>(widget) != nullptr ||
                           qobject_cast<const QComboBox*>(widget) != nullptr;
    if (!isControl || widget->objectName().startsWith(QStringLiteral("qt_"))) continue;
    if (qobject_cast<const QLineEdit*>(widget->parentWidget()) != nullptr) continue;  // the clear button
    EXPECT_FALSE(widget->objectName().isEmpty());
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->objectName().toStdString();
  }
}

}  // namespace
}  // namespace deckpipe
