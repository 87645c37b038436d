// SPDX-License-Identifier: GPL-3.0-or-later
// The docks: moved, closed and put back by a person, and as they were the next time; and the way from pane to
// pane by keyboard.
#include "console/workspace.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QSettings>
#include <QShortcut>

#include "app/console/window_test.h"
#include "model/decode_model.h"
#include "panel/common/help_panel.h"
#include "panel/devices/device_list_panel.h"
#include "panel/page/full_dial.h"
#include "panel/play/transport_bar.h"
#include "panel/trace/trace_panel.h"
#include "panel/trace/trace_view.h"
#include "support/child.h"

namespace deckpipe {
namespace {

using test::kTruck;

class Docks : public test::WindowTest {
 protected:
  void SetUp() override {
    QSettings().clear();
    WindowTest::SetUp();
    openLog(kTruck);
  }
  void clickRow(int row) {
    auto* trace = only<TraceView>();
    const int y = row * trace->rowHeight() + trace->rowHeight() / 2;
    QTest::mouseClick(trace->viewport(), Qt::LeftButton, {}, QPoint(300, y));
  }
  bool hasFocus(const QWidget* pane) const {
    const QWidget* focus = QApplication::focusWidget();
    return focus != nullptr && (pane == focus || pane->isAncestorOf(focus));
  }
};

TEST_F(Docks, AreClosedAndOpenedFromTheViewMenu) {
  auto* dock = named<QDockWidget>("traceDock");
  ASSERT_TRUE(dock->isVisible());
  trigger("traceDockAction");
  EXPECT_FALSE(dock->isVisible());
  trigger("traceDockAction");
  EXPECT_TRUE(dock->isVisible());
}

TEST_F(Docks, AreTakenOutAndClosedByTheButtonsOfTheirTitle) {
  auto* dock = named<QDockWidget>("devicesDock");
  QTest::mouseClick(named<QAbstractButton>("devicesDockFloat"), Qt::LeftButton);
  EXPECT_TRUE(dock->isFloating());
  QTest::mouseClick(named<QAbstractButton>("devicesDockFloat"), Qt::LeftButton);
  EXPECT_FALSE(dock->isFloating());
  QTest::mouseClick(named<QAbstractButton>("devicesDockClose"), Qt::LeftButton);
  EXPECT_FALSE(dock->isVisible());
  EXPECT_FALSE(named<QAction>("devicesDockAction")->isChecked());
}

TEST_F(Docks, HaveATitleOnlyWhereNoTabNamesThem) {
  const auto titleHeight = [this] { return named<QWidget>("traceDockTitle")->height(); };
  QApplication::sendPostedEvents();
  EXPECT_EQ(titleHeight(), 0);
  named<QDockWidget>("eventsDock")->close();
  named<QDockWidget>("terminalDock")->close();
  (void)QTest::qWaitFor([&] { return titleHeight() > 0; });
  EXPECT_GE(titleHeight(), 32) << "alone";
  trigger("eventsDockAction");
  (void)QTest::qWaitFor([&] { return titleHeight() == 0; });
  EXPECT_EQ(titleHeight(), 0);
  named<QDockWidget>("traceDock")->setFloating(true);
  (void)QTest::qWaitFor([&] { return titleHeight() > 0; });
  EXPECT_GE(titleHeight(), 32) << "floating";
}

TEST_F(Docks, ComeBackWhereTheyWereByResetLayout) {
  auto* devices = named<QDockWidget>("devicesDock");
  const QRect before = devices->geometry();
  only<Workspace>()->addDockWidget(Qt::RightDockWidgetArea, devices);
  trigger("traceDockAction");
  trigger("resetLayoutAction");
  EXPECT_TRUE(named<QDockWidget>("traceDock")->isVisible());
  EXPECT_EQ(only<Workspace>()->dockWidgetArea(devices), Qt::LeftDockWidgetArea);
  QApplication::sendPostedEvents();
  EXPECT_EQ(devices->width(), before.width());
}

TEST_F(Docks, AreTheNextTimeAsTheyWereLeft) {
  trigger("traceDockAction");
  only<Workspace>()->addDockWidget(Qt::RightDockWidgetArea, named<QDockWidget>("devicesDock"));
  m_window.close();
  MainWindow next(m_session);
  next.restoreLayout();
  next.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&next));
  auto* workspace = test::child<Workspace>(next);
  EXPECT_EQ(workspace->dockWidgetArea(test::child<QDockWidget>(next, "devicesDock")),
            Qt::RightDockWidgetArea);
  EXPECT_TRUE(test::child<QDockWidget>(next, "traceDock")->isHidden());
}

TEST_F(Docks, StayAsTheyAreWhenAFrameIsLookedAt) {
  const QRect trace = named<QDockWidget>("traceDock")->geometry();
  clickRow(1);
  QApplication::sendPostedEvents();
  EXPECT_FALSE(named<QDockWidget>("decodeDock")->isVisible());
  EXPECT_EQ(named<QDockWidget>("traceDock")->geometry(), trace);
}

