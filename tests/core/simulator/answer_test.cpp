// SPDX-License-Identifier: GPL-3.0-or-later
// Answers that are lost, late, doubled, malformed or from elsewhere; and devices that lose their power, are
// reset, and come back, or do not.
#include <gtest/gtest.h>

#include "terminal.h"

namespace deckpipe::simulator::test {
namespace {

class Answer : public ::testing::Test {
 protected:
  // How many frames with this first byte went to F9 within so long after a request from there.
  std::vector<Seen> request(const char* request, Duration d = 50ms) {
    const std::size_t before = rig.log.size();
    rig.send("18EF80F9", request);
    rig.run(d);
    std::vector<Seen> answers;
    for (std::size_t i = before; i < rig.log.size(); ++i) {
      if (rig.log[i].destination() == Address{0xF9} && rig.log[i].source() != Address{0xF9})
        answers.push_back(rig.log[i]);
    }
    return answers;
  }
  MonitorRig rig;
};

TEST_F(Answer, IsLostKOfN) {
  rig.monitor.misbehave({.answers = {.lost = {2, 3}}});
  std::vector<std::size_t> counts;
  for (int i = 0; i < 6; ++i) counts.push_back(request("03").size());
  EXPECT_EQ(counts, (std::vector<std::size_t>{1, 0, 0, 1, 0, 0}));
  rig.monitor.misbehave({.answers = {.lost = {1, 1}}});
  EXPECT_TRUE(request("46").empty()) << "acknowledgements too";
}

TEST_F(Answer, ComesLateAndHoldsUpNoStatus) {
  rig.monitor.misbehave({.answers = {.late = 800ms}});
  const Instant from = rig.now();
  EXPECT_TRUE(request("02", 790ms).empty());
  EXPECT_GE(rig.all(MessageId::PositionLimitStatus, from).size(), 7u);
  rig.run(15ms);
  const auto answers = rig.all(MessageId::FaultResponse, from);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].time - from, 802ms);
}

TEST_F(Answer, LateOnesKeepTheirOrder) {
  rig.monitor.misbehave({.answers = {.late = 300ms}});
  rig.send("18EF80F9", "03");
  rig.send("18EF80F9", "04");
  rig.monitor.misbehave({.answers = {.late = 100ms}});
  rig.send("18EF80F9", "05");
  rig.run(1s);
  const Instant firmware = rig.all(MessageId::FirmwareResponse)[0].time;
  EXPECT_LT(firmware, rig.all(MessageId::PcodeResponse)[0].time);
  EXPECT_GT(firmware, rig.all(MessageId::ConfigResponse)[0].time);
}

TEST_F(Answer, ComesTwice) {
  rig.monitor.misbehave({.answers = {.twice = true}});
  EXPECT_EQ(request("04").size(), 2u);
  EXPECT_EQ(request("21").size(), 4u);
}

TEST_F(Answer, HasAWrongLengthWhileStatusesAreRight) {
  rig.monitor.misbehave({.answers = {.wrongLength = true}});
  const Instant from = rig.now();
  struct Row {
    const char* request;
    unsigned length;
  };
  for (const Row& row : {Row{"02", 6}, Row{"03", 6}, Row{"41", 2}}) {
    const auto answers = request(row.request);
    ASSERT_EQ(answers.size(), 1u) << row.request;
    EXPECT_EQ(answers[0].frame.length, row.length) << row.request;
  }
  for (const Seen& seen : rig.all(MessageId::PositionLimitStatus, from)) EXPECT_FALSE(seen.what.malformed);
}

TEST_F(Answer, ComesFromAWrongSource) {
  rig.monitor.misbehave({.answers = {.wrongSource = true}});
  const auto answers = request("02");
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].source(), Address{0x81});
}

TEST_F(Answer, OfOlderFirmwareHasFiveBytesAndNoErrorCode) {
  rig.monitor.misbehave(
      {.faultBits = faultBit("internal_fuse"), .pcodeError = 42, .answers = {.shortFault = true}});
  const auto answers = request("02");
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].frame.length, 5u);
  EXPECT_EQ(FaultStatus::of(answers[0].frame), (FaultStatus{faultBit("internal_fuse"), std::nullopt}));
  EXPECT_EQ(request("03")[0].frame.length, 7u);
}

