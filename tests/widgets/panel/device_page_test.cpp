// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/device_page.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>

#include "paint/dial.h"
#include "paint/dial_layout.h"
#include "paint/figures.h"
#include "paint/status_lamp.h"
#include "panel/page/fact_list.h"
#include "panel/page/full_dial.h"
#include "support/child.h"
#include "support/look.h"
#include "text/time_text.h"
#include "widgets/panel/panel_scenes.h"

namespace deckpipe {
namespace {

using namespace test;

// One layout asks for the next; an event loop would come round as often.
void settle() {
  for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
}

class PageTest : public testing::Test {
 protected:
  void SetUp() override {
    m_page.resize(1030, 500);
    m_page.show();
  }
  void show(const DeviceKey& key = keyOfA()) {
    show(m_bus.view(), key);
    settle();
  }
  void show(const LogView& log, const DeviceKey& key) {
    m_view.log = log;
    m_view.device = key;
    m_page.setView(m_view);
  }
  template <typename W>
  W* find(const char* name) const {
    return test::child<W>(m_page, name);
  }
  bool isShown(const char* name) const {
    // Most parts of a page are made when they are first wanted.
    const auto* w = m_page.findChild<QWidget*>(QString::fromLatin1(name));
    return w != nullptr && w->isVisible();
  }
  QString text(const char* name) const { return find<QLabel>(name)->text(); }
  StatusLamp* lamp(const char* name) const { return find<StatusLamp>(name); }