TEST_F(Docks, ShowTheFrameInDetailAtSpaceAndFollowFromThenOn) {
  const int height = named<QDockWidget>("traceDock")->height();
  clickRow(1);
  QTest::keyClick(only<TraceView>(), Qt::Key_Space);
  EXPECT_TRUE(named<QDockWidget>("decodeDock")->isVisible());
  for (int i = 0; i < 4; ++i) QTest::qWait(0);
  EXPECT_EQ(named<QDockWidget>("traceDock")->height(), height);
  EXPECT_GE(named<QDockWidget>("traceDock")->width(), 600);
  EXPECT_EQ(only<DecodeModel>()->frame(), std::optional<std::uint64_t>(1));
  clickRow(0);
  EXPECT_EQ(only<DecodeModel>()->frame(), std::optional<std::uint64_t>(0));
}

TEST_F(Docks, ShowTheFrameInDetailFromTheMenuOfItsRow) {
  only<TraceView>()->setCurrentFrame(1);
  QContextMenuEvent event(QContextMenuEvent::Keyboard, QPoint(), QPoint());
  QApplication::sendEvent(only<TraceView>(), &event);
  auto* menu = only<TracePanel>()->findChild<QMenu*>(QStringLiteral("traceMenu"));
  ASSERT_NE(menu, nullptr);
  for (QAction* action : menu->actions()) {
    if (action->text() == QStringLiteral("In detail")) action->trigger();
  }
  EXPECT_TRUE(named<QDockWidget>("decodeDock")->isVisible());
}

TEST_F(Docks, FloatOnlyWhileALogIsOpen) {
  auto* dock = named<QDockWidget>("devicesDock");
  dock->setFloating(true);
  trigger("closeAction");
  EXPECT_FALSE(dock->isVisible());
  openLog(kTruck);
  EXPECT_TRUE(dock->isVisible());
}

TEST_F(Docks, LeaveTheWindowToTheDialAtF11WhateverHasTheFocus) {
  m_window.activateWindow();
  only<TraceView>()->setFocus();
  QTest::keyClick(only<TraceView>(), Qt::Key_F11);
  auto* full = only<FullDial>();
  EXPECT_EQ(full->width(), m_window.width());
  EXPECT_TRUE(named<QWidget>("statusStrip")->isVisible()) << "link and lock stay in sight";
  const QRect covered(full->mapTo(&m_window, QPoint()), full->size());
  const auto* strip = named<QWidget>("statusStrip");
  EXPECT_FALSE(covered.intersects(QRect(strip->mapTo(&m_window, QPoint()), strip->size())));
  QTest::keyClick(full, Qt::Key_F11);
  EXPECT_TRUE(QTest::qWaitFor([this] { return m_window.findChild<FullDial*>() == nullptr; }));
}

TEST_F(Docks, ComeForwardFromBehindATabByTheViewMenu) {
  EXPECT_FALSE(named<QAction>("eventsDockAction")->isChecked()) << "behind the trace";
  trigger("eventsDockAction");
  // What lies behind a tab is put out of the window's sight.
  const auto left = [this](const char* dock) { return named<QWidget>(dock)->mapTo(&m_window, QPoint()).x(); };
  EXPECT_TRUE(QTest::qWaitFor([&] { return left("eventsDock") >= 0; }));
  EXPECT_LT(left("traceDock"), 0);
  EXPECT_TRUE(only<Workspace>()->panes().contains(named<QWidget>("eventsDock")));
  EXPECT_TRUE(named<QAction>("eventsDockAction")->isChecked());
  EXPECT_FALSE(named<QAction>("traceDockAction")->isChecked());
}

// Two of them on one key are none.
TEST_F(Docks, ShareNoKeyWithWhatIsInThem) {
  QStringList keys;
  for (const QAction* action : m_window.findChildren<QAction*>()) {
    if (action->shortcutContext() == Qt::WidgetShortcut) continue;  // written in the menu alone
    for (const QKeySequence& key : action->shortcuts()) keys += key.toString();
  }
  for (const QShortcut* shortcut : m_window.findChildren<QShortcut*>())
    EXPECT_FALSE(keys.contains(shortcut->key().toString())) << qPrintable(shortcut->key().toString());
  EXPECT_FALSE(keys.isEmpty());
}

TEST_F(Docks, ShowWhereTheChosenDeviceIsAsked) {
  m_window.activateWindow();
  ASSERT_FALSE(named<QDockWidget>("requestsDock")->isVisible());
  QTest::keyClick(&m_window, Qt::Key_R, Qt::ControlModifier);
  EXPECT_TRUE(named<QDockWidget>("requestsDock")->isVisible());
}

