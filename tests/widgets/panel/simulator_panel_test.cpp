// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/simulator_panel.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QTest>

#include "support/child.h"
#include "widgets/panel/simulator_samples.h"

namespace deckpipe {
namespace {

struct SimulatorPanelTest : testing::Test {
  SimulatorPanel panel;
  std::vector<SimulatorIntent> intents;

  SimulatorPanelTest() {
    QObject::connect(&panel, &SimulatorPanel::simulatorIntended,
                     [this](const SimulatorIntent& intent) { intents.push_back(intent); });
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
  void choose(int device) { child<QComboBox>("simulatorDevices")->setCurrentIndex(device); }
  QString state() const { return child<QLabel>("simulatorState")->text(); }
};

TEST_F(SimulatorPanelTest, SaysThatNothingRunsUntilSomethingDoes) {
  EXPECT_TRUE(child<QLabel>("noSimulator")->isVisible());
  panel.setStatus(test::simulatorSample());
  EXPECT_FALSE(child<QLabel>("noSimulator")->isVisible());
  panel.setStatus({});
  EXPECT_TRUE(child<QLabel>("noSimulator")->isVisible());
}

TEST_F(SimulatorPanelTest, NamesTheDevicesAndTheirStates) {
  panel.setStatus(test::simulatorSample());
  const auto* devices = child<QComboBox>("simulatorDevices");
  ASSERT_EQ(devices->count(), 4);
  EXPECT_EQ(devices->itemText(0), QStringLiteral("6032 Universal II, 1032AE100801035"));
  EXPECT_EQ(devices->itemText(2), QStringLiteral("6039 without a PIN"));
  EXPECT_EQ(state(), QStringLiteral("On the bus at 80 hex"));
  choose(1);
  EXPECT_EQ(state(), QStringLiteral("No power"));
  choose(2);
  EXPECT_EQ(state(), QStringLiteral("Powered, without an address"));
}

TEST_F(SimulatorPanelTest, ButtonsIntentForTheDeviceThatIsShown) {
  panel.setStatus(test::simulatorSample());
  click("simulatorPowerOff");
  click("simulatorReset");
  click("simulatorPowerOn");  // it is on: nothing to press
  choose(1);
  click("simulatorPowerOn");
  click("simulatorPowerOff");
  EXPECT_EQ(intents,
            (std::vector<SimulatorIntent>{
                {0, SimulatorButton::PowerOff}, {0, SimulatorButton::Reset}, {1, SimulatorButton::PowerOn}}));
}

TEST_F(SimulatorPanelTest, ATickIsAnIntentAndShownOnceTheSimulatorSaysSo) {
  panel.setStatus(test::simulatorSample());
  click("simulatorFault_silent");
  EXPECT_EQ(intents, (std::vector<SimulatorIntent>{{0, SimulatorSwitch{SimulatedFault::Silent, true}}}));
  EXPECT_FALSE(child<QCheckBox>("simulatorFault_silent")->isChecked());
  panel.setStatus(test::simulatorSample({SimulatedFault::Silent, SimulatedFault::AnswersLate}));
  EXPECT_TRUE(child<QCheckBox>("simulatorFault_silent")->isChecked());
  QTest::keyClick(child<QCheckBox>("simulatorFault_answersLate"), Qt::Key_Space);
  EXPECT_EQ(intents.back(), (SimulatorIntent{0, SimulatorSwitch{SimulatedFault::AnswersLate, false}}));
  click("simulatorAllWell");
  EXPECT_EQ(intents.back(), (SimulatorIntent{0, SimulatorAllWell{}}));
}

TEST_F(SimulatorPanelTest, SaysTheNumbersThatTheSimulatorGoesBy) {
  EXPECT_EQ(child<QCheckBox>("simulatorFault_answersLost")->text(), QStringLiteral("2 of 3 lost"));
  EXPECT_EQ(child<QCheckBox>("simulatorFault_acksLate")->text(),
            QStringLiteral("Acknowledgements 400 ms late"));
  EXPECT_EQ(child<QCheckBox>("simulatorFault_vanishesInTransfer")->text(),
            QStringLiteral("No power after 50 packets, for 3 s"));
}

TEST_F(SimulatorPanelTest, ShowsWhatTheSimulatorSaysAndIntendsNothingByItself) {
  panel.setStatus(test::simulatorSample({SimulatedFault::AcksLost}));
  EXPECT_TRUE(child<QCheckBox>("simulatorFault_acksLost")->isChecked());
  EXPECT_TRUE(child<QAbstractButton>("simulatorAllWell")->isEnabled());
  panel.setStatus(test::simulatorSample({}));
  EXPECT_FALSE(child<QCheckBox>("simulatorFault_acksLost")->isChecked());
  EXPECT_FALSE(child<QAbstractButton>("simulatorAllWell")->isEnabled());
  EXPECT_TRUE(intents.empty());
}

TEST_F(SimulatorPanelTest, OffersOnlyWhatADeviceCanDoWrong) {
  panel.setStatus(test::simulatorSample());
  EXPECT_TRUE(child<QCheckBox>("simulatorFault_notFitted")->isVisible());
  choose(3);
  EXPECT_FALSE(child<QCheckBox>("simulatorFault_notFitted")->isVisible());
  EXPECT_TRUE(child<QCheckBox>("simulatorFault_acksLost")->isVisible());
}

TEST_F(SimulatorPanelTest, KeepsTheDeviceThatWasChosen) {
  panel.setStatus(test::simulatorSample());
  choose(3);
  panel.setStatus(test::simulatorSample({SimulatedFault::Silent}));
  EXPECT_EQ(child<QComboBox>("simulatorDevices")->currentIndex(), 3);
}

TEST_F(SimulatorPanelTest, EveryControlHasANameAndIsLargeEnoughToHit) {
  panel.setStatus(test::simulatorSample());
  for (const auto* button : panel.findChildren<QAbstractButton*>()) {
    if (!button->isVisible()) continue;
    EXPECT_FALSE(button->objectName().isEmpty());
    EXPECT_FALSE(button->accessibleName().isEmpty()) << button->objectName().toStdString();
    EXPECT_GE(button->height(), 32) << button->objectName().toStdString();
  }
}

TEST_F(SimulatorPanelTest, NothingIsCutOffAtTheWidthThatItLikes) {
  panel.setStatus(test::simulatorSample());
  panel.resize(panel.sizeHint());
  const auto* list = child<QScrollArea>("simulatorFaults");
  for (const auto* box : panel.findChildren<QCheckBox*>())
    EXPECT_LE(box->sizeHint().width() + 16, list->viewport()->width()) << box->text().toStdString();
}

}  // namespace
}  // namespace deckpipe
