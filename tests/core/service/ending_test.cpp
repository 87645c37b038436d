// SPDX-License-Identifier: GPL-3.0-or-later
// What the contract of the services promises to one that must still say something at its end: a small one of
// its own that says 'neutral' from an address of its own.
#include <gtest/gtest.h>

#include "support/pair.h"

namespace deckpipe::test {
namespace {

// After a lock it says neutral every 20 ms for 500 ms, unless it is told to go on for ever.
class Neutral : public Service {
 public:
  static constexpr Duration kPeriod = 20ms, kLength = 500ms;

  explicit Neutral(const ClaimService& own) : m_own(own) {}
  bool neverEnds = false;
  std::vector<WriteOutcome> outcomes;
  std::vector<EndReason> ends;
  std::vector<bool> links;

  void linkChanged(Instant, const Live&, bool isOpen, Outgoing&) override {
    links.push_back(isOpen);
    m_until = m_next = kNever;
  }
  std::optional<Refusal> intentCame(Instant, const Live&, const Intent&, Outgoing&) override { return {}; }
  void received(Instant, const Live&, const Frame&, Outgoing&) override {}
  void writeEnded(Instant, const Live&, FrameTag, WriteOutcome outcome, Outgoing&) override {
    outcomes.push_back(outcome);
  }
  void timeCame(Instant now, const Live& live, Outgoing& out) override {
    if (now < m_next) return;
    if (now >= m_until && !neverEnds) {
      m_next = kNever;
      return;
    }
    say(live, source(), out);
    m_next = now + kPeriod;
  }
  Instant nextTime() const override { return m_next; }
  void end(Instant now, const Live& live, EndReason reason, Outgoing& out) override {
    ends.push_back(reason);
    if (reason == EndReason::AddressLost) {  // one at most, so that our deflection does not stay
      if (m_last != kNullAddress) say(live, m_last, out);
      m_next = kNever;
      return;
    }
    m_until = now + kLength;
    m_next = now;
    timeCame(now, live, out);
  }
  bool hasEnded() const override { return m_next == kNever; }
  Address source() const override { return m_own.address(); }
  void status(const Live&, ServiceStatus&) const override {}

 private:
  void say(const Live& live, Address from, Outgoing& out) {
    m_last = from;
    out.send(live, from, MessageId::BasicJoystick, kGlobalAddress,
             {.data = {0x01, 0x00, 0x01, 0x00}, .length = 8});
  }
  const ClaimService& m_own;
  Address m_last = kNullAddress;
  Instant m_until = kNever, m_next = kNever;
};

struct Ending : ::testing::Test {
  Ending() {
    auto claim = std::make_unique<ClaimService>(ClaimSettings{.identityNumber = 1,
                                                              .preferred = Address{0x38},
                                                              .second = Address{0x37},
                                                              .lowest = Address{0x33},
                                                              .highest = Address{0x38},
                                                              .functionInstance = 1,
                                                              .isConsole = false});
    own = claim.get();
    console.services.add(std::move(claim));
    auto service = std::make_unique<Neutral>(*own);
    neutral = service.get();
    console.services.add(std::move(service));
    pair.unlock();
  }
  TruckPair pair;
  Console& console = pair.console();
  ClaimService* own;
  Neutral* neutral;