TEST_F(Docks, HaveAKeyEachAndTheFocusOnceTheyAreOpened) {
  m_window.activateWindow();
  for (const DockRow& row : dockRows()) {
    auto* action = named<QAction>((QByteArray(row.id) + "Action").constData());
    EXPECT_FALSE(action->shortcut().isEmpty()) << row.id;
    auto* dock = named<QDockWidget>(row.id);
    // Help explains what has the focus, so it takes none.
    if (row.isOfDemo || dock->findChild<HelpPanel*>() != nullptr) continue;
    dock->close();
    QApplication::sendPostedEvents();
    action->trigger();
    EXPECT_TRUE(hasFocus(dock)) << row.id;
  }
}

TEST_F(Docks, FindInTheTraceFromAnyPlaceAndFromTheMenu) {
  m_window.activateWindow();
  for (const bool isByKey : {true, false}) {
    named<QDockWidget>("traceDock")->close();
    only<TransportBar>()->setFocus();
    if (isByKey) {
      QTest::keyClick(only<TransportBar>(), Qt::Key_F, Qt::ControlModifier);
    } else {
      trigger("findAction");
    }
    EXPECT_TRUE(named<QDockWidget>("traceDock")->isVisible()) << isByKey;
    EXPECT_TRUE(hasFocus(named<QWidget>("traceSearch"))) << isByKey;
    QTest::keyClick(named<QWidget>("traceSearch"), Qt::Key_Escape);
  }
}

TEST_F(Docks, AreInAMenuThatOffersWhatCanBeDoneNowAndSaysWhyNot) {
  const auto isOffered = [this](const char* action) { return named<QAction>(action)->isEnabled(); };
  const auto whyNot = [this](const char* action) { return named<QAction>(action)->toolTip(); };
  for (const char* action :
       {"saveLogAction", "markAction", "closeAction", "fullDialAction", "traceDeviceAction",
        "traceDockAction", "findAction", "resetLayoutAction", "explainAction"})
    EXPECT_TRUE(isOffered(action)) << action;
  for (const char* action : {"lockAction", "askNamesAction", "askEveryoneAction", "stopAskingAction"}) {
    EXPECT_FALSE(isOffered(action)) << action;
    EXPECT_FALSE(whyNot(action).isEmpty()) << action;
  }
  trigger("settingsAction");
  EXPECT_FALSE(isOffered("fullDialAction"));
  EXPECT_TRUE(whyNot("fullDialAction").contains(QStringLiteral("Another page")));
  EXPECT_TRUE(isOffered("saveLogAction"));
  QTest::mouseClick(named<QAbstractButton>("settingsDone"), Qt::LeftButton);
  EXPECT_TRUE(isOffered("fullDialAction"));
  openLog("(1.000000) can0 123#11\n");
  EXPECT_FALSE(isOffered("fullDialAction"));
  EXPECT_TRUE(whyNot("fullDialAction").contains(QStringLiteral("no dial")));
  EXPECT_FALSE(isOffered("traceDeviceAction"));
  trigger("closeAction");
  for (const char* action : {"saveLogAction", "markAction", "closeAction", "fullDialAction",
                             "traceDockAction", "nextEventAction", "findAction"}) {
    EXPECT_FALSE(isOffered(action)) << action;
    EXPECT_FALSE(whyNot(action).isEmpty()) << action;
  }
}

TEST_F(Docks, ShowOnlyTheChosenDevicesFramesAtCtrlT) {
  m_window.activateWindow();
  openLog(kTruck + "(10.300000) can0 18FEF190#0102\n");
  trigger("traceDockAction");
  QTest::keyClick(&m_window, Qt::Key_T, Qt::ControlModifier);
  EXPECT_TRUE(named<QDockWidget>("traceDock")->isVisible());
  EXPECT_EQ(named<QLineEdit>("traceFilter")->text(), QStringLiteral("sa=80"));
}

TEST_F(Docks, AreReachedOneAfterAnotherByF6) {
  m_window.activateWindow();
  only<TransportBar>()->setFocus();
  QTest::keyClick(&m_window, Qt::Key_F6);
  EXPECT_TRUE(hasFocus(named<QWidget>("statusStrip")));
  const QList<QWidget*> panes = only<Workspace>()->panes();
  ASSERT_EQ(panes.size(), 3);
  for (const QWidget* pane : panes) {
    QTest::keyClick(&m_window, Qt::Key_F6);
    EXPECT_TRUE(hasFocus(pane)) << qPrintable(pane->objectName());
  }
  QTest::keyClick(&m_window, Qt::Key_F6);
  EXPECT_TRUE(hasFocus(only<TransportBar>()));
  QTest::keyClick(&m_window, Qt::Key_F6, Qt::ShiftModifier);
  EXPECT_TRUE(hasFocus(panes.last()));
}

}  // namespace
}  // namespace deckpipe
