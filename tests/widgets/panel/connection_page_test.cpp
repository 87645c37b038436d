// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/connect/connection_page.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <set>

#include "panel/common/notice_bar.h"
#include "support/child.h"

namespace deckpipe {
namespace {

AdapterOffer offer(const char* name, bool canConnect = true) {
  AdapterOffer made;
  made.plugin = QStringLiteral("socketcan");
  made.interfaceName = made.title = QLatin1String(name);
  made.canConnect = canConnect;
  if (!canConnect) made.command = QStringLiteral("sudo ip link set can0 up");
  return made;
}

struct PageToConnect : testing::Test {
  void SetUp() override {
    page.resize(1366, 640);
    page.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&page));
  }
  void click(const char* name, int which = 0) {
    const auto buttons = page.findChildren<QPushButton*>(QLatin1String(name));
    QTest::mouseClick(buttons.at(which), Qt::LeftButton);
  }
  ConnectionPage page;
};

TEST_F(PageToConnect, ConnectsToTheAdapterThatIsClickedAtTheRateChosen) {
  page.setOffers({{offer("can0"), offer("can1")}});
  page.setBitRate(125'000);
  QCoreApplication::sendPostedEvents();
  QSignalSpy requests(&page, &ConnectionPage::connectRequested);
  QTest::qWait(0);
  for (auto* button : page.findChildren<QPushButton*>(QStringLiteral("adapterConnect"))) {
    if (button->isVisible() && button->accessibleDescription().startsWith(QStringLiteral("can1")))
      QTest::mouseClick(button, Qt::LeftButton);
  }
  ASSERT_EQ(requests.size(), 1);
  EXPECT_EQ(requests[0][1].toString(), QStringLiteral("can1"));
  EXPECT_EQ(requests[0][2].toInt(), 125'000);
}

TEST_F(PageToConnect, CopiesTheCommandThatHelps) {
  page.setOffers({{offer("can0", false)}});
  for (auto* button : page.findChildren<QPushButton*>(QStringLiteral("adapterCopy"))) {
    if (button->isVisible()) QTest::mouseClick(button, Qt::LeftButton);
  }
  EXPECT_EQ(QGuiApplication::clipboard()->text(), QStringLiteral("sudo ip link set can0 up"));
}

TEST_F(PageToConnect, TellsThatARateWasChosenByHand) {
  QSignalSpy chosen(&page, &ConnectionPage::bitRateChosen);
  auto* rates = test::child<QComboBox>(page, "bitRate");
  rates->setFocus();
  QTest::keyClick(rates, Qt::Key_Down);
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), page.bitRate());
}

TEST_F(PageToConnect, ListsRecentLogsAndShowsWhichAreGone) {
  QSignalSpy requests(&page, &ConnectionPage::logRequested);
  page.setRecentLogs({{QStringLiteral("/a/one.log")}, {QStringLiteral("/a/two.log"), true}});
  const auto buttons = page.findChildren<QPushButton*>(QStringLiteral("recentLog"));
  ASSERT_EQ(buttons.size(), 2);
  EXPECT_FALSE(buttons[1]->isEnabled());
  EXPECT_TRUE(buttons[1]->text().contains(QStringLiteral("gone")));
  QTest::qWait(0);
  buttons[0]->click();
  ASSERT_EQ(requests.size(), 1);
  EXPECT_EQ(requests[0][0].toString(), QStringLiteral("/a/one.log"));
}