  ServiceStatus status() { return console.status(pair.now()); }
  std::vector<Pair::Seen> said(Instant from) {
    std::vector<Pair::Seen> out = pair.sentBy(&console, from);
    std::erase_if(out, [](const Pair::Seen& seen) { return seen.id().pgn != pgn::kBasicJoystick; });
    return out;
  }
  std::vector<std::string_view> lastNotes(std::size_t count) {
    std::vector<std::string_view> out;
    for (const Note& note : console.notes) out.push_back(noteKey(note.value));
    out.erase(out.begin(), out.end() - static_cast<std::ptrdiff_t>(std::min(count, out.size())));
    return out;
  }
};

TEST_F(Ending, TwoApplicationsHaveANameAndAnAddressEach) {
  EXPECT_EQ(status().claim.address, Address{0xF9});
  EXPECT_EQ(own->address(), Address{0x38});
  const State& state = console.state;
  EXPECT_EQ(state.channel(Channel{}).ownAddress, Address{0xF9}) << "the console's";
  const Name first = state.channel(Channel{}).book.holder(Address{0xF9});
  const Name second = state.channel(Channel{}).book.holder(Address{0x38});
  EXPECT_NE(first.value, second.value);
  EXPECT_EQ(first.identityNumber(), second.identityNumber());
}

TEST_F(Ending, ALockIsCompleteWhenNeutralWasSaidForHalfASecond) {
  const Instant locked = pair.now();
  pair.intend(intent::Lock{});
  EXPECT_TRUE(status().isEnding);
  EXPECT_FALSE(status().locked);
  EXPECT_FALSE(status().canRequest());
  EXPECT_EQ(said(locked).size(), 1u) << "the first goes at once";
  EXPECT_EQ(pair.intend(intent::SendRequests{{}, kPolls}), Refusal::Busy) << "nothing is begun meanwhile";
  EXPECT_EQ(pair.intend(intent::Unlock{}), Refusal::Busy);
  pair.run(Neutral::kLength - 1ms);
  EXPECT_TRUE(status().isEnding);
  pair.run(1ms);
  EXPECT_FALSE(status().isEnding);
  EXPECT_TRUE(status().locked);
  const auto frames = said(locked);
  ASSERT_EQ(frames.size(), 25u);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].time - locked, static_cast<int>(i) * Neutral::kPeriod);
    EXPECT_EQ(frames[i].id().source, Address{0x38});
  }
  EXPECT_EQ(neutral->ends, std::vector{EndReason::Locked}) << "once, though it was asked for again";
  const Instant after = pair.now() + 1ns;
  pair.run(5s);
  EXPECT_TRUE(pair.sentBy(&console, after).empty());
  EXPECT_EQ(neutral->outcomes, std::vector(25, WriteOutcome::OnBus));
}

TEST_F(Ending, TheAddressesAreGivenUpLast) {
  pair.intend(intent::Lock{});
  pair.run(100ms);
  const Instant before = pair.now();
  pair.inject(frame("18EAFF80", "00EE00"));
  pair.run(10ms);
  std::vector<Address> names;
  for (const Pair::Seen& seen : pair.sentBy(&console, before)) {
    if (seen.id().pgn == pgn::kAddressClaimed) names.push_back(seen.id().source);
  }
  EXPECT_EQ(names, (std::vector{Address{0xF9}, Address{0x38}})) << "still answered";
  pair.run(1s);
  EXPECT_EQ(lastNotes(2), (std::vector<std::string_view>{"own_address", "locked"}));
}

TEST_F(Ending, OthersFallSilentAtOnce) {
  pair.intend(intent::Repeat{TruckPair::monitor(), RequestSet{Request::Fault}, 500ms});
  pair.run(100ms);
  pair.intend(intent::Lock{});
  const Instant before = pair.now();
  Frame data = frame("18EFF980", "FE4142");
  data.id = J1939Id{6, pgn::kProprietaryA, pair.addressOf(TruckPair::monitor()), Address{0xF9}}.frameId();
  pair.inject(data);
  pair.run(2s);
  EXPECT_TRUE(pair.sent(0x02, &console, before).empty());
  EXPECT_TRUE(pair.sent(0xFE, &console, before).empty());
}

TEST_F(Ending, WhatALockKeepsFromTheAdapterIsNotCountedAsRefusedByIt) {
  Services& services = console.services;
  const auto apply = [&](Intent intent) {
    services.apply(pair.now(), console.state, {std::move(intent), pair.now(), 1});
  };
  apply(intent::SendRequests{TruckPair::monitor(), RequestSet{Request::SetupMode}});
  apply(intent::Lock{});
  const RequestStatus command = console.request(pair.now(), TruckPair::monitor(), Request::SetupMode);
  EXPECT_EQ(command.end, RequestEnd::NotOnBus);
  EXPECT_EQ(status().notTaken, 0u);
  std::vector<OutFrame> frames;
  services.takeFrames(frames);
  EXPECT_EQ(std::ranges::count_if(frames, [](const OutFrame& f) { return f.frame.data[0] == 0x46; }), 0);
}

