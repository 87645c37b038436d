// SPDX-License-Identifier: GPL-3.0-or-later
// The window has the room that its screen gives it: whatever is open, in both densities.
#include <QDockWidget>
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

}  // namespace
}  // namespace deckpipe
