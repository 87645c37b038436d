// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bus/j1939.h"
#include "support/pair.h"

namespace deckpipe::test {
namespace {

using Progress = ClaimStatus::Progress;

Frame claimFrame(std::uint64_t name, std::uint8_t source) {
  Frame f;
  f.id = J1939Id{6, pgn::kAddressClaimed, Address{source}, kGlobalAddress}.frameId();
  f.length = 8;
  f.data = std::bit_cast<Payload>(name);
  return f;
}
Frame requestNames(std::uint8_t source, std::uint8_t destination = 0xFF) {
  Frame f = frame("18EAFFFE", "00EE00");
  f.id = J1939Id{6, pgn::kRequest, Address{source}, Address{destination}}.frameId();
  return f;
}

// A console alone on the bus.
struct Claim : ::testing::Test {
  Claim() { pair.addConsole(); }
  Pair pair;
  ClaimStatus status() { return pair.console().status(pair.now()).claim; }
  std::vector<Pair::Seen> names(Instant from = kNotYet) {
    std::vector<Pair::Seen> out = pair.sentBy(&pair.console(), from);
    std::erase_if(out, [](const Pair::Seen& seen) { return seen.id().pgn != pgn::kAddressClaimed; });
    return out;
  }
  std::uint64_t ours() { return status().name; }
  // Other services go on with the log as it is.
  Console& connectAgain(Console& before) {
    pair.setLink(before, false);
    before.state.apply(Note{.time = pair.now(), .value = note::LinkDown{}});
    pair.run(3s);
    Console& console = pair.addConsole();
    console.state = before.state;
    console.state.apply(Note{.time = pair.now(), .value = note::LinkUp{}});
    return console;
  }
  // Another node holds every address from `first` on.
  void takeAll(unsigned first) {
    for (unsigned a = first; a <= 0xFD; ++a)
      pair.inject(claimFrame(0x1000 + a, static_cast<std::uint8_t>(a)));
  }
};

TEST_F(Claim, LockedNothingIsSentWhateverIsAsked) {
  pair.inject(requestNames(0x80));
  pair.inject(claimFrame(5, 0xF9));
  pair.run(5s);
  EXPECT_TRUE(pair.sentBy(&pair.console()).empty());
  EXPECT_EQ(status().progress, Progress::Off);
}

TEST_F(Claim, UnlockedItAsksWhoIsThereFirstThenClaimsTheServiceTools) {
  pair.intend(intent::Unlock{});
  ASSERT_EQ(pair.sentBy(&pair.console()).size(), 1u);
  EXPECT_EQ(pair.log.back().frame.id, frame("18EAFFFE", "").id);
  pair.run(ClaimService::kListen - 1ms);
  EXPECT_TRUE(names().empty());
  pair.run(1ms);
  ASSERT_EQ(names().size(), 1u);
  EXPECT_EQ(names()[0].frame.id, frame("18EEFFF9", "").id);
  EXPECT_EQ(status().progress, Progress::Claiming);
  pair.run(kClaimTime);
  EXPECT_EQ(status().progress, Progress::Claiming) << "counted from its echo";
  pair.run(Pair::kFlight);
  EXPECT_EQ(status().progress, Progress::Claimed);
  EXPECT_EQ(status().address, Address{0xF9});
  EXPECT_EQ(pair.console().state.channel(Channel{}).ownAddress, Address{0xF9});
}

TEST_F(Claim, ItsNameIsAServiceToolsWithItsOwnIdentityNumber) {
  const Name name = consoleName(0x3FFFFF);
  EXPECT_EQ(name.function(), 129u);
  EXPECT_EQ(name.identityNumber(), 0x1FFFFFu) << "21 bits";
  EXPECT_EQ(name.part(fieldOf(j1939::kNameFields, "industry_group").bits), 0u);
  EXPECT_EQ(name.part(fieldOf(j1939::kNameFields, "arbitrary_address_capable").bits), 1u);
}

TEST_F(Claim, WhatOthersHoldOrUseWithoutANameIsLeftAlone) {
  pair.inject(claimFrame(5, 0xF9));
  pair.inject(frame("18FECAFA", "0000000000000000"));
  pair.inject(claimFrame(6, 0xF7));
  pair.unlock();
  EXPECT_EQ(status().address, Address{0xF6});
}

TEST_F(Claim, AnAddressWhoseHolderCannotClaimIsFreeAgain) {
  pair.inject(claimFrame(5, 0xF9));
  pair.inject(claimFrame(5, 0xFE));
  pair.unlock();
  EXPECT_EQ(status().address, Address{0xFA}) << "it was used, and may be again";
}

TEST_F(Claim, TheAddressThatItHadBeforeAGapIsItsOwnAgain) {
  Console* console = &pair.console();
  for (int i = 0; i < 3; ++i) {
    pair.intend(*console, intent::Unlock{});
    pair.run(1s);
    EXPECT_EQ(console->status(pair.now()).claim.address, Address{0xF9})
        << "connected again " << i << " times";
    console = &connectAgain(*console);
  }
}

TEST_F(Claim, AHigherNameIsAnsweredAtOnceAndLoses) {
  pair.unlock();
  const Instant before = pair.now();
  pair.inject(claimFrame(~0ull, 0xF9));
  pair.run(10ms);
  ASSERT_EQ(names(before).size(), 1u);
  EXPECT_EQ(names(before)[0].frame.id, frame("18EEFFF9", "").id);
  EXPECT_EQ(status().progress, Progress::Claimed);
  EXPECT_EQ(status().won, 1);
}

TEST_F(Claim, ALowerNameTakesTheAddressAndAnotherIsClaimed) {
  pair.unlock();
  pair.inject(claimFrame(1, 0xF9));
  pair.run(1ms);
  EXPECT_EQ(status().progress, Progress::Claiming);
  EXPECT_EQ(status().address, Address{0xFA});
  EXPECT_EQ(status().lost, 1);
  EXPECT_EQ(pair.console().state.channel(Channel{}).ownAddress, kNullAddress);
  pair.run(kClaimTime + Pair::kFlight);
  EXPECT_EQ(status().progress, Progress::Claimed);
}

// Both frames arrive before anything is written, as after a stall.
TEST_F(Claim, NothingMoreIsSentFromAnAddressThatWasLostMeanwhile) {
  pair.intend(intent::Unlock{});
  pair.run(1s);
  ASSERT_EQ(status().progress, Progress::Claimed);
  Services& services = pair.console().services;
  services.received(pair.now(), pair.console().state, requestNames(0x80));
  services.received(pair.now(), pair.console().state, claimFrame(5, 0xF9));
  std::vector<OutFrame> out;
  services.takeFrames(out);
  ASSERT_FALSE(out.empty()) << "another address is claimed";
  for (const OutFrame& sent : out) EXPECT_NE(J1939Id::of(sent.frame.identifier()).source, Address{0xF9});
}

TEST_F(Claim, ContestedWhileClaimingItNeverUsesTheAddress) {
  pair.intend(intent::Unlock{});
  pair.run(ClaimService::kListen + 100ms);
  pair.inject(claimFrame(1, 0xF9));
  pair.run(kClaimTime - 1ms);
  EXPECT_EQ(status().progress, Progress::Claiming);
  EXPECT_EQ(status().address, Address{0xFA});
  pair.run(3ms);
  EXPECT_EQ(status().progress, Progress::Claimed);
}

TEST_F(Claim, WhereNoneIsFreeItSaysSoOnceAndWhenAsked) {
  takeAll(0x80);
  const Instant before = pair.now();
  pair.unlock();
  EXPECT_EQ(status().progress, Progress::CannotClaim);
  EXPECT_EQ(status().address, kNullAddress);
  ASSERT_EQ(names(before).size(), 1u);
  EXPECT_EQ(names(before)[0].frame.id, frame("18EEFFFE", "").id);
  EXPECT_LE(names(before)[0].time - before, ClaimService::kListen + 154ms);
  const Instant asked = pair.now();
  pair.inject(requestNames(0x80));
  pair.run(1s);
  ASSERT_EQ(names(asked).size(), 1u);
  EXPECT_EQ(names(asked)[0].frame.id, frame("18EEFFFE", "").id);
  EXPECT_EQ(pair.intend(intent::SendRequests{{}, kPolls}), Refusal::NoAddress);
}

TEST_F(Claim, RequestsForItsNameThatArePaddedAreAnswered) {
  pair.unlock();
  const Instant before = pair.now();
  pair.inject(frame("18EAFF80", "00EE00FF"));
  pair.inject(frame("18EAFF80", "00EE00FFFFFFFFFF"));
  pair.run(50ms);
  EXPECT_EQ(names(before).size(), 2u);
}

TEST_F(Claim, RequestsForItsNameAreAnsweredToAllAndToItself) {
  pair.unlock();
  for (const std::uint8_t destination : {std::uint8_t{0xFF}, std::uint8_t{0xF9}}) {
    const Instant before = pair.now();
    pair.inject(requestNames(0x80, destination));
    pair.run(50ms);
    ASSERT_EQ(names(before).size(), 1u) << static_cast<unsigned>(destination);
    EXPECT_EQ(loadLittle(names(before)[0].frame.data), ours());
  }
  const Instant before = pair.now();
  pair.inject(requestNames(0x80, 0x42));
  pair.inject(frame("18EAFF80", "00EE"));  // a byte short
  pair.run(50ms);
  EXPECT_TRUE(names(before).empty());
}

TEST_F(Claim, ARequestToUsForAnythingElseIsSaidToBeForWhatWeHaveNot) {
  const Frame wanted = frame("18EAF980", "DAFE00");
  pair.inject(wanted);
  pair.run(1s);
  EXPECT_TRUE(pair.sentBy(&pair.console()).empty()) << "locked";
  pair.unlock();
  const Instant before = pair.now();
  pair.inject(wanted);
  pair.inject(frame("18EAFF80", "DAFE00"));  // to all
  pair.inject(frame("18EA4280", "DAFE00"));  // to another
  pair.inject(frame("18EAF980", "DAFE"));    // a byte short
  pair.run(50ms);
  const auto sent = pair.sentBy(&pair.console(), before);
  ASSERT_EQ(sent.size(), 1u);
  const Frame answer = frame("18E8FFF9", "01FFFFFF80DAFE00");
  EXPECT_EQ(sent[0].frame.id, answer.id);
  EXPECT_EQ(sent[0].frame.length, answer.length);
  EXPECT_EQ(sent[0].frame.data, answer.data);
  pair.inject(wanted);
  pair.run(1ms);
  EXPECT_EQ(pair.sentBy(&pair.console(), before).size(), 1u) << "not as often as somebody may ask";
  pair.run(ClaimService::kDeclineAgain);
  pair.inject(wanted);
  pair.run(1ms);
  EXPECT_EQ(pair.sentBy(&pair.console(), before).size(), 2u);
}

TEST_F(Claim, OurOwnFramesOfAnEarlierRunThatTheAdapterKeptAreNobodys) {
  pair.console().leaves = [](const Frame&) { return Duration{400ms}; };
  const std::uint64_t name = ours();
  pair.intend(intent::Unlock{});
  pair.run(100ms);
  pair.inject(claimFrame(name, 0xF9));
  pair.inject(frame("18EF80F9", "02"));
  pair.run(3s);
  EXPECT_EQ(status().progress, Progress::Claimed);
  EXPECT_EQ(status().address, Address{0xF9});
  EXPECT_EQ(status().conflicts, 0u);
}

TEST_F(Claim, ClaimsThatAreNoneChangeNothing) {
  pair.unlock();
  const Instant before = pair.now();
  pair.inject(claimFrame(0, 0xF9));
  pair.inject(claimFrame(1, 0xFF));
  Frame tooShort = claimFrame(1, 0xF9);
  tooShort.length = 7;
  pair.inject(tooShort);
  pair.run(1s);
  EXPECT_EQ(status().address, Address{0xF9});
  EXPECT_TRUE(names(before).empty());
}

TEST_F(Claim, AnotherNodeWithOurVeryNameEndsOurSending) {
  pair.unlock();
  pair.inject(claimFrame(ours(), 0x90));
  pair.run(1ms);
  EXPECT_EQ(status().progress, Progress::SameName);
  const Instant before = pair.now();
  pair.inject(requestNames(0x80));
  pair.run(1s);
  EXPECT_TRUE(pair.sentBy(&pair.console(), before).empty());
  EXPECT_EQ(pair.intend(intent::SendRequests{{}, kPolls}), Refusal::NoAddress);
}

TEST_F(Claim, LockingFallsSilentAndUnlockingClaimsAnew) {
  pair.unlock();
  pair.intend(intent::Lock{});
  const Instant before = pair.now();
  pair.inject(requestNames(0x80));
  pair.run(1s);
  EXPECT_TRUE(pair.sentBy(&pair.console(), before).empty());
  pair.unlock();
  EXPECT_EQ(status().address, Address{0xF9}) << "that it was heard there itself is no hindrance";
}

TEST_F(Claim, Rule02NothingStaysUnlockedOverAReplugNorIsUnlockedWithoutALink) {
  pair.unlock();
  pair.setLink(pair.console(), false);
  EXPECT_EQ(status().progress, Progress::Off);
  EXPECT_TRUE(pair.console().services.isLocked());
  EXPECT_EQ(pair.intend(intent::Unlock{}), Refusal::NoLink);
  const Instant before = pair.now();
  pair.run(1s);
  pair.setLink(pair.console(), true);
  pair.run(1s);
  EXPECT_TRUE(pair.sentBy(&pair.console(), before).empty());
  pair.unlock();
  EXPECT_EQ(names(before).size(), 1u);
  EXPECT_EQ(status().progress, Progress::Claimed);
}

// Its NAME is lower than a joystick's or a monitor's: it would win such an address.
TEST(ClaimPreferring, AJoysticksOrAMonitorsAddressClaimsTheServiceToolsInstead) {
  constexpr Address kRefused[] = {{0x33}, {0x38}, {0x80}, {0xF7}, kNullAddress, kGlobalAddress};
  for (const Address refused : kRefused) {
    Pair pair;
    ServiceSettings settings;
    settings.claim.preferred = refused;
    pair.addConsole(settings);
    pair.unlock();
    EXPECT_EQ(pair.console().status(pair.now()).claim.address, kServiceTool1) << unsigned{refused.value};
    for (const Pair::Seen& seen : pair.sentBy(&pair.console()))
      EXPECT_TRUE(seen.id().source == kServiceTool1 || seen.id().source == kNullAddress)
          << "not for a moment";
  }
}

TEST(ClaimPreferring, AFixedAddressBelowThemIsTakenAtItsWord) {
  Pair pair;
  ServiceSettings settings;
  settings.claim.preferred = Address{0x42};
  pair.addConsole(settings);
  pair.unlock();
  EXPECT_EQ(pair.console().status(pair.now()).claim.address, Address{0x42});
}

TEST(ClaimPreferring, AnAddressThatIsTakenClaimsTheServiceToolsBeforeAMonitors) {
  Pair pair;
  ServiceSettings settings;
  settings.claim.preferred = Address{0xFB};
  pair.addConsole(settings);
  pair.inject(claimFrame(5, 0xFB));
  pair.unlock();
  EXPECT_EQ(pair.console().status(pair.now()).claim.address, kServiceTool1);
}

// F9 and FA are taken: it has the topmost of the monitors' addresses.
struct ClaimAmongMonitors : Claim {
  ClaimAmongMonitors() {
    pair.inject(claimFrame(5, 0xF9));
    pair.inject(claimFrame(6, 0xFA));
  }
  void expectMovedOn(Instant since) {
    pair.run(1ms);
    EXPECT_EQ(status().progress, Progress::Claiming);
    EXPECT_EQ(status().address, Address{0xF6});
    EXPECT_EQ(status().lost, 1);
    pair.run(10s);
    EXPECT_EQ(status().progress, Progress::Claimed);
    for (const Pair::Seen& seen : pair.sentBy(&pair.console(), since))
      EXPECT_EQ(seen.id().source, Address{0xF6});
  }
};

TEST_F(ClaimAmongMonitors, ALowerNameTakesItAtOnce) {
  pair.unlock();
  ASSERT_EQ(status().address, Address{0xF7});
  const Instant before = pair.now();
  pair.inject(claimFrame(1, 0xF7));
  expectMovedOn(before);
}

TEST_F(ClaimAmongMonitors, AHigherNameTakesItAtOnceAndIsNotAnswered) {
  pair.unlock();
  const Instant before = pair.now();
  pair.inject(claimFrame(~0ull, 0xF7));
  expectMovedOn(before);
}

TEST_F(ClaimAmongMonitors, AnyFrameOfSomebodyElseTakesItAtOnce) {
  pair.unlock();
  ASSERT_EQ(status().address, Address{0xF7});
  const Instant before = pair.now();
  pair.inject(frame("18EFFFF7", "0100000000000000"));
  expectMovedOn(before);
}

TEST_F(ClaimAmongMonitors, AClaimThatIsNoneTakesItToo) {
  pair.unlock();
  const Instant before = pair.now();
  pair.inject(claimFrame(0, 0xF7));
  expectMovedOn(before);
}

TEST_F(ClaimAmongMonitors, WhileClaimingItIsGivenUpAsWell) {
  pair.intend(intent::Unlock{});
  pair.run(ClaimService::kListen + 100ms);
  ASSERT_EQ(status().progress, Progress::Claiming);
  const Instant before = pair.now();
  pair.inject(frame("18EFFFF7", "0100000000000000"));
  expectMovedOn(before);
}

TEST_F(ClaimAmongMonitors, OurVeryNameIsStillReported) {
  pair.unlock();
  pair.inject(claimFrame(ours(), 0xF7));
  pair.run(1ms);
  EXPECT_EQ(status().progress, Progress::SameName);
}

TEST_F(ClaimAmongMonitors, WhereSomebodyMayHaveSpokenWhileItWasLockedItIsNotTakenAgain) {
  pair.unlock();
  ASSERT_EQ(status().address, Address{0xF7});
  pair.intend(intent::Lock{});
  pair.run(1ms);
  pair.inject(frame("18EFFFF7", "0100000000000000"));
  pair.unlock();
  EXPECT_EQ(status().address, Address{0xF6});
}

TEST_F(ClaimAmongMonitors, OneThatItHadBeforeAGapIsNotTakenAgain) {
  pair.unlock();
  ASSERT_EQ(status().address, Address{0xF7});
  Console& console = connectAgain(pair.console());
  pair.inject(claimFrame(5, 0xF9));
  pair.inject(claimFrame(6, 0xFA));
  pair.intend(console, intent::Unlock{});
  pair.run(1s);
  EXPECT_EQ(console.status(pair.now()).claim.address, Address{0xF6});
}

TEST_F(Claim, TwoConsolesOnOneBusShareTheServiceTools) {
  ServiceSettings other;
  other.claim.identityNumber = 2;
  Console& second = pair.addConsole(other);
  pair.intend(intent::Unlock{});
  pair.intend(second, intent::Unlock{});  // at the same instant
  pair.run(2s);
  EXPECT_EQ(status().progress, Progress::Claimed);
  EXPECT_EQ(status().address, Address{0xF9}) << "the lower NAME";
  EXPECT_EQ(second.status(pair.now()).claim.progress, Progress::Claimed);
  EXPECT_EQ(second.status(pair.now()).claim.address, Address{0xFA});
}

}  // namespace
}  // namespace deckpipe::test
