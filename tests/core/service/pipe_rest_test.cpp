// SPDX-License-Identifier: GPL-3.0-or-later
// What the person said for the rest of a file or text, and what a restart of the device ends.
#include "core/service/pipe_rig.h"

namespace deckpipe::test {
namespace {

using Rest = PipeStatus::Rest;

struct PipeRest : PipeRig {
  static constexpr std::size_t kPackets = 12;
  static std::string content() {
    std::string text;
    for (std::size_t i = 0; i < kPackets; ++i) text += "packet" + std::string(1, static_cast<char>('a' + i));
    return text;
  }
  void loseAcks(std::vector<int> which) {
    acks([which = std::move(which)](int n) {
      return Pair::Fate{std::ranges::find(which, n) != which.end() ? 0 : 1, 0ns};
    });
  }
  void loseAllAcks() {
    acks([](int) { return Pair::Fate{0, 0ns}; });
  }
  std::ptrdiff_t stalls() {
    const std::vector<PipeEvent> all = events();
    return std::ranges::count(all, PipeEvent::Stalled);
  }
  void cyclePower() {
    pair.simulator.press(pair.now(), 0, simulator::Simulator::Button::PowerOff);
    pair.simulator.press(pair.now() + 300ms, 0, simulator::Simulator::Button::PowerOn);
  }
};

TEST_F(PipeRest, OneDecisionIsForOnePacket) {
  loseAcks({1, 3});
  send(content());
  pair.run(2s);
  act(What::Skip);
  pair.run(5s);
  EXPECT_EQ(status().progress, PipeStatus::Progress::Stalled);
  EXPECT_EQ(status().rest, Rest::Ask);
}

TEST_F(PipeRest, SkippedForTheRestOfAFileEachIsCountedAndTheFileEndsWhole) {
  loseAcks({1, 3, 4, 8});
  send(content());
  pair.run(2s);
  ASSERT_EQ(act(What::Skip, true), Refusal::None);
  EXPECT_EQ(status().rest, Rest::Skip);
  pair.run(20s);
  EXPECT_EQ(status().fileEnd, PipeStatus::FileEnd::Done);
  EXPECT_EQ(sentText(), content());
  EXPECT_EQ(status().fileSkipped, 4u);
  EXPECT_EQ(status().skipped, 4u);
  EXPECT_EQ(stalls(), 4);
  EXPECT_EQ(status().rest, Rest::Ask) << "it was said of that file";
}

TEST_F(PipeRest, SentAgainForTheRestOfAFileEachIsCounted) {
  loseAcks({1, 4, 5});
  send(content());
  pair.run(2s);
  ASSERT_EQ(act(What::Resend, true), Refusal::None);
  pair.run(20s);
  EXPECT_EQ(status().fileEnd, PipeStatus::FileEnd::Done);
  EXPECT_EQ(packets().size(), kPackets + 3);
  EXPECT_EQ(status().fileResent, 3u);
  EXPECT_EQ(status().rest, Rest::Ask);
}

TEST_F(PipeRest, StopsAfterFiveMissingAcksInARow) {
  for (const What what : {What::Skip, What::Resend}) {
    act(What::Abort);
    loseAllAcks();
    pair.run(2s);
    const Instant before = pair.now();
    send(content());
    pair.run(2s);
    act(what, true);
    pair.run(30s);
    EXPECT_EQ(status().progress, PipeStatus::Progress::Stalled);
    EXPECT_EQ(status().rest, Rest::Ask);
    EXPECT_EQ(what == What::Skip ? status().fileSkipped : status().fileResent, kMaxMissingAcks);
    EXPECT_EQ(packets(before).size(), kMaxMissingAcks + 1);
  }
}

TEST_F(PipeRest, AnAckBetweenBeginsTheCountAnew) {
  loseAcks({0, 1, 2, 4, 5, 6});
  send(content());
  pair.run(2s);
  act(What::Skip, true);
  pair.run(30s);
  EXPECT_EQ(status().fileEnd, PipeStatus::FileEnd::Done);
  EXPECT_EQ(status().fileSkipped, 6u);
}

TEST_F(PipeRest, HoldsForTheRestOfATextAndNotForTheNext) {
  loseAcks({0, 2, 3});
  type(content().substr(0, 21));
  pair.run(2s);
  act(What::Skip, true);
  pair.run(10s);
  EXPECT_EQ(status().progress, PipeStatus::Progress::Idle);
  EXPECT_EQ(status().textSkipped, 2u);
  EXPECT_EQ(status().rest, Rest::Ask);
  type("next");
  EXPECT_EQ(status().textSkipped, 0u) << "of another text";
  pair.run(5s);
  EXPECT_EQ(status().progress, PipeStatus::Progress::Stalled);
}

TEST_F(PipeRest, WhatIsTypedMeanwhileWasNotDecidedOn) {
  loseAcks({0, 1});
  type(content().substr(0, 14));
  pair.run(2s);
  act(What::Skip, true);
  type("more");
  pair.run(10s);
  EXPECT_EQ(status().progress, PipeStatus::Progress::Stalled);
  EXPECT_EQ(status().textSkipped, 1u);
}

TEST_F(PipeRest, EndsAtALockAndWithACancelledFile) {
  for (const bool isLock : {true, false}) {
    loseAcks({0, 20});
    send(content() + content());
    pair.run(2s);
    act(What::Skip, true);
    ASSERT_EQ(status().rest, Rest::Skip);
    isLock ? pair.intend(intent::Lock{}) : act(What::Cancel);
    EXPECT_EQ(status().rest, Rest::Ask);
    pair.intend(intent::Unlock{});
    pair.run(5s);
  }
}

// What is not for want of an ack is for the person to see.
TEST_F(PipeRest, IsNotAskedWhereTheDeviceIsElsewhere) {
  loseAllAcks();
  send(content());
  pair.run(2s);
  act(What::Skip, true);
  ASSERT_TRUE(pair.runUntil([&] { return status().progress == PipeStatus::Progress::Sending; }, 5s));
  pair.inject(frame(address() == 0x80 ? "18EEFF80" : "18EEFF81", "0100000000000000"));
  pair.run(10s);
  EXPECT_EQ(status().progress, PipeStatus::Progress::Stalled);
  EXPECT_EQ(status().stall, PipeStatus::Stall::Moved);
  EXPECT_EQ(status().rest, Rest::Ask);
}

TEST_F(PipeRest, ARestartOfTheDeviceEndsTheFileAndTheRule) {
  loseAcks({0});
  send(std::string(7'000, 'x'));
  pair.run(2s);
  act(What::Resend, true);
  pair.run(2s);
  ASSERT_EQ(status().rest, Rest::Resend);
  cyclePower();
  ASSERT_TRUE(pair.runUntil([&] { return status().fileEnd != PipeStatus::FileEnd::None; }, 20s));
  EXPECT_EQ(status().fileEnd, PipeStatus::FileEnd::Restarted);
  EXPECT_EQ(status().rest, Rest::Ask);
  EXPECT_EQ(status().restarts, 1u);
  EXPECT_EQ(status().notTaken, 0u) << "nothing was typed";
  const Instant restarted = pair.now();
  pair.run(10s);
  EXPECT_TRUE(packets(restarted).empty());
  EXPECT_EQ(status().progress, PipeStatus::Progress::Idle);
  const std::vector<PipeEvent> all = events();
  EXPECT_EQ(std::vector(all.end() - 2, all.end()),
            (std::vector{PipeEvent::DeviceRestarted, PipeEvent::FileAborted}));
}

TEST_F(PipeRest, WhatWasTypedBeforeARestartIsDroppedAndCounted) {
  loseAllAcks();
  type("0123456789");
  pair.run(2s);
  cyclePower();
  ASSERT_TRUE(pair.runUntil([&] { return status().restarts != 0; }, 20s));
  EXPECT_EQ(status().notTaken, 10u);
  EXPECT_EQ(status().waiting, 0u);
  pair.wire = [](const Frame&) { return Pair::Fate{}; };
  pair.run(2s);
  const Instant before = pair.now();
  type("new");
  pair.run(2s);
  EXPECT_EQ(status().notTaken, 0u);
  EXPECT_EQ(packets(before), (std::vector<std::string>{"new"}));
}

TEST_F(PipeRest, ARestartBeforeAnythingWasTypedIsNone) {
  cyclePower();
  pair.run(5s);
  type("0123456789");
  pair.run(2s);
  EXPECT_EQ(status().restarts, 0u);
  EXPECT_EQ(sentText(), "0123456789");
}

}  // namespace
}  // namespace deckpipe::test
