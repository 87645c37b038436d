// SPDX-License-Identifier: GPL-3.0-or-later
// What a person comes for, by keys alone. Each key that is not text counts as one act; how many a task may take
// is a contract.
#include <QFileInfo>
#include <QSettings>
#include <functional>
#include <utility>

#include "app/console/window_test.h"
#include "console/kept_settings.h"
#include "console/workspace.h"
#include "link/can_link.h"
#include "link/virtual_bus.h"
#include "model/event_model.h"
#include "panel/connect/connection_page.h"
#include "panel/devices/device_list_panel.h"
#include "panel/events/event_panel.h"
#include "panel/page/device_page.h"
#include "panel/page/overview_panel.h"
#include "support/frames.h"
#include "support/recording_listener.h"

namespace deckpipe {
namespace {

using test::frame;
using test::kPatience;
using test::kTruck;

const DeviceKey kMonitor = DeviceKey::of(*Pin::parse("1032AE100801035"));

class ByKeysAlone : public test::WindowTest {
 protected:
  void SetUp() override {
    QSettings().clear();
    WindowTest::SetUp();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&m_window));
  }
  void press(Qt::Key key, Qt::KeyboardModifiers with = {}) {
    ++m_acts;
    QTest::keyClick(keysGoTo(), key, with);
  }
  void type(const QString& words) { QTest::keyClicks(keysGoTo(), words); }
  int acts() const { return m_acts; }
  void count() { m_acts = 0; }
  bool waitFor(const std::function<bool()>& isSo) { return QTest::qWaitFor(isSo, kPatience); }
  // Until it takes the keys.
  bool waitForDialog() {
    return waitFor([] {
      const QWidget* dialog = QApplication::activeModalWidget();
      return dialog != nullptr && dialog == QApplication::activeWindow();
    });
  }
  // In the window's sight, not below a fold.
  static bool isSeen(const QWidget* widget) {
    return widget->isVisible() && !widget->visibleRegion().isEmpty();
  }
  // Under the dial, without unfolding anything.
  QString reasons() const {
    QStringList said;
    for (const char* name : {"reason1", "reason2"}) {
      const auto* words = m_window.findChild<QLabel*>(QLatin1String(name));
      if (words != nullptr && isSeen(words)) said << words->text();
    }
    return said.join(u'\n');
  }
  void closeLog() {
    trigger("closeAction");
    ASSERT_TRUE(waitFor([&] { return only<ConnectionPage>()->isVisible(); }));
    m_window.activateWindow();  // as a window manager does once a dialog is gone
    ASSERT_TRUE(QTest::qWaitForWindowActive(&m_window));
  }

 private:
  QWidget* keysGoTo() {
    if (QWidget* popup = QApplication::activePopupWidget()) return popup;
    if (QWidget* focus = QApplication::focusWidget()) return focus;
    QWidget* modal = QApplication::activeModalWidget();
    return modal != nullptr ? modal : &m_window;
  }
  int m_acts = 0;
};

