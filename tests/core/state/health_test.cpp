// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/health.h"

#include <gtest/gtest.h>

#include <functional>

#include "health_bus.h"

namespace deckpipe {
namespace {

using namespace test;

// Of the first device, PIN or not, or of address 21 where there is none.
std::string listedFirst(const Bus& bus) {
  const Device& first = bus.state().devices().all().front();
  return first.kind != Device::Kind::Free ? listed(healthOf(bus.state(), first))
                                          : listed(healthOf(bus.state(), Channel{0}, Address{0x21}));
}

struct Case {
  const char* name;
  std::function<void(Bus&)> story;
  const char* causes;
};
class HealthRule : public testing::TestWithParam<Case> {};

TEST_P(HealthRule, SaysEveryCauseThatHolds) {
  Bus bus;
  GetParam().story(bus);
  EXPECT_EQ(listedFirst(bus), GetParam().causes);
}
INSTANTIATE_TEST_SUITE_P(
    Of, HealthRule,
    testing::Values(
        // Faults asked for or not.
        Case{"AMonitorThatWasNeverAsked", [](Bus& b) { b.monitor(); }, "faults_never_asked"},
        Case{"AMonitorWithoutFaults", [](Bus& b) { b.monitor().answered(); }, "fine"},
        Case{"AFirstPollThatMayBeAnsweredYet", [](Bus& b) { b.monitor().asked().pass(100ms).statuses(); },
             "faults_awaited"},
        Case{"AFirstPollThatMayBeAnsweredAtTheLastMoment",
             [](Bus& b) { b.monitor().asked().pass(1500ms - 1ns).statuses(); }, "faults_awaited"},
        Case{"ALaterPollThatMayBeAnsweredYet",
             [](Bus& b) { b.monitor().answered().pass(1s).statuses().asked().pass(100ms).statuses(); },
             "fine"},
        Case{"APollWithoutAnswer", [](Bus& b) { b.monitor().asked().goOn(1600ms); }, "faults_not_answered"},
        Case{"PollsWithoutAnswerThatGoOn",
             [](Bus& b) {
               b.monitor();
               for (int i = 0; i < 5; ++i) b.asked().goOn(400ms);
             },
             "faults_not_answered"},
        Case{"ALaterPollWithoutAnswer", [](Bus& b) { b.monitor().answered().goOn(1s).asked().goOn(2s); },
             "faults_not_answered"},
        Case{"AnAnswerAfterAll", [](Bus& b) { b.monitor().asked().goOn(2s).hear("18EFF980", kNoFaults); },
             "fine"},
        Case{"AnAnswerOfAWrongLength",
             [](Bus& b) { b.monitor().asked().hear("18EFF980", "020000").goOn(2s); },
             "malformed faults_refused"},
        Case{"AnAnswerOfAWrongLengthAndNoneToTheNextPoll",
             [](Bus& b) { b.monitor().asked().hear("18EFF980", "020000").asked().goOn(2s); },
             "malformed faults_not_answered"},
        Case{"Faults", [](Bus& b) { b.monitor().answered("02002000000000"); }, "faults"},
        Case{"AnErrorCodeAlone", [](Bus& b) { b.monitor().answered("0200000000000B"); }, "faults"},
        // Of a log that was saved through a filter.
        Case{"AMonitorWhoseFramesMayHaveBeenLeftOut",
             [](Bus& b) { b.note(note::Filtered{"sa=33"}).monitor().answered().pass(60s); }, "filtered"},
        Case{"APollWhoseAnswerMayHaveBeenLeftOut",
             [](Bus& b) { b.note(note::Filtered{"da=80"}).monitor().asked().goOn(2s); }, "filtered"},
        Case{"StatusesThatMayHaveBeenLeftOut",
             [](Bus& b) {
               b.note(note::Filtered{"name~position"}).monitor().answered();
               for (int i = 0; i < 20; ++i) b.pass(100ms).hear("18EFFF80", test::kPosition);
             },
             "filtered"},
        Case{"FaultsAndARestartWhoseRequestMayHaveBeenLeftOut",
             [](Bus& b) {
               b.note(note::Filtered{"sa=80"}).monitor().answered("02002000000000").goOn(2s);
               b.hear("18EFFF80", kAnnouncesA);
             },
             "faults filtered"},
        Case{"ASelectionSavedWhole", [](Bus& b) { b.note(note::Added{2}).monitor().answered().pass(60s); },
             "silent faults_old"},
        // Old answers.
        Case{"WhatWasAddedWhenAPartWasSaved",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).note(note::Added{2});
               b.hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA);
             },
             "fine"},
        Case{"ARestart", [](Bus& b) { b.monitor().answered().goOn(2s).hear("18EFFF80", kAnnouncesA); },
             "faults_old"},
        Case{"AnAnswerAfterTheRestart",
             [](Bus& b) { b.monitor().answered().goOn(2s).hear("18EFFF80", kAnnouncesA).answered(); },
             "fine"},
        Case{"AnAnnouncementThatWasAskedFor",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).hear("18EAFFF9", kAsksForNames).pass(100ms).statuses();
               b.hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA);
             },
             "fine"},
        Case{"AnAnnouncementThatWasAskedForInEightBytes",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).hear("18EAFF80", "00EE00FFFFFFFFFF").pass(100ms).statuses();
               b.hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA);
             },
             "fine"},
        Case{"ARestartAmongRequestsToAllForTheirNames",
             [](Bus& b) {
               b.monitor().answered().goOn(2s);
               for (int i = 0; i < 3; ++i) b.hear("18EAFFF9", kAsksForNames).pass(800ms);
               b.hear("18EEFF80", kNameOfA).pass(150ms).hear("18EFFF80", kAnnouncesA).statuses();
             },
             "faults_old"},
        Case{"ARestartWithinASecondOfARequestForItsName",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).pass(400ms).hear("18EA80F9", kAsksForNames).pass(700ms);
               b.hear("18EFFF80", kAnnouncesA).statuses();
             },
             "faults_old"},
        Case{"ANameThatIsAskedForOnceTheLinkIsUpAgain",
             [](Bus& b) {
               b.monitor().answered().note(note::LinkDown{}).pass(2s).note(note::LinkUp{}).pass(50ms);
               b.hear("18EAFFF9", kAsksForNames).hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA);
               b.statuses().answered();
             },
             "fine"},
        Case{"AnAddressThatWasDefended",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).hear("18EEFF80", kHigherForeignName).pass(50ms).statuses();
               b.hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA);
             },
             "fine"},
        Case{"AnAddressThatWasDefendedBeforeTheRestart",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).hear("18EEFF80", kHigherForeignName).pass(50ms).statuses();
               b.hear("18EEFF80", kNameOfA).goOn(2s).hear("18EEFF80", kNameOfA);
             },
             "faults_old"},
        Case{"ARestartThatContestsTheAddressOfAnother",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).hear("18EEFF90", kNameOfB).pass(1s).statuses();
               b.hear("18EEFF90", kNameOfA).hear("18EEFF90", kNameOfB).hear("18EEFF80", kNameOfA);
               b.pass(250ms).hear("18EFFF80", kAnnouncesA).statuses();
             },
             "faults_old"},
        Case{"ARestartThatIsContested",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).pass(1s).hear("18EEFF80", kNameOfA).pass(10ms);
               b.hear("18EEFF80", kNameOfB).hear("18EEFF80", kNameOfA).hear("18EEFF81", kNameOfB);
               b.pass(250ms).hear("18EFFF80", kAnnouncesA).statuses();
             },
             "faults_old"},
        Case{"ARestartThatComesAfterTheContest",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).pass(1s).hear("18EEFF80", kNameOfB).pass(10ms);
               b.hear("18EEFF80", kNameOfA).hear("18EEFF81", kNameOfB);
               b.pass(250ms).hear("18EFFF80", kAnnouncesA).statuses();
             },
             "faults_old"},
        Case{"ARestartAtAnotherAddress",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).hear("18EEFF81", kNameOfA).pass(250ms);
               b.hear("18EFFF81", kAnnouncesA).hear("18EFFF81", kPosition).hear("18EFFF81", kOutputs);
             },
             "faults_old"},
        Case{"AnAnswerBetweenTheClaimAndTheAnnouncement",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).hear("18EEFF80", kNameOfA).pass(100ms).answered();
               b.pass(150ms).hear("18EFFF80", kAnnouncesA).statuses();
             },
             "fine"},
        Case{"ANameThatItsDeviceAloneWasAskedFor",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).hear("18EA80F9", kAsksForNames).hear("18EEFF80", kNameOfA);
               b.hear("18EFFF80", kAnnouncesA);
             },
             "fine"},
        Case{"ARestartWhileAnotherIsAskedForItsName",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).hear("18EA90F9", kAsksForNames).hear("18EEFF80", kNameOfA);
               b.hear("18EFFF80", kAnnouncesA);
             },
             "faults_old"},
        Case{"AnAddressThatWasTakenAndAnotherOne",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).hear("18EEFF80", kLowerForeignName).pass(1ms);
               b.hear("18EEFF84", kNameOfA).pass(250ms).hear("18EFFF84", kAnnouncesA);
               b.hear("18EFFF84", kPosition).hear("18EFFF84", kOutputs);
             },
             "fine"},
        Case{"AnAddressThatWasCommanded",
             [](Bus& b) {
               b.monitor().answered().goOn(2s).hear("18ECFFF9", "20090002FFD8FE00").pass(200ms).statuses();
               b.hear("18EEFF84", kNameOfA).pass(250ms).hear("18EFFF84", kAnnouncesA);
               b.hear("18EFFF84", kPosition).hear("18EFFF84", kOutputs);
             },
             "fine"},
        Case{"ARestartOfAnInputModule",
             [](Bus& b) {
               b.hear("18EEFF83", kNameOfB).hear("18EFFF83", "8500").hear("18EF83F9", "02");
               b.hear("18EFF983", kNoFaults).pass(100ms).hear("18EFFF83", "8500").pass(100ms);
               b.hear("18EEFF83", kNameOfB).hear("18EFFF83", "8500");
             },
             "faults_old"},
        Case{"AMoveToAnotherAddress",
             [](Bus& b) {
               b.monitor().answered().pass(100ms).hear("18EFFF81", kAnnouncesA).hear("18EFFF81", kPosition);
               b.hear("18EFFF81", kOutputs);
             },
             "fine"},
        Case{"ASilenceThatEnded", [](Bus& b) { b.monitor().answered("02002000000000").pass(5s).statuses(); },
             "faults_old"},
        Case{"AnAnswerDuringTheSilence", [](Bus& b) { b.monitor().pass(20s).answered().pass(1s); }, "silent"},
        // Statuses that never came.
        Case{"AMonitorThatNeverSaidWhetherItIsEnabled",
             [](Bus& b) { b.hear("18EFFF80", kAnnouncesA).hear("18EFFF80", kPosition).answered(); },
             "status_never_heard"},
        Case{"AMonitorThatNeverSaidWhereItIs",
             [](Bus& b) { b.hear("18EFFF80", kAnnouncesA).hear("18EFFF80", kOutputs).answered(); },
             "status_never_heard"},
        Case{"AMonitorOfNoKnownTypeThatNeverSaidWhetherItIsEnabled",
             [](Bus& b) { b.hear("18EFFF80", kPosition).answered(); }, "status_never_heard"},
        Case{"ASenderOfSoftLimitsThatNeverSaidWhereItIs",
             [](Bus& b) { b.hear("18EFFF80", "81FED401C200").answered(); }, "status_never_heard"},
        Case{"AMonitorOfNoKnownType", [](Bus& b) { b.statuses().answered(); }, "fine"},
        Case{"ARiserThatNeverSaidHowItIs", [](Bus& b) { b.hear("18EFFF80", "FF831502450C0D59").answered(); },
             "status_never_heard"},
        Case{"AnInputModule",
             [](Bus& b) { b.hear("18EFFFD0", "8500").hear("18EFD0F9", "02").hear("18EFF9D0", kNoFaults); },
             "fine"},
        Case{"ANodeWithoutHeartbeat",
             [](Bus& b) { b.hear("1A4", kPosition).hear("2A4", kOutputs).hear("5A4", "4301500100000000"); },
             "fine"},
        Case{"ANodeWithHeartbeatThatNeverSaidWhereItIs",
             [](Bus& b) { b.hear("724", "05").hear("2A4", kOutputs).hear("5A4", "4301500100000000"); },
             "status_never_heard"},
        Case{"ANodeThatNeverSaidWhetherItIsEnabled",
             [](Bus& b) { b.hear("724", "05").hear("1A4", kPosition).hear("5A4", "4301500100000000"); },
             "status_never_heard"},
        Case{"ANodeWithThePartNumberOfAMonitor",
             [](Bus& b) {
               b.hear("724", "05").hear("5A4", "4300500116699803").hear("5A4", "4301500100000000");
             },
             "status_never_heard"},
        // Silence and lateness.
        Case{"SilenceBegins", [](Bus& b) { b.monitor().pass(3s - 1ns); }, "late faults_never_asked"},
        Case{"Silence", [](Bus& b) { b.monitor().pass(3s); }, "silent faults_never_asked"},
        Case{"SilenceAfterAnAnswer", [](Bus& b) { b.monitor().answered().pass(1h); }, "silent faults_old"},
        Case{"AMonitorThatAnswersAndSendsNoStatus",
             [](Bus& b) { b.monitor().answered().pass(40s).answered(); }, "silent"},
        Case{"AMonitorThatSendsNoStatusAtAll",
             [](Bus& b) { b.hear("18EFFF80", kAnnouncesA).answered().pass(3s); },
             "silent faults_old status_never_heard"},
        Case{"OneStatusLate", [](Bus& b) { b.monitor().answered().pass(300ms).hear("18EFFF80", kOutputs); },
             "late"},
        Case{"ALinkThatIsDown", [](Bus& b) { b.monitor().answered().note(note::LinkDown{}).pass(1h); },
             "link_down"},
        Case{"FaultsWhoseLinkIsDown",
             [](Bus& b) { b.monitor().answered("02002000000000").note(note::LinkDown{}).pass(1ms); },
             "link_down"},
        Case{"TheMomentAtWhichALinkGoesDownAndARecordingEnds",
             [](Bus& b) { b.monitor().answered().note(note::LinkDown{}); }, "fine"},
        Case{"ANodeOfAnotherMakerWhoseLinkIsDown",
             [](Bus& b) { b.hear("18FEF121", "00").note(note::LinkDown{}).pass(1h); }, "link_down"},
        Case{"ALinkThatGoesDownDuringASilence",
             [](Bus& b) { b.monitor().answered().pass(5s).note(note::LinkDown{}).pass(1h); }, "link_down"},
        Case{"SilenceBeforeTheLinkWasDown",
             [](Bus& b) {
               b.monitor().answered().pass(3s).note(note::LinkDown{}).pass(1h).note(note::LinkUp{}).pass(1ms);
             },
             "faults_old"},
        Case{"SilenceBeforeTheLinkWasDownThatGoesOn",
             [](Bus& b) {
               b.monitor().answered().pass(3s).note(note::LinkDown{}).pass(1h).note(note::LinkUp{}).pass(3s);
             },
             "idle faults_old"},
        Case{"SilenceThatHadNotBegunWhenTheLinkWasDown",
             [](Bus& b) {
               b.monitor().answered().pass(3s - 1ns).note(note::LinkDown{}).pass(1h).note(note::LinkUp{});
               b.pass(3s - 1ns);
             },
             "faults_old"},
        Case{"SilenceBeforeTheLinkWasDownAndWordsAfterIt",
             [](Bus& b) {
               b.monitor().answered().pass(3s).note(note::LinkDown{}).pass(1h).note(note::LinkUp{});
               b.statuses().answered();
             },
             "fine"},
        Case{
            "AnIdleNodeBehindALinkThatWasDown",
            [](Bus& b) {
              b.hear("18FEF121", "00").pass(3s).note(note::LinkDown{}).pass(1h).note(note::LinkUp{}).pass(3s);
            },
            "idle cannot_be_asked"},
        Case{"ALinkThatIsJustUpAgain",
             [](Bus& b) {
               b.monitor().answered().note(note::LinkDown{}).pass(1h).note(note::LinkUp{}).pass(250ms);
             },
             "faults_old"},
        Case{"FaultsAnErrorAndADisabledMonitorBehindALinkThatWasDown",
             [](Bus& b) {
               b.monitor(kSensorError, "830051").answered("02002000000000").note(note::LinkDown{}).pass(1h);
               b.note(note::LinkUp{}).pass(1ms);
             },
             "faults_old"},
        Case{"WrongLengthsAndAPollInVainBehindALinkThatWasDown",
             [](Bus& b) {
               b.monitor().hear("18EFFF80", "0100").asked().pass(2s).statuses().note(note::LinkDown{});
               b.pass(1h).note(note::LinkUp{}).statuses();
             },
             "faults_never_asked"},
        Case{"AnotherTypeBehindALinkThatWasDown",
             [](Bus& b) {
               b.monitor().note(note::LinkDown{}).pass(1s).note(note::LinkUp{});
               for (int i = 0; i < 10; ++i) b.pass(100ms).hear("18EFFF80", "848000");
             },
             "faults_never_asked"},
        Case{"ADeviceThatIsNotHeardSinceTheLinkIsUpAgain",
             [](Bus& b) {
               b.monitor().answered().note(note::LinkDown{}).pass(1h).note(note::LinkUp{}).pass(3s);
             },
             "idle faults_old"},
        Case{
            "SilenceAfterTheLinkIsUpAgain",
            [](Bus& b) {
              b.monitor().answered().note(note::LinkDown{}).pass(1h).note(note::LinkUp{}).statuses().pass(3s);
            },
            "silent faults_old"},
        Case{"APinThatIsHeardAnewWithoutItsStatuses",
             [](Bus& b) {
               b.monitor().answered().note(note::LinkDown{}).pass(1h).note(note::LinkUp{}).pass(1ms);
               b.hear("18EEFF80", kNameOfA).hear("18EFFF80", kAnnouncesA).pass(3s);
             },
             "silent faults_old"},
        Case{"AnAddressThatIsHeardAnewWithoutItsStatusesAndItsPin",
             [](Bus& b) {
               b.monitor().answered().note(note::LinkDown{}).pass(1h).note(note::LinkUp{}).pass(1ms);
               b.hear("18EFF980", kNoFaults).pass(3s);
             },
             "idle"},
        Case{"AJoystickThatIsNotHeardSinceTheLinkIsUpAgain",
             [](Bus& b) {
               b.hear("0CFDD621", "0100010000000000").pass(2s).note(note::LinkDown{}).pass(57s);
               b.note(note::LinkUp{}).pass(1ms);
             },
             "cannot_be_asked"},
        Case{"ANodeOfAnotherSystemBehindALinkThatWasDown",
             [](Bus& b) {
               b.node().answered().note(note::LinkDown{}).pass(1h).note(note::LinkUp{}).pass(1ms);
               b.hear("724", "05");
             },
             "cannot_be_asked"},
        Case{"AJoystickWhoseLinkIsDown",
             [](Bus& b) {
               b.hear("18EEFF33", kNameOfA).hear("18EFFF33", kAnnouncesA);
               b.hear("0CFDD633", "0100010000000000").note(note::LinkDown{}).pass(1h);
             },
             "link_down"},
        Case{"AMonitorWhoseSensorsAreNotFittedAnyMore",
             [](Bus& b) {
               b.monitor().answered().hear("18EFFF80", "81FED401C200").hear("18EFFF80", "82FE0C00E100");
               for (int i = 0; i < 50; ++i) b.pass(100ms).statuses("01FFFFFFFF000001");
             },
             "fine"},
        Case{"SoftLimitsThatStop",
             [](Bus& b) { b.monitor().answered().hear("18EFFF80", "81FED401C200").goOn(5s); }, "late"},
        Case{"ARiserThatStopped", [](Bus& b) { b.hear("18EFFF91", "848000").pass(3s); },
             "silent faults_never_asked"},
        Case{"AJoystickThatStopped",
             [](Bus& b) {
               b.hear("18EEFF33", kNameOfA).hear("18EFFF33", kAnnouncesA);
               b.hear("0CFDD633", "0100010000000000").pass(200ms);
             },
             "joystick_stopped faults_never_asked status_never_heard"},
        Case{"ANodeOfAnotherMakerThatStopped",
             [](Bus& b) {
               for (int i = 0; i < 50; ++i) b.hear("18FEF121", "11").pass(100ms);
               b.pass(3s);
             },
             "silent cannot_be_asked"},
        Case{"ANodeOfAnotherMaker",
             [](Bus& b) {
               for (int i = 0; i < 50; ++i) b.hear("18FEF121", "11").pass(100ms);
             },
             "cannot_be_asked"},
        Case{"ANodeOfAnotherMakerThatSendsEveryFiveSeconds",
             [](Bus& b) {
               for (int i = 0; i < 6; ++i) b.hear("18FEF121", "11").pass(5s);
               b.pass(9900ms);
             },
             "cannot_be_asked"},
        Case{"ANodeOfAnotherMakerThatSentEveryFiveSeconds",
             [](Bus& b) {
               for (int i = 0; i < 6; ++i) b.hear("18FEF121", "11").pass(5s);
               b.pass(10s);
             },
             "silent cannot_be_asked"},
        Case{"ANodeOfAnotherMakerThatBecameFaster",
             [](Bus& b) {
               for (int i = 0; i < 6; ++i) b.hear("18FEF121", "11").pass(5s);
               for (int i = 0; i < 12; ++i) b.hear("18FEF121", "11").pass(1s);
               b.pass(2s);
             },
             "silent cannot_be_asked"},
        Case{"ANodeOfAnotherMakerHeardNowAndThen",
             [](Bus& b) { b.hear("18EEFF21", kHigherForeignName).pass(1h); }, "idle cannot_be_asked"},
        Case{"ANodeOfAnotherMakerThatOnlyAnswered",
             [](Bus& b) {
               for (int i = 0; i < 50; ++i) {
                 b.hear("18EA21F9", "DAFE00").hear("18E8FF21", "01FFFFFFF9DAFE00").hear("18EFF921", "11");
                 b.pass(100ms);
               }
               b.pass(3s);
             },
             "idle cannot_be_asked"},
        Case{"ANodeOfAnotherMakerThatOnlyAskedForNames",
             [](Bus& b) {
               for (int i = 0; i < 50; ++i) b.hear("18EAFF21", kAsksForNames).pass(100ms);
               b.pass(3s);
             },
             "idle cannot_be_asked"},
        Case{"AnAddressThatWasOurOwn",
             [](Bus& b) {
               b.note(note::OwnAddress{
                   .channel = Channel{0}, .address = Address{0x21}, .how = note::OwnAddress::How::Claimed});
               for (int i = 0; i < 50; ++i) b.hear("18FEF121", "11").pass(100ms);
               b.note(note::OwnAddress{
                   .channel = Channel{0}, .address = kNullAddress, .how = note::OwnAddress::How::Locked});
               b.pass(3s);
             },
             "idle cannot_be_asked"},
        Case{"AControlFromTheAddressOfItsPin",
             [](Bus& b) { b.hear("18EFFF80", "FF82EA02D0000002").pass(1h); }, "idle faults_never_asked"},
        // What it reports.
        Case{"Disabled", [](Bus& b) { b.monitor(kPosition, "834051").answered(); }, "disabled"},
        Case{"SensorError", [](Bus& b) { b.monitor(kSensorError).answered(); }, "sensor_error"},
        Case{"SensorsThatAreNotFitted", [](Bus& b) { b.monitor("01FFFFFFFF000001").answered(); }, "fine"},
        Case{"OperationalError", [](Bus& b) { b.monitor("011D940371000045").answered("0200000000000B"); },
             "faults operational_error"},
        Case{"OperationalErrorThatIsOver",
             [](Bus& b) { b.monitor("011D940371000045").answered("0200000000000B").pass(100ms).statuses(); },
             "fine"},
        Case{"OperationalErrorThatIsOverAndFaultsThatAreNot",
             [](Bus& b) { b.monitor("011D940371000045").answered("0200200000000B").pass(100ms).statuses(); },
             "faults"},
        Case{"OperationalErrorOfANodeThatIsOver",
             [](Bus& b) {
               b.node().hear("5A4", "4301500100000000").hear("1A4", "011D940371000045");
               b.hear("5A4", "4B0150020B00").pass(50ms).hear("1A4", kPosition);
             },
             "fine"},
        Case{"StopError", [](Bus& b) { b.monitor("011D940371020001").answered(); }, "stop_error"},
        Case{"PositionThatIsNotValid", [](Bus& b) { b.monitor("0112350000000000").answered(); },
             "position_invalid"},
        Case{"RiserThatIsFaulted", [](Bus& b) { b.hear("18EFFF91", "84C000"); },
             "device_faulted faults_never_asked"},
        Case{"WrongLength", [](Bus& b) { b.monitor().answered().hear("18EFFF80", "0100"); }, "malformed"},
        Case{"StatusesOfWrongLengths",
             [](Bus& b) {
               b.monitor().answered();
               for (int i = 0; i < 50; ++i) b.pass(100ms).statuses("0100", "83");
             },
             "malformed"},
        Case{"StatusesOfWrongLengthsThatStop",
             [](Bus& b) { b.monitor().answered().pass(100ms).statuses("0100", "83").pass(3s); },
             "silent malformed faults_old"},
        Case{"AStatusThatOnlyEverCameInAWrongLength",
             [](Bus& b) { b.hear("18EFFF80", kAnnouncesA).answered().statuses("0100"); }, "malformed"},
        Case{"EverythingAtOnce",
             [](Bus& b) { b.monitor("01FFF4FFF4020004", "834051").answered("0200200000000B"); },
             "faults sensor_error operational_error stop_error disabled"},
        // Addresses.
        Case{"AddressLost",
             [](Bus& b) { b.monitor().answered().hear("18EEFF80", kLowerForeignName).pass(kClaimTime); },
             "address_lost"},
        Case{"AddressContested",
             [](Bus& b) {
               b.monitor().answered().pass(250ms).hear("18EEFF80", kHigherForeignName).statuses();
             },
             "address_contested"},
        Case{"NoAddressToClaim",
             [](Bus& b) { b.hear("18EEFF21", kHigherForeignName).hear("18EEFFFE", kHigherForeignName); },
             "cannot_claim cannot_be_asked"},
        Case{"ANameOfAkronsWithoutItsPin", [](Bus& b) { b.hear("18EEFF21", kNameOfA); }, "not_announced"},
        // CANopen.
        Case{"NodeThatIsNotOperational", [](Bus& b) { b.hear("724", "7F"); },
             "not_operational cannot_be_asked"},
        Case{"NodeWithAnErrorCode",
             [](Bus& b) { b.hear("724", "05").hear("5A4", "4300500116699803").hear("5A4", "4B0150020B00"); },
             "faults faults_never_asked status_never_heard"},
        Case{"NodeOfWhichOnlyTheErrorCodeWasRead", [](Bus& b) { b.node().hear("5A4", "4B0150020000"); },
             "faults_never_asked"},
        Case{"NodeWhoseErrorCodeWasReadAgainAfterItBooted",
             [](Bus& b) {
               b.node().hear("5A4", "4301500100000020").pass(1ms).hear("724", "00");
               b.hear("724", "05").hear("5A4", "4B0150020000");
             },
             "faults_old"},
        Case{"NodeWithANewErrorCodeAndOldFaults",
             [](Bus& b) {
               b.node().hear("5A4", "4301500100000020").pass(1ms).hear("724", "00");
               b.hear("724", "05").hear("5A4", "4B0150020B00");
             },
             "faults faults_old"},
        Case{"NodeWithAnErrorCodeOfBeforeItBooted",
             [](Bus& b) {
               b.node().hear("5A4", "4B0150020B00").pass(1ms).hear("724", "00");
               b.hear("724", "05").hear("5A4", "4301500100000000");
             },
             "fine"},
        Case{"NodeThatWasAsked",
             [](Bus& b) { b.node().hear("624", "40015001").hear("5A4", "4301500100000000"); }, "fine"},
        Case{"NodeThatAborts",
             [](Bus& b) { b.node().hear("624", "40015001").hear("5A4", "8001500100000206").pass(2s); },
             "faults_refused"},
        Case{"NodeWhoseMasterAborts",
             [](Bus& b) { b.node().hear("624", "40015001").hear("624", "8001500100000405").pass(2s); },
             "faults_not_answered"},
        // Its periods are settings: they are heard.
        Case{"NodeWithASlowHeartbeatBetweenTwo",
             [](Bus& b) {
               for (int i = 0; i < 4; ++i) b.hear("724", "05").hear("5A4", "4301500100000000").pass(5s);
               b.pass(9900ms);
             },
             "fine"},
        Case{"NodeWithASlowHeartbeatThatStops",
             [](Bus& b) {
               for (int i = 0; i < 4; ++i) b.hear("724", "05").hear("5A4", "4301500100000000").pass(5s);
               b.pass(10s);
             },
             "silent faults_old"},
        Case{"NodeWithSlowStatuses",
             [](Bus& b) {
               for (int i = 0; i < 4; ++i) b.node().hear("5A4", "4301500100000000").pass(1s);
               b.pass(1900ms);
             },
             "fine"},
        Case{"NodeWithSlowStatusesOfWhichOneStops",
             [](Bus& b) {
               for (int i = 0; i < 4; ++i) b.node().hear("5A4", "4301500100000000").pass(1s);
               for (int i = 0; i < 3; ++i) b.hear("724", "05").hear("1A4", kPosition).pass(1s);
             },
             "late"},
        Case{"NodeThatMissedAMessage",
             [](Bus& b) {
               for (const Duration pause : {1s, 1s, 30s, 1s, 3s}) b.hear("724", "05").pass(pause);
             },
             "silent cannot_be_asked"},
        Case{"NodeOfWhichOneMessageCame", [](Bus& b) { b.hear("724", "05").pass(1h); },
             "idle cannot_be_asked"},
        Case{"NodeThatAnswersInAnotherSize",
             [](Bus& b) { b.node().hear("624", "40015001").hear("5A4", "4B0150010000"); }, "faults_refused"},
        Case{"NodeThatAnswersAfterAnAbort",
             [](Bus& b) {
               b.node().hear("624", "40015001").hear("5A4", "8001500100000206");
               b.hear("5A4", "4301500100000000");
             },
             "fine"},
        Case{"NodeThatBootedSince",
             [](Bus& b) {
               b.node().hear("5A4", "4301500100000000").pass(1ms).hear("724", "00");
               b.hear("724", "05");
             },
             "faults_old"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(WhoIsADevice, NobodyWhoOnlySendsToOne) {
  Bus bus;
  bus.monitor();
  for (const char* from : {"05", "A0"}) {
    for (const char* data : {"0200000000000000", "02000000000000", "03010203040506", "04010203040506",
                             "05010203040506", "011D940371000041", "83C051", "FF83150206021A0C"})
      bus.hear(std::string("18EF80") + from, data);
  }
  for (const Device& device : bus.state().devices().all())
    EXPECT_TRUE(device.kind == Device::Kind::Free || device.address == Address{0x80});
  EXPECT_FALSE(bus.state().channel({}).book.isAkron(Address{0xA0}));
}

TEST(WhoIsADevice, NobodyWhoOnlySendsToOneThatWasNeverHeard) {
  Bus bus;
  for (const char* data : {"02000000000000", "03010203040506", "04010203040506"}) bus.hear("18EF80A0", data);
  EXPECT_EQ(bus.state().devices().byAddress({}, Address{0xA0}), nullptr);
}

TEST(WhoIsADevice, NobodyWhoOnlyClaimedTheAddressOfAnother) {
  Bus bus;
  bus.monitor().goOn(5s).hear("18EEFF80", kLowerForeignName).hear("18EEFF84", kNameOfA);
  bus.hear("18EFFF84", kAnnouncesA).pass(10s);
  EXPECT_EQ(listed(healthOf(bus.state(), Channel{0}, Address{0x80})), "idle cannot_be_asked");
}

TEST(WhoIsADevice, WhoeverAnswersAsOne) {
  Bus bus;
  bus.hear("18EFF991", kNoFaults);
  EXPECT_NE(bus.state().devices().byAddress({}, Address{0x91}), nullptr) << "presumed";
}

TEST(Health, KnowsTheWorstAndItsKey) {
  Health health;
  EXPECT_EQ(health.key(), "fine");
  EXPECT_EQ(health.severity(), Severity::Fine);
  health.causes.add(HealthCause::Late);
  health.causes.add(HealthCause::SensorError);
  EXPECT_EQ(health.worst(), HealthCause::SensorError);
  EXPECT_EQ(health.key(), "sensor_error");
  EXPECT_EQ(health.severity(), Severity::Fault);
}

TEST(Health, KeepsOldFaultsAndANewErrorCodeApart) {
  Bus bus;
  bus.node().hear("5A4", "4301500100000020").pass(1ms).hear("724", "00");
  bus.hear("724", "05").hear("5A4", "4B0150020B00");
  const Health health = healthOf(bus.state(), bus.state().devices().all().front());
  EXPECT_EQ(health.faults, (NamedFaults{.map = 0, .errorCode = 11}));
  EXPECT_NE(health.oldFaults.map, 0u);
  EXPECT_EQ(health.oldFaults.errorCode, 0);
}

TEST(Health, NamesNoCodeOfAnOperationalErrorThatIsOver) {
  Bus bus;
  bus.monitor("011D940371000045").answered("0200000000000B").pass(100ms).statuses().pass(100ms);
  bus.statuses("011D940371000045");
  const auto health = [&] { return healthOf(bus.state(), *bus.device(kPinA)); };
  EXPECT_EQ(listed(health()), "operational_error");
  EXPECT_EQ(health().faults.errorCode, 0) << "the next one is asked anew";
  bus.answered("0200000000000C");
  EXPECT_EQ(health().faults.errorCode, 12);
}

TEST(Health, NamesWhatWasNeverHeardAndWhetherAnythingEverWas) {
  Bus bus;
  bus.hear("18EFFF80", kAnnouncesA).hear("18EFFF80", kPosition);
  const auto health = [&] { return healthOf(bus.state(), *bus.device(kPinA)); };
  EXPECT_EQ(health().neverHeard, EnumSet(MessageId::DigitalOutputs));
  bus.pass(5s);
  EXPECT_TRUE(health().has(HealthCause::Silent));
  EXPECT_EQ(bus.now() - health().since, 5s);
  Bus mute;
  mute.hear("18EFFF80", kAnnouncesA).pass(5s);
  EXPECT_EQ(healthOf(mute.state(), *mute.device(kPinA)).since, kNotYet);
}

TEST(Health, NamesTheAxisOfEachCause) {
  Bus bus;
  bus.monitor("01FFF41235000000");
  const Health health = healthOf(bus.state(), *bus.device(kPinA));
  EXPECT_EQ(health.sensorError, (Axes{.rotation = true}));
  EXPECT_EQ(health.invalid, (Axes{.elevation = true}));
}

TEST(Health, KnowsWhyAnAnswerIsOld) {
  Bus bus;
  bus.monitor().answered();
  const Instant answered = bus.now();
  const auto age = [&] { return ageOfAnswer(bus.state(), *bus.device(kPinA), answered); };
  EXPECT_EQ(age(), AnswerAge::Current);
  bus.pass(93s);
  EXPECT_EQ(age(), AnswerAge::BeforeSilence);
  bus.statuses();
  EXPECT_EQ(age(), AnswerAge::BeforeSilence) << "it may have restarted meanwhile";
  bus.hear("18EFFF80", kAnnouncesA);
  EXPECT_EQ(age(), AnswerAge::BeforeRestart);
}

}  // namespace
}  // namespace deckpipe
