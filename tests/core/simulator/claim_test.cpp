// SPDX-License-Identifier: GPL-3.0-or-later
// How simulated devices get, defend, lose and announce their addresses: J1939-81 and Appendix A.
#include <gtest/gtest.h>

#include <bit>
#include <set>

#include "rig.h"

namespace deckpipe::simulator::test {
namespace {

constexpr MessageId kName = MessageId::Name;
constexpr MessageId kAnnouncement = MessageId::AddressAnnouncement;

Frame claim(std::uint64_t name, unsigned source) {
  return nameFrame({name}, Address{static_cast<std::uint8_t>(source)});
}

TEST(Claim, NameIsTheManualsExample) {
  const Identity identity = identityOf("1032AE100801035", {}, {});
  EXPECT_EQ(nameFrame(identity.name, Address{0x80}), frame("18EEFF80", "0B1AC22800420090", 0, kNoStamp));
  EXPECT_EQ(announcementFrame(*identity.pin, Address{0x80}),
            frame("18EFFF80", "FF83150206021A0B", 0, kNoStamp));
}

TEST(Claim, StartsAtEightyAndAnnouncesItselfAfterTheContentionTime) {
  Rig rig;
  Device& device = rig.simulator.add<Monitor6032>(500ms, MonitorRig::kPin, MonitorSettings{}, 1u);
  rig.simulator.powerOn(rig.now());
  rig.run(749ms);
  ASSERT_EQ(rig.log.size(), 1u) << "nothing but the claim before 250 ms have passed";
  EXPECT_EQ(rig.log[0].time, Instant{} + 500ms);
  EXPECT_EQ(rig.log[0].source(), Address{0x80});
  EXPECT_EQ(device.address(), kNullAddress);
  rig.run(1ms);
  EXPECT_EQ(device.address(), Address{0x80});
  ASSERT_EQ(rig.all(kAnnouncement).size(), 1u);
  EXPECT_EQ(rig.all(kAnnouncement)[0].time, Instant{} + 750ms);
  EXPECT_EQ(rig.last(kAnnouncement), "pin=1032AE100801035; device_type=1032");
}

TEST(Claim, DefendsItsAddressAgainstAHigherName) {
  MonitorRig rig;
  const Instant before = rig.now();
  rig.send(claim(rig.monitor.identity().name.value + 1, 0x80));
  rig.run(5ms);
  EXPECT_EQ(rig.monitor.address(), Address{0x80});
  EXPECT_EQ(rig.all(kName, before).size(), 2u) << "theirs, and ours again";
  rig.run(1s);
  EXPECT_TRUE(rig.all(kAnnouncement, before).empty()) << "it lost nothing, so there is nothing to announce";
}

TEST(Claim, LosesItsAddressToALowerNameAndAnnouncesTheNextOne) {
  MonitorRig rig;
  const Instant before = rig.now();
  rig.send(claim(1, 0x80));
  EXPECT_EQ(rig.monitor.address(), kNullAddress);
  rig.run(250ms);
  for (const Seen& seen : rig.log) {
    if (seen.time > before) {
      EXPECT_EQ(seen.what.message, kName) << "spoke without an address";
    }
  }
  rig.run(2ms);
  EXPECT_EQ(rig.monitor.address(), Address{0x81});
  ASSERT_EQ(rig.all(kAnnouncement, before).size(), 1u);
  EXPECT_EQ(rig.all(kAnnouncement, before)[0].source(), Address{0x81});
  rig.run(1s);
  EXPECT_FALSE(rig.all(MessageId::PositionLimitStatus, Address{0x81}).empty());
}

TEST(Claim, PassesOverAddressesItHeardClaimed) {
  MonitorRig rig;
  rig.send(claim(2, 0x81));
  rig.send(claim(3, 0x82));
  rig.send(claim(1, 0x80));
  rig.run(300ms);
  EXPECT_EQ(rig.monitor.address(), Address{0x83});
}

TEST(Claim, LowerNameKeepsTheAddressThatBothWant) {
  Rig rig;
  Device& high = rig.simulator.add<Monitor6032>(500ms, "1032AE100801099", MonitorSettings{}, 1u);
  Device& low = rig.simulator.add<Monitor6032>(600ms, "1032AE100801035", MonitorSettings{}, 2u);
  rig.simulator.powerOn(rig.now());
  rig.run(2s);
  EXPECT_EQ(low.address(), Address{0x80});
  EXPECT_EQ(high.address(), Address{0x81});
  EXPECT_EQ(rig.all(kAnnouncement).size(), 2u);
}

TEST(Claim, SaysThatItCannotClaimWhereNoAddressIsFree) {
  MonitorRig rig;
  for (unsigned a = 0x81; a <= 0xF7; ++a) rig.send(claim(a, a));
  const Instant before = rig.now();
  rig.send(claim(1, 0x80));
  rig.run(160ms);
  const auto cannot = rig.all(kName, kNullAddress, before);
  ASSERT_EQ(cannot.size(), 1u);
  EXPECT_LE(cannot[0].time - before, 153ms);
  EXPECT_EQ(rig.monitor.claimState(), AddressClaim::State::CannotClaim);
  rig.run(5s);
  EXPECT_EQ(rig.all(kName, kNullAddress, before).size(), 1u);
  EXPECT_TRUE(rig.all(MessageId::PositionLimitStatus, before).empty()) << "it has no address to speak from";

  rig.send("18EAFFF9", "00EE00");
  rig.run(160ms);
  EXPECT_EQ(rig.all(kName, kNullAddress, before).size(), 2u) << "asked, it says so again";
  EXPECT_TRUE(rig.all(kAnnouncement, before).empty());
}

TEST(Claim, TriesEveryAddressBeforeItGivesUp) {
  MonitorRig rig;
  std::set<unsigned> tried;
  for (unsigned i = 0; i < 300 && rig.monitor.claimState() != AddressClaim::State::CannotClaim; ++i) {
    const unsigned at = rig.all(kName).back().source().value;
    tried.insert(at);
    rig.send(claim(1 + at, at));
    rig.run(10ms);
  }
  EXPECT_EQ(tried.size(), 0xF7u - 0x80u + 1u);
}

TEST(Claim, CannotClaimDelayFollowsTheSeed) {
  const auto delay = [](std::uint64_t seed) {
    Outbox out;
    AddressClaim claim(akronName(5), {Address{0x80}, Address{0x80}}, seed);
    claim.start({}, out);
    out.clear();
    const Frame rival = nameFrame({1}, Address{0x80});
    claim.received({}, J1939Id::of(rival.identifier()), rival, out);
    return out.nextTime().ns;
  };
  std::set<std::int64_t> delays;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    EXPECT_EQ(delay(seed), delay(seed));
    EXPECT_GE(delay(seed), 0);
    EXPECT_LE(delay(seed), std::chrono::nanoseconds(153ms).count());
    delays.insert(delay(seed));
  }
  EXPECT_GT(delays.size(), 30u);
}

TEST(Claim, IgnoresWhatIsNoClaim) {
  struct Row {
    const char* name;
    Frame frame;
  };
  Frame shortName = claim(1, 0x80);
  shortName.length = 7;
  Frame remote = claim(1, 0x80);
  remote.id |= kRemoteBit;
  Frame standard = claim(1, 0x80);
  standard.id = 0x080;
  const Row rows[] = {
      {"seven_bytes", shortName},
      {"name_zero", claim(0, 0x80)},
      {"from_global_address", claim(1, 0xFF)},
      {"remote_frame", remote},
      {"eleven_bit_identifier", standard},
      {"another_address", claim(1, 0x90)},
      {"cannot_claim_of_another", claim(1, 0xFE)},
  };
  for (const Row& row : rows) {
    MonitorRig rig;
    rig.send(row.frame);
    EXPECT_EQ(rig.monitor.address(), Address{0x80}) << row.name;
  }
}

TEST(Claim, AnswersARequestForItsNameAndAnnouncesItself) {
  struct Row {
    const char* name;
    const char* id;
    const char* data;
    bool answered;
  };
  const Row rows[] = {
      {"to_all", "18EAFFF9", "00EE00", true},
      {"to_all_from_null", "18EAFFFE", "00EE00", true},
      {"to_it", "18EA80F9", "00EE00", true},
      {"to_another", "18EA81F9", "00EE00", false},
      {"for_another_pgn", "18EAFFF9", "00EB00", false},
      {"two_bytes", "18EAFFF9", "00EE", false},
      {"padded_to_four_bytes", "18EAFFF9", "00EE00FF", true},
      {"padded_to_eight_bytes", "18EAFFF9", "00EE00FFFFFFFFFF", true},
  };
  for (const Row& row : rows) {
    MonitorRig rig;
    const Instant before = rig.now();
    rig.send(row.id, row.data);
    rig.run(5ms);
    EXPECT_EQ(rig.all(kName, before).size(), row.answered ? 1u : 0u) << row.name;
    EXPECT_EQ(rig.all(kAnnouncement, before).size(), row.answered ? 1u : 0u) << row.name;
    if (row.answered) {
      EXPECT_LT(rig.all(kName, before)[0].time, rig.all(kAnnouncement, before)[0].time) << row.name;
    }
  }
}

TEST(Claim, IoModuleHasANameAndMakesNoAnnouncement) {
  Rig rig;
  rig.simulator.add<IoModule6039>(100ms, 4711u, 1u);
  rig.simulator.powerOn(rig.now());
  rig.run(1s);
  rig.send("18EAFFF9", "00EE00");
  rig.run(1s);
  EXPECT_EQ(rig.all(kName).size(), 2u);
  EXPECT_TRUE(rig.all(kAnnouncement).empty());
  EXPECT_FALSE(rig.all(MessageId::DigitalInputs).empty());
}

}  // namespace
}  // namespace deckpipe::simulator::test
