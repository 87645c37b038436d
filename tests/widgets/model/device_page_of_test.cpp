// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_page_values.h"

#include <gtest/gtest.h>

#include <QRegularExpression>
#include <functional>

#include "model/page_sources.h"
#include "support/logs.h"
#include "text/health_text.h"
#include "widgets/model/heard.h"

namespace deckpipe {
namespace {

using namespace test;
using How = note::OwnAddress::How;

DevicePageValues pageOf(const Heard& bus, const DeviceKey& key = keyOfA()) {
  return devicePageOf(bus.view(), key);
}
DeviceKey addressKey(int address) {
  return DeviceKey::at(Channel{0}, Address{static_cast<std::uint8_t>(address)});
}
DeviceKey nodeKey(int node) { return DeviceKey::at(Channel{0}, NodeId{static_cast<std::uint8_t>(node)}); }

const PageLampGroup* groupOf(const DevicePageValues& page, const char* key) {
  for (const PageLampGroup& group : page.lamps) {
    if (group.key == QLatin1String(key)) return &group;
  }
  return nullptr;
}
std::optional<Status2> lamp(const DevicePageValues& page, const char* group, const char* label) {
  if (const PageLampGroup* lamps = groupOf(page, group)) {
    for (const PageLamp& l : lamps->lamps) {
      if (l.label == QLatin1String(label)) return l.state;
    }
  }
  ADD_FAILURE() << "no lamp " << group << ' ' << label;
  return {};
}
PageFact fact(const DevicePageValues& page, const char* label) {
  for (const PageFactGroup& group : page.facts) {
    for (const PageFact& f : group.facts) {
      if (f.label == QLatin1String(label)) return f;
    }
  }
  ADD_FAILURE() << "no fact " << label;
  return {};
}

// A monitor with everything it sends, that a joystick moves, on a link that goes down.
Heard linkThatGoesDown() {
  Heard bus;
  bus.note({.value = note::LinkUp{}})
      .monitor()
      .faults()
      .pass(50ms)
      .statuses()
      .hear("0CFDD633", kStickRightBack);
  bus.pass(10ms).note({.time = bus.now(), .value = note::LinkDown{}});
  return bus;
}

TEST(DevicePageOf, ShowsTheLastStateWhereARecordingEnds) {
  const DevicePageValues page = pageOf(linkThatGoesDown());
  EXPECT_FALSE(page.dial->rotation.isStale);
  EXPECT_EQ(page.dial->rotation.age, Age::ago(10ms));
  EXPECT_EQ(page.dial->enable, true);
  EXPECT_TRUE(page.dial->rotation.command);
}

TEST(DevicePageOf, DrawsNothingAsCurrentWhileTheLinkIsDown) {
  const Heard bus = linkThatGoesDown().pass(4s);
  const DevicePageValues page = pageOf(bus);
  const Age down = Age::linkDown(4s);
  EXPECT_EQ(page.age, down);
  for (const DialAxis& axis : {page.dial->rotation, page.dial->elevation}) {
    EXPECT_TRUE(axis.isStale && axis.areLimitsStale);
    EXPECT_EQ(axis.age, down);
    EXPECT_FALSE(axis.command);
  }
  EXPECT_FALSE(page.dial->enable || page.dial->stowed);
  EXPECT_TRUE(page.stops.isStale);
  EXPECT_EQ(page.stops.age, down);
  for (const PageLampGroup& group : page.lamps) {
    EXPECT_TRUE(group.isStale) << group.key.toStdString();
    EXPECT_EQ(group.age, down) << group.key.toStdString();
  }
  EXPECT_EQ(fact(page, "Fault bits").value, QStringLiteral("none set\nasked 4.0 s ago, link down since"));
  EXPECT_EQ(fact(page, "Fault bits").tone, Severity::Unknown);

  const DevicePageValues stick = pageOf(bus, addressKey(0x33));
  ASSERT_EQ(stick.sticks.size(), 1u);
  EXPECT_TRUE(stick.sticks[0].isStale);
  EXPECT_EQ(stick.sticks[0].age, down);
  for (const PageLampGroup& group : stick.lamps) EXPECT_TRUE(group.isStale) << group.key.toStdString();
  for (const char* label : {"Sending", "Rotation", "Elevation"}) {
    EXPECT_EQ(fact(stick, label).value, QStringLiteral("not known, the link is down")) << label;
    EXPECT_EQ(fact(stick, label).tone, Severity::Unknown) << label;
  }
}

TEST(DevicePageOf, DrawsWhatIsOlderThanALostLinkAsOldUntilItIsHeardAgain) {
  Heard bus = linkThatGoesDown().pass(4s);
  bus.note({.time = bus.now(), .value = note::LinkUp{}}).pass(20ms);
  EXPECT_TRUE(pageOf(bus).dial->rotation.isStale);
  EXPECT_FALSE(pageOf(bus).dial->rotation.command);
  EXPECT_FALSE(pageOf(bus).dial->enable);
  bus.statuses().hear("0CFDD633", kStickRightBack);
  EXPECT_FALSE(pageOf(bus).dial->rotation.isStale);
  EXPECT_TRUE(pageOf(bus).dial->rotation.command);
  EXPECT_EQ(pageOf(bus).dial->enable, true);
}

TEST(DevicePageOf, SaysThatNodesAreOldBehindALinkThatIsDown) {
  Heard bus;
  bus.note({.value = note::LinkUp{}}).hear("1A4", "011D940371000041").hear("724", "05");
  bus.hear("224", "107D046400100000")
      .pass(10ms)
      .note({.time = bus.now(), .value = note::LinkDown{}})
      .pass(150ms);
  const DevicePageValues page = pageOf(bus, nodeKey(0x24));
  EXPECT_EQ(fact(page, "NMT state").tone, Severity::Unknown);
  ASSERT_TRUE(page.dial);
  EXPECT_TRUE(page.dial->rotation.isStale);
  EXPECT_FALSE(page.dial->rotation.command);
}

TEST(DevicePageOf, HasNoAgesWhereTheLogHasNoTimes) {
  const auto log = test::logOfText(
      "can0  18EEFF80   [8]  0B 1A C2 28 00 42 00 90\n"
      "can0  18EFFF80   [8]  FF 83 15 02 06 02 1A 0B\n"
      "can0  18EFFF80   [8]  01 1D 94 03 71 00 00 41\n"
      "can0  18EFFF80   [3]  83 C0 51\n"
      "can0  18EF80F9   [1]  02\n"
      "can0  18EFF980   [7]  02 00 00 00 00 00 00\n"
      "can0  0CFDD633   [8]  01 00 01 00 00 00 00 00\n");
  LogView view = test::viewOf(log);
  view.state = std::make_shared<State>(log->keyframes.at(view.cursor));
  for (const DeviceKey& key : {keyOfA(), addressKey(0x33)}) {
    const DevicePageValues page = devicePageOf(view, key);
    ASSERT_TRUE(page.isFound);
    EXPECT_EQ(page.age, Age{Age::Kind::NoTimes});
    if (page.dial) {
      EXPECT_EQ(page.dial->rotation.age, Age{Age::Kind::NoTimes});
    }
    EXPECT_FALSE(page.stops.age.isTimed());
    for (const PageLampGroup& group : page.lamps)
      EXPECT_FALSE(group.age.isTimed()) << group.key.toStdString();
    for (const PageStick& stick : page.sticks) EXPECT_EQ(stick.age, Age{Age::Kind::NoTimes});
    for (const PageFactGroup& group : page.facts) {
      for (const PageFact& f : group.facts) {
        EXPECT_FALSE(f.age) << f.label.toStdString();
        EXPECT_FALSE(f.value.contains(QRegularExpression(QStringLiteral("\\d m?s\\b"))))
            << f.value.toStdString();
      }
    }
  }
}

TEST(DevicePageOf, GivesAMonitorItsDialFromFeedback) {
  Heard bus;
  bus.monitor().pass(50ms);
  const DevicePageValues page = pageOf(bus);
  ASSERT_TRUE(page.isFound);
  EXPECT_EQ(page.title, QString::fromLatin1(kPinA));
  EXPECT_EQ(page.type, QStringLiteral("6032 Universal II"));
  EXPECT_EQ(page.address, QStringLiteral("address 80 hex"));
  EXPECT_EQ(page.age, Age::ago(50ms));
  ASSERT_TRUE(page.dial);
  const DialAxis& rotation = page.dial->rotation;
  EXPECT_EQ(rotation.reading, PositionState::Ok);
  EXPECT_EQ(rotation.degrees, 47.3);
  EXPECT_EQ(rotation.age, Age::ago(50ms));
  EXPECT_FALSE(rotation.isStale);
  EXPECT_EQ(rotation.limitLow, -30);
  EXPECT_EQ(rotation.limitHigh, 45);
  EXPECT_FALSE(rotation.isOscillating);
  EXPECT_EQ(page.dial->elevation.reading, PositionState::Ok);
  EXPECT_EQ(page.dial->elevation.degrees, -5.5);
  EXPECT_EQ(page.dial->elevation.limitHigh, 90);
  EXPECT_EQ(page.dial->enable, true);
  EXPECT_EQ(page.dial->stowed, false);
  EXPECT_FALSE(rotation.command);
}

TEST(DevicePageOf, MakesEachPartStaleByItsOwnPeriod) {
  Heard bus;
  bus.monitor().pass(200ms).hear("18EFFF80", kPosition).pass(100ms);
  DevicePageValues page = pageOf(bus);
  EXPECT_FALSE(page.dial->rotation.isStale);
  EXPECT_TRUE(page.dial->rotation.areLimitsStale);
  EXPECT_TRUE(page.dial->elevation.areLimitsStale);
  EXPECT_FALSE(page.stops.isStale);
  EXPECT_TRUE(groupOf(page, "outputs")->isStale);
  EXPECT_EQ(groupOf(page, "outputs")->age, Age::ago(300ms));
  bus.pass(200ms);
  page = pageOf(bus);
  EXPECT_TRUE(page.dial->rotation.isStale);
  EXPECT_TRUE(page.stops.isStale);
  EXPECT_EQ(page.dial->rotation.degrees, 47.3) << "kept, but as old";
}

TEST(DevicePageOf, KnowsNothingOfEnableOnceOutputsAreStaleOrNeverCame) {
  Heard bus;
  bus.monitor().pass(299ms);
  EXPECT_EQ(pageOf(bus).dial->enable, true);
  bus.pass(1ms);
  EXPECT_EQ(pageOf(bus).dial->enable, std::nullopt);
  EXPECT_EQ(pageOf(bus).dial->stowed, std::nullopt);
  Heard other;
  other.hear("18EFFF90", kPosition);
  EXPECT_EQ(pageOf(other, addressKey(0x90)).dial->enable, std::nullopt);
}

struct ReadingCase {
  const char* name;
  const char* frame;
  PositionState state;
};
class Readings : public testing::TestWithParam<ReadingCase> {};
TEST_P(Readings, ComeThroughAsTheControllerSaidThem) {
  Heard bus;
  bus.monitor(GetParam().frame);
  const DevicePageValues page = pageOf(bus);
  ASSERT_TRUE(page.dial && page.dial->rotation.reading);
  EXPECT_EQ(page.dial->rotation.reading, GetParam().state);
}
INSTANTIATE_TEST_SUITE_P(OfTheSensor, Readings,
                         testing::Values(ReadingCase{"Ok", kPosition, PositionState::Ok},
                                         ReadingCase{"SensorError", kSensorError, PositionState::SensorError},
                                         ReadingCase{"NotFitted", kNotFitted, PositionState::NotFitted},
                                         ReadingCase{"Invalid", "0112350000000000", PositionState::Invalid}),
                         [](const auto& row) { return std::string(row.param.name); });

struct CommandCase {
  const char* name;
  std::function<void(Heard&)> story;
  double rotation;
  const char* rotationBy;
  double elevation;
  const char* elevationBy;
};
class Commands : public testing::TestWithParam<CommandCase> {};
TEST_P(Commands, AreOfTheHighestSourceThatDeflectsTheAxis) {
  Heard bus;
  bus.monitor();
  GetParam().story(bus);
  const DevicePageValues page = pageOf(bus);
  const auto check = [](const std::optional<DialAxis::Command>& command, double speed, const char* by) {
    EXPECT_EQ(command.has_value(), by[0] != '\0');
    if (!command) return;
    EXPECT_NEAR(command->speed, speed, 1e-9);
    EXPECT_EQ(command->source.toStdString(), by);
  };
  check(page.dial->rotation.command, GetParam().rotation, GetParam().rotationBy);
  check(page.dial->elevation.command, GetParam().elevation, GetParam().elevationBy);
}
INSTANTIATE_TEST_SUITE_P(
    OfJoysticks, Commands,
    testing::Values(
        CommandCase{"Nobody", [](Heard&) {}, 0, "", 0, ""},
        CommandCase{"Resting", [](Heard& b) { b.hear("0CFDD633", kRestingStick); }, 0, "", 0, ""},
        CommandCase{"BackIsUp", [](Heard& b) { b.hear("0CFDD635", kStickRightBack); }, 0.5, "Joystick 35",
                    0.4, "Joystick 35"},
        CommandCase{"RestingSourceStopsNobody",
                    [](Heard& b) { b.hear("0CFDD633", kRestingStick).hear("0CFDD638", kStickRightBack); },
                    0.5, "Joystick 38", 0.4, "Joystick 38"},
        CommandCase{"AxisByAxis",
                    [](Heard& b) { b.hear("0CFDD638", kStickRightBack).hear("0CFDD634", kStickLeft); }, -1.0,
                    "Joystick 34", 0.4, "Joystick 38"},
        CommandCase{"OtherSourcesAreNotListenedTo", [](Heard& b) { b.hear("0CFDD640", kStickRightBack); }, 0,
                    "", 0, ""},
        CommandCase{"ForgottenAfter200Milliseconds",
                    [](Heard& b) { b.hear("0CFDD633", kStickRightBack).pass(200ms); }, 0, "", 0, ""},
        CommandCase{"HeldUpTo200Milliseconds",
                    [](Heard& b) { b.hear("0CFDD633", kStickRightBack).pass(199ms); }, 0.5, "Joystick 33",
                    0.4, "Joystick 33"},
        CommandCase{"OtherChannel", [](Heard& b) { b.hear("0CFDD633", kStickRightBack, 1); }, 0, "", 0, ""}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(DevicePageOf, TakesANodesCommandFromTheGatewayWhileItIsFresh) {
  Heard bus;
  bus.hear("724", "05").hear("1A4", kPosition).hear("224", kStickRightBack).hear("0CFDD633", kStickLeft);
  DevicePageValues page = pageOf(bus, nodeKey(0x24));
  ASSERT_TRUE(page.dial);
  ASSERT_TRUE(page.dial->rotation.command);
  EXPECT_EQ(page.dial->rotation.command->source, QStringLiteral("Gateway joystick"));
  EXPECT_NEAR(page.dial->rotation.command->speed, 0.5, 1e-9);
  bus.pass(200ms);
  EXPECT_FALSE(pageOf(bus, nodeKey(0x24)).dial->rotation.command);
}

TEST(DevicePageOf, ShowsStopsInTheWordsOfTheType) {
  Heard bus;
  bus.monitor("011D940371004141");  // axis 3 + and axis 4 -
  const PageStops stops = pageOf(bus).stops;
  ASSERT_EQ(stops.axes.size(), 5u);
  EXPECT_EQ(stops.axes[2].axis, QStringLiteral("Pattern"));
  EXPECT_EQ(stops.axes[2].plus.label, QStringLiteral("Stream"));
  EXPECT_EQ(stops.axes[4].minus.label, QStringLiteral("Close"));
  EXPECT_EQ(stops.axes[4].minus.spoken, QStringLiteral("Discharge valve, Close stop"));
  EXPECT_EQ(stops.axes[2].plus.state, Status2::On);
  EXPECT_EQ(stops.axes[2].minus.state, Status2::Off);
  EXPECT_EQ(stops.axes[3].minus.state, Status2::On);
}

TEST(DevicePageOf, ShowsOutputsErrorAndCalibration) {
  Heard bus;
  bus.monitor();
  const DevicePageValues page = pageOf(bus);
  EXPECT_EQ(lamp(page, "outputs", "Enabled"), Status2::On);
  EXPECT_EQ(lamp(page, "outputs", "Stowed"), Status2::Off);
  EXPECT_EQ(lamp(page, "outputs", "Discharge valve"), Status2::On);
  EXPECT_EQ(lamp(page, "outputs", "High flow"), Status2::Off);
  EXPECT_EQ(lamp(page, "status", "Operational error"), Status2::Off);
  EXPECT_EQ(lamp(page, "status", "Calibrated"), Status2::On);
}

TEST(DevicePageOf, LeavesLampsUnknownThatNeverCame) {
  Heard bus;
  bus.hear("18EFFF80", kAnnouncesA);
  const DevicePageValues page = pageOf(bus);
  ASSERT_TRUE(page.dial) << "a 6032 is a monitor though it has not sent anything yet";
  EXPECT_FALSE(page.dial->rotation.reading);
  EXPECT_EQ(page.stops.axes[0].plus.state, std::nullopt);
  EXPECT_EQ(lamp(page, "outputs", "Enabled"), std::nullopt);
  EXPECT_EQ(groupOf(page, "outputs")->age, Age());
}

TEST(DevicePageOf, ShowsAnswersWithTheirAge) {
  Heard bus;
  bus.monitor();
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").value, QStringLiteral("never asked"));
  EXPECT_EQ(fact(pageOf(bus), "Firmware").value, QStringLiteral("never asked"));
  bus.hear("18EF0580", "0200300000000B")
      .hear("18EF0580", "03010001020105")
      .hear("18EF0580", "040D1C000E0200")
      .hear("18EF0580", "050398690E0103");
  for (int i = 0; i < 90; ++i) bus.pass(1s).statuses();
  const DevicePageValues page = pageOf(bus);
  EXPECT_EQ(fact(page, "Fault bits").value,
            QStringLiteral("Reserved bit 20 (older manuals: pCode fault 4)\nInternal fuse"));
  EXPECT_EQ(fact(page, "Fault bits").tone, Severity::Fault);
  EXPECT_EQ(fact(page, "Fault bits").age, 90s);
  EXPECT_EQ(fact(page, "pCode error").value, QStringLiteral("Error 11: rotation sensor error"));
  EXPECT_EQ(fact(page, "Firmware").value, QStringLiteral("system 1.5, bootloader 1.2, fixed boot 1.0"));
  EXPECT_EQ(fact(page, "pCode").value,
            QStringLiteral("version 2.0\nstyle 3356: Trident\nsubtype 14: analog sensors"));
  EXPECT_EQ(fact(page, "Configuration").value,
            QStringLiteral("version 1.3\npart 60320014: Trident with Novotechnik sensors"));
}

TEST(DevicePageOf, TellsNeverAskedFromNoAnswer) {
  Heard bus;
  bus.monitor().hear("18EF80F9", "02");
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").value, QStringLiteral("asked, no answer yet"));
  bus.pass(2s).statuses();
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").value, QStringLiteral("no answer, asked 2.0 s ago"));
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").tone, Severity::Warning);
  EXPECT_EQ(fact(pageOf(bus), "Firmware").value, QStringLiteral("never asked"));
  bus.hear("18EF80F9", "02").hear("18EFF980", "02000000000000").hear("18EF80F9", "02").pass(2s).statuses();
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").value,
            QStringLiteral("none set\nasked again 2.0 s ago, no answer"));
}

TEST(DevicePageOf, DrawsAnAnswerAsOldAfterASilenceAndAfterARestart) {
  Heard bus;
  bus.monitor().faults().pass(93s);
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").value, QStringLiteral("none set\nasked 93 s ago, silent since"));
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").tone, Severity::Unknown);
  bus.monitor();
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").value,
            QStringLiteral("none set\nasked 93 s ago, restarted since"));
  bus.faults();
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").value, QStringLiteral("none set"));
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").tone, Severity::Fine);
}

TEST(DevicePageOf, ListsEveryCauseOfTheHealth) {
  Heard bus;
  bus.monitor("01FFF4FFF4000000").hear("18EFFF80", "834051");
  using Reasons = std::vector<PageReason>;
  EXPECT_EQ(pageOf(bus).reasons, (Reasons{{QStringLiteral("Sensor error: rotation, elevation."),
                                           Severity::Fault, healthAdvice(HealthCause::SensorError)},
                                          {QStringLiteral("Enable is off: it cannot move."),
                                           Severity::Warning, healthAdvice(HealthCause::Disabled)},
                                          {QStringLiteral("Its faults were never asked."), Severity::Unknown,
                                           healthAdvice(HealthCause::FaultsNeverAsked)}}));
  bus.statuses().faults();
  EXPECT_EQ(pageOf(bus).reasons,
            (Reasons{{QStringLiteral("It has no faults, and its messages come in time."), Severity::Fine}}));
}

TEST(DevicePageOf, SaysThatAShortFaultAnswerHasNoErrorCode) {
  Heard bus;
  bus.monitor().hear("18EF0580", "0200000000");
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").value, QStringLiteral("none set"));
  EXPECT_TRUE(fact(pageOf(bus), "pCode error").value.contains(QStringLiteral("older firmware")));
}

TEST(DevicePageOf, ShowsAPermissiveWithItsSenderAndItsTimeOut) {
  Heard bus;
  bus.monitor();
  EXPECT_EQ(groupOf(pageOf(bus), "permissive"), nullptr);
  bus.hear("18EF8005", "A10009");
  DevicePageValues page = pageOf(bus);
  EXPECT_EQ(lamp(page, "permissive", "Right"), Status2::On);
  EXPECT_EQ(lamp(page, "permissive", "Left"), Status2::Off);
  EXPECT_EQ(groupOf(page, "permissive")->remark, QStringLiteral("from 05 hex"));
  bus.pass(300ms);
  page = pageOf(bus);
  EXPECT_TRUE(groupOf(page, "permissive")->isStale);
  EXPECT_EQ(groupOf(page, "permissive")->remark, QStringLiteral("timed out, last from 05 hex"));
}

TEST(DevicePageOf, CallsNothingMissingInALogThatWasSavedThroughAFilter) {
  Heard bus;
  bus.note({.frame = 0, .time = bus.now(), .value = note::Filtered{"name~position"}});
  bus.monitor().hear("18EF8005", "A10009").hear("18EF80F9", "02").hear("724", "05");
  bus.hear("0CFDD634", kStickLeft).hear("0CFDD635", kRestingStick).pass(60s);
  EXPECT_EQ(groupOf(pageOf(bus), "permissive")->remark,
            QStringLiteral("last from 05 hex in this log, which was saved through a filter"));
  EXPECT_EQ(fact(pageOf(bus), "Fault bits").value,
            QStringLiteral("not in this log, which was saved through a filter"));
  EXPECT_EQ(fact(pageOf(bus, nodeKey(0x24)), "NMT state").value,
            QStringLiteral("operational, the last in this log, which was saved through a filter"));
  const DevicePageValues stick = pageOf(bus, addressKey(0x35));
  EXPECT_EQ(fact(stick, "Sending").value, QStringLiteral("not known, the log was saved through a filter"));
  EXPECT_EQ(fact(stick, "Rotation").value, QStringLiteral("not known, the log was saved through a filter"));
  EXPECT_EQ(fact(stick, "Before it").value.section(QLatin1Char('\n'), 1),
            QStringLiteral("Joystick 34: not known, the log was saved through a filter"));
}

TEST(DevicePageOf, SaysThatAPermissiveIsRequiredAndMissing) {
  Heard bus;
  bus.monitor().hear("18EFFF80", "83C800");
  EXPECT_EQ(groupOf(pageOf(bus), "permissive")->remark, QStringLiteral("required, none heard"));
  EXPECT_EQ(lamp(pageOf(bus), "permissive", "Up"), std::nullopt);
}

TEST(DevicePageOf, ShowsA6033WithItsRiserAndWithoutADial) {
  Heard bus;
  bus.hear("18EFFF91", announcementOf("1033AB000000001")).hear("18EFFF91", "848002");
  const DevicePageValues page = pageOf(bus, DeviceKey::of(*Pin::parse("1033AB000000001")));
  EXPECT_FALSE(page.dial);
  EXPECT_TRUE(page.stops.axes.empty());
  EXPECT_EQ(lamp(page, "riser", "Riser extended"), Status2::On);
  EXPECT_EQ(lamp(page, "riser", "Riser retracted"), Status2::Off);
  EXPECT_EQ(lamp(page, "riser", "Device active"), Status2::On);
}

TEST(DevicePageOf, ShowsA6039WithItsInputs) {
  Heard bus;
  bus.hear("18EFFFF0", "8505");
  const DevicePageValues page = pageOf(bus, addressKey(0xF0));
  EXPECT_FALSE(page.dial);
  EXPECT_EQ(page.type, QStringLiteral("6039 CAN I/O module"));
  EXPECT_EQ(lamp(page, "inputs", "Allowed in collision zone"), Status2::On);
  EXPECT_EQ(lamp(page, "inputs", "Deploy"), Status2::Off);
  EXPECT_EQ(lamp(page, "inputs", "Stow"), Status2::On);
}

TEST(DevicePageOf, ShowsAJoystickWithItsStickAndTiming) {
  Heard bus;
  bus.hear("18EEFF33", kNameOfSerial2).hear("18EFFF33", announcementOf("1035AB000000002"));
  for (int i = 0; i < 5; ++i) bus.hear("0CFDD633", kRestingStick).pass(20ms);
  bus.pass(120ms).hear("0CFDD633", "107D046400004000");
  const DevicePageValues page = pageOf(bus, DeviceKey::of(*Pin::parse("1035AB000000002")));
  EXPECT_FALSE(page.dial);
  ASSERT_FALSE(page.sticks.empty());
  EXPECT_NEAR(*page.sticks[0].x, 0.5, 1e-9);
  EXPECT_NEAR(*page.sticks[0].y, -0.4, 1e-9);
  EXPECT_EQ(page.sticks[0].xText, QStringLiteral("50.0 % right"));
  EXPECT_EQ(page.sticks[0].yText, QStringLiteral("40.0 % back"));
  EXPECT_EQ(lamp(page, "switches", "5 Flow high"), Status2::On);
  EXPECT_EQ(fact(page, "Priority").value, QStringLiteral("1 of 6, the highest on CAN"));
  EXPECT_EQ(fact(page, "Worst gap").value, QStringLiteral("140 ms, more than 100 ms"));
  EXPECT_EQ(fact(page, "Worst gap").tone, Severity::Warning);
  bus.pass(200ms);
  EXPECT_TRUE(pageOf(bus, page.key).sticks[0].isStale);
}

struct StickCase {
  const char* name;
  const char* frame;
  const char* x;
};
class StickWords : public testing::TestWithParam<StickCase> {};
TEST_P(StickWords, SayWhatTheAxisSays) {
  Heard bus;
  bus.hear("0CFDD634", GetParam().frame);
  const DevicePageValues page = pageOf(bus, addressKey(0x34));
  ASSERT_FALSE(page.sticks.empty());
  EXPECT_EQ(page.sticks[0].xText.toStdString(), GetParam().x);
}
INSTANTIATE_TEST_SUITE_P(OfAnAxis, StickWords,
                         testing::Values(StickCase{"Neutral", kRestingStick, "neutral"},
                                         StickCase{"Left", kStickLeft, "100.0 % left"},
                                         StickCase{"Error", "A0FF010000000000", "error"},
                                         StickCase{"NotFitted", "FFFF010000000000", "not fitted"},
                                         StickCase{"BothWays", "147D010000000000", "not valid"}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(DevicePageOf, ShowsAForeignNodeWithItsNameInWords) {
  Heard bus;
  bus.hear("18EEFF21", kHigherForeignName).pass(1s);
  const DevicePageValues page = pageOf(bus, addressKey(0x21));
  EXPECT_TRUE(page.isFound);
  EXPECT_FALSE(page.dial);
  EXPECT_TRUE(page.lamps.empty());
  EXPECT_EQ(page.type, QStringLiteral("Other maker, code 9; usually body controller"));
  EXPECT_TRUE(fact(page, "NAME").value.startsWith(QStringLiteral("Maker: other maker, code 9")));
  EXPECT_EQ(fact(page, "Claim").value, QStringLiteral("claimed"));
}

TEST(DevicePageOf, ShowsAHeartbeatOnlyNodeWithoutADial) {
  Heard bus;
  bus.hear("724", "05");
  DevicePageValues page = pageOf(bus, nodeKey(0x24));
  EXPECT_FALSE(page.dial);
  EXPECT_EQ(page.address, QStringLiteral("CANopen node 24 hex"));
  EXPECT_EQ(fact(page, "NMT state").value, QStringLiteral("operational"));
  bus.hear("724", "22");
  EXPECT_EQ(fact(pageOf(bus, nodeKey(0x24)), "NMT state").value, QStringLiteral("unknown state 22 hex"));
  bus.pass(3s);
  EXPECT_EQ(fact(pageOf(bus, nodeKey(0x24)), "NMT state").value,
            QStringLiteral("unknown state 22 hex, overdue"));
}

TEST(DevicePageOf, ShowsANodesAnswers) {
  Heard bus;
  bus.hear("724", "05")
      .hear("5A4", "4300500116699803")
      .hear("5A4", "4301500100200000")
      .hear("5A4", "4B0150020B00");
  const DevicePageValues page = pageOf(bus, nodeKey(0x24));
  EXPECT_EQ(page.type, QStringLiteral("60320022: Firefox, style 3463, with Novotechnik sensors"));
  EXPECT_EQ(fact(page, "Fault bits").value, QStringLiteral("Internal fuse"));
  EXPECT_EQ(fact(page, "Operational error").value, QStringLiteral("Error 11: rotation sensor error"));
  EXPECT_EQ(page.stops.axes.at(2).axis, QStringLiteral("Pattern")) << "the part is one of the 6032's";
}

TEST(DevicePageOf, FollowsTheDeviceToItsNewAddress) {
  Heard bus;
  bus.monitor().pass(2s).hear("18EFFF81", kAnnouncesA).pass(5s);
  const DevicePageValues page = pageOf(bus);
  EXPECT_EQ(page.address, QStringLiteral("address 81 hex"));
  EXPECT_EQ(fact(page, "Address").value, QStringLiteral("81 hex for 5.0 s"));
  EXPECT_EQ(fact(page, "Before").value, QStringLiteral("80 hex until 5.0 s ago"));
  EXPECT_EQ(pageOf(bus, addressKey(0x81)).key, keyOfA()) << "an address means who has it";
  bus.hear("18EEFF81", kLowerForeignName);
  EXPECT_EQ(pageOf(bus).address, QStringLiteral("address lost"));
}

TEST(DevicePageOf, TellsTheAddressesBeforeAndHowManyMore) {
  Heard bus;
  for (const char* id : {"18EFFF80", "18EFFF81", "18EFFF82", "18EFFF83", "18EFFF84", "18EFFF85"})
    bus.hear(id, kAnnouncesA).pass(10s);
  EXPECT_EQ(
      fact(pageOf(bus), "Before").value,
      QStringLiteral("84 hex until 10 s ago\n83 hex until 20 s ago\n82 hex until 30 s ago\nand 2 earlier"));
  bus.hear("18EEFF85", kLowerForeignName);
  EXPECT_EQ(fact(pageOf(bus), "Address").value, QStringLiteral("lost 0.0 s ago, it was 85 hex"));
  EXPECT_TRUE(fact(pageOf(bus), "Before").value.startsWith(QStringLiteral("84 hex")))
      << fact(pageOf(bus), "Before").value.toStdString();
}

TEST(DevicePageOf, PutsTheLabelBeforeThePin) {
  Heard bus;
  bus.monitor();
  DeviceLabels labels;
  labels.set(keyOfA().pin, QStringLiteral("Roof"));
  const DevicePageValues page = devicePageOf(bus.view(), keyOfA(), labels);
  EXPECT_EQ(page.title, QStringLiteral("Roof"));
  EXPECT_EQ(page.identity, QString::fromLatin1(kPinA));
  EXPECT_EQ(pageOf(bus).identity, QString());
}

TEST(DevicePageOf, SaysWhereAJoystickStandsAndWhatItMoves) {
  Heard bus;
  bus.monitor().hear("18EFFF91", kPosition);
  bus.hear("0CFDD634", kStickLeft).hear("0CFDD635", kStickRightBack).hear("0CFDD638", kRestingStick);
  DeviceLabels labels;
  labels.set(keyOfA().pin, QStringLiteral("Roof"));
  DevicePageValues page = devicePageOf(bus.view(), addressKey(0x35), labels);
  EXPECT_EQ(fact(page, "Rotation").value, QStringLiteral("Joystick 34: left at 100 %"));
  EXPECT_EQ(fact(page, "Elevation").value, QStringLiteral("this one: up at 40 %"));
  EXPECT_EQ(fact(page, "Before it").value,
            QStringLiteral("a 6032's own switches, which no message tells of\nJoystick 34: deflected"));
  EXPECT_EQ(fact(page, "After it").value, QStringLiteral("Joystick 38: at rest"));
  EXPECT_EQ(fact(page, "Moves").value,
            QStringLiteral("Roof (1032AE100801035)\nAddress 91\nand any that listens without being heard"));
  bus.pass(200ms).hear("0CFDD635", kRestingStick);
  page = pageOf(bus, addressKey(0x35));
  EXPECT_EQ(fact(page, "Rotation").value, QStringLiteral("nobody commands"));
  EXPECT_EQ(fact(page, "After it").value, QStringLiteral("Joystick 38: stopped sending"));
}

TEST(DevicePageOf, SaysThatASourceSendsWrongLengthsOnly) {
  Heard bus;
  bus.hear("0CFDD634", "01000100").hear("0CFDD633", kRestingStick);
  EXPECT_EQ(fact(pageOf(bus, addressKey(0x34)), "Sending").value,
            QStringLiteral("messages of a wrong length only; monitors take no input from them"));
  EXPECT_EQ(fact(pageOf(bus, addressKey(0x33)), "After it").value,
            QStringLiteral("Joystick 34: messages of a wrong length only"));
}

TEST(DevicePageOf, SaysWhoWasThereBeforeTheLinkWasDown) {
  Heard bus = linkThatGoesDown().pass(4s);
  bus.note({.time = bus.now(), .value = note::LinkUp{}}).pass(20ms).statuses();
  const DevicePageValues page = pageOf(bus);
  EXPECT_EQ(page.key, addressKey(0x80));
  EXPECT_EQ(page.title, QStringLiteral("Address 80, was 1032AE100801035"));
  ASSERT_FALSE(page.reasons.empty());
  EXPECT_EQ(page.reasons.front().text,
            QStringLiteral("Who is at this address has not said its PIN since the link came back: it was "
                           "1032AE100801035, before the link went down."));
  EXPECT_EQ(fact(page, "Fault bits").value,
            QStringLiteral("none set\nasked 4.0 s ago, before the link went down"));
  EXPECT_TRUE(fact(page, "NAME").value.endsWith(QStringLiteral("before the link went down")));
  bus.hear("18EFFF80", kAnnouncesA);
  EXPECT_EQ(pageOf(bus).title, QStringLiteral("1032AE100801035"));
}

TEST(DevicePageOf, SaysThatAnotherSourceMovesNothing) {
  Heard bus;
  bus.monitor().hear("0CFDD640", kStickLeft);
  EXPECT_EQ(fact(pageOf(bus, addressKey(0x40)), "Moves").tone, Severity::Warning);
}

TEST(DevicePageOf, ShowsAGripWithItsDetentsAndSwitches) {
  Heard bus;
  bus.hear("0CFDD634", "107D046450000000").hear("0CFDD734", "107D0464FFFF4450");
  DevicePageValues page = pageOf(bus, addressKey(0x34));
  ASSERT_EQ(page.sticks.size(), 2u);
  EXPECT_NEAR(*page.sticks[1].x, 0.5, 1e-9);
  EXPECT_EQ(page.sticks[1].yText, QStringLiteral("40.0 % back"));
  EXPECT_EQ(page.sticks[1].thetaText, QStringLiteral("not fitted"));
  EXPECT_EQ(lamp(page, "detents", "X detent"), Status2::On);
  EXPECT_EQ(lamp(page, "detents", "Y detent"), Status2::On);
  EXPECT_EQ(lamp(page, "grip", "Grip X detent"), Status2::On);
  EXPECT_EQ(lamp(page, "grip", "Grip Y detent"), Status2::Off);
  EXPECT_EQ(lamp(page, "grip", "Switch 13, reserved"), Status2::On);
  EXPECT_FALSE(page.sticks[1].isStale);
  bus.pass(200ms);
  EXPECT_TRUE(pageOf(bus, addressKey(0x34)).sticks[1].isStale);
}

TEST(DevicePageOf, DoesNotGuessWhichSourceIsAControlsOwn) {
  Heard bus;
  bus.hear("18EFFF82", announcementOf("1035AE100804442")).hear("0CFDD633", kRestingStick);
  const DevicePageValues page = pageOf(bus, DeviceKey::of(*Pin::parse("1035AE100804442")));
  EXPECT_TRUE(page.sticks.empty());
  EXPECT_EQ(fact(page, "Heard here").value, QStringLiteral("Joystick 33: at rest"));
  EXPECT_TRUE(fact(page, "Its own").value.startsWith(QStringLiteral("not known")));
}

TEST(DevicePageOf, SaysThatADriveIsOneBecauseAPersonSaidSo) {
  Heard bus;
  bus.hear("18EF0521", "8200");
  bus.note({.frame = 1, .time = bus.now(), .value = note::DriveSaid{{}, {0x21}}});
  const DevicePageValues page = pageOf(bus, addressKey(0x21));
  EXPECT_EQ(page.type, QStringLiteral("Copley drive"));
  EXPECT_EQ(fact(page, "Taken for").value, QStringLiteral("a Copley drive, because a person said so"));
  EXPECT_EQ(fact(page, "Frames").value, QStringLiteral("1, now 0 a second"));
}

TEST(DevicePageOf, KnowsTheConsoleItselfWhileItHoldsItsAddress) {
  Heard bus;
  bus.note({.frame = 0, .time = bus.now(), .value = note::OwnAddress{{}, {0xF9}, How::Claimed}});
  bus.hear("18EEFFF9", "010000FF00810000");
  EXPECT_EQ(pageOf(bus, addressKey(0xF9)).type, QStringLiteral("This console"));
  bus.note({.frame = 1, .time = bus.now(), .value = note::OwnAddress{{}, kNullAddress, How::Locked}});
  EXPECT_NE(pageOf(bus, addressKey(0xF9)).type, QStringLiteral("This console"));
}

TEST(DevicePageOf, SaysHowTheTraceIsFilteredToTheDevice) {
  Heard bus;
  bus.monitor().hear("18FEF190", "01");
  EXPECT_EQ(pageOf(bus).traceFilter, QStringLiteral("sa=80"));
  EXPECT_EQ(pageOf(bus, addressKey(0x90)).traceFilter, QStringLiteral("sa=90"));
  bus.document().frames.channel("can1");
  EXPECT_EQ(pageOf(bus).traceFilter, QStringLiteral("sa=80 and ch=can0"));
  bus.hear("724", "05");
  EXPECT_EQ(pageOf(bus, nodeKey(0x24)).traceFilter, QStringLiteral("node=24 and ch=can0"));
  bus.hear("724", "05");
  EXPECT_EQ(pageOf(bus, nodeKey(0x24)).traceFilter, QStringLiteral("node=24 and ch=can0"));
}

struct MotionCase {
  const char* name;
  const char* position;  // of a monitor limited to 30.0° left and 45.0° right
  const char* stick;     // of joystick 33
  const char* reason;    // empty: none
};
class MotionReasons : public testing::TestWithParam<MotionCase> {};

TEST_P(MotionReasons, NamesWhatSpeaksAgainstACommandedMotion) {
  const auto [name, position, stick, reason] = GetParam();
  Heard bus;
  bus.monitor(position).faults().hear("0CFDD633", stick);
  const std::vector<PageReason> reasons = pageOf(bus).reasons;
  const bool isTold = reasons.front().tone == Severity::Warning;
  EXPECT_EQ(isTold ? reasons.front().text.toStdString() : std::string(), reason);
}
INSTANTIATE_TEST_SUITE_P(
    DevicePageOf, MotionReasons,
    testing::Values(
        MotionCase{"NothingCommanded", "011C040371000041", kRestingStick, ""},
        MotionCase{"AtTheSoftLimit", "011C040371000041", kStickRightBack,
                   "Commanded right at 50 %: its soft limit on that side is at 45.0°, it stands at 44.8°."},
        MotionCase{"FarFromTheSoftLimit", "010C040371000041", kStickRightBack, ""},
        MotionCase{"AwayFromTheSoftLimit", "011C040371000041", kStickLeft, ""},
        MotionCase{"AtTheHardStop", "010C040371400041", kStickRightBack,
                   "Commanded right at 50 %: it stands at its hard stop on that side."}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(DevicePageOf, ShowsTheStickThatCommandsAMonitorAndWhoIsOutranked) {
  Heard bus;
  bus.monitor("0100000371000041").faults().hear("0CFDD634", kStickLeft).hear("0CFDD633", kRestingStick);
  EXPECT_EQ(pageOf(bus).sticks.at(0).title, QStringLiteral("Joystick 34")) << "33 asks for nothing";
  EXPECT_EQ(pageOf(bus).sticks.at(0).xText, QStringLiteral("100.0 % left"));
  bus.hear("0CFDD633", kStickRightBack);
  DevicePageValues page = pageOf(bus);
  EXPECT_EQ(page.sticks.at(0).title, QStringLiteral("Joystick 33"));
  EXPECT_EQ(
      page.reasons.at(0),
      (PageReason{QStringLiteral("Joystick 34 asks for left at 100 % in vain: Joystick 33 comes first."),
                  Severity::Warning}));
  bus.hear("0CFDD634", kRestingStick);
  page = pageOf(bus);
  EXPECT_EQ(page.reasons.at(0).tone, Severity::Fine);
  bus.hear("0CFDD633", kRestingStick);
  EXPECT_EQ(pageOf(bus).sticks.at(0).title, QStringLiteral("Joystick 33")) << "both rest: the first in rank";
  bus.pass(200ms);
  EXPECT_TRUE(pageOf(bus).sticks.empty()) << "stopped sending";
}

TEST(DevicePageOf, IsNotFoundWhereNothingWasHeardOfTheDevice) {
  Heard bus;
  EXPECT_FALSE(pageOf(bus).isFound);
  EXPECT_FALSE(pageOf(bus, {}).isFound);
  EXPECT_FALSE(devicePageOf({}, keyOfA()).isFound);
  EXPECT_EQ(pageOf(bus).key, keyOfA());
}

TEST(DevicePageOf, EveryGroupCitesItsManual) {
  Heard bus;
  bus.monitor().pass(50ms);
  const DevicePageValues page = pageOf(bus);
  for (const PageLampGroup& group : page.lamps)
    EXPECT_TRUE(pageSourceText(group.key).contains(QStringLiteral("manual"))) << group.key.toStdString();
  for (const PageFactGroup& group : page.facts)
    EXPECT_FALSE(pageSourceText(group.key).isEmpty()) << group.key.toStdString();
  EXPECT_TRUE(pageSourceText(QStringLiteral("stops")).contains(QStringLiteral("01")));
}

}  // namespace
}  // namespace deckpipe
