// SPDX-License-Identifier: GPL-3.0-or-later
// The window has the room that its screen gives it: whatever is open, in both densities.
#include <QDockWidget>
#include <QScreen>
#include <QSettings>
#include <algorithm>
#include <string>
#include <vector>

#include "app/console/window_scenes.h"
#include "app/console/window_test.h"
#include "console/workspace.h"
#include "paint/app_style.h"
#include "support/child.h"

namespace deckpipe {
namespace {

constexpr Density kDensities[] = {Density::Desk, Density::Field};

class WindowRoom : public test::WindowTest {
 protected:
  void SetUp() override {
    QSettings().clear();
    WindowTest::SetUp();
  }
  void TearDown() override { m_window.setDensity(Density::Desk); }
  // Where each dock is, and how large.
  static QStringList docksOf(const MainWindow& window) {
    QStringList docks;
    for (const auto* dock : window.findChildren<QDockWidget*>()) {
      const QRect at = dock->isFloating() ? dock->frameGeometry() : dock->geometry();
      QString how = QStringLiteral("%1,%2 %3 by %4").arg(at.x()).arg(at.y()).arg(at.width()).arg(at.height());
      if (dock->isFloating()) how += QStringLiteral(" floating");
      if (at.right() < 0) how = QStringLiteral("behind a tab");
      if (dock->isHidden()) how = QStringLiteral("closed");
      docks += dock->objectName() + QStringLiteral(": ") + how;
    }
    docks.sort();
    return docks;
  }
  QRect placeOf(const char* name) const {
    const auto* widget = named<QWidget>(name);
    return {widget->mapTo(&m_window, QPoint()), widget->size()};
  }
  // As a person moves a separator.
  void widen(const char* dock, int width) const {
    only<Workspace>()->resizeDocks({named<QDockWidget>(dock)}, {width}, Qt::Horizontal);
  }
  // Each layout in layouts is told in a turn of its own.
  void settle() const {
    for (int i = 0; i < 4; ++i) QTest::qWait(0);
  }
};

TEST_F(WindowRoom, IsThatOfASmallScreenAtLeastWithEveryDockOpen) {
  for (const Density density : kDensities) {
    m_window.setDensity(density);
    for (const test::Scene& scene : test::windowScenes()) {
      m_window.setSnapshot(scene.snapshot);
      for (auto* dock : m_window.findChildren<QDockWidget*>()) dock->show();
      settle();
      const QSize least = m_window.minimumSizeHint();
      EXPECT_LE(least.width(), 800) << scene.name << " density " << static_cast<int>(density);
      EXPECT_LE(least.height(), 480) << scene.name << " density " << static_cast<int>(density);
    }
  }
}

TEST_F(WindowRoom, KeepsLockAndPlayInSightAndInTheirPlace) {
  for (const Density density : kDensities) {
    m_window.setDensity(density);
    for (const int width : {800, 1024, 1366, 1920}) {
      QRect place;
      for (const test::Scene& scene : test::windowScenes()) {
        if (scene.snapshot.source.kind != SourceStatus::Kind::Link) continue;
        const auto trace = testing::Message()
                           << scene.name << " at " << width << ", density " << static_cast<int>(density);
        SCOPED_TRACE(trace);
        m_window.resize(width, 600);
        m_window.setSnapshot(scene.snapshot);
        settle();
        EXPECT_EQ(m_window.width(), width);
        const QRect lock = placeOf("lockButton");
        if (place.isNull()) place = lock;
        EXPECT_EQ(lock, place);
        for (const char* name : {"lockButton", "stopRoom", "transmitLockCell", "play", "toEnd"}) {
          const auto* widget = named<QWidget>(name);
          if (!widget->isVisible()) continue;  // nothing to be played is there
          EXPECT_TRUE(m_window.rect().contains(placeOf(name))) << name;
          EXPECT_GE(widget->width(), widget->minimumSizeHint().width()) << name;
          EXPECT_FALSE(widget->visibleRegion().isEmpty()) << name;
        }
      }
    }
  }
}

TEST_F(WindowRoom, IsGivenUpByNumbersAndLastByTheRecording) {
  m_window.setSnapshot(test::askingSnapshot());
  std::vector<std::string> gone;
  for (int width = 1500; width >= 800; width -= 20) {
    m_window.resize(width, 600);
    settle();
    for (const char* name :
         {"frameRateCell", "busLoadCell", "errorFramesCell", "completenessCell", "frameCountsCell"}) {
      const bool isKnown = std::ranges::find(gone, name) != gone.end();
      if (!isKnown && !named<QWidget>(name)->isVisible()) gone.emplace_back(name);
    }
    EXPECT_GE(named<QWidget>("sourceStatusCell")->width(), 200) << width;
  }
  const std::vector<std::string> expected{"frameRateCell", "busLoadCell", "errorFramesCell",
                                          "completenessCell"};
  gone.resize(std::min(gone.size(), expected.size()));
  EXPECT_EQ(gone, expected);
}

// A screen of 800×800 here: neither a first window nor one that was left larger goes beyond it.
TEST_F(WindowRoom, IsNeverMoreThanTheScreen) {
  const QRect screen = m_window.screen()->availableGeometry();
  ASSERT_LT(screen.width(), 1366);
  m_window.close();
  QSettings().clear();
  MainWindow first(m_session);
  first.restoreLayout();
  first.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&first));
  EXPECT_TRUE(first.isMaximized());
  EXPECT_TRUE(screen.contains(first.frameGeometry())) << first.width() << "x" << first.height();
  first.setWindowState(Qt::WindowNoState);
  first.setGeometry(300, 200, 1366, 720);
  QTest::qWait(0);
  first.close();
  MainWindow second(m_session);
  second.restoreLayout();
  second.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&second));
  EXPECT_TRUE(screen.contains(second.frameGeometry())) << second.width() << "x" << second.height();
}

