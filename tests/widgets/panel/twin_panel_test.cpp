// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/twin_panel.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QTest>

#include "support/child.h"
#include "widgets/panel/twin_samples.h"

namespace deckpipe {
namespace {

struct TwinPanelTest : testing::Test {
  TwinPanel panel;
  std::vector<TwinIntent> intents;

  TwinPanelTest() {
    QObject::connect(&panel, &TwinPanel::twinIntended,
                     [this](const TwinIntent& intent) { intents.push_back(intent); });
    panel.resize(320, 700);
    panel.show();
  }
  template <typename T>
  T* child(const char* name) const {
    return test::child<T>(panel, name);
  }
  void click(const char* name) {
    auto* button = child<QAbstractButton>(name);
    QTest::mouseClick(button, Qt::LeftButton, {}, {10, button->height() / 2});
  }
  void choose(int device) { child<QComboBox>("twinDevices")->setCurrentIndex(device); }
  QString state() const { return child<QLabel>("twinState")->text(); }
};

TEST_F(TwinPanelTest, SaysThatNothingRunsUntilSomethingDoes) {
  EXPECT_TRUE(child<QLabel>("noTwin")->isVisible());
  panel.setStatus(test::twinSample());
  EXPECT_FALSE(child<QLabel>("noTwin")->isVisible());
  panel.setStatus({});
  EXPECT_TRUE(child<QLabel>("noTwin")->isVisible());
}

TEST_F(TwinPanelTest, NamesTheDevicesAndTheirStates) {
  panel.setStatus(test::twinSample());
  const auto* devices = child<QComboBox>("twinDevices");
  ASSERT_EQ(devices->count(), 4);
  EXPECT_EQ(devices->itemText(0), QStringLiteral("6032 Universal II, 1032AE100801035"));
  EXPECT_EQ(devices->itemText(2), QStringLiteral("6039 without a PIN"));
  EXPECT_EQ(state(), QStringLiteral("On the bus at 80 hex"));
  choose(1);
  EXPECT_EQ(state(), QStringLiteral("No power"));
  choose(2);
  EXPECT_EQ(state(), QStringLiteral("Powered, without an address"));
}

TEST_F(TwinPanelTest, ButtonsIntentForTheDeviceThatIsShown) {
  panel.setStatus(test::twinSample());
  click("twinPowerOff");
  click("twinReset");
  click("twinPowerOn");  // it is on: nothing to press
  choose(1);
  click("twinPowerOn");
  click("twinPowerOff");
  EXPECT_EQ(intents, (std::vector<TwinIntent>{
                         {0, TwinButton::PowerOff}, {0, TwinButton::Reset}, {1, TwinButton::PowerOn}}));
}

TEST_F(TwinPanelTest, ATickIsAIntentAndShownOnceTheTwinSaysSo) {
  panel.setStatus(test::twinSample());
  click("twinFault_silent");
  EXPECT_EQ(intents, (std::vector<TwinIntent>{{0, TwinSwitch{TwinFault::Silent, true}}}));
  EXPECT_FALSE(child<QCheckBox>("twinFault_silent")->isChecked());
  panel.setStatus(test::twinSample({TwinFault::Silent, TwinFault::AnswersLate}));
  EXPECT_TRUE(child<QCheckBox>("twinFault_silent")->isChecked());
  QTest::keyClick(child<QCheckBox>("twinFault_answersLate"), Qt::Key_Space);
  EXPECT_EQ(intents.back(), (TwinIntent{0, TwinSwitch{TwinFault::AnswersLate, false}}));
  click("twinAllWell");
  EXPECT_EQ(intents.back(), (TwinIntent{0, TwinAllWell{}}));
}

TEST_F(TwinPanelTest, SaysTheNumbersThatTheTwinGoesBy) {
  EXPECT_EQ(child<QCheckBox>("twinFault_answersLost")->text(), QStringLiteral("2 of 3 lost"));
  EXPECT_EQ(child<QCheckBox>("twinFault_acksLate")->text(), QStringLiteral("Acknowledgements 400 ms late"));
  EXPECT_EQ(child<QCheckBox>("twinFault_vanishesInTransfer")->text(),
            QStringLiteral("No power after 50 packets, for 3 s"));
}

TEST_F(TwinPanelTest, ShowsWhatTheTwinSaysAndIntentsNothingByItself) {
  panel.setStatus(test::twinSample({TwinFault::AcksLost}));
  EXPECT_TRUE(child<QCheckBox>("twinFault_acksLost")->isChecked());
  EXPECT_TRUE(child<QAbstractButton>("twinAllWell")->isEnabled());
  panel.setStatus(test::twinSample({}));
  EXPECT_FALSE(child<QCheckBox>("twinFault_acksLost")->isChecked());
  EXPECT_FALSE(child<QAbstractButton>("twinAllWell")->isEnabled());
  EXPECT_TRUE(intents.empty());
}

TEST_F(TwinPanelTest, OffersOnlyWhatADeviceCanDoWrong) {
  panel.setStatus(test::twinSample());
  EXPECT_TRUE(child<QCheckBox>("twinFault_notFitted")->isVisible());
  choose(3);
  EXPECT_FALSE(child<QCheckBox>("twinFault_notFitted")->isVisible());
  EXPECT_TRUE(child<QCheckBox>("twinFault_acksLost")->isVisible());
}

TEST_F(TwinPanelTest, KeepsTheDeviceThatWasChosen) {
  panel.setStatus(test::twinSample());
  choose(3);
  panel.setStatus(test::twinSample({TwinFault::Silent}));
  EXPECT_EQ(child<QComboBox>("twinDevices")->currentIndex(), 3);
}

TEST_F(TwinPanelTest, EveryControlHasANameAndIsLargeEnoughToHit) {
  panel.setStatus(test::twinSample());
  for (const auto* button : panel.findChildren<QAbstractButton*>()) {
    if (!button->isVisible()) continue;
    EXPECT_FALSE(button->objectName().isEmpty());
    EXPECT_FALSE(button->accessibleName().isEmpty()) << button->objectName().toStdString();
    EXPECT_GE(button->height(), 32) << button->objectName().toStdString();
  }
}

TEST_F(TwinPanelTest, NothingIsCutOffAtItsSmallestWidth) {
  panel.setStatus(test::twinSample());
  panel.resize(panel.minimumSizeHint());
  const auto* list = child<QScrollArea>("twinFaults");
  for (const auto* box : panel.findChildren<QCheckBox*>())
    EXPECT_LE(box->sizeHint().width() + 16, list->viewport()->width()) << box->text().toStdString();
}

}  // namespace
}  // namespace deckpipe