  Heard m_bus;
  PanelView m_view;
  DevicePage m_page;
};

TEST_F(PageTest, SaysWhatToDoWhereThereIsNothingToShow) {
  show({});
  EXPECT_TRUE(isShown("pageMessage"));
  EXPECT_FALSE(isShown("pageHeader"));
  EXPECT_EQ(text("pageMessage"), QStringLiteral("Devices are shown here once they are heard."));
  m_bus.monitor();
  show({});
  EXPECT_EQ(text("pageMessage"), QStringLiteral("Choose a device on the left."));
  LogView earlier = m_bus.view();
  earlier.frameCount = 900;
  show(earlier, {});
  EXPECT_EQ(
      text("pageMessage"),
      QStringLiteral("More is heard later in this log: press play, or click further on in the timeline.\n"
                     "Choose a device on the left."));
  earlier.cursor.frames = 1;
  show(earlier, {});
  EXPECT_EQ(text("pageMessage"),
            QStringLiteral("The log is at its begin: press play, or click into the timeline.\n"
                           "Choose a device on the left."));
  show(DeviceKey::of(*Pin::parse("1042XY123456789")));
  EXPECT_EQ(text("pageMessage"),
            QStringLiteral("1042XY123456789 was not heard up to this place of the log."));
  show();
  EXPECT_FALSE(isShown("pageMessage"));
  EXPECT_TRUE(isShown("pageHeader"));
}

TEST_F(PageTest, ShowsAMonitor) {
  m_bus.monitor().faults().hear("0CFDD633", kStickRightBack);
  show();
  EXPECT_EQ(text("pageTitle"), QString::fromLatin1(kPinA));
  EXPECT_EQ(text("pageType"), QStringLiteral("6032 Universal II"));
  EXPECT_EQ(text("pageAddress"), QStringLiteral("address 80 hex"));
  EXPECT_EQ(text("pageHealth"), QStringLiteral("fine"));
  const auto* dial = find<Dial>("dial");
  EXPECT_TRUE(dial->isVisible());
  EXPECT_NEAR(dial->values().rotation.degrees, 47.3, 1e-9);
  EXPECT_NEAR(dial->values().elevation.degrees, -5.5, 1e-9);
  EXPECT_EQ(dial->values().rotation.limitLow, -30.0);
  EXPECT_EQ(dial->values().elevation.limitHigh, 90.0);
  ASSERT_TRUE(dial->values().elevation.command);
  EXPECT_NEAR(dial->values().elevation.command->speed, 0.4, 1e-9);
  EXPECT_EQ(dial->values().enable, true);
  EXPECT_EQ(text("stopAxis3"), QStringLiteral("Pattern"));
  EXPECT_EQ(lamp("stopPlus5")->state(), Status2::On);
  EXPECT_EQ(lamp("stopPlus5")->accessibleName(), QStringLiteral("Discharge valve, Open stop"));
  EXPECT_EQ(lamp("outputsLamp1")->state(), Status2::On);
  EXPECT_EQ(text("reason1").toStdString(),
            "Commanded right at 50 %: its soft limit on that side is at 45.0°, it stands at 47.3°.");
  EXPECT_EQ(text("reason2"), QStringLiteral("It has no faults, and its messages come in time."));
  EXPECT_TRUE(isShown("stick"));
  EXPECT_TRUE(isShown("faultsFacts"));
  EXPECT_TRUE(isShown("versionsFacts"));
}

TEST_F(PageTest, GreysWhatIsOverdueWhileTimePasses) {
  m_bus.monitor().faults();
  show();
  EXPECT_FALSE(lamp("stopPlus1")->isStale());
  m_bus.pass(300ms);
  show();
  EXPECT_TRUE(lamp("stopPlus1")->isStale());
  EXPECT_TRUE(lamp("outputsLamp1")->isStale());
  EXPECT_TRUE(find<Dial>("dial")->values().rotation.isStale);
  EXPECT_EQ(find<Dial>("dial")->values().enable, std::nullopt);
  EXPECT_EQ(text("pageHealth"), QStringLiteral("late"));
  m_bus.statuses();
  show();
  EXPECT_FALSE(lamp("stopPlus1")->isStale());
  EXPECT_EQ(text("pageHealth"), QStringLiteral("fine"));
}

struct KindCase {
  const char* scene;
  bool dial, stick, stops;
  const char* part;  // that this page has
};
class PageOfKind : public PageTest, public testing::WithParamInterface<KindCase> {};

TEST_P(PageOfKind, HasTheParts) {
  for (const PanelScene& scene : panelScenes()) {
    if (scene.name != GetParam().scene) continue;
    show(scene.view, scene.device);
    settle();
    EXPECT_EQ(isShown("dial"), GetParam().dial);
    EXPECT_EQ(isShown("stick"), GetParam().stick);
    EXPECT_EQ(isShown("stops"), GetParam().stops);
    EXPECT_TRUE(isShown(GetParam().part));
    return;
  }
  FAIL() << "no such scene";
}
INSTANTIATE_TEST_SUITE_P(OfEachKind, PageOfKind,
                         testing::Values(KindCase{"fresh", true, true, true, "outputsLamps"},
                                         KindCase{"forestry", true, true, true, "outputsLamps"},
                                         KindCase{"no_pin", true, true, true, "statusLamps"},
                                         KindCase{"riser", false, false, false, "riserLamps"},
                                         KindCase{"io_module", false, false, false, "inputsLamps"},
                                         KindCase{"joystick", false, true, false, "switchesLamps"},
                                         KindCase{"foreign", false, false, false, "addressFacts"},
                                         KindCase{"heartbeat_only", false, false, false, "nodeFacts"},
                                         KindCase{"gateway_monitor", true, false, true, "nodeFacts"}),
                         [](const auto& row) { return std::string(row.param.scene); });

// From each page to each other: no part of the one before is left over, and every text is there.
TEST_F(PageTest, ChangesFromAnyDeviceToAnyOther) {
  const std::vector<PanelScene> scenes = panelScenes();
  for (const PanelScene& from : scenes) {
    for (const PanelScene& to : scenes) {
      show(from.view, from.device);
      show(to.view, to.device);
      const DevicePageValues& v = m_page.values();
      EXPECT_EQ(v, devicePageOf(to.view, to.device));
      EXPECT_EQ(isShown("dial"), v.isFound && v.dial.has_value()) << from.name << " to " << to.name;
      for (const PageLampGroup& group : v.lamps) {
        EXPECT_TRUE(isShown(qPrintable(group.key + QStringLiteral("Lamps"))))
            << from.name << " to " << to.name;
      }
      int shown = 0;
      for (const QWidget* w : m_page.findChildren<QWidget*>())
        shown += w->objectName().endsWith(QStringLiteral("Lamps")) && w->isVisible();
      EXPECT_EQ(shown, v.isFound ? static_cast<int>(v.lamps.size()) : 0) << from.name << " to " << to.name;
    }
  }
}

// Nothing stands on anything else, and nothing is squeezed below what it needs, at any width.
TEST_F(PageTest, LaysOutWithoutOverlapAtAnySize) {
  for (const QSize size :
       {QSize(1030, 500), QSize(1030, 420), QSize(1584, 900), QSize(700, 600), QSize(400, 700)}) {
    for (const PanelScene& scene : panelScenes()) {
      m_page.resize(size);
      show(scene.view, scene.device);
      settle();
      if (!m_page.values().isFound) continue;
      const auto* content = find<QWidget>("pageContent");
      QList<QRect> taken;
      for (const QWidget* w : content->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (!w->isVisible()) continue;
        for (const QRect& other : taken)
          EXPECT_FALSE(other.intersects(w->geometry()))
              << scene.name << ' ' << size.width() << ' ' << w->objectName().toStdString();
        taken << w->geometry();
        EXPECT_TRUE(content->rect().contains(w->geometry()))
            << scene.name << ' ' << size.width() << ' ' << w->objectName().toStdString();
      }
      for (const QLabel* label : content->findChildren<QLabel*>()) {
        if (!label->isVisible()) continue;
        const int needed =
            label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
        EXPECT_GE(label->height(), needed)
            << scene.name << ' ' << size.width() << ' ' << label->text().toStdString();
      }
      for (const StatusLamp* l : content->findChildren<StatusLamp*>()) {
        if (l->isVisible()) {
          EXPECT_GE(l->height(), 32) << scene.name << ' ' << l->objectName().toStdString();
        }
      }
    }
  }
}

TEST_F(PageTest, MovesNothingWhileValuesChangeTheirWidth) {
  m_bus.monitor();
  show();
  const auto* reasons = find<QWidget>("faultLines");  // keeps its place; its lines come and go
  const auto places = [&] {
    QList<QRect> rects;
    for (const QWidget* w : m_page.findChildren<QWidget*>()) {
      if (w->isVisible() && !reasons->isAncestorOf(w) && !w->objectName().startsWith(QStringLiteral("qt_")))
        rects << QRect(w->mapTo(&m_page, QPoint()), w->size());
    }
    return rects;
  };
  const QList<QRect> before = places();
  m_bus.pass(90min);
  m_bus.monitor("01FFF4FFF4AAAAAE", kOscillating).pass(400ms);
  show();
  EXPECT_EQ(places().size(), before.size());
  const QList<QRect> after = places();
  for (int i = 0; i < std::min(before.size(), after.size()); ++i)
    EXPECT_EQ(before[i].topLeft(), after[i].topLeft()) << i;
}

TEST_F(PageTest, ShowsDialAndStopsWithoutScrollingOnASmallScreen) {
  m_bus.monitor();
  show();
  const auto* scroll = find<QScrollArea>("pageScroll");
  EXPECT_EQ(scroll->verticalScrollBar()->value(), 0);
  for (const char* name : {"dial", "stops", "statusLamps"}) {
    const auto* w = find<QWidget>(name);
    EXPECT_LE(w->mapTo(scroll->viewport(), QPoint(0, w->height())).y(), scroll->viewport()->height()) << name;
  }
  EXPECT_EQ(scroll->horizontalScrollBar()->maximum(), 0);
}

// A page as low as its window may leave it, with a notice and the trace open: the dial comes first.
TEST_F(PageTest, ShowsTheDialAndItsNumbersWithoutScrollingHoweverLowThePageIs) {
  m_bus.monitor();
  for (const Density density : {Density::Desk, Density::Field}) {
    const test::Look look(Theme::Light, density);
    show();
    for (const QSize size : {QSize(1030, 500), QSize(1030, 250), QSize(974, 186), QSize(688, 240),
                             QSize(688, 186), QSize(480, 186)}) {
      m_page.resize(size);
      settle();
      const auto* viewport = find<QScrollArea>("pageScroll")->viewport();
      const auto* dial = find<Dial>("dial");
      const QRect shown(dial->mapTo(viewport, QPoint()), dial->size());
      EXPECT_TRUE(viewport->rect().contains(shown)) << size.width() << 'x' << size.height();
      const DialLayout layout = layOutDial(QRectF(dial->rect()));
      for (const DialViewLayout* view : {&layout.rotation, &layout.elevation}) {
        EXPECT_TRUE(layout.bounds.contains(view->value)) << size.width() << 'x' << size.height();
        EXPECT_TRUE(layout.bounds.contains(view->drawing)) << size.width() << 'x' << size.height();
        EXPECT_GE(view->value.height(), 18) << size.width() << 'x' << size.height();
        EXPECT_GE(view->radius, 30) << size.width() << 'x' << size.height();
      }
    }
  }
}

// With three causes and with none: two lines right under the dial, and nothing below moves.
TEST_F(PageTest, SaysWhatIsWrongRightUnderTheDial) {
  m_bus.monitor();
  show();
  const auto* dial = find<Dial>("dial");
  const auto* lines = find<QWidget>("faultLines");
  const QRect fine = lines->geometry();
  EXPECT_EQ(fine.left(), dial->geometry().left());
  EXPECT_GT(fine.top(), dial->geometry().bottom());
  EXPECT_LE(fine.top(), dial->geometry().bottom() + 9);
  EXPECT_FALSE(isShown("moreReasons"));
  const auto* viewport = find<QScrollArea>("pageScroll")->viewport();
  EXPECT_LE(lines->mapTo(viewport, QPoint(0, lines->height())).y(), viewport->height());
  m_bus.monitor("01FFF4FFF4000000").hear("18EFFF80", "834051");
  show();
  EXPECT_EQ(lines->geometry(), fine);
  EXPECT_EQ(text("reason1"), QStringLiteral("Sensor error: rotation, elevation."));
  EXPECT_TRUE(isShown("reason2"));
  ASSERT_GT(m_page.values().reasons.size(), 2u);
  EXPECT_FALSE(isShown("reason3"));
  auto* more = find<QAbstractButton>("moreReasons");
  EXPECT_TRUE(more->isVisible());
  EXPECT_GE(more->height(), 32);
  QTest::mouseClick(more, Qt::LeftButton);
  settle();
  EXPECT_TRUE(isShown("reason3"));
  EXPECT_GT(lines->height(), fine.height());
  for (std::size_t i = 0; i < m_page.values().reasons.size(); ++i) {
    EXPECT_EQ(text(qPrintable(QStringLiteral("reason%1").arg(i + 1))), m_page.values().reasons[i].text);
  }
  QTest::mouseClick(more, Qt::LeftButton);
  settle();
  EXPECT_EQ(lines->geometry(), fine);
}

TEST_F(PageTest, HasNamesForReaders) {
  for (const PanelScene& scene : panelScenes()) {
    show(scene.view, scene.device);
    for (const StatusLamp* l : m_page.findChildren<StatusLamp*>()) {
      EXPECT_FALSE(l->accessibleName().isEmpty()) << scene.name;
      EXPECT_FALSE(l->objectName().isEmpty()) << scene.name;
    }
  }
}

TEST_F(PageTest, PutsTheLabelBeforeThePin) {
  m_bus.monitor();
  show();
  m_view.labels.set(keyOfA().pin, QStringLiteral("Roof"));
  show();
  EXPECT_EQ(text("pageTitle"), QStringLiteral("Roof"));
  EXPECT_EQ(text("pageType"), QStringLiteral("1032AE100801035 · 6032 Universal II"));
}

TEST_F(PageTest, ElidesWhatHasNoRoomInItsHead) {
  m_bus.monitor();
  show();
  m_page.resize(400, 500);
  settle();
  const auto* type = find<QLabel>("pageType");
  EXPECT_LE(type->fontMetrics().horizontalAdvance(type->text()), type->width());
  EXPECT_EQ(type->toolTip(), QStringLiteral("6032 Universal II"));
  m_page.resize(1030, 500);
  settle();
  EXPECT_EQ(text("pageType"), QStringLiteral("6032 Universal II"));
}

TEST_F(PageTest, HasTheWholePinInItsHeadOrItsTwoEnds) {
  m_bus.monitor();
  for (const Density density : {Density::Desk, Density::Field}) {
    const test::Look look(Theme::Light, density);
    show();
    for (const int width : {320, 400, 480, 560, 700}) {
      m_page.resize(width, 500);
      settle();
      const auto* title = find<QLabel>("pageTitle");
      EXPECT_LE(title->fontMetrics().horizontalAdvance(title->text()), title->width()) << width;
      const bool isWhole = title->text() == QString::fromLatin1(kPinA);
      EXPECT_TRUE(isWhole || (width < 400 && title->text() == QStringLiteral("1032…801035")))
          << width << ' ' << title->text().toStdString();
      EXPECT_EQ(title->toolTip(), QString::fromLatin1(kPinA));
      EXPECT_LE(find<QAbstractButton>("fullButton")->geometry().right(), width) << width;
    }
  }
}

class FullDialTest : public PageTest {
 protected:
  // The page as a part of a window, as the console has it.
  void SetUp() override {
    m_window.resize(900, 600);
    m_page.setParent(&m_window);
    m_page.setGeometry(300, 40, 600, 500);
    m_window.show();
    m_bus.monitor();
    show();
  }
  ~FullDialTest() override { m_page.setParent(nullptr); }
  QWidget m_window;
};

TEST_F(FullDialTest, FillsTheWindowOnADoubleClickAndGoesBackOnEscape) {
  QTest::mouseDClick(find<QWidget>("dial"), Qt::LeftButton);
  FullDial* full = m_page.full();
  ASSERT_NE(full, nullptr);
  EXPECT_EQ(full->parentWidget(), &m_window);
  EXPECT_EQ(full->geometry(), m_window.rect());
  auto* dial = test::child<Dial>(*full);
  EXPECT_NEAR(dial->values().rotation.degrees, 47.3, 1e-9);
  m_window.resize(1000, 700);
  settle();
  EXPECT_EQ(full->geometry(), m_window.rect());
  m_bus.hear("18EFFF80", kNotFitted);
  show();
  EXPECT_EQ(dial->values().rotation.reading, PositionState::NotFitted) << "it goes on with the page";
  QTest::keyClick(full, Qt::Key_Escape);
  EXPECT_EQ(m_page.full(), nullptr);
}

TEST_F(FullDialTest, OpensAndClosesByItsButtons) {
  auto* button = find<QAbstractButton>("fullButton");
  EXPECT_GE(button->height(), 44);
  QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_NE(m_page.full(), nullptr);
  QTest::mouseClick(test::child<QAbstractButton>(*m_page.full(), "fullButton"), Qt::LeftButton);
  EXPECT_EQ(m_page.full(), nullptr);
}

TEST_F(FullDialTest, SaysThatTheDeviceIsNotThereAtTheCursor) {
  m_page.toggleFull();
  ASSERT_NE(m_page.full(), nullptr);
  show(Heard().view(), keyOfA());
  const auto* message = test::child<QLabel>(*m_page.full(), "fullMessage");
  EXPECT_TRUE(message->isVisible());
  show(m_bus.view(), keyOfA());
  EXPECT_FALSE(message->isVisible());
}

TEST_F(FullDialTest, IsOfferedForMonitorsAlone) {
  EXPECT_TRUE(isShown("fullButton"));
  m_bus.hear("18EFFFF0", "8505");
  show(DeviceKey::at(Channel{0}, Address{0xF0}));
  EXPECT_FALSE(isShown("fullButton"));
  m_page.toggleFull();
  EXPECT_EQ(m_page.full(), nullptr);
}

// Two rooms that share nothing write ages; they write them alike.
TEST(Ages, AreWrittenAlikeByTheDialAndByThePanels) {
  for (const Duration age : {Duration(-1s), Duration(0s), Duration(100ms), Duration(9949ms), Duration(9950ms),
                             Duration(99s), Duration(100s), Duration(105s), Duration(99min), Duration(100min),
                             Duration(47h), Duration(48h), Duration(1000h)})
    EXPECT_EQ(ageText(age), briefAge(age)) << age.count();
}

TEST(FactList, HoldsFiguresThatRunBackAndSaysWordsAtOnce) {
  FactList list;
  PageFactGroup group{QStringLiteral("address"), QStringLiteral("Address"), {}};
  const auto say = [&](const char* value) {
    group.facts = {{.label = QStringLiteral("Frames"), .value = QString::fromLatin1(value), .age = {}}};
    list.setGroup(group);
  };
  const auto said = [&] { return test::child<QLabel>(list, "addressFact1")->text(); };
  say("12, now 3 a second");
  EXPECT_EQ(said(), QStringLiteral("12, now 3 a second"));
  say("13, now 3 a second");
  say("14, now 3 a second");
  EXPECT_EQ(said(), QStringLiteral("12, now 3 a second"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return said() == QStringLiteral("14, now 3 a second"); }));
  say("15, now 3 a second");
  say("not heard any more");
  EXPECT_EQ(said(), QStringLiteral("not heard any more"));
}

}  // namespace
}  // namespace deckpipe
