// SPDX-License-Identifier: GPL-3.0-or-later
// What takes the keys is spoken with name and role, and its focus is seen from 1 m: walks of the whole window.
#include <QAbstractScrollArea>
#include <QAccessible>
#include <QAction>
#include <QDockWidget>
#include <QScrollBar>
#include <QSettings>
#include <QWindow>
#include <set>
#include <string>

#include "app/console/window_scenes.h"
#include "app/console/window_test.h"
#include "paint/timeline.h"

namespace deckpipe {
namespace {

using test::kPatience;

class Reach : public test::WindowTest {
 protected:
  void SetUp() override {
    QSettings().clear();
    WindowTest::SetUp();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&m_window));
  }
  void show(const Snapshot& snapshot) {
    m_window.setSnapshot(snapshot);
    QTest::qWait(0);
  }
  void openEveryDock() {
    for (auto* dock : m_window.findChildren<QDockWidget*>()) {
      dock->show();
      dock->raise();
    }
    QTest::qWait(0);
  }
  static std::string nameOf(const QWidget* widget) {
    return widget->metaObject()->className() + std::string(" ") + widget->objectName().toStdString();
  }
  // As the style's ring is: three pixels around all of it.
  static int changedPixels(const QImage& before, const QImage& after, const QRect& where) {
    int changed = 0;
    const QRect area = where.intersected(after.rect());
    for (int y = area.top(); y <= area.bottom(); ++y)
      for (int x = area.left(); x <= area.right(); ++x)
        changed += before.pixel(x, y) != after.pixel(x, y) ? 1 : 0;
    return changed;
  }
};

TEST_F(Reach, EverythingThatTakesKeysHasANameAndARole) {
  std::set<std::string> seen;
  const auto walk = [&] {
    for (auto* widget : m_window.findChildren<QWidget*>()) {
      if (!widget->isVisible() || (widget->focusPolicy() & Qt::TabFocus) == 0) continue;
      if (widget->focusProxy() != nullptr || !seen.insert(nameOf(widget)).second) continue;
      QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(widget);
      ASSERT_NE(spoken, nullptr) << nameOf(widget);
      EXPECT_FALSE(spoken->text(QAccessible::Name).isEmpty()) << nameOf(widget);
      const bool isArea = qobject_cast<QAbstractScrollArea*>(widget) != nullptr;
      EXPECT_TRUE(isArea || spoken->role() != QAccessible::Client) << nameOf(widget);
      EXPECT_NE(spoken->role(), QAccessible::NoRole) << nameOf(widget);
    }
  };
  for (const test::Scene& scene : test::windowScenes()) {
    show(scene.snapshot);
    walk();
  }
  show(test::askingSnapshot());
  for (auto* dock : m_window.findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    QTest::qWait(0);
    walk();
  }
  for (const char* action : {"overviewAction", "settingsAction", "aboutAction", "recordingsAction"}) {
    trigger(action);
    QTest::qWait(0);
    walk();
  }
  EXPECT_GT(seen.size(), 60U);
}

TEST_F(Reach, PaintedButtonsCanBePressedByAScreenReader) {
  openLog(test::kTruck);
  for (const char* name : {"play", "fullButton", "timeReadout"}) {
    auto* spoken = QAccessible::queryAccessibleInterface(named<QWidget>(name));
    EXPECT_EQ(spoken->role(), QAccessible::Button) << name;
    ASSERT_NE(spoken->actionInterface(), nullptr) << name;
    EXPECT_TRUE(spoken->actionInterface()->actionNames().contains(QAccessibleActionInterface::pressAction()))
        << name;
  }
  auto* play = QAccessible::queryAccessibleInterface(named<QWidget>("play"));
  play->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
  EXPECT_TRUE(m_session.snapshot().playing);
}

