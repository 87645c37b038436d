// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/event_walk.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <set>

#include "event_story.h"

namespace deckpipe {
namespace {

using Story = test::EventStory;
using Lines = std::vector<std::string>;

struct EventCase {
  const char* name;
  std::function<void(Story&)> tell;
  Lines lines;
};
class EventsOf : public testing::TestWithParam<EventCase> {};

TEST_P(EventsOf, AreToldWhenTheyHappen) {
  Story story;
  GetParam().tell(story);
  EXPECT_EQ(story.lines(), GetParam().lines);
}

// Cases begin with the monitor at 6 s, after five seconds of its statuses.
#define MONITOR " 1032AE100801035"
const std::vector<EventCase> kCases{
    {"AMonitorThatIsWell", [](Story& s) { s.monitor().answers(Story::kNoFaults).goOn(60s); }, {}},
    // Presence.
    {"ASilence",
     [](Story& s) { s.monitor().pass(40s).goOn(1s); },
     {"8.900 silent" MONITOR " since 5.900", "46.000 back" MONITOR " 40100 ms"}},
    {"ASilenceThatGoesOn", [](Story& s) { s.monitor().pass(3s); }, {"8.900 silent" MONITOR " since 5.900"}},
    {"NoSilenceYet", [](Story& s) { s.monitor().pass(2899ms); }, {}},
    {"ASilenceOfWhatAnswersAndSendsNoStatus",
     [](Story& s) { s.monitor().pass(10s).answers(Story::kNoFaults).pass(1s); },
     {"8.900 silent" MONITOR " since 5.900"}},
    {"NothingThatRestsOnASilenceOfALogSavedThroughAFilter",
     [](Story& s) {
       s.note(note::Filtered{"sa=80"}).monitor().stick(1s).hear("18EF8021", "A1000F").pass(40s);
       s.goOn(1s, Story::kPosition, "834051").hear("18EFFF80", Story::kAnnouncesA).stick(1s).pass(9s);
       for (Duration t = 0s; t < 3s; t += 600us) s.hear("18FEF100", "1122334455667788").pass(600us);
       s.pass(9s).hear("18EFFF81", Story::kAnnouncesB).hear("18EFFF81", Story::kPosition).pass(9s);
     },
     {"47.000 disabled" MONITOR}},
    {"ASilenceInASelection",
     [](Story& s) { s.note(note::Added{2}).monitor().pass(3s); },
     {"8.900 silent" MONITOR " since 5.900"}},
    {"ALinkThatIsDownIsNoSilence",
     [](Story& s) { s.monitor().note(note::LinkDown{}).pass(40s).note(note::LinkUp{}).pass(100ms).goOn(5s); },
     {}},
    {"StatusesOfWrongLengthsAreNoSilence",
     [](Story& s) { s.monitor().goOn(10s, "0100", "83"); },
     {"6.300 malformed" MONITOR " since 6.000"}},
    {"OneStatusOfWrongLengthsAmongOthers",
     [](Story& s) { s.monitor().goOn(5s, "011D9403710000").goOn(1s, Story::kPosition, "83C0").goOn(1s); },
     {"6.300 malformed" MONITOR " since 6.000", "11.000 malformed_over" MONITOR,
      "11.300 malformed" MONITOR " since 11.000", "12.000 malformed_over" MONITOR}},
    {"AStatusOfAWrongLengthAmongRightOnes",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 20; ++i) s.goOn(200ms, "0100").goOn(100ms);
     },
     {}},
    {"AStatusOfAWrongLengthNowAndThen",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 5; ++i) s.hear("18EFFF80", "84").goOn(5s);
     },
     {}},
    {"WrongLengthsThatAreLongerThanRightOnes",
     [](Story& s) { s.monitor().goOn(1s, Story::kPosition, "83C05100").goOn(1s); },
     {"6.300 malformed" MONITOR " since 6.000", "7.000 malformed_over" MONITOR}},
    {"ANodeWhoseHeartbeatsHaveWrongLengths",
     [](Story& s) {
       s.hear("724", "05").pass(1s).hear("724", "05").pass(1s);
       for (int i = 0; i < 6; ++i) s.hear("724", "0500").pass(1s);
       s.hear("724", "05");
     },
     {"6.000 malformed node 24 since 3.000", "9.000 malformed_over node 24"}},
    {"APermissiveBehindALinkThatIsDown",
     [](Story& s) {
       s.monitor().hear("18EF8021", "A1000F").note(note::LinkDown{}).pass(40s).note(note::LinkUp{});
       s.hear("18EF8021", "A1000F").goOn(1s);
     },
     {"46.300 permissive_lost 80"}},
    {"ADeviceThatIsNotBackWithItsLink",
     [](Story& s) { s.monitor().gap().pass(9s); },
     {"49.000 not_back" MONITOR " since 46.000"}},
    {"ADeviceThatIsNotBackBehindSeveralGaps",
     [](Story& s) { s.monitor().gap().pass(1s).gap().pass(9s).gap().pass(9s); },
     {"90.000 not_back" MONITOR " since 87.000"}},
    {"ADeviceThatIsBackLater",
     [](Story& s) { s.monitor().gap().pass(9s).goOn(1s).pass(9s); },
     {"49.000 not_back" MONITOR " since 46.000", "55.000 back 80 9000 ms", "58.900 silent 80 since 55.900"}},
    {"ADeviceThatIsBackBehindASecondGap",
     [](Story& s) { s.monitor().gap().pass(9s).gap().goOn(1s); },
     {"49.000 not_back" MONITOR " since 46.000", "95.000 back 80 49000 ms"}},
    {"ADeviceThatSaysThatItIsBack",
     [](Story& s) { s.monitor().gap().pass(9s).hear("18EFFF80", Story::kAnnouncesA).pass(9s); },
     {"49.000 not_back" MONITOR " since 46.000", "55.000 back" MONITOR " 9000 ms",
      "58.000 silent" MONITOR " since 46.000"}},
    {"AnotherDeviceWhereOneIsNotBack",
     [](Story& s) {
       s.monitor().gap().hear("18FEF100", "11").pass(9s).hear("18EFFF80", Story::kAnnouncesB).goOn(1s);
     },
     {"49.000 not_back" MONITOR " since 46.000", "55.000 appeared 1032AE100801036"}},
    {"ANodeThatIsNotBackWithItsLink",
     [](Story& s) {
       for (int i = 0; i < 5; ++i) s.hear("724", "05").pass(5s);
       s.gap().pass(20s).hear("724", "05");
     },
     {"81.000 not_back node 24 since 66.000", "86.000 back node 24 20000 ms"}},
    {"NothingOfADeviceThatIsNotBackInALogSavedThroughAFilter",
     [](Story& s) { s.note(note::Filtered{"sa=80"}).monitor().gap().pass(9s); },
     {}},
    {"ASilenceAfterTheLinkIsUpAgain",
     [](Story& s) { s.monitor().gap().goOn(100ms).pass(9s); },
     {"49.000 silent 80 since 46.000"}},
    {"ASilenceThatTheLinkIsDownIn",
     [](Story& s) { s.monitor().pass(4s).gap().pass(4s).goOn(1s); },
     {"8.900 silent" MONITOR " since 5.900"}},
    {"ADeviceBehindAGapThatSaysItsPinAnew",
     [](Story& s) {
       s.monitor().answers("02002000000000").gap().goOn(1s).asksForNames();
       s.hear("18EEFF80", Story::kNameOfA).hear("18EFFF80", Story::kAnnouncesA).goOn(1s);
       s.answers(Story::kNoFaults).goOn(1s);
     },
     {"6.000 fault" MONITOR " 21>21"}},
    {"ADeviceBehindAGapWhoseFaultIsToldAnew",
     [](Story& s) { s.monitor().answers("02002000000000").gap().goOn(1s).answers("02002000000000"); },
     {"6.000 fault" MONITOR " 21>21", "47.000 fault 80 21>21"}},
    {"AnotherDeviceBehindAGapAtTheSameAddress",
     [](Story& s) {
       s.monitor().gap().goOn(5s).asksForNames().hear("18EEFF80", Story::kNameOfB);
       s.hear("18EFFF80", Story::kAnnouncesB).goOn(5s);
     },
     {"51.000 appeared 1032AE100801036"}},
    {"AnotherDeviceBehindAGapThatOnlyAnnouncesItself",
     [](Story& s) { s.monitor().gap().goOn(5s).hear("18EFFF80", Story::kAnnouncesB).goOn(5s); },
     {"51.000 appeared 1032AE100801036"}},
    {"ADeviceThatHadNoPinBeforeAGap",
     [](Story& s) { s.goOn(5s).gap().goOn(5s).hear("18EFFF80", Story::kAnnouncesB).goOn(5s); },
     {"51.000 restarted 1032AE100801036"}},
    {"ANewDeviceLongAfterAGapBeforeWhichAnotherOneHadNoPin",
     [](Story& s) { s.goOn(5s).gap().goOn(60s).hear("18EFFF82", Story::kAnnouncesB); },
     {"106.000 appeared 1032AE100801036"}},
    {"ADeviceAtOnceBehindAGapBeforeWhichAnotherOneHadNoPin",
     [](Story& s) { s.goOn(5s).gap().hear("18EFFF82", Story::kAnnouncesB).pass(1s); },
     {}},
    {"ADeviceThatSaysItsPinLateBehindAGapBeforeWhichAnotherOneHadNoPin",
     [](Story& s) {
       s.goOn(5s).gap().hear("18EFFF82", Story::kPosition).goOn(2s).hear("18EFFF82", Story::kAnnouncesB);
     },
     {"48.000 restarted 1032AE100801036"}},
    {"ANewDeviceBehindASecondGapWithoutAnAnnouncementSinceTheFirst",
     [](Story& s) {
       s.monitor().gap().goOn(5s).gap().goOn(1s).hear("18EFFF82", Story::kAnnouncesB).goOn(1s);
     },
     {"92.000 appeared 1032AE100801036"}},
    {"ADeviceThatIsBackLongAfterAGap",
     [](Story& s) {
       s.monitor().gap().hear("18FEF100", "FFFFFFFFFFFFFFFF").pass(5s);
       s.hear("18EEFF80", Story::kNameOfA).hear("18EFFF80", Story::kAnnouncesA).goOn(1s);
     },
     {"49.000 not_back" MONITOR " since 46.000", "51.000 back" MONITOR " 5000 ms",
      "51.000 restarted" MONITOR}},
    {"ADeviceThatMovedBetweenTwoGaps",
     [](Story& s) {
       const auto heardAt81 = [&s] {
         s.gap().asksForNames().hear("18EEFF81", Story::kNameOfA).hear("18EFFF81", Story::kAnnouncesA);
       };
       s.monitor();
       heardAt81();
       heardAt81();
     },
     {"46.000 moved_address" MONITOR " 128>129"}},
    {"ADeviceThatLostItsAddressBeforeAGap",
     [](Story& s) {
       s.monitor().hear("18EEFF80", Story::kLowerName).pass(1s).gap().asksForNames();
       s.hear("18EEFF81", Story::kNameOfA).hear("18EFFF81", Story::kAnnouncesA);
     },
     {"6.250 address_lost" MONITOR " to another", "47.000 moved_address" MONITOR " 128>129"}},
    {"ADeviceThatTookAnAddressBeforeAGapAndSaysItsPinBehindIt",
     [](Story& s) {
       s.monitor().hear("18EEFF80", "0A1AC22800420090").goOn(1s).gap().goOn(5s);
       s.hear("18EFFF80", "FF83150206021A0A").goOn(1s);
     },
     {"6.000 address_lost" MONITOR " to another", "6.000 appeared 80", "52.000 restarted 1032AE100801034"}},
    {"ANewDeviceBehindAGapThatSaysItsPinLater",
     [](Story& s) {
       s.monitor().gap().goOn(60s).hear("18EFFF82", Story::kPosition).goOn(1s);
       s.hear("18EFFF82", Story::kAnnouncesB);
     },
     {"106.000 appeared 82"}},
    {"ADeviceThatMovesBehindAGapByItsNameAndSaysItsPinLater",
     [](Story& s) {
       s.hear("18EEFF90", Story::kNameOfB).hear("18EFFF90", Story::kAnnouncesB).pass(1s).gap();
       s.hear("18EEFF83", Story::kNameOfB);
       for (int i = 0; i < 50; ++i) s.hear("18EFFF83", Story::kPosition).pass(100ms);
       s.hear("18EEFF83", Story::kLowerName).pass(1ms).hear("18EEFF84", Story::kNameOfB).pass(250ms);
       s.hear("18EFFF84", Story::kPosition).hear("18EFFF84", Story::kAnnouncesB);
     },
     {"47.001 address_lost 83 to another", "47.251 moved_address 84 131>132"}},
    {"OtherStatesBehindAGap",
     [](Story& s) { s.monitor().gap().goOn(5s, "0123283284401041", "830051"); },
     {"46.000 disabled 80"}},
    {"ADeviceOfAnotherTypeBehindAGap",
     [](Story& s) {
       s.monitor().gap();
       for (int i = 0; i < 50; ++i) s.hear("18EFFF80", "848000").pass(100ms);
     },
     {}},
    {"DevicesBehindAGapThatChangedPlaces",
     [](Story& s) {
       s.monitor().hear("18EEFF81", Story::kNameOfB).hear("18EFFF81", Story::kAnnouncesB).goOn(100ms);
       s.gap().asksForNames().hear("18EEFF80", Story::kNameOfB).hear("18EFFF80", Story::kAnnouncesB);
       s.hear("18EEFF81", Story::kNameOfA).hear("18EFFF81", Story::kAnnouncesA).goOn(2s);
     },
     {"6.000 appeared 1032AE100801036", "46.100 moved_address 1032AE100801036 129>128",
      "46.100 moved_address 1032AE100801035 128>129"}},
    {"ADeviceThatStartsLongAfterAGap",
     [](Story& s) {
       s.monitor().gap().goOn(5s).hear("18EEFF80", Story::kNameOfA).hear("18EFFF80", Story::kAnnouncesA);
     },
     {"51.000 restarted" MONITOR}},
    {"ADeviceThatWasAskedWhileTheLinkWasDown",
     [](Story& s) {
       s.monitor().gap().pass(300ms).hear("18EEFF80", Story::kNameOfA).hear("18EFFF80", Story::kAnnouncesA);
       s.goOn(2s);
     },
     {}},
    {"AnAddressWhoseLinkGoesDownWhileItIsContested",
     [](Story& s) { s.monitor().hear("18EEFF80", Story::kHigherName).pass(10ms).gap().goOn(1s); },
     {}},
    {"TwoDevicesAtOneAddressBeforeAGap",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 20; ++i) s.statuses().pass(30ms).statuses("0112C10644000041").pass(70ms);
       s.gap().goOn(5s);
     },
     {"6.200 two_at_one_address" MONITOR}},
    {"ADeviceThatNeverSendsWhatItsTypeRepeats",
     [](Story& s) {
       s.hear("18EEFF80", Story::kNameOfA).hear("18EFFF80", Story::kAnnouncesA).pass(5s).goOn(100ms);
     },
     {"4.000 silent" MONITOR " since 1.000", "6.000 back" MONITOR " 5000 ms"}},
    {"SilencesThatComeTooFastForAReader",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 4; ++i) s.pass(3s).goOn(100ms);
       s.goOn(30s);
     },
     {"8.900 silent" MONITOR " since 5.900", "9.000 back" MONITOR " 3100 ms",
      "12.000 silent" MONITOR " since 9.000", "12.100 back" MONITOR " 3100 ms",
      "18.900 back" MONITOR " 3100 ms since 18.300 (3)"}},
    {"ADeviceThatAppearsLater",
     [](Story& s) {
       s.monitor().hear("18EEFF81", Story::kNameOfB).hear("18EFFF81", Story::kAnnouncesB).goOn(1s);
     },
     {"6.000 appeared 1032AE100801036"}},
    {"AMonitorThatAppearsAfterItsStatusesHadWrongLengths",
     [](Story& s) { s.goOn(5s, "0100", "83").goOn(1s); },
     {}},
    {"AMonitorWithoutAPinThatAppearsLater",
     [](Story& s) { s.monitor().hear("18EFFF81", Story::kPosition); },
     {"6.000 appeared 81"}},
    {"AMonitorThatAppearsLaterWithStatusesOfWrongLengths",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 10; ++i) s.goOn(100ms).hear("18EFFF81", "0100");
       s.hear("18EFFF81", Story::kPosition);
     },
     {"7.000 appeared 81 since 6.100"}},
    {"ANodeThatIsBelievedInLater",
     [](Story& s) {
       for (int i = 0; i < 50; ++i) s.hear("1A4", Story::kPosition).pass(100ms);
       s.hear("724", "05").hear("1A4", Story::kPosition).pass(100ms);
     },
     {}},
    {"ARestart",
     [](Story& s) { s.monitor().hear("18EFFF80", Story::kAnnouncesA).goOn(1s); },
     {"6.000 restarted" MONITOR}},
    {"AnAnnouncementThatWasAskedFor",
     [](Story& s) {
       s.monitor().hear("18EAFFF9", "00EE00").hear("18EEFF80", Story::kNameOfA);
       s.hear("18EFFF80", Story::kAnnouncesA).goOn(1s);
     },
     {}},
    {"ARestartThatClaimsFirst",
     [](Story& s) {
       s.monitor().pass(1s).hear("18EEFF80", Story::kNameOfA).pass(10ms).hear("18EEFF80", Story::kHigherName);
       s.hear("18EEFF80", Story::kNameOfA).pass(240ms).hear("18EFFF80", Story::kAnnouncesA).goOn(1s);
     },
     {"7.000 restarted" MONITOR}},
    {"ARestartAmongRequestsToAllForTheirNames",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 3; ++i) s.hear("18EAFFF9", "00EE00").pass(900ms);
       s.hear("18EEFF80", Story::kNameOfA).pass(250ms).hear("18EFFF80", Story::kAnnouncesA).goOn(1s);
     },
     {"8.700 restarted" MONITOR, "8.900 silent" MONITOR " since 5.900", "8.950 back" MONITOR " 3050 ms"}},
    {"AMonitorWithoutStatusesThatIsAskedForItsNameAgainAndAgain",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 10; ++i)
         s.hear("18EAFFF9", "00EE00").hear("18EEFF80", Story::kNameOfA).pass(900ms);
     },
     {"6.900 restarted" MONITOR, "8.900 silent" MONITOR " since 5.900"}},
    {"AMonitorThatIsAskedForItsNameOnceItsLinkIsUpAgain",
     [](Story& s) {
       s.monitor()
           .note(note::LinkDown{})
           .pass(40s)
           .note(note::LinkUp{})
           .pass(50ms)
           .hear("18EAFFF9", "00EE00");
       s.hear("18EEFF80", Story::kNameOfA).hear("18EFFF80", Story::kAnnouncesA).goOn(1s);
     },
     {}},
    {"ADeviceThatTakesTheAddressOfAnother",
     [](Story& s) {
       s.hear("18EEFF80", Story::kNameOfB).hear("18EFFF80", Story::kAnnouncesB).goOn(5s);
       s.hear("18EEFF80", Story::kNameOfA).goOn(300ms).hear("18EFFF80", Story::kAnnouncesA).goOn(1s);
     },
     {"6.000 address_lost 1032AE100801036 to another", "6.000 appeared 80"}},
    {"ANodeThatRestarts",
     [](Story& s) {
       for (const char* state : {"05", "05", "00", "7F", "05"}) s.hear("724", state).pass(1s);
     },
     {"3.000 restarted node 24", "3.000 not_operational node 24", "5.000 operational node 24"}},
    {"ANodeThatBootsAgainAndAgain",
     [](Story& s) {
       for (const char* state : {"05", "00", "00", "00"}) s.hear("724", state).pass(1s);
     },
     {"2.000 restarted node 24", "2.000 not_operational node 24", "3.000 restarted node 24",
      "4.000 restarted node 24"}},
    {"ANodeThatIsSilent",
     [](Story& s) { s.hear("724", "05").pass(1s).hear("724", "05").pass(9s).hear("724", "05"); },
     {"5.000 silent node 24 since 2.000", "11.000 back node 24 9000 ms"}},
    {"ANodeWithASlowHeartbeat",
     [](Story& s) {
       for (int i = 0; i < 5; ++i) s.hear("724", "05").pass(5s);
       s.pass(20s);
     },
     {"36.000 silent node 24 since 21.000"}},
    {"ANodeThatIsNotOperationalAtFirst",
     [](Story& s) { s.hear("724", "7F").pass(1s).hear("724", "05"); },
     {"1.000 not_operational node 24", "2.000 operational node 24"}},
    {"ANodeOfAGatewayThatSendsStatusesAlone",
     [](Story& s) {
       const auto goOn = [&](const char* position, const char* outputs) {
         for (int i = 0; i < 10; ++i) s.hear("1A4", position).hear("2A4", outputs).pass(100ms);
       };
       goOn(Story::kPosition, "83C001");
       goOn("01FFF40371000041", "834001");
       s.pass(40s);
     },
     {"2.000 sensor_error node 24 -1", "2.000 disabled node 24", "5.900 silent node 24 since 2.900"}},
    {"WhatOnlyLooksLikeAStatusOfANode",
     [](Story& s) { s.hear("1A4", Story::kPosition).pass(100ms).hear("1A4", "01FFF40371000041").pass(40s); },
     {}},
    {"ANodeOfAnotherMakerThatIsSilent",
     [](Story& s) {
       for (int i = 0; i < 6; ++i) s.hear("18FF1028", "00").pass(1s);
       s.pass(9s).hear("18FF1028", "00");
     },
     {"9.000 silent 28 since 6.000", "16.000 back 28 10000 ms"}},
    {"ANodeOfAnotherMakerThatSendsEveryTwoSecondsAndIsSilent",
     [](Story& s) {
       for (int i = 0; i < 6; ++i) s.hear("18FF1028", "00").pass(2s);
       s.pass(30s).hear("18FF1028", "00");
     },
     {"17.000 silent 28 since 11.000", "43.000 back 28 32000 ms"}},
    {"ANodeOfAnotherMakerThatSendsEveryNineSecondsAndIsSilent",
     [](Story& s) {
       for (int i = 0; i < 6; ++i) s.hear("18FF1028", "00").pass(9s);
       s.pass(30s);
     },
     {"73.000 silent 28 since 46.000"}},
    {"ANodeOfAnotherMakerThatSendsNowAndThen",
     [](Story& s) {
       for (const Duration pause : {9s, 4s, 9s, 2s, 9s, 1s, 9s, 5s, 9s, 2s, 60s})
         s.hear("18FF1028", "00").pass(pause);
     },
     {}},
    {"ANodeOfAnotherMakerBehindALinkThatIsDown",
     [](Story& s) {
       for (int i = 0; i < 6; ++i) s.hear("18FF1028", "00").pass(1s);
       s.note(note::LinkDown{}).pass(40s).note(note::LinkUp{}).pass(1s).hear("18FF1028", "00");
     },
     {}},
    {"ANodeOfAnotherMakerThatIsNotBackWithItsLink",
     [](Story& s) {
       for (int i = 0; i < 6; ++i) s.hear("18FF1028", "00").pass(1s);
       s.gap().pass(9s).gap().pass(9s).hear("18FF1028", "00");
     },
     {"50.000 not_back 28 since 47.000", "105.000 back 28 58000 ms"}},
    {"ANodeOfAnotherMakerThatIsSilentBeforeAGap",
     [](Story& s) {
       for (int i = 0; i < 6; ++i) s.hear("18FF1028", "00").pass(1s);
       s.pass(9s).gap().pass(9s).hear("18FF1028", "00");
     },
     {"9.000 silent 28 since 6.000", "65.000 back 28 59000 ms"}},
    {"AnAddressOfTheConsoleBehindAGap",
     [](Story& s) {
       s.note(note::OwnAddress{{}, {0x28}});
       for (int i = 0; i < 6; ++i) s.hear("18FF1028", "00").pass(1s);
       s.gap().pass(9s);
     },
     {}},
    {"AnAddressThatAMonitorLeftInAGap",
     [](Story& s) {
       s.monitor().goOn(9s).gap().asksForNames();
       s.hear("18EEFF81", Story::kNameOfA).hear("18EFFF81", Story::kAnnouncesA);
       for (int i = 0; i < 90; ++i) s.hear("18EFFF81", Story::kPosition).pass(100ms);
     },
     {"55.000 moved_address" MONITOR " 128>129"}},
    {"ANodeOfAnotherMakerThatSendsEverySecondBeforeAndAfterAGap",
     [](Story& s) {
       for (int i = 0; i < 6; ++i) s.hear("18FF1028", "00").pass(1s);
       s.gap();
       for (int i = 0; i < 6; ++i) s.hear("18FF1028", "00").pass(1s);
       s.pass(9s);
     },
     {"55.000 silent 28 since 52.000"}},
    // Addresses.
    {"AMove",
     [](Story& s) {
       s.monitor().hear("18EFFF85", Story::kAnnouncesA).pass(100ms).hear("18EFFF85", Story::kPosition);
     },
     {"6.000 moved_address" MONITOR " 128>133"}},
    {"AnAddressLostToALowerName",
     [](Story& s) { s.monitor().hear("18EEFF80", Story::kLowerName).pass(1s); },
     {"6.250 address_lost" MONITOR " to another"}},
    {"AnAddressLostAndAnotherOneTaken",
     [](Story& s) {
       s.monitor()
           .hear("18EEFF80", Story::kLowerName)
           .pass(1ms)
           .hear("18EEFF84", Story::kNameOfA)
           .pass(250ms);
       s.hear("18EFFF84", Story::kAnnouncesA);
       for (int i = 0; i < 100; ++i) s.hear("18EFFF84", Story::kPosition).pass(100ms);
     },
     {"6.001 address_lost" MONITOR " to another", "6.251 moved_address" MONITOR " 128>132"}},
    {"AnAddressOfAnInputModuleThatIsLost",
     [](Story& s) {
       s.hear("18EEFF83", Story::kNameOfB);
       for (int i = 0; i < 50; ++i) s.hear("18EFFF83", "8500").pass(100ms);
       s.hear("18EEFF83", Story::kLowerName).pass(1ms).hear("18EEFF84", Story::kNameOfB).pass(250ms);
       for (int i = 0; i < 100; ++i) s.hear("18EFFF84", "8500").pass(100ms);
     },
     {"6.001 address_lost 83 to another", "6.251 moved_address 84 131>132"}},
    {"AnAddressOfAnInputModuleThatIsLostWithOthersThatItTries",
     [](Story& s) {
       s.hear("18EEFF83", Story::kNameOfB);
       for (int i = 0; i < 50; ++i) s.hear("18EFFF83", "8500").pass(100ms);
       s.hear("18EEFF83", Story::kLowerName).pass(1ms);
       for (const char* id : {"18EEFF84", "18EEFF85"})
         s.hear(id, Story::kNameOfB).pass(1ms).hear(id, Story::kNameOfA).pass(1ms);
       s.hear("18EEFF86", Story::kNameOfB).pass(250ms);
       for (int i = 0; i < 100; ++i) s.hear("18EFFF86", "8500").pass(100ms);
     },
     {"6.001 address_lost 83 to another", "6.255 moved_address 86 131>134"}},
    {"AnAddressThatAnAnnouncementTakesBeforeItsNameDoes",
     [](Story& s) {
       s.monitor().hear("18EEFF80", Story::kNameOfB).pass(1ms).hear("18EFFF80", Story::kAnnouncesB);
       s.pass(100ms);
     },
     {"6.001 address_lost" MONITOR " to another", "6.001 appeared 1032AE100801036"}},
    {"AnAddressLostForWantOfAnAnswer",
     [](Story& s) { s.monitor().hear("18EEFF80", Story::kHigherName).pass(1s); },
     {"6.250 address_lost" MONITOR " to another"}},
    {"AddressesThatAreLostAtOnce",
     [](Story& s) {
       for (const char* id : {"18EEFF20", "18EEFF21", "18EEFF22", "18EEFF23", "18EEFF24", "18EEFF25"})
         s.hear(id, Story::kHigherName);
       s.pass(1s);
       for (const char* id : {"18EEFF20", "18EEFF21", "18EEFF22", "18EEFF23", "18EEFF24", "18EEFF25"})
         s.hear(id, Story::kLowerName);
     },
     {"2.000 address_lost 20 to another", "2.000 address_lost 21 to another",
      "2.000 address_lost 22 to another", "2.000 address_lost 23 to another",
      "2.000 address_lost 24 to another", "2.000 address_lost 25 to another"}},
    {"AnAddressOfAnotherMakerThatIsLost",
     [](Story& s) { s.hear("18EEFF21", Story::kHigherName).pass(1s).hear("18EEFF21", Story::kLowerName); },
     {"2.000 address_lost 21 to another"}},
    {"AContestThatTheHolderWins",
     [](Story& s) {
       s.monitor().hear("18EEFF80", Story::kHigherName).pass(50ms).hear("18EEFF80", Story::kNameOfA).goOn(1s);
     },
     {}},
    {"ANameThatCannotClaimIsToldOnce",
     [](Story& s) {
       s.monitor().hear("18EEFFFE", Story::kNameOfA).pass(1s).hear("18EEFFFE", Story::kNameOfA);
     },
     {"6.000 cannot_claim" MONITOR}},
    {"ANameThatNeverHadAnAddressAndCannotClaim",
     [](Story& s) { s.hear("18EEFFFE", Story::kHigherName); },
     {"1.000 cannot_claim"}},
    {"TwoAtOneAddress",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 8; ++i)
         s.hear("18EFFF80", i % 2 == 0 ? Story::kPosition : "0112C10644000041").pass(50ms);
       s.goOn(15s);
     },
     {"6.250 two_at_one_address" MONITOR, "17.250 two_at_one_address_over" MONITOR}},
    {"TwoAtOneAddressByTheirPinsAlone",
     [](Story& s) {
       for (const char* pin : {Story::kAnnouncesA, Story::kAnnouncesB, Story::kAnnouncesA})
         s.hear("18EFFF80", pin).pass(2s);
     },
     {"3.000 address_lost" MONITOR, "4.000 silent" MONITOR " since 1.000",
      "5.000 address_lost 1032AE100801036", "5.000 back" MONITOR " 4000 ms",
      "5.250 two_at_one_address" MONITOR}},
    {"TwoAtOneAddressOfWhomOneLostIt",
     [](Story& s) {
       s.hear("18EEFF80", Story::kNameOfB).hear("18EFFF80", Story::kAnnouncesB).goOn(5s);
       s.hear("18EEFF80", Story::kNameOfA).hear("18EFFF80", Story::kAnnouncesA);
       for (int i = 0; i < 200; ++i)
         s.hear("18EFFF80", i % 2 == 0 ? Story::kPosition : "0112C10644000041").pass(50ms);
     },
     {"6.000 address_lost 1032AE100801036 to another", "6.000 appeared" MONITOR,
      "6.250 two_at_one_address" MONITOR}},
    {"TwoAtOneAddressUnderTheNameOfAnotherMaker",
     [](Story& s) {
       s.monitor().goOn(1s).hear("18EEFF80", Story::kLowerName).goOn(2s);
       s.goOn(4s, Story::kPosition, "834051").pass(5s);
     },
     {"7.250 two_at_one_address" MONITOR, "9.000 disabled" MONITOR,
      "14.100 address_lost" MONITOR " to another", "14.100 two_at_one_address_over 80",
      "15.900 silent" MONITOR " since 12.900"}},
    {"TwoAtOneAddressOfADeviceThatHasNotSaidWhoItIs",
     [](Story& s) {
       s.goOn(6s).hear("18EEFF80", Story::kLowerName).goOn(2s).goOn(1s, Story::kPosition, "834051");
     },
     {"7.250 two_at_one_address 80", "9.000 disabled 80"}},
    // Faults.
    {"FaultsRaisedAndCleared",
     [](Story& s) {
       s.monitor().answers(Story::kNoFaults).goOn(1s).answers("02002000020000").goOn(1s);
       s.answers("02002000000000").goOn(1s).answers(Story::kNoFaults);
     },
     {"7.000 fault" MONITOR " 1>1", "7.000 fault" MONITOR " 21>21", "8.000 fault_cleared" MONITOR " 1>1",
      "9.000 fault_cleared" MONITOR " 21>21"}},
    {"AFaultInTheFirstAnswer",
     [](Story& s) { s.monitor().answers("02002000000000"); },
     {"6.000 fault" MONITOR " 21>21"}},
    {"FaultsThatComeOneAfterTheOther",
     [](Story& s) {
       s.monitor();
       for (const char* faults : {"02000000010000", "02000000020000", "02000000040000", "02000000080000",
                                  "02000000100000", "02000000200000"})
         s.answers(faults).goOn(1s);
     },
     {"6.000 fault" MONITOR " 0>0", "7.000 fault_cleared" MONITOR " 0>0", "7.000 fault" MONITOR " 1>1",
      "8.000 fault_cleared" MONITOR " 1>1", "8.000 fault" MONITOR " 2>2",
      "9.000 fault_cleared" MONITOR " 2>2", "9.000 fault" MONITOR " 3>3",
      "10.000 fault_cleared" MONITOR " 3>3", "10.000 fault" MONITOR " 4>4",
      "11.000 fault_cleared" MONITOR " 4>4", "11.000 fault" MONITOR " 5>5"}},
    {"AFaultThatFlickersBesideOthers",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 8; ++i) s.answers(i % 2 == 0 ? "02000000010000" : Story::kNoFaults).goOn(1s);
       s.answers("02000000020000").goOn(10s);
     },
     {"6.000 fault" MONITOR " 0>0", "7.000 fault_cleared" MONITOR " 0>0", "8.000 fault" MONITOR " 0>0",
      "9.000 fault_cleared" MONITOR " 0>0", "14.000 fault" MONITOR " 1>1",
      "16.000 fault_cleared" MONITOR " 0>0 since 13.000 (3)"}},
    {"ErrorCodesThatComeOneAfterTheOther",
     [](Story& s) {
       s.monitor();
       for (const char* code : {"01", "02", "03", "04", "05", "06", "07", "08"})
         s.answers(std::string("020000000000") + code).goOn(1s);
     },
     {"6.000 error_code" MONITOR " 0>1", "7.000 error_code" MONITOR " 1>2", "8.000 error_code" MONITOR " 2>3",
      "9.000 error_code" MONITOR " 3>4", "10.000 error_code" MONITOR " 4>5",
      "11.000 error_code" MONITOR " 5>6", "12.000 error_code" MONITOR " 6>7",
      "13.000 error_code" MONITOR " 7>8"}},
    {"PollsThatRepeatAnAnswer",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 50; ++i) s.answers("0200200000000B").goOn(1s);
     },
     {"6.000 fault" MONITOR " 21>21", "6.000 error_code" MONITOR " 0>11"}},
    {"AnErrorCodeThatChangesAndIsCleared",
     [](Story& s) {
       s.monitor().answers("0200000000000B").goOn(1s).answers("0200000000000C").goOn(1s);
       s.answers(Story::kNoFaults);
     },
     {"6.000 error_code" MONITOR " 0>11", "7.000 error_code" MONITOR " 11>12",
      "8.000 error_code_cleared" MONITOR " 12>0"}},
    {"FaultsOfANode",
     [](Story& s) {
       s.hear("724", "05").hear("5A4", "4301500100002000").pass(1s).hear("5A4", "4301500100000000");
       s.hear("5A4", "4B0150020B00").pass(1s).hear("5A4", "4B0150020000");
     },
     {"1.000 fault node 24 13>13", "2.000 fault_cleared node 24 13>13", "2.000 error_code node 24 0>11",
      "3.000 error_code_cleared node 24 11>0"}},
    {"AnErrorCodeOfANodeThatSettles",
     [](Story& s) {
       s.hear("724", "05");
       for (const char* code : {"0B", "0C", "0B", "0C", "0B", "0C"})
         s.hear("5A4", std::string("4B015002") + code + "00").hear("724", "05").pass(900ms);
       for (int i = 0; i < 20; ++i) s.hear("724", "05").pass(1s);
     },
     {"1.000 error_code node 24 0>11", "1.900 error_code node 24 11>12", "2.800 error_code node 24 12>11",
      "3.700 error_code node 24 11>12", "11.000 error_code node 24 12>12 since 5.500 (1)"}},
    {"AnOperationalError",
     [](Story& s) { s.monitor().goOn(1s, "011D940371000045").goOn(1s); },
     {"6.000 operational_error" MONITOR " 0>0", "7.000 operational_error_over" MONITOR " 0>0"}},
    {"AnOperationalErrorWhoseCodeIsAsked",
     [](Story& s) {
       s.monitor()
           .goOn(1s, "011D940371000045")
           .answers("0200000000000B")
           .goOn(1s, "011D940371000045")
           .goOn(1s);
     },
     {"6.000 operational_error" MONITOR " 0>0", "7.000 error_code" MONITOR " 0>11",
      "8.000 operational_error_over" MONITOR " 11>0"}},
    {"ASensorError",
     [](Story& s) { s.monitor().goOn(1s, "01FFF40371000041").goOn(1s); },
     {"6.000 sensor_error" MONITOR " -1", "7.000 sensor_error_over" MONITOR " -1"}},
    {"ARiserThatIsFaulted",
     [](Story& s) {
       for (const char* outputs : {"848000", "84C000", "848000"}) s.hear("18EFFF91", outputs).pass(100ms);
     },
     {"1.100 device_faulted 91", "1.200 device_faulted_over 91"}},
    // Modes.
    {"DisabledAndEnabled",
     [](Story& s) { s.monitor().goOn(1s, Story::kPosition, "834051").goOn(1s); },
     {"6.000 disabled" MONITOR, "7.000 enabled" MONITOR}},
    {"DisabledWithAStopErrorAtFirst",
     [](Story& s) {
       s.hear("18FEF100", "11").pass(10s).hear("18EFFF80", Story::kAnnouncesA);
       s.goOn(1s, "011D940371840041", "834051").goOn(1s);
     },
     {"11.000 appeared" MONITOR, "11.000 stop_error" MONITOR " +1 0>2", "11.000 disabled" MONITOR,
      "12.000 stop_left" MONITOR " +1 2>0", "12.000 stop_left" MONITOR " +2 1>0", "12.000 enabled" MONITOR}},
    {"RemoteMode",
     [](Story& s) { s.monitor().goOn(1s, Story::kPosition, "83C059").goOn(1s); },
     {"6.000 remote_mode" MONITOR, "7.000 remote_mode_over" MONITOR}},
    {"Stowed",
     [](Story& s) { s.monitor().goOn(1s, Story::kPosition, "83A051").goOn(1s); },
     {"6.000 stowed" MONITOR, "7.000 not_stowed" MONITOR}},
    {"APermissiveThatTimesOutAndComesBack",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 10; ++i) s.hear("18EF8021", "A1000F").goOn(100ms);
       s.goOn(2s).hear("18EF8021", "A1000F");
     },
     {"7.200 permissive_lost" MONITOR, "9.000 permissive_back" MONITOR}},
    {"APermissiveThatIsWithdrawn",
     [](Story& s) {
       s.monitor().hear("18EF8021", "A1000F").goOn(100ms).hear("18EF8021", "A10000").goOn(100ms);
       s.hear("18EF8021", "A10001");
     },
     {"6.100 permissive_lost" MONITOR, "6.200 permissive_back" MONITOR}},
    // Stops and limits.
    {"AStop",
     [](Story& s) { s.monitor().goOn(1s, "011D940371400041").goOn(1s); },
     {"6.000 stop_reached" MONITOR " +1 0>1", "7.000 stop_left" MONITOR " +1 1>0"}},
    {"AStopThatReportsAnError",
     [](Story& s) { s.monitor().goOn(1s, "011D940371020041").goOn(1s, "011D940371010041"); },
     {"6.000 stop_error" MONITOR " -2 0>2", "7.000 stop_reached" MONITOR " -2 2>1"}},
    {"SoftLimits",
     [](Story& s) {
       s.monitor();
       for (const char* limits : {"81FC7C03840000", "81FC7C02BC0000"})
         s.hear("18EFFF80", std::string(limits).substr(0, 12)).goOn(1s);
       for (const char* limits : {"82FE0C00E100", "82FED400E100"}) s.hear("18EFFF80", limits).goOn(1s);
     },
     {"7.000 soft_limit_changed" MONITOR " +1 900>700", "9.000 soft_limit_changed" MONITOR " -2 -500>-300"}},
    {"LimitsOfAnOscillationAreNoSoftLimits",
     [](Story& s) {
       s.monitor();
       for (const char* limits : {"81FC7C038400", "81FF9C006480", "81FC7C038400"})
         s.hear("18EFFF80", limits).goOn(1s);
     },
     {}},
    // Joysticks.
    {"AJoystickThatWasThereAllTheTime", [](Story& s) { s.stick(20s); }, {}},
    {"AJoystickThatBeginsAndEnds",
     [](Story& s) { s.hear("18FEF100", "11").pass(5s).stick(1s).pass(3s); },
     {"6.000 joystick_began 33", "7.180 joystick_timed_out 33", "8.980 joystick_ended 33 since 6.980"}},
    {"AJoystickBehindALinkThatIsDown",
     [](Story& s) { s.stick(1s).note(note::LinkDown{}).pass(40s).note(note::LinkUp{}).pass(50ms).stick(5s); },
     {}},
    {"AJoystickThatIsNotBackWithItsLink",
     [](Story& s) { s.stick(1s).gap().pass(9s).gap().pass(9s).stick(1s); },
     {"44.000 joystick_ended 33 since 42.000", "100.000 joystick_began 33"}},
    {"AJoystickThatEndedBeforeAGap",
     [](Story& s) { s.stick(1s).pass(3s).gap().pass(9s); },
     {"2.180 joystick_timed_out 33", "3.980 joystick_ended 33 since 1.980"}},
    {"ADeviceThatSendsJoystickMessagesAloneBeforeAndBehindAGap",
     [](Story& s) {
       s.hear("18EFFF33", Story::kAnnouncesB).stick(5s, "0CFDD633").gap().stick(5s, "0CFDD633");
     },
     {}},
    {"AJoystickThatStopsAfterTheLinkIsUpAgain",
     [](Story& s) { s.stick(1s).gap().stick(1s).pass(9s); },
     {"43.180 joystick_timed_out 33", "44.980 joystick_ended 33 since 42.980"}},
    {"AJoystickWhoseMessagesHaveWrongLengthsFromTheStart",
     [](Story& s) { s.stick(5s, "0CFDD633", "01000100").stick(1s); },
     {"1.200 malformed 33 since 1.000", "6.000 malformed_over 33", "6.000 joystick_began 33"}},
    {"AJoystickMessageOfAWrongLengthNowAndThen",
     [](Story& s) {
       for (int i = 0; i < 5; ++i) s.hear("0CFDD633", "01000100").stick(1s);
     },
     {}},
    {"AJoystickWhoseMessagesHaveWrongLengths",
     [](Story& s) { s.stick(1s).stick(3s, "0CFDD633", "01000100").stick(100ms); },
     {"2.180 joystick_timed_out 33", "2.200 malformed 33 since 2.000", "3.980 joystick_ended 33 since 1.980",
      "5.000 malformed_over 33", "5.000 joystick_began 33"}},
    {"AJoystickWithSomeMessagesOfWrongLengths",
     [](Story& s) {
       s.stick(1s);
       for (int i = 0; i < 20; ++i) s.stick(40ms, "0CFDD633", "01000100").stick(40ms);
     },
     {}},
    {"AJoystickThatBeginsAnew",
     [](Story& s) { s.stick(1s).pass(3s).stick(100ms); },
     {"2.180 joystick_timed_out 33", "3.980 joystick_ended 33 since 1.980", "5.000 joystick_began 33"}},
    {"AGapOfAJoystick",
     [](Story& s) { s.stick(1s).pass(130ms).stick(1s); },
     {"2.130 joystick_gap 33 150 ms"}},
    {"NoGapOfAJoystick", [](Story& s) { s.stick(1s).pass(80ms).stick(1s); }, {}},
    {"AJoystickThatSendsEvery100Ms",
     [](Story& s) {
       for (int i = 0; i < 100; ++i) s.hear("0CFDD633", Story::kNeutral).pass(i % 2 == 0 ? 98ms : 102ms);
     },
     {}},
    {"ATimeOutOfAJoystick",
     [](Story& s) { s.stick(1s).pass(480ms).stick(1s); },
     {"2.180 joystick_timed_out 33", "2.480 joystick_back 33 500 ms"}},
    {"ATimeOutOfAJoystickThatIsToldLate",
     [](Story& s) {
       s.stick(1s);
       for (int i = 0; i < 3; ++i) s.pass(480ms).stick(1s);
       s.stick(20s);
     },
     {"2.180 joystick_timed_out 33", "2.480 joystick_back 33 500 ms", "3.660 joystick_timed_out 33",
      "3.960 joystick_back 33 500 ms", "12.180 joystick_back 33 500 ms since 5.440 (1)"}},
    {"ADeviceThatSendsExtendedJoystickMessagesAlone",
     [](Story& s) {
       const auto stick = [&] {
         for (int i = 0; i < 50; ++i) s.hear("0CFDD780", "0100010000000000").pass(100ms);
       };
       s.hear("18EFFF80", Story::kAnnouncesA);
       stick();
       s.pass(5s);
       stick();
     },
     {"8.900 silent" MONITOR " since 5.900", "11.000 back" MONITOR " 5100 ms"}},
    {"AJoystickThatIsOutranked",
     [](Story& s) {
       s.stick(1s, "0CFDD634", Story::kRight);
       for (int i = 0; i < 10; ++i) s.stick(20ms, "0CFDD633", Story::kRight).hear("0CFDD634", Story::kRight);
       for (int i = 0; i < 10; ++i) s.stick(20ms, "0CFDD633").hear("0CFDD634", Story::kRight);
     },
     {"2.020 joystick_outranked 34 -1 0>51", "2.220 joystick_outranked_over 34 -1"}},
    // The bus.
    {"ABurstOfErrorFrames",
     [](Story& s) {
       for (int i = 0; i < 30; ++i) s.errorFrame(0x8).pass(100ms);
       s.pass(5s);
     },
     {"1.000 error_frames", "4.900 error_frames_over 0>30"}},
    {"AControllerThatIsBusOff",
     [](Story& s) {
       s.errorFrame(0x4, 0x20).pass(10ms).errorFrame(0x40).pass(10ms).errorFrame(0x100).pass(5s);
     },
     {"1.000 error_frames", "1.000 error_passive", "1.010 bus_off", "1.020 error_active",
      "2.020 error_frames_over 0>3"}},
    {"AControllerThatIsBusOffAfterItFlickered",
     [](Story& s) {
       for (int i = 0; i < 3; ++i) s.errorFrame(0x4, 0x20).pass(100ms).errorFrame(0x4, 0x40).pass(100ms);
       s.errorFrame(0x40).pass(100ms).errorFrame(0x100).pass(1s);
     },
     {"1.000 error_frames", "1.000 error_passive", "1.100 error_active", "1.200 error_passive",
      "1.300 error_active", "1.600 bus_off (2)", "2.700 error_frames_over 0>8"}},
    {"AControllerThatIsBusOffAgainAfterItsLinkWasUpAgain",
     [](Story& s) {
       s.errorFrame(0x40).pass(2s).note(note::LinkDown{}).pass(1s).note(note::LinkUp{}).pass(1s);
       s.errorFrame(0x40).pass(2s);
     },
     {"1.000 error_frames", "1.000 bus_off", "2.000 error_frames_over 0>1", "5.000 error_frames",
      "5.000 bus_off", "6.000 error_frames_over 0>1"}},
    {"ABusThatIsFullerThanItsEstimateAllows",
     [](Story& s) {
       s.monitor();
       for (Duration t = 0s; t < 2700ms; t += 540us) s.hear("18FEF100", "1122334455667788").pass(540us);
       s.goOn(3s);
     },
     {"7.000 load_high 0>107 of 250?", "10.000 load_normal 75>0 of 250?"}},
    {"AFullBus",
     [](Story& s) {
       s.monitor();
       for (int i = 0; i < 20; ++i) s.goOn(100ms);
       for (Duration t = 0s; t < 3s; t += 600us) {
         if (t % 120ms == 0s) s.statuses();
         s.hear("18FEF100", "1122334455667788").pass(600us);
       }
       s.goOn(3s);
     },
     {"9.000 load_high 0>97 of 250?", "12.000 load_normal 97>0 of 250?"}},
    {"AFullBusWhoseRateTheLogSays",
     [](Story& s) {
       s.note(note::LinkUp{{}, {}, 500'000});
       for (Duration t = 0s; t < 3s; t += 300us) s.hear("18FEF100", "1122334455667788").pass(300us);
       s.pass(3s);
     },
     {"2.000 load_high 0>96 of 500", "5.000 load_normal 96>0 of 500"}},
    {"ABusThatIsHalfFullOfTheRateThatTheLogSays",
     [](Story& s) {
       s.note(note::LinkUp{{}, {}, 500'000}).monitor();
       for (int i = 0; i < 20; ++i) s.goOn(100ms);
       for (Duration t = 0s; t < 3s; t += 600us) {
         if (t % 120ms == 0s) s.statuses();
         s.hear("18FEF100", "1122334455667788").pass(600us);
       }
       s.goOn(3s);
     },
     {}},
    {"ABusWhoseTimesAreGoodToTheSecond",
     [](Story& s) {
       s.note(note::LinkUp{{}, {}, 500'000});
       for (int second = 0; second < 3; ++second) {
         for (int i = 0; i < 3'400; ++i) s.hear("18FEF100", "1122334455667788");
         s.pass(1s);
       }
       s.pass(3s);
     },
     {}},
    {"ABusThatCarriesMoreThanTheAssumedRateAllows",
     [](Story& s) {
       s.monitor();
       for (Duration t = 0s; t < 3s; t += 300us) {
         if (t % 120ms == 0s) s.statuses();
         s.hear("18FEF100", "1122334455667788").pass(300us);
       }
       s.goOn(3s);
     },
     {}},
};
INSTANTIATE_TEST_SUITE_P(Walk, EventsOf, testing::ValuesIn(kCases),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(EventWalk, HasACaseOfEveryKind) {
  std::set<std::string_view> told{kEvents[EventKind::ClockJump].key};  // below
  for (const EventCase& event : kCases) {
    for (const std::string& line : event.lines) {
      for (const EventFacts& facts : kEvents) {
        if ((line + " ").find(" " + std::string(facts.key) + " ") != std::string::npos)
          told.insert(facts.key);
      }
    }
  }
  for (const EventFacts& facts : kEvents) EXPECT_TRUE(told.contains(facts.key)) << facts.key;
}

// What whole seconds hide is not told: 50 messages of a joystick stand at one time.
TEST(EventWalk, JudgesNothingBelowASecondOfTimesThatAreGoodToTheSecond) {
  for (const bool isSilent : {false, true}) {
    Story story;
    for (int second = 0; second < 10; ++second) {
      if (second == 0) story.hear("18EEFF80", Story::kNameOfA).hear("18EFFF80", Story::kAnnouncesA);
      for (int i = 0; i < 10; ++i) story.statuses();
      const bool hasStick = !isSilent || second < 2 || second > 4;
      for (int i = 0; i < 50 && hasStick; ++i) story.hear("0CFDD633", Story::kNeutral);
      if (hasStick) story.hear("18EF8021", "A1000F");
      story.pass(1s);
    }
    if (!isSilent) {
      EXPECT_EQ(story.lines(), Lines{});
    } else {
      EXPECT_EQ(story.lines(), (Lines{"3.200 joystick_timed_out 33", "3.300 permissive_lost" MONITOR,
                                      "4.000 joystick_ended 33 since 2.000", "6.000 joystick_began 33",
                                      "6.000 permissive_back" MONITOR}))
          << "three seconds are more than the times err by";
    }
  }
}

TEST(EventWalk, TellsThatTheClockJumps) {
  FrameStore frames;
  const std::vector<Frame> all{
      test::frame("18FEF100", "11", 0, 9'000'000'000), test::frame("18FEF100", "11", 0, 10'000'000'000),
      test::frame("18FEF100", "11", 0, 1'000'000'000), test::frame("18FEF100", "11", 0, 2'000'000'000)};
  ASSERT_TRUE(frames.append(all));
  std::vector<Event> events;
  EventWalk walk;
  walk.advance(frames, NoteStore(), cursorAfter(frames, 4), events);
  EXPECT_EQ(test::linesOf(events), (Lines{"10.000 clock_jump"}));
}

// At a cursor anywhere, frame or no frame.
TEST(EventWalk, FindsTheSameHoweverOftenItStops) {
  std::mt19937 random(1);
  for (const EventCase& event : kCases) {
    Story story;
    event.tell(story);
    EventWalk walk;
    std::vector<Event> events;
    for (Instant at = walk.cursor().time; at < story.now();) {
      at = std::max(at, Instant{0}) + Duration(static_cast<std::int64_t>(random() % 500'000'000));
      at = std::min(at, story.now());
      walk.advance(story.frames(), story.notes(), cursorAt(story.frames(), at), events);
    }
    EXPECT_EQ(test::linesOf(events), event.lines) << event.name;
    State state;
    advance(state, story.frames(), story.notes(), story.end());
    EXPECT_EQ(walk.state(), state) << event.name;
  }
}

TEST(EventWalk, DoesNotTellEveryChangeOfAValueThatFlickers) {
  Story story;
  story.monitor();
  for (int i = 0; i < 301; ++i) story.goOn(100ms, Story::kPosition, i % 2 == 0 ? "834051" : "83C051");
  story.goOn(20s, Story::kPosition, "834051");
  const Lines lines = story.lines();
  EXPECT_EQ(lines,
            (Lines{"6.000 disabled" MONITOR, "6.100 enabled" MONITOR, "6.200 disabled" MONITOR,
                   "6.300 enabled" MONITOR, "16.000 enabled" MONITOR " since 15.900 (95)",
                   "26.000 enabled" MONITOR " since 25.900 (99)",
                   "36.000 enabled" MONITOR " since 35.900 (99)", "46.000 disabled" MONITOR " since 36.000"}))
      << "what it settles at is told";
}

TEST(EventWalk, CountsGapsOfAJoystickThatSendsTooSeldom) {
  Story story;
  story.stick(1s);
  for (int i = 0; i < 200; ++i) story.pass(130ms).hear("0CFDD633", Story::kNeutral);
  const Lines lines = story.lines();
  EXPECT_LE(lines.size(), 10u);
  EXPECT_EQ(lines.back().back(), ')') << lines.back();
}

}  // namespace
}  // namespace deckpipe