TEST_F(ByKeysAlone, TheKnownAdapterIsConnectedToAndItsMonitorSeenInOneAct) {
  VirtualBus bus;
  ASSERT_TRUE(bus.start());
  const QString place = bus.interfaceName(0);
  RecordingListener peer;
  CanLink monitor({QStringLiteral("virtualcan"), place, 250'000, {}});
  monitor.open(peer);
  ASSERT_TRUE(waitFor([&] { return peer.state() == LinkState::Up; }));
  only<ConnectionPage>()->setRecentLinks({{QStringLiteral("virtualcan"), place, 250'000, {}, true}});
  press(Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] { return bus.clients(0) == 2; }));
  for (const char* data : {"FF83150206021A0B", "011D940371000041"}) monitor.write(frame("18EFFF80", data));
  EXPECT_TRUE(
      waitFor([&] { return only<Workspace>()->device() == kMonitor && isSeen(named<QWidget>("dial")); }));
  EXPECT_EQ(text("pageTitle"), QStringLiteral("1032AE100801035"));
  EXPECT_EQ(acts(), 1);
}

TEST_F(ByKeysAlone, EnterIsMeantForTheLogOfLastTimeWhereNoAdapterIsKnown) {
  const QString path = writeLog(kTruck);
  rememberLog(path);
  MainWindow next(m_session);
  next.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&next));
  ASSERT_TRUE(waitFor([] {
    const auto* focus = QApplication::focusWidget();
    return focus != nullptr && focus->objectName() == QStringLiteral("recentLog");
  }));
  press(Qt::Key_Return);
  EXPECT_TRUE(waitFor([&] { return m_session.snapshot().view.frameCount == 3; }));
  EXPECT_EQ(acts(), 1);
}

struct Trouble {
  const char* name;
  QByteArray frames;
  const char* said;
};

const QByteArray kPlaced =
    "(10.000000) can0 18EFFF80#FF83150206021A0B\n"
    "(10.100000) can0 18EFFF80#011D940371000041\n"
    "(10.150000) can0 18EFFF80#83C051\n";
const QByteArray kRight = "(10.300000) can0 0CFDD633#107D046400100000\n";
const Trouble kTroubles[] = {
    {"disabled", kPlaced + "(10.300000) can0 18EFFF80#834051\n", "cannot move"},
    {"faulted", kPlaced + "(10.300000) can0 18EF80F9#02\n(10.310000) can0 18EFF980#0200200000000B\n",
     "Internal fuse"},
    {"outranked", kPlaced + kRight + "(10.310000) can0 0CFDD634#04FA010000000000\n", "comes first"},
    {"limited", kPlaced + "(10.250000) can0 18EFFF80#81FED401C200\n" + kRight, "soft limit"},
};

TEST_F(ByKeysAlone, WhyTheOnlyMonitorDoesNotMoveIsSeenWithoutAnAct) {
  for (const Trouble& trouble : kTroubles) {
    openLog(trouble.frames);
    EXPECT_TRUE(waitFor([&] { return reasons().contains(QLatin1String(trouble.said)); }))
        << trouble.name << ": " << qPrintable(reasons());
  }
  EXPECT_EQ(acts(), 0);
}

// Each has a tile of its own.
TEST_F(ByKeysAlone, WhyAnotherMonitorDoesNotMoveIsSeenByOneAct) {
  for (const Trouble& trouble : kTroubles) {
    QByteArray second = trouble.frames;
    openLog(second.replace("18EFFF80", "18EFFF8A").replace("18EF80", "18EF8A").replace("F980", "F98A") +
            QByteArray("(10.311000) can0 18EFFF80#FF83150206021A0C\n"
                       "(10.312000) can0 18EFFF80#011D940371000041\n"));
    ASSERT_TRUE(waitFor([&] { return only<DevicePage>()->isVisible(); }));
    count();
    press(Qt::Key_0, Qt::AltModifier);
    EXPECT_TRUE(waitFor([&] {
      for (const auto* tile : m_window.findChildren<MonitorTile*>()) {
        if (isSeen(tile) && tile->monitor().key == kMonitor &&
            tile->monitor().trouble.contains(QLatin1String(trouble.said)))
          return true;
      }
      return false;
    })) << trouble.name;
    EXPECT_EQ(acts(), 1);
    press(Qt::Key_9, Qt::AltModifier);
    EXPECT_TRUE(only<DevicePage>()->isVisible());
  }
}

TEST_F(ByKeysAlone, ALogIsSavedInTwoActsAndOpenedAgainInTwoWithItsNamesAndMarks) {
  openLog(kTruck);
  rememberLog(m_dir.filePath(QStringLiteral("truck.log")));
  m_session.seekFrames(2);
  m_session.mark(m_session.snapshot().view.cursor, QStringLiteral("valve opened"));
  ASSERT_TRUE(waitFor([&] { return !m_session.snapshot().source.isKeepingMarks; }));
  Q_EMIT only<DeviceListPanel>()->labelEdited(*Pin::parse("1032AE100801035"), QStringLiteral("front bumper"));
  count();
  press(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(waitForDialog());
  press(Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] { return text("saveText").startsWith(QStringLiteral("Saved 3 frames")); }))
      << qPrintable(text("saveText"));
  EXPECT_EQ(acts(), 2);
  const QString saved = recentLogs().first();
  EXPECT_EQ(QFileInfo(saved).absolutePath(), QFileInfo(m_dir.path()).absoluteFilePath());

  // Another person's computer.
  Q_EMIT only<DeviceListPanel>()->labelEdited(*Pin::parse("1032AE100801035"), {});
  closeLog();
  count();
  press(Qt::Key_F, Qt::AltModifier);
  ASSERT_NE(QApplication::activePopupWidget(), nullptr);
  press(Qt::Key_1);
  ASSERT_TRUE(waitFor([&] { return m_session.snapshot().view.frameCount == 3; }));
  EXPECT_EQ(m_session.snapshot().source.name, saved);
  EXPECT_TRUE(waitFor([&] { return text("pageTitle") == QStringLiteral("front bumper"); }))
      << qPrintable(text("pageTitle"));
  const auto notes = m_session.snapshot().view.document->notes.all();
  EXPECT_TRUE(std::ranges::any_of(
      notes, [](const Note& note) { return note.value == NoteValue(note::Mark{"valve opened"}); }));
  EXPECT_EQ(acts(), 2);
}