TEST_F(PageToConnect, ListsEachBitRateOnce) {
  const auto* rates = test::child<QComboBox>(page, "bitRate");
  std::set<int> found;
  for (int i = 0; i < rates->count(); ++i) EXPECT_TRUE(found.insert(rates->itemData(i).toInt()).second) << i;
  EXPECT_TRUE(found.contains(0));
  EXPECT_TRUE(found.contains(125'000));
  EXPECT_TRUE(found.contains(250'000));
}

TEST_F(PageToConnect, PutsVirtualBusesUnderATitleOfTheirOwn) {
  const auto* title = test::child<QWidget>(page, "virtualTitle");
  page.setOffers({{offer("can0"), offer("can1", false)}});
  EXPECT_FALSE(title->isVisible());
  AdapterOffer vcan = offer("vcan0");
  vcan.isVirtual = true;
  for (int i = 0; i < 2; ++i) {
    page.setOffers({{offer("can0"), offer("can1", false), vcan}});
    QCoreApplication::sendPostedEvents();
    QTest::qWait(0);
    EXPECT_TRUE(title->isVisible());
    for (const auto* row : page.findChildren<QWidget*>(QStringLiteral("adapterRow"))) {
      if (!row->isVisible()) continue;
      EXPECT_EQ(row->accessibleName() == QLatin1String("vcan0"), row->y() > title->y())
          << qPrintable(row->accessibleName());
    }
    vcan.state = QStringLiteral("another");
  }
}

TEST_F(PageToConnect, ConnectsToABusAsBefore) {
  page.setRecentLinks(
      {{QStringLiteral("peakcan"), QStringLiteral("usb0"), 125'000, QStringLiteral("PEAK · yesterday")},
       {QStringLiteral("socketcan"), QStringLiteral("can9"), 0, {}, false}});
  const auto buttons = page.findChildren<QPushButton*>(QStringLiteral("recentLink"));
  ASSERT_EQ(buttons.size(), 2);
  EXPECT_TRUE(buttons[0]->text().contains(QStringLiteral("yesterday")));
  EXPECT_FALSE(buttons[1]->isEnabled());
  QSignalSpy requests(&page, &ConnectionPage::connectRequested);
  buttons[0]->click();
  ASSERT_EQ(requests.size(), 1);
  EXPECT_EQ(requests[0][0].toString(), QStringLiteral("peakcan"));
  EXPECT_EQ(requests[0][2].toInt(), 125'000);
}

TEST_F(PageToConnect, SaysFolderTimeAndSizeOfARecentLog) {
  page.setRecentLogs({{QStringLiteral("/a/b&c.log"), false, QStringLiteral("/a · today · 1 MB")}});
  const auto* button = test::child<QPushButton>(page, "recentLog");
  EXPECT_EQ(button->text(), QStringLiteral("b&&c.log\n/a · today · 1 MB"));
}

TEST_F(PageToConnect, SaysThatThereIsNoAdapter) {
  page.setOffers({});
  EXPECT_TRUE(test::child<QWidget>(page, "noAdapters")->isVisible());
  page.setOffers({{offer("can0")}});
  EXPECT_FALSE(test::child<QWidget>(page, "noAdapters")->isVisible());
}

TEST(BarOfNotices, ActsOnAClickAndKeepsItsHeightWithoutWords) {
  NoticeBar bar;
  bar.resize(900, 60);
  EXPECT_TRUE(bar.isHidden());
  Notice notice{Severity::Fault, QStringLiteral("The link is lost.")};
  notice.action = Notice::Action::Reconnect;
  bar.setNotice(notice);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&bar));
  QSignalSpy actions(&bar, &NoticeBar::actionRequested);
  QTest::mouseClick(test::child<QPushButton>(bar, "noticeAction"), Qt::LeftButton);
  EXPECT_EQ(actions.size(), 1);
  const int height = bar.sizeHint().height();
  bar.setNotice({});
  EXPECT_TRUE(bar.isHidden());
  EXPECT_TRUE(bar.sizePolicy().retainSizeWhenHidden());
  EXPECT_EQ(bar.sizeHint().height(), height);
}

TEST(BarOfNotices, UnfoldsWhatHasNoRoomInItsLine) {
  NoticeBar bar;
  bar.resize(900, 40);
  Notice notice{Severity::Fault, QStringLiteral("The link is lost.")};
  bar.setNotice(notice);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&bar));
  auto* more = test::child<QToolButton>(bar, "noticeMore");
  EXPECT_FALSE(more->isVisible());
  bar.resize(100, 40);
  EXPECT_TRUE(more->isVisible()) << "too narrow for the words";
  bar.resize(900, 40);
  EXPECT_FALSE(more->isVisible());
  notice.command = QStringLiteral("sudo ip link set can0 up");
  bar.setNotice(notice);
  EXPECT_TRUE(more->isVisible()) << "the command is told there";
  auto* copy = test::child<QPushButton>(bar, "noticeCopy");
  QTimer::singleShot(0, &bar, [&] {
    EXPECT_TRUE(test::child<QLabel>(bar, "noticeWhole")->isVisible());
    QTest::mouseClick(copy, Qt::LeftButton);
    more->menu()->close();
  });
  QTest::mouseClick(more, Qt::LeftButton);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), notice.command);
  EXPECT_FALSE(copy->isVisible());
}

}  // namespace
}  // namespace deckpipe