TEST_F(Ending, LastsASecondAtMostAndWhatStillWaitsIsSaid) {
  neutral->neverEnds = true;
  console.leaves = [](const Frame&) { return std::optional<Duration>(); };
  const Instant locked = pair.now();
  pair.intend(intent::Lock{});
  pair.run(kEndingTime - 1ms);
  EXPECT_TRUE(status().isEnding);
  pair.run(1ms);
  EXPECT_TRUE(status().locked);
  ASSERT_EQ(lastNotes(2), (std::vector<std::string_view>{"still_waits", "locked"}));
  const std::size_t handed = pair.written.size();
  EXPECT_GE(std::get<note::StillWaits>(console.notes[console.notes.size() - 2].value).count, 50u);
  EXPECT_GE(status().unconfirmed, 45u);
  pair.run(5s);
  EXPECT_EQ(pair.written.size(), handed);
  EXPECT_TRUE(pair.sentBy(&console, locked).empty());
}

TEST_F(Ending, ALinkThatIsLostEndsItAtOnce) {
  pair.intend(intent::Lock{});
  pair.run(100ms);
  pair.setLink(console, false);
  EXPECT_TRUE(status().locked);
  EXPECT_FALSE(status().isEnding);
  EXPECT_EQ(neutral->links, (std::vector{true, false}));
  const std::size_t handed = pair.written.size();
  pair.setLink(console, true);
  pair.run(2s);
  EXPECT_EQ(pair.written.size(), handed) << "locked as it was wanted";
}

TEST_F(Ending, ACloseEndsAsALockDoes) {
  const Instant before = pair.now();
  console.services.close(pair.now(), console.state);
  EXPECT_FALSE(console.services.isLocked());
  pair.run(Neutral::kLength);
  EXPECT_TRUE(console.services.isLocked());
  EXPECT_EQ(neutral->ends, std::vector{EndReason::Closing});
  EXPECT_EQ(said(before).size(), 25u);
}

TEST_F(Ending, AfterTheNextUnlockEverythingBeginsAnew) {
  pair.intend(intent::Lock{});
  pair.run(1s);
  pair.unlock();
  EXPECT_EQ(neutral->links, (std::vector{true, true}));
  EXPECT_EQ(own->address(), Address{0x38});
  EXPECT_EQ(pair.intend(intent::SendRequests{{}, kPolls}), Refusal::None);
}

TEST_F(Ending, AnAddressThatIsLostEndsWhoSendsFromItAndNobodyElse) {
  pair.intend(intent::Repeat{TruckPair::monitor(), RequestSet{Request::Fault}, 500ms});
  pair.run(1s);
  pair.inject(frame("18EEFF38", "0100000000000000"));
  pair.run(2s);
  EXPECT_EQ(neutral->ends, std::vector{EndReason::AddressLost});
  EXPECT_EQ(own->address(), Address{0x37});
  EXPECT_EQ(status().claim.address, Address{0xF9});
  EXPECT_GT(status().find(TruckPair::monitor())->of(Request::Fault).period, 0ns) << "goes on";
}

TEST_F(Ending, WhatBecameOfAFrameIsToldAfterTheEndToo) {
  console.leaves = [](const Frame& f) {
    const bool isNeutral = J1939Id::of(f.identifier()).pgn == pgn::kBasicJoystick;
    return std::optional<Duration>(isNeutral ? 3s : 0s);
  };
  pair.intend(intent::Lock{});
  pair.run(1s);
  ASSERT_TRUE(status().locked);
  EXPECT_TRUE(neutral->outcomes.empty());
  pair.run(3s);
  EXPECT_EQ(neutral->outcomes.size(), 25u);
}

}  // namespace
}  // namespace deckpipe::test
