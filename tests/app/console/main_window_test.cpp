// SPDX-License-Identifier: GPL-3.0-or-later
// The window as a person meets it: a log opened, a device chosen, rows and the timeline worked with real
// events.
#include <QLineEdit>

#include "app/console/window_scenes.h"
#include "app/console/window_test.h"
#include "console/workspace.h"
#include "model/decode_model.h"
#include "panel/devices/device_list_panel.h"
#include "panel/page/device_page.h"
#include "panel/play/transport_bar.h"
#include "panel/trace/trace_view.h"
#include "session/playback.h"
#include "support/child.h"

namespace deckpipe {
namespace {

using test::kPatience;
using test::kTruck;

class Window : public test::WindowTest {};

TEST_F(Window, SaysWhatToDoWhileNothingIsOpen) {
  EXPECT_TRUE(test::child<QWidget>(m_window, "startPage")->isVisible());
  EXPECT_EQ(text("sourceStatus"), QStringLiteral("Nothing open"));
}

TEST_F(Window, ShowsTheFirstMonitorOfALogAtItsEnd) {
  openLog(kTruck);
  ASSERT_TRUE(QTest::qWaitFor([&] { return only<DevicePage>()->isVisible(); }, kPatience));
  EXPECT_EQ(only<Workspace>()->device(),
            keyOf(*m_session.snapshot().view.state->devices().byPin(*Pin::parse("1032AE100801035"))));
  EXPECT_EQ(text("frameCounts"), QStringLiteral("3 frames"));
  EXPECT_EQ(m_window.windowTitle(), QStringLiteral("truck.log – Deckpipe"));
}

TEST_F(Window, PutsTheCursorWhereARowIsDoubleClicked) {
  openLog(kTruck);
  auto* trace = only<TraceView>();
  const QPoint secondRow(300, trace->rowHeight() + trace->rowHeight() / 2);
  QTest::mouseClick(trace->viewport(), Qt::LeftButton, {}, secondRow);
  EXPECT_EQ(trace->currentFrame(), std::optional<std::uint64_t>(1));
  EXPECT_EQ(only<DecodeModel>()->frame(), std::optional<std::uint64_t>(1));
  QTest::mouseDClick(trace->viewport(), Qt::LeftButton, {}, secondRow);
  EXPECT_EQ(m_session.snapshot().view.cursor.frames, 2u);
  EXPECT_FALSE(m_session.snapshot().view.atEnd);
}

TEST_F(Window, PlaysFromTheTimelineWithSpace) {
  openLog(kTruck);
  QTest::keyClick(only<TransportBar>(), Qt::Key_Space);
  EXPECT_TRUE(m_session.snapshot().playing);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !m_session.snapshot().playing; }, kPatience));
  EXPECT_EQ(m_session.snapshot().view.cursor.frames, 3u);
}

TEST_F(Window, GoesToATimeThatIsTyped) {
  openLog(kTruck);
  const LogView view = m_session.snapshot().view;
  QTest::keyClick(&m_window, Qt::Key_G, Qt::ControlModifier);
  auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_NE(field, nullptr);
  EXPECT_EQ(field->accessibleName(), QStringLiteral("Go to a time"));
  QTest::keyClicks(field, QStringLiteral("0.1"));
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(m_session.snapshot().view.cursor.time, view.begin + 100ms);
  EXPECT_FALSE(field->isVisible());
  EXPECT_EQ(QApplication::focusWidget()->objectName(), QStringLiteral("timeline")) << "Space plays at once";
}