TEST_F(ByKeysAlone, EverythingIsAskedOfADeviceInTwoActsUnlockingIncluded) {
  trigger("demoAction");
  const auto asked = [&] {
    const DeviceServices* device = m_session.snapshot().services->find(only<Workspace>()->device());
    if (device == nullptr) return std::pair(0, 0);
    int taken = 0, answered = 0;
    for (const Request request : kAllOf<Request>) {
      if (isCommand(request) || !device->takes.has(request)) continue;
      ++taken;
      answered += device->of(request).end == RequestEnd::Answered ? 1 : 0;
    }
    return std::pair(taken, answered);
  };
  ASSERT_TRUE(waitFor([&] { return asked().first > 0 && named<QAction>("askAllAction")->isEnabled(); }));
  ASSERT_TRUE(m_session.snapshot().services->locked);
  press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(waitForDialog());
  press(Qt::Key_U, Qt::AltModifier);
  EXPECT_TRUE(waitFor([&] { return asked().first > 0 && asked().first == asked().second; }))
      << asked().second << " of " << asked().first;
  EXPECT_EQ(acts(), 2);
  EXPECT_TRUE(isSeen(named<QWidget>("requestPanel"))) << "the answers are shown";
}

// The faults of a long log are found by the same key from either end.
TEST_F(ByKeysAlone, TheMomentAFaultBeganIsFoundInOneAct) {
  QByteArray log = kPlaced;
  for (int i = 0; i < 2'000; ++i) {
    log += QByteArray("(") + QByteArray::number(11 + i / 100) + "." +
           QByteArray::number(i % 100).rightJustified(2, '0') + "0000) can0 18EFFF80#011D940371000041\n";
    if (i == 1'200) log += "(23.001000) can0 18EF80F9#02\n(23.002000) can0 18EFF980#0200200000000B\n";
  }
  openLog(log);
  const Instant began{23'002'000'000};
  const auto* events = only<EventPanel>()->model();
  ASSERT_TRUE(waitFor(
      [&] { return events->rowCount() > 0 && events->weight(events->rowCount() - 1) == Severity::Fault; }));
  const auto cursor = [&] { return m_session.snapshot().view.cursor.time; };
  ASSERT_NE(cursor(), began);
  press(Qt::Key_F8, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(cursor(), began);
  EXPECT_EQ(acts(), 1);
  m_session.seekFrames(1);
  press(Qt::Key_F8, Qt::ControlModifier);
  EXPECT_EQ(cursor(), began);
  press(Qt::Key_F8, Qt::ControlModifier);
  EXPECT_EQ(cursor(), began) << "there is no other";
  EXPECT_TRUE(waitFor([&] { return reasons().contains(QLatin1String("Internal fuse")); }))
      << "and is said in words";
}

}  // namespace
}  // namespace deckpipe
