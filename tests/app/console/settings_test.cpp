// SPDX-License-Identifier: GPL-3.0-or-later
// How the window looks and explains itself: themes, sizes, the settings that keep them, help.
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QHelpEvent>
#include <QMenuBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QSpinBox>
#include <QWhatsThis>
#include <algorithm>

#include "app/console/window_test.h"
#include "console/recordings_list.h"
#include "console/sending_actions.h"
#include "model/field_text.h"
#include "paint/app_style.h"
#include "panel/common/help_panel.h"
#include "panel/common/status_cell.h"
#include "panel/trace/trace_panel.h"
#include "support/child.h"

namespace deckpipe {
namespace {

using test::kTruck;

class Looks : public test::WindowTest {
 protected:
  void SetUp() override {
    QSettings().clear();
    WindowTest::SetUp();
  }
  void TearDown() override {
    m_window.setDensity(Density::Desk);
    m_window.setTheme(Theme::Light);
    QSettings().clear();  // the next window reads them before SetUp()
  }
  // What lies behind another dock's tab is laid out when it comes forward.
  static bool isSeen(const QWidget& widget) {
    return widget.isVisible() && !widget.visibleRegion().isEmpty();
  }
  // Every control in sight that is touched, with less than its height.
  QStringList tooSmall(int least) const {
    QStringList names;
    for (const auto* button : m_window.findChildren<QAbstractButton*>()) {
      if (isSeen(*button) && button->height() < least) names += button->objectName();
    }
    for (const auto* box : m_window.findChildren<QComboBox*>()) {
      if (isSeen(*box) && box->height() < least) names += box->objectName();
    }
    return names;
  }
};

TEST_F(Looks, GiveGlovesTargetsOfFortyFourPixels) {
  EXPECT_EQ(tooSmall(32).join(QLatin1Char(' ')).toStdString(), "");
  const int before = QApplication::font().pointSize();
  trigger("fieldDensityAction");
  EXPECT_GT(QApplication::font().pointSize(), before);
  // Each layout in layouts is told in a turn of its own.
  (void)QTest::qWaitFor([this] { return tooSmall(44).isEmpty(); });
  EXPECT_EQ(tooSmall(44).join(QLatin1Char(' ')).toStdString(), "");
  openLog(kTruck);
  // Each layout in layouts is told in a turn of its own.
  (void)QTest::qWaitFor([this] { return tooSmall(44).isEmpty(); });
  EXPECT_EQ(tooSmall(44).join(QLatin1Char(' ')).toStdString(), "");
}

TEST_F(Looks, ChangeAtOnceFromTheSettings) {
  trigger("settingsAction");
  ASSERT_TRUE(named<QWidget>("settingsPage")->isVisible());
  QTest::mouseClick(named<QRadioButton>("sunlightTheme"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_EQ(m_window.theme(), Theme::Sunlight);
  QTest::mouseClick(named<QRadioButton>("fieldDensity"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_TRUE(named<QAction>("fieldDensityAction")->isChecked());
  QTest::keyClick(named<QRadioButton>("fieldDensity"), Qt::Key_Escape);
  EXPECT_FALSE(named<QWidget>("settingsPage")->isVisible());
}

TEST_F(Looks, LetAPersonSayWhoTheConsoleIsOnABus) {
  trigger("settingsAction");
  auto* address = named<QSpinBox>("preferredAddress");
  auto* identity = named<QSpinBox>("identityNumber");
  EXPECT_EQ(address->text(), QStringLiteral("F9"));
  EXPECT_GE(identity->value(), 1) << "made up";
  address->setFocus();
  address->selectAll();
  QTest::keyClicks(address, QStringLiteral("fb\t"));
  identity->setFocus();
  identity->selectAll();
  QTest::keyClicks(identity, QStringLiteral("4711\t"));
  EXPECT_EQ(claimSettings().preferred, Address{0xFB}) << "kept";
  EXPECT_EQ(claimSettings().identityNumber, 4711u);
}

TEST_F(Looks, LetAPersonSayHowMuchOfTheRecordingsIsKept) {
  trigger("settingsAction");
  auto* megabytes = named<QSpinBox>("recordingMegabytes");
  auto* days = named<QSpinBox>("recordingDays");
  EXPECT_EQ(megabytes->value(), 2'048);
  EXPECT_EQ(days->value(), 30);
  megabytes->setFocus();
  megabytes->selectAll();
  QTest::keyClicks(megabytes, QStringLiteral("500\t"));
  days->setFocus();
  days->selectAll();
  QTest::keyClicks(days, QStringLiteral("7\t"));
  EXPECT_EQ(recordingLimits().maxBytes, std::uint64_t{500} << 20);
  EXPECT_EQ(recordingLimits().maxDays, 7);
}

TEST_F(Looks, TakeNoJoysticksOrMonitorsAddressForTheConsole) {
  trigger("settingsAction");
  auto* address = named<QSpinBox>("preferredAddress");
  for (const char* refused : {"33", "38", "80", "f7"}) {
    address->setFocus();
    address->selectAll();
    QTest::keyClicks(address, QLatin1String(refused) + QLatin1Char('\t'));
    EXPECT_EQ(address->text(), QStringLiteral("F9")) << refused;
    EXPECT_TRUE(text("preferredAddressNote").startsWith(QString::fromLatin1(refused).toUpper()))
        << "and it says why: " << qPrintable(text("preferredAddressNote"));
    EXPECT_EQ(claimSettings().preferred, Address{0xF9});
  }
}

TEST_F(Looks, WarnOfAFixedAddressAndStepOverTheRefusedOnes) {
  trigger("settingsAction");
  auto* address = named<QSpinBox>("preferredAddress");
  address->setFocus();
  QTest::keyClick(address, Qt::Key_Down);
  EXPECT_EQ(address->text(), QStringLiteral("F8"));
  QTest::keyClick(address, Qt::Key_Down);
  EXPECT_EQ(address->text(), QStringLiteral("7F"));
  EXPECT_TRUE(text("preferredAddressNote").startsWith(QStringLiteral("Below 80")));
  QTest::keyClick(address, Qt::Key_Up);
  EXPECT_EQ(address->text(), QStringLiteral("F8"));
  EXPECT_EQ(claimSettings().preferred, Address{0xF8});
}

TEST_F(Looks, DoNotUseAKeptAddressOfAJoystickAndSaySoOnce) {
  QSettings().setValue(QStringLiteral("bus/preferredAddress"), 0x33);
  EXPECT_EQ(claimSettings().preferred, Address{0xF9});
  MainWindow next(m_session);
  const auto* notice = test::child<NoticeBar>(next);
  ASSERT_NE(notice, nullptr);
  EXPECT_TRUE(notice->notice().text.contains(QStringLiteral("preferred address 33")))
      << qPrintable(notice->notice().text);
  test::child<QAction>(next, "settingsAction")->trigger();
  EXPECT_TRUE(notice->notice().text.isEmpty());
  EXPECT_TRUE(test::child<QLabel>(next, "preferredAddressNote")->text().startsWith(QStringLiteral("33 ")));
  MainWindow third(m_session);
  EXPECT_TRUE(test::child<NoticeBar>(third)->notice().text.isEmpty());
}

TEST_F(Looks, AreKeptForTheNextTime) {
  m_window.setTheme(Theme::Dark);
  m_window.setDensity(Density::Field);
  m_window.close();
  MainWindow next(m_session);
  next.restoreLayout();
  EXPECT_EQ(next.theme(), Theme::Dark);
  EXPECT_TRUE(test::child<QAction>(next, "fieldDensityAction")->isChecked());
}

TEST_F(Looks, OfOneRunAreNotKept) {
  m_window.setTheme(Theme::Sunlight);
  m_window.setLook(Theme::Dark, Density::Field);
  EXPECT_TRUE(named<QAction>("fieldDensityAction")->isChecked());
  m_window.close();
  MainWindow next(m_session);
  next.restoreLayout();
  EXPECT_EQ(next.theme(), Theme::Sunlight);
  EXPECT_EQ(next.density(), Density::Desk);
}

// Widths were measured in the letters of their density: taken in others they would grow each time.
TEST_F(Looks, KeepTheColumnsOfTheFieldAsWideAsTheyWere) {
  const auto widthIn = [](const MainWindow& window, int column) {
    QCoreApplication::sendPostedEvents();  // new letters come by one
    return test::child<TracePanel>(window)->view()->header()->sectionSize(column);
  };
  const int desk = widthIn(m_window, TraceModel::Identifier);
  m_window.setDensity(Density::Field);
  const int field = widthIn(m_window, TraceModel::Identifier);
  EXPECT_LT(desk, field);
  test::child<TracePanel>(m_window)->view()->header()->resizeSection(TraceModel::Name, 400);
  m_window.close();
  m_window.setDensity(Density::Desk);
  MainWindow next(m_session);
  next.restoreLayout();
  EXPECT_EQ(widthIn(next, TraceModel::Identifier), field);
  EXPECT_NEAR(widthIn(next, TraceModel::Name), 400, 1);
}

TEST_F(Looks, ClosesTheSettingsForWhatWasOpened) {
  trigger("aboutAction");
  EXPECT_TRUE(named<QWidget>("aboutPage")->isVisible());
  openLog(kTruck);
  EXPECT_TRUE(named<QWidget>("workspace")->isVisible());
}

TEST_F(Looks, AboutSaysVersionLicenceAndPlaces) {
  trigger("aboutAction");
  EXPECT_TRUE(text("aboutTitle").startsWith(QStringLiteral("Deckpipe 0")));
  EXPECT_TRUE(text("aboutLicence").contains(QStringLiteral("version 3 or later")));
  EXPECT_TRUE(text("aboutQt").contains(QLatin1String(qVersion())));
  EXPECT_TRUE(text("aboutPaths").contains(QSettings().fileName()));
  QTest::mouseClick(named<QPushButton>("aboutDone"), Qt::LeftButton);
  EXPECT_FALSE(named<QWidget>("aboutPage")->isVisible());
}

TEST_F(Looks, F1OnARowOfTheTraceExplainsItsMessage) {
  openLog(kTruck);
  TraceView* rows = only<TracePanel>()->view();
  rows->setFocus();
  trigger("explainAction");
  const auto said = [this] { return only<HelpPanel>()->text(); };
  EXPECT_TRUE(said().startsWith(QStringLiteral("Trace\n"))) << qPrintable(said());
  EXPECT_TRUE(said().contains(QStringLiteral("Every frame of the log"))) << "nothing is chosen yet";
  QTest::keyClick(rows, Qt::Key_End);
  EXPECT_TRUE(said().contains(QStringLiteral("Position / limit status"))) << qPrintable(said());
  EXPECT_TRUE(said().contains(toQString(messageOf(MessageId::PositionLimitStatus).source)))
      << qPrintable(said());
  QTest::keyClick(rows, Qt::Key_Home);
  EXPECT_TRUE(said().contains(toQString(messageOf(MessageId::AddressAnnouncement).source)))
      << qPrintable(said());
  EXPECT_FALSE(said().contains(QStringLiteral("Position / limit status")));
  named<QWidget>("traceFilter")->setFocus();
  EXPECT_TRUE(said().contains(QStringLiteral("parameter group, hex"))) << qPrintable(said());
}

// Whatever stands under the pointer says what it is, if only by its tool tip.
TEST_F(Looks, WhatsThisExplainsWhatIsPointedAt) {
  openLog(kTruck);
  const auto request = [](QWidget* widget, QPoint at) {
    QHelpEvent event(QEvent::WhatsThis, at, widget->mapToGlobal(at));
    QApplication::sendEvent(widget, &event);
    const QWidgetList all = QApplication::topLevelWidgets();
    const bool isSaid =
        std::any_of(all.begin(), all.end(), [](const QWidget* w) { return w->inherits("QWhatsThat"); });
    QWhatsThis::hideText();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return isSaid;
  };
  EXPECT_TRUE(request(only<TracePanel>()->view()->viewport(), {200, 5})) << "a row";
  auto* follow = named<QWidget>("traceFollow");
  EXPECT_TRUE(follow->whatsThis().isEmpty());
  EXPECT_TRUE(request(follow, {4, 4})) << "by its tool tip";
  EXPECT_FALSE(request(only<QMenuBar>(), {600, 4})) << "nothing is said of what says nothing";
}

TEST_F(Looks, F1ExplainsWhatHasTheFocus) {
  openLog(kTruck);
  m_window.activateWindow();
  named<QWidget>("transmitLockCell")->setFocus();
  QTest::keyClick(&m_window, Qt::Key_F1);
  ASSERT_TRUE(named<QDockWidget>("helpDock")->isVisible());
  EXPECT_TRUE(only<HelpPanel>()->text().contains(QStringLiteral("receives only")))
      << qPrintable(only<HelpPanel>()->text());
  named<QWidget>("busLoadCell")->setFocus();
  EXPECT_TRUE(only<HelpPanel>()->text().startsWith(QStringLiteral("Bus load")));
}

TEST_F(Looks, EveryControlHasANameForWhoCannotSeeIt) {
  openLog(kTruck);
  QStringList nameless;
  for (const auto* widget : m_window.findChildren<QWidget*>()) {
    const bool isControl = (widget->focusPolicy() & Qt::TabFocus) != 0 && widget->isVisible();
    const bool isQts = widget->objectName().startsWith(QStringLiteral("qt_"));
    if (isControl && !isQts && widget->accessibleName().isEmpty() && widget->focusProxy() == nullptr)
      nameless +=
          QStringLiteral("%1 %2").arg(QLatin1String(widget->metaObject()->className()), widget->objectName());
  }
  EXPECT_EQ(nameless.join(QLatin1Char('\n')).toStdString(), "");
}

}  // namespace
}  // namespace deckpipe