TEST_F(Window, ChangesTheSpeedAndLoopsByKeys) {
  openLog(kTruck);
  for (int i = 0; i < 12; ++i) QTest::keyClick(&m_window, Qt::Key_Up, Qt::ControlModifier);
  EXPECT_EQ(m_session.snapshot().speed, Playback::kUnbounded);
  for (int i = 0; i < 12; ++i) QTest::keyClick(&m_window, Qt::Key_Down, Qt::ControlModifier);
  EXPECT_EQ(m_session.snapshot().speed, Playback::kSlowest);
  QTest::keyClick(&m_window, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(m_session.snapshot().isLooping) << "nothing is selected";
  m_session.seekFrames(2);
  QTest::keyClick(named<QWidget>("timeline"), Qt::Key_BracketRight);
  QTest::keyClick(&m_window, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(m_session.snapshot().isLooping);
  EXPECT_TRUE(m_session.snapshot().playing);
  QTest::keyClick(&m_window, Qt::Key_P, Qt::ControlModifier);
  EXPECT_FALSE(m_session.snapshot().playing);
  trigger("silencesAction");
  EXPECT_TRUE(m_session.snapshot().skipsSilences);
}

TEST_F(Window, OffersReplayOnlyWhereThereIsALog) {
  const auto isOffered = [this](const char* action) { return named<QAction>(action)->isEnabled(); };
  for (const char* action : {"playAction", "typeTimeAction", "fasterAction", "silencesAction"})
    EXPECT_FALSE(isOffered(action)) << action;
  openLog(kTruck);
  for (const char* action : {"playAction", "typeTimeAction", "fasterAction", "silencesAction"})
    EXPECT_TRUE(isOffered(action)) << action;
}

TEST_F(Window, ChangesItsThemeAtOnce) {
  openLog(kTruck);
  const QImage light = m_window.grab().toImage();
  test::child<QAction>(m_window, "darkThemeAction")->trigger();
  EXPECT_EQ(m_window.theme(), Theme::Dark);
  EXPECT_NE(m_window.grab().toImage(), light);
  test::child<QAction>(m_window, "lightThemeAction")->trigger();
}

TEST_F(Window, SaysWhyALogCannotBeRead) {
  m_session.openLog(m_dir.filePath(QStringLiteral("absent.log")));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return m_session.snapshot().source.progress == SourceStatus::Progress::Failed; }, kPatience));
  EXPECT_TRUE(text("sourceStatus").contains(QStringLiteral("cannot be read")))
      << qPrintable(text("sourceStatus"));
}

TEST_F(Window, ForgetsTheDevicesOfALogThatWasClosed) {
  openLog(kTruck);
  test::child<QAction>(m_window, "closeAction")->trigger();
  EXPECT_TRUE(test::child<QWidget>(m_window, "startPage")->isVisible());
  EXPECT_EQ(only<Workspace>()->device(), DeviceKey{});
  openLog("(1.000000) can0 123#11\n");
  EXPECT_EQ(only<Workspace>()->device(), DeviceKey{});
}

TEST_F(Window, ShowsTheDemoMoving) {
  test::child<QAction>(m_window, "demoAction")->trigger();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const Device* monitor =
            m_session.snapshot().view.state->devices().byPin(*Pin::parse("1032AE100801035"));
        return monitor != nullptr && monitor->position().isKnown() &&
               only<Workspace>()->device() == keyOf(*monitor);
      },
      kPatience));
  EXPECT_TRUE(text("sourceStatus").contains(QStringLiteral("Simulated truck")));
  EXPECT_TRUE(m_window.windowTitle().startsWith(QStringLiteral("Simulated truck")))
      << qPrintable(m_window.windowTitle());
}

TEST_F(Window, SaysThatAQuestionAnsweredInThePastSentNothing) {
  trigger("demoAction");
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_session.snapshot().services->linkUp; }, kPatience));
  trigger("lockAction");
  QWidget* question = QApplication::activeModalWidget();
  ASSERT_NE(question, nullptr);
  m_session.pause();
  QTest::mouseClick(test::child<QAbstractButton>(*question, "dangerVerb"), Qt::LeftButton);
  EXPECT_TRUE(only<NoticeBar>()->notice().text.contains(QStringLiteral("Nothing was sent")))
      << qPrintable(only<NoticeBar>()->notice().text);
  EXPECT_TRUE(m_session.snapshot().services->locked);
}

TEST_F(Window, ListsRepeatedPollsInTheBusMenu) {
  m_window.setSnapshot(test::askingSnapshot());
  EXPECT_TRUE(named<QAction>("endRepeatsAction")->isEnabled());
  EXPECT_TRUE(named<QAction>("endRepeatsAction")->text().contains(QStringLiteral("repeated polls of 1")));
  EXPECT_TRUE(named<QLabel>("repeatText")->text().contains(QStringLiteral("1033AE100802117")));
  m_window.setSnapshot(test::windowScenes()[0].snapshot);
  EXPECT_FALSE(named<QAction>("endRepeatsAction")->isEnabled());
}

}  // namespace
}  // namespace deckpipe