TEST_F(Reach, TheTimelineSpeaksItsPlaceAndSpeaksAgainAfterAKey) {
  openLog(test::kTruck + "(15.100000) can0 18EFFF80#83C001\n");
  auto* timeline = only<Timeline>();
  auto* spoken = QAccessible::queryAccessibleInterface(timeline);
  const auto words = [&] { return spoken->text(QAccessible::Value); };
  const auto says = [&](const char* part) {
    return QTest::qWaitFor([&] { return words().contains(QLatin1String(part)); }, kPatience);
  };
  EXPECT_EQ(spoken->role(), QAccessible::Slider);
  EXPECT_EQ(spoken->text(QAccessible::Name), QStringLiteral("Position in the log"));
  EXPECT_TRUE(says("at 5.1 s of 5.1 s, live edge")) << qPrintable(words());
  EXPECT_TRUE(says("mark")) << qPrintable(words());
  timeline->setFocus();
  QTest::keyClick(timeline, Qt::Key_Left);
  EXPECT_TRUE(says("at 4.1 s of 5.1 s")) << qPrintable(words());
  EXPECT_FALSE(words().contains(QStringLiteral("live edge")));
  QTest::keyClick(timeline, Qt::Key_Left);
  EXPECT_TRUE(says("at 3.1 s of 5.1 s")) << qPrintable(words());
  ASSERT_NE(spoken->valueInterface(), nullptr);
  EXPECT_NEAR(spoken->valueInterface()->currentValue().toDouble(), 3.1, 1e-6);
  EXPECT_NEAR(spoken->valueInterface()->maximumValue().toDouble(), 5.1, 1e-6);
}

TEST_F(Reach, FocusIsSeenOnEveryControlThatTabComesTo) {
  const auto walk = [&](const char* where) {
    std::set<QWidget*> seen;
    QWidget* before = QApplication::focusWidget();
    QImage without = m_window.grab().toImage();
    for (int i = 0; i < 200; ++i) {
      QTest::keyClick(m_window.windowHandle(), Qt::Key_Tab);
      QWidget* now = QApplication::focusWidget();
      if (now == nullptr || !seen.insert(now).second) break;
      const QImage with = m_window.grab().toImage();
      if (now != before && now->window() == &m_window && !now->visibleRegion().isEmpty()) {
        const QRect area(now->mapTo(&m_window, QPoint()), now->size());
        // The head of a page is marked, the page itself is not.
        const int least = now->objectName() == QLatin1String("pageScroll") ? 0 : 150;
        EXPECT_GE(changedPixels(without, with, area), least) << nameOf(now) << " in " << where;
      }
      without = with;
      before = now;
    }
    EXPECT_FALSE(seen.empty()) << where;
  };
  show(test::windowScenes()[0].snapshot);
  walk("the connection page");
  openLog(test::kTruck);
  walk("the work");
  trigger("requestsDockAction");
  QTest::qWait(0);
  walk("the requests");
  for (const char* action : {"overviewAction", "eventsDockAction", "terminalDockAction", "decodeDockAction",
                             "helpDockAction", "settingsAction"}) {
    if (m_window.findChild<QAction*>(QLatin1String(action)) == nullptr) continue;
    trigger(action);
    QTest::qWait(0);
    walk(action);
  }
}

// Lines that come and go lie over the page: whatever a person aims at stays where it is.
TEST_F(Reach, ALineAtTheFootMovesNothing) {
  openLog(test::kTruck);
  const auto places = [&] {
    QStringList found;
    for (const char* name : {"dial", "traceView", "timeline", "play", "lockButton", "deviceList"}) {
      const auto* widget = named<QWidget>(name);
      const QRect at(widget->mapTo(&m_window, QPoint()), widget->size());
      found += QStringLiteral("%1 %2,%3 %4x%5")
                   .arg(QLatin1String(name))
                   .arg(at.x())
                   .arg(at.y())
                   .arg(at.width())
                   .arg(at.height());
    }
    return found.join(u'\n').toStdString();
  };
  QTest::qWait(0);
  const std::string before = places();
  trigger("markAction");
  QTest::qWait(0);
  EXPECT_TRUE(named<QWidget>("markText")->isVisible());
  EXPECT_FALSE(named<QWidget>("markText")->visibleRegion().isEmpty());
  EXPECT_EQ(places(), before);
  m_window.saveLog(m_dir.filePath(QStringLiteral("saved.log")));
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return text("saveText").startsWith(QStringLiteral("Saved")); }, kPatience));
  QTest::qWait(0);
  EXPECT_EQ(places(), before);
  const QRect save(named<QWidget>("saveBar")->mapTo(&m_window, QPoint()), named<QWidget>("saveBar")->size());
  const QRect mark(named<QWidget>("markBar")->mapTo(&m_window, QPoint()), named<QWidget>("markBar")->size());
  EXPECT_FALSE(save.intersects(mark));
  EXPECT_LE(save.bottom(), named<QWidget>("timeline")->mapTo(&m_window, QPoint()).y());
}

TEST_F(Reach, TheRecordingsPageDoesNotScrollSideways) {
  m_window.resize(1024, 600);
  trigger("recordingsAction");
  QTest::qWait(0);
  auto* list = named<QAbstractScrollArea>("recordingsList");
  EXPECT_FALSE(list->horizontalScrollBar()->isVisible());
}

}  // namespace
}  // namespace deckpipe