TEST_F(Answer, CarriesReservedFaultBitsAndAnyErrorCode) {
  rig.monitor.misbehave({.faultBits = kOlderFaultBits, .pcodeError = 42});
  const auto answers = request("02");
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(Rig::textOf(answers[0]), "faults=; reserved_bits=17, 18, 19, 20, 22; pcode_error=42");
  rig.run(200ms);
  EXPECT_EQ(rig.position().operationalError, Status2::On);
}

TEST_F(Answer, AnIntruderAnswersNothingOfAkrons) {
  rig.monitor.misbehave({.addressTaken = true});
  rig.run(1s);
  ASSERT_EQ(rig.monitor.address(), Address{0x81});
  for (const char* type : {"02", "03", "FE41", "45"}) EXPECT_TRUE(request(type).empty()) << type;
}

class Power : public ::testing::Test {
 protected:
  std::size_t framesSince(Instant from) const {
    std::size_t count = 0;
    for (const Seen& seen : rig.log) count += seen.time > from;
    return count;
  }
  MonitorRig rig;
};

TEST_F(Power, OffMeansSilenceAndStandstillAndOnANewClaim) {
  rig.simulator.press(rig.now() + 1s, 0, Simulator::Button::PowerOff);
  rig.simulator.press(rig.now() + 4s, 0, Simulator::Button::PowerOn);
  rig.hold(stick(0x33, 1000, 0), 1s);
  const Instant off = rig.now();
  rig.run(1ms);
  const double before = rig.rotation();
  EXPECT_FALSE(rig.monitor.isPowered());
  EXPECT_EQ(rig.monitor.address(), kNullAddress);
  rig.run(2900ms);
  EXPECT_EQ(framesSince(off + 1ms), 0u);
  EXPECT_EQ(rig.rotation(), before);
  rig.run(2s);
  ASSERT_EQ(rig.all(MessageId::Name, off).size(), 1u);
  EXPECT_EQ(rig.all(MessageId::Name, off)[0].time - off, 3500ms) << "its boot time after power";
  EXPECT_EQ(rig.all(MessageId::AddressAnnouncement, off).size(), 1u);
  EXPECT_EQ(rig.monitor.address(), Address{0x80});
}

TEST_F(Power, OnWhereItIsOnDoesNothing) {
  const Instant from = rig.now();
  rig.simulator.press(rig.now(), 0, Simulator::Button::PowerOn);
  rig.run(5s);
  EXPECT_TRUE(rig.all(MessageId::Name, from).empty());
}

TEST_F(Power, ComesBackAtAnotherAddressWhereAsked) {
  rig.monitor.misbehave({.elsewhere = true});
  for (const unsigned address : {0x81u, 0x82u}) {
    rig.simulator.press(rig.now(), 0, Simulator::Button::PowerOff);
    rig.simulator.press(rig.now() + 1s, 0, Simulator::Button::PowerOn);
    rig.run(3s);
    EXPECT_EQ(rig.monitor.address(), Address{static_cast<std::uint8_t>(address)});
    EXPECT_EQ(rig.all(MessageId::AddressAnnouncement).back().source(), rig.monitor.address());
  }
}

TEST_F(Power, TheResetButtonIsMessage45) {
  const Instant at = rig.now();
  rig.simulator.press(at, 0, Simulator::Button::Reset);
  rig.run(3s);
  ASSERT_EQ(rig.all(MessageId::Name, at).size(), 1u);
  EXPECT_EQ(rig.all(MessageId::Name, at)[0].time - at, Misbehaviour::kReset);
}

TEST_F(Power, AResetTakesAsLongAsAsked) {
  rig.monitor.misbehave({.resetTakes = 12s});
  const Instant at = rig.now();
  rig.send("18EF8005", "45");
  rig.run(20s);
  ASSERT_EQ(rig.all(MessageId::AddressAnnouncement, at).size(), 1u);
  EXPECT_EQ(rig.all(MessageId::AddressAnnouncement, at)[0].time - at, 12s + AddressClaim::kContention);
}

TEST_F(Power, AResetMayNeverComeBackUntilThePowerIsSwitched) {
  rig.monitor.misbehave({.resetTakes = Misbehaviour::kForever});
  const Instant at = rig.now();
  rig.send("18EF8005", "45");
  rig.run(1h);
  EXPECT_EQ(framesSince(at), 0u);
  rig.simulator.press(rig.now(), 0, Simulator::Button::PowerOff);
  rig.simulator.press(rig.now(), 0, Simulator::Button::PowerOn);
  rig.run(1s);
  EXPECT_EQ(rig.monitor.address(), Address{0x80});
}

}  // namespace
}  // namespace deckpipe::simulator::test
