// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/overview_of.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "widgets/model/heard.h"

namespace deckpipe {
namespace {

using namespace test;

TEST(OverviewOf, ListsMonitorsAloneInOrderOfAppearance) {
  Heard bus;
  bus.hear("0CFDD633", kStickRightBack)
      .hear("724", "05")
      .hear("1A5", kPosition)
      .monitor()
      .hear("18EFFF91", announcementOf("1033AB000000001"))
      .hear("18EFFF90", kNotFitted);
  const std::vector<OverviewMonitor> monitors = overviewOf(bus.view());
  ASSERT_EQ(monitors.size(), 3u);
  EXPECT_EQ(monitors[0].title, QStringLiteral("Node 25"));
  EXPECT_EQ(monitors[1].key, keyOfA());
  EXPECT_EQ(monitors[1].detail, QStringLiteral("6032 Universal II · 80 hex"));
  EXPECT_EQ(monitors[1].dial.rotation.degrees, 47.3);
  ASSERT_TRUE(monitors[1].dial.rotation.command);
  EXPECT_EQ(monitors[1].dial.rotation.command->source, QStringLiteral("Joystick 33"));
  EXPECT_EQ(monitors[2].title, QStringLiteral("No PIN, address 90"));
  EXPECT_EQ(monitors[2].dial.rotation.reading, PositionState::NotFitted);
}

TEST(OverviewOf, NamesTheStopsThatADialDoesNotShow) {
  Heard bus;
  bus.monitor("011D940371004141");  // axis 3 + and axis 4 -
  EXPECT_EQ(overviewOf(bus.view())[0].stops,
            QStringLiteral("Pattern Stream, Axis 4 Low | Stow, Discharge valve Open"));
  EXPECT_FALSE(overviewOf(bus.view())[0].areStopsStale);
  bus.pass(300ms);
  EXPECT_TRUE(overviewOf(bus.view())[0].areStopsStale);
  EXPECT_EQ(overviewOf(bus.view())[0].health.worst(), HealthCause::Late);
}

TEST(OverviewOf, DrawsNothingAsCurrentWhileTheLinkIsDown) {
  Heard bus;
  bus.monitor("011D940371004141").hear("0CFDD633", kStickRightBack);
  bus.note({.time = bus.now(), .value = note::LinkDown{}});
  EXPECT_TRUE(overviewOf(bus.view())[0].dial.rotation.command);
  bus.pass(50ms);
  const OverviewMonitor monitor = overviewOf(bus.view())[0];
  EXPECT_EQ(monitor.age, Age::linkDown(50ms));
  EXPECT_TRUE(monitor.areStopsStale);
  EXPECT_TRUE(monitor.dial.rotation.isStale && monitor.dial.elevation.isStale);
  EXPECT_FALSE(monitor.dial.rotation.command);
  EXPECT_FALSE(monitor.dial.enable);
}

std::string announcementOfMonitor(int i) {
  char pin[24];
  std::snprintf(pin, sizeof pin, "1032AE%09d", i);
  return announcementOf(pin);
}

// Thirty that are fine, but for the fourth (disabled), the seventh and the twentieth (faults).
Heard thirtyMonitors() {
  Heard bus;
  for (int i = 0; i < 30; ++i) {
    char from[16];
    std::snprintf(from, sizeof from, "18EFFF%02X", 0x80u + static_cast<unsigned>(i));
    const std::string answer = "18EFF9" + std::string(from + 6), ask = "18EF" + std::string(from + 6) + "F9";
    bus.hear(from, announcementOfMonitor(i))
        .hear(from, i == 19 ? kSensorError : kPosition)
        .hear(from, kRotationLimits)
        .hear(from, kElevationLimits)
        .hear(from, i == 3 ? "834051" : kOutputs)
        .hear(ask, "02")
        .hear(answer, i == 6 ? "02002000000000" : "02000000000000");
  }
  return bus;
}

TEST(OverviewOf, PutsMonitorsInTroubleFirstTheGravestBeforeTheOthers) {
  const std::vector<OverviewMonitor> monitors = overviewOf(thirtyMonitors().view());
  ASSERT_EQ(monitors.size(), 30u);
  EXPECT_EQ(monitors[0].title, QStringLiteral("1032AE000000006"));
  EXPECT_EQ(monitors[0].trouble, QStringLiteral("It answered: Internal fuse."));
  EXPECT_EQ(monitors[1].title, QStringLiteral("1032AE000000019"));
  EXPECT_EQ(monitors[2].title, QStringLiteral("1032AE000000003"));
  EXPECT_EQ(monitors[2].trouble, QStringLiteral("Enable is off: it cannot move."));
  for (int i = 3; i < 30; ++i) EXPECT_TRUE(monitors[static_cast<std::size_t>(i)].trouble.isEmpty()) << i;
  EXPECT_EQ(monitors[3].title, QStringLiteral("1032AE000000000")) << "the others in order of appearance";
  EXPECT_EQ(monitors[29].title, QStringLiteral("1032AE000000029"));
}

TEST(OverviewOf, CountsEachMonitorByItsWorstTrouble) {
  Heard bus = thirtyMonitors();
  EXPECT_EQ(overviewSummary(overviewOf(bus.view())),
            QStringLiteral("30 monitor(s): 2 fault(s), 1 disabled, 27 fine"));
  bus.pass(5s);
  EXPECT_EQ(overviewSummary(overviewOf(bus.view())), QStringLiteral("30 monitor(s): 30 silent"));
  Heard one;
  one.monitor();
  EXPECT_EQ(overviewSummary(overviewOf(one.view())), QStringLiteral("1 monitor(s): 1 not asked"));
}

TEST(OverviewOf, PutsTheLabelBeforeThePin) {
  Heard bus;
  bus.monitor();
  DeviceLabels labels;
  labels.set(keyOfA().pin, QStringLiteral("Roof"));
  const OverviewMonitor monitor = overviewOf(bus.view(), labels)[0];
  EXPECT_EQ(monitor.title, QStringLiteral("Roof"));
  EXPECT_EQ(monitor.identity, QStringLiteral("1032AE100801035"));
  EXPECT_EQ(monitor.detail, QStringLiteral("6032 Universal II · 80 hex"));
}

TEST(OverviewOf, IsEmptyWithoutAState) { EXPECT_TRUE(overviewOf({}).empty()); }

}  // namespace
}  // namespace deckpipe
