// SPDX-License-Identifier: GPL-3.0-or-later
// Devices as a person names them and looks at them in the window: labels that stay, the overview, the dial
// over everything.
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSettings>
#include <QTabWidget>
#include <QTreeView>

#include "app/console/window_test.h"
#include "console/kept_settings.h"
#include "console/workspace.h"
#include "model/answer_history.h"
#include "panel/devices/device_list_panel.h"
#include "panel/page/device_page.h"
#include "panel/page/full_dial.h"
#include "panel/page/overview_panel.h"
#include "support/child.h"
#include "support/patience.h"

namespace deckpipe {
namespace {

using test::kTruck;

const Pin kPin = *Pin::parse("1032AE100801035");

class WindowDevices : public test::WindowTest {
 protected:
  void TearDown() override { SettingsLabels().write({}); }
  QTabWidget* tabs() const { return named<QTabWidget>("centreTabs"); }
};

TEST_F(WindowDevices, KeepsALabelThatAPersonGives) {
  openLog(kTruck);
  auto* list = named<QTreeView>("deviceList");
  list->setFocus();
  QTest::keyClick(list, Qt::Key_F2);
  auto* editor = test::child<QLineEdit>(*list, "labelEditor");
  QTest::keyClicks(editor, QStringLiteral("Roof"));
  QTest::keyClick(editor, Qt::Key_Return);
  QCoreApplication::processEvents();
  EXPECT_EQ(text("pageTitle"), QStringLiteral("Roof"));
  EXPECT_EQ(SettingsLabels().read().of(kPin), QStringLiteral("Roof"));
  MainWindow later(m_session);
  later.show();
  QCoreApplication::processEvents();
  EXPECT_EQ(test::child<QLabel>(later, "pageTitle")->text(), QStringLiteral("Roof"));
}

TEST_F(WindowDevices, ShowsAllMonitorsAndGoesToThePageOfOne) {
  openLog(kTruck + "(10.300000) can0 18EFFF81#011D940371000041\n");
  tabs()->setCurrentWidget(only<OverviewPanel>());
  auto* second = named<MonitorTile>("monitorTile2");
  QTest::mouseClick(second, Qt::LeftButton);
  EXPECT_EQ(tabs()->currentWidget(), only<DevicePage>());
  EXPECT_EQ(only<Workspace>()->device(), DeviceKey::at(Channel{0}, Address{0x81}));
  EXPECT_EQ(only<DevicePage>()->values().key, DeviceKey::at(Channel{0}, Address{0x81}));
}

// At rest no snapshot comes that would tell the docks.
TEST_F(WindowDevices, FollowTheChoiceInEveryDockWhileALogIsAtRest) {
  openLog(kTruck +
          "(10.300000) can0 18EFFF81#FF83150206021A0C\n"
          "(10.400000) can0 18EF81F9#02\n"
          "(10.410000) can0 18EFF981#0200200000000B\n"
          "(10.500000) can0 18EFF981#FE4F4B\n");
  const auto* history = only<AnswerHistory>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_session.snapshot().view.found >= 4; }, kPatience));
  EXPECT_EQ(only<Workspace>()->device(), DeviceKey::of(kPin));
  const int before = history->rowCount();
  only<Workspace>()->selectDevice(DeviceKey::of(*Pin::parse("1032AE100801036")));
  EXPECT_EQ(history->rowCount(), before + 1);
  EXPECT_EQ(text("pageTitle"), QStringLiteral("1032AE100801036"));
  EXPECT_TRUE(named<QPlainTextEdit>("pipeText")->toPlainText().contains(QStringLiteral("OK")));
}

TEST_F(WindowDevices, SpreadsTheDialOverTheWorkspace) {
  openLog(kTruck);
  QTest::mouseDClick(named<QWidget>("dial"), Qt::LeftButton);
  auto* full = only<FullDial>();
  EXPECT_EQ(full->parentWidget(), only<Workspace>());
  EXPECT_EQ(full->size(), only<Workspace>()->size());
  QTest::keyClick(full, Qt::Key_Escape);
  EXPECT_EQ(only<DevicePage>()->full(), nullptr);
}

TEST(SettingsLabelsTest, KeepAnyPinThatADeviceCanHave) {
  SettingsLabels storage;
  const Pin odd = *Pin::make(1042, '/', '%', 7);
  DeviceLabels labels;
  labels.set(kPin, QStringLiteral("Tête; = %1"));
  labels.set(odd, QStringLiteral("odd"));
  storage.write(labels);
  EXPECT_EQ(storage.read(), labels);
  labels.set(odd, {});
  storage.write(labels);
  EXPECT_EQ(storage.read(), labels);
  storage.write({});
  EXPECT_EQ(storage.read(), DeviceLabels());
}

}  // namespace
}  // namespace deckpipe
