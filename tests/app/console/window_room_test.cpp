// SPDX-License-Identifier: GPL-3.0-or-later
// The window has the room that its screen gives it: whatever is open, in both densities.
#include <QDockWidget>
#include <QScreen>
#include <QSettings>

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
  first.close();
  MainWindow second(m_session);
  second.restoreLayout();
  second.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&second));
  EXPECT_TRUE(screen.contains(second.frameGeometry())) << second.width() << "x" << second.height();
}

}  // namespace
}  // namespace deckpipe