TEST_F(WindowRoom, IsSharedToThePixelAsItWasLeft) {
  openLog(test::kTruck);
  enum class Way { Plain, Floating, Maximised, Untouched };
  for (const Density density : kDensities) {
    for (const Way way : {Way::Untouched, Way::Plain, Way::Floating, Way::Maximised}) {
      const auto trace = testing::Message()
                         << "density " << static_cast<int>(density) << " way " << static_cast<int>(way);
      SCOPED_TRACE(trace);
      QSettings().clear();
      m_window.setDensity(density);
      MainWindow left(m_session);
      left.setDensity(density);
      left.resize(780, 700);
      left.show();
      ASSERT_TRUE(QTest::qWaitForWindowExposed(&left));
      settle();
      auto* workspace = test::child<Workspace>(left);
      if (way == Way::Maximised) left.setWindowState(Qt::WindowMaximized);
      if (way != Way::Untouched) {
        settle();
        test::child<QAction>(left, "requestsDockAction")->trigger();
        settle();
        workspace->resizeDocks({test::child<QDockWidget>(left, "devicesDock")}, {213}, Qt::Horizontal);
        workspace->resizeDocks({test::child<QDockWidget>(left, "traceDock")}, {151}, Qt::Vertical);
        test::child<QAction>(left, "eventsDockAction")->trigger();
      }
      if (way == Way::Floating) {
        auto* floating = test::child<QDockWidget>(left, "terminalDock");
        floating->setFloating(true);
        floating->setGeometry(50, 60, 321, 234);
      }
      settle();
      const QStringList before = docksOf(left);
      left.close();
      m_window.setDensity(Density::Desk);
      MainWindow next(m_session);
      next.restoreLayout();
      next.show();
      ASSERT_TRUE(QTest::qWaitForWindowExposed(&next));
      (void)QTest::qWaitFor([&] { return docksOf(next) == before; }, 3'000);  // docks glide
      EXPECT_EQ(docksOf(next).join(u'\n').toStdString(), before.join(u'\n').toStdString());
    }
  }
}

// A window manager maximises a window some time after it was shown.
TEST_F(WindowRoom, IsSharedAsItWasLeftOnceTheWindowHasItsSize) {
  openLog(test::kTruck);
  m_window.resize(780, 700);
  settle();
  widen("devicesDock", 301);
  settle();
  const QStringList before = docksOf(m_window);
  m_window.close();
  MainWindow next(m_session);
  next.restoreLayout();
  next.resize(520, 400);
  next.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&next));
  settle();
  EXPECT_NE(docksOf(next), before);
  next.resize(780, 700);
  settle();
  EXPECT_EQ(docksOf(next).join(u'\n').toStdString(), before.join(u'\n').toStdString());
}

// Nobody has seen a log since, so nobody arranged anything.
TEST_F(WindowRoom, IsRememberedThroughATimeInWhichNothingWasOpened) {
  openLog(test::kTruck);
  m_window.resize(780, 700);
  settle();
  widen("devicesDock", 301);
  settle();
  const QStringList before = docksOf(m_window);
  m_window.close();
  Session idle;
  MainWindow empty(idle);
  empty.restoreLayout();
  empty.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&empty));
  empty.close();
  MainWindow next(m_session);
  next.restoreLayout();
  next.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&next));
  settle();
  EXPECT_EQ(docksOf(next).join(u'\n').toStdString(), before.join(u'\n').toStdString());
}

}  // namespace
}  // namespace deckpipe
