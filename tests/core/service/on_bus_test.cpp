// SPDX-License-Identifier: GPL-3.0-or-later
// Handed over is not on the bus: adapters that keep, lose, refuse and reorder what is written to them.
#include <gtest/gtest.h>

#include "control/pipe_event.h"
#include "service/pipe_service.h"
#include "service/request_service.h"
#include "support/pair.h"

namespace deckpipe::test {
namespace {

using Progress = RequestStatus::Progress;
using Claim = ClaimStatus::Progress;

constexpr std::uint8_t kZeroAxes = 0x41, kPipe = 0xFE, kFaultPoll = 0x02;

bool isClaim(const Frame& f) { return J1939Id::of(f.identifier()).pgn == pgn::kAddressClaimed; }
bool isType(const Frame& f, std::uint8_t type) {
  return J1939Id::of(f.identifier()).pgn == pgn::kProprietaryA && f.length > 0 && f.data[0] == type;
}

struct OnBus : ::testing::Test {
  TruckPair pair;
  const DeviceKey monitor = TruckPair::monitor();

  Console& console() { return pair.console(); }
  ServiceStatus all() { return console().status(pair.now()); }
  RequestStatus request(Request request) { return console().request(pair.now(), monitor, request); }
  PipeStatus pipe() { return console().pipe(pair.now(), monitor); }
  Refusal sendRequest(Request what) { return pair.intend(intent::SendRequests{monitor, RequestSet{what}}); }
  Refusal type(std::string text) { return pair.intend(intent::PipeWrite{monitor, std::move(text)}); }
  // Frames of this type wait so long in the adapter; nothing: until the link goes.
  void keep(std::uint8_t type, std::optional<Duration> wait) {
    console().leaves = [type, wait](const Frame& f) {
      return isType(f, type) ? wait : std::optional<Duration>(0ns);
    };
  }
  void refuse(std::uint8_t type, WriteResult result, int count = 1'000) {
    console().take = [type, result, count](const Frame& f) mutable {
      return isType(f, type) && count-- > 0 ? result : WriteResult::Accepted;
    };
  }
  Frame fromMonitor(std::string_view data) {
    Frame f = frame("18EF0000", data);
    f.id = J1939Id{6, pgn::kProprietaryA, pair.addressOf(monitor), Address{0xF9}}.frameId();
    return f;
  }
  std::vector<RequestEnd> ends() {
    std::vector<RequestEnd> out;
    for (const Note& note : console().notes) {
      if (const auto* ended = std::get_if<note::RequestEnded>(&note.value)) out.push_back(ended->end);
    }
    return out;
  }
  template <typename Kind>
  std::ptrdiff_t notes() {
    return std::ranges::count_if(console().notes,
                                 [](const Note& note) { return std::holds_alternative<Kind>(note.value); });
  }
  std::ptrdiff_t written(std::uint8_t type) {
    return std::ranges::count_if(pair.written,
                                 [type](const Pair::Seen& seen) { return isType(seen.frame, type); });
  }
};

// --- the claim

TEST_F(OnBus, AClaimCountsFromItsEcho) {
  console().echo = [](const Frame& f) { return isClaim(f) ? Fate{1, 3s} : Fate{}; };
  pair.intend(intent::Unlock{});
  pair.run(ClaimService::kListen + 3s + kClaimTime - 1ms);
  EXPECT_EQ(pair.claim().progress, Claim::Claiming);
  EXPECT_EQ(sendRequest(Request::Fault), Refusal::NoAddress);
  pair.run(5ms);
  EXPECT_EQ(pair.claim().progress, Claim::Claimed);
}

TEST_F(OnBus, AClaimThatIsNotOnTheBusIsNoAddress) {
  console().leaves = [](const Frame& f) { return isClaim(f) ? std::nullopt : std::optional<Duration>(0ns); };
  pair.intend(intent::Unlock{});
  pair.run(10s);
  EXPECT_EQ(pair.claim().progress, Claim::Claiming);
  EXPECT_FALSE(pair.claim().isOnBus);
  EXPECT_EQ(all().unconfirmed, 1u);
}

TEST_F(OnBus, AClaimThatAFullQueueRefusedIsTriedAgainOnceAndASecondLaterAnew) {
  console().take = [](const Frame& f) { return isClaim(f) ? WriteResult::QueueFull : WriteResult::Accepted; };
  const auto claims = [this] {
    return std::ranges::count_if(pair.written, [](const Pair::Seen& seen) { return isClaim(seen.frame); });
  };
  pair.intend(intent::Unlock{});
  pair.run(ClaimService::kListen + 500ms);
  EXPECT_EQ(claims(), 2);
  EXPECT_EQ(all().notTaken, 1u);
  console().take = [](const Frame&) { return WriteResult::Accepted; };
  pair.run(2s);
  EXPECT_EQ(claims(), 3);
  EXPECT_EQ(pair.claim().progress, Claim::Claimed);
}

TEST_F(OnBus, WithoutEchoesAClaimCountsFromItsBeingTaken) {
  Console& deaf = pair.addConsole({.echoes = false, .claim = {.identityNumber = 7}});
  pair.intend(deaf, intent::Unlock{});
  pair.run(ClaimService::kListen + kClaimTime);
  EXPECT_EQ(deaf.status(pair.now()).claim.progress, Claim::Claimed);
  EXPECT_EQ(deaf.status(pair.now()).unconfirmed, 0u) << "nobody can tell";
}

TEST_F(OnBus, AFrameFromOurAddressThatWeDidNotSendIsAnsweredByOurClaimAndThenWeMove) {
  pair.unlock();
  sendRequest(Request::Reset);
  pair.run(10ms);
  const Frame stranger = frame("18EF80F9", "02");
  Instant before = pair.now();
  pair.inject(stranger);
  pair.run(10ms);
  ASSERT_EQ(pair.sentBy(&console(), before).size(), 1u);
  EXPECT_TRUE(isClaim(pair.sentBy(&console(), before)[0].frame));
  EXPECT_EQ(pair.claim().progress, Claim::Claimed) << "kept while it is defended";
  EXPECT_EQ(pair.claim().conflicts, 1u);
  EXPECT_TRUE(pair.claim().isDisputed);
  EXPECT_TRUE(std::ranges::any_of(console().notes, [](const Note& note) {
    const auto* own = std::get_if<note::OwnAddress>(&note.value);
    return own != nullptr && own->how == note::OwnAddress::How::Disputed && own->address == Address{0xF9};
  }));
  pair.inject(stranger);  // it may not have heard us yet
  pair.run(kClaimTime);
  EXPECT_EQ(pair.claim().address, Address{0xF9});
  pair.inject(stranger);
  pair.run(1s);
  EXPECT_EQ(pair.claim().progress, Claim::Claimed);
  EXPECT_EQ(pair.claim().address, Address{0xFA});
  EXPECT_EQ(request(Request::Reset).end, RequestEnd::AddressLost) << "what depended on it has ended";
}

TEST_F(OnBus, NoCommandGoesFromAnAddressThatAnotherSendsFromAndNoAckIsBelievedThere) {
  pair.unlock();
  keep(kZeroAxes, 50ms);
  sendRequest(Request::ZeroAxes);
  pair.run(10ms);
  pair.inject(frame("18EF80F9", "02"));
  pair.run(1s);
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::CannotTell) << "the ack may be for the other node";
  EXPECT_EQ(sendRequest(Request::ZeroAxes), Refusal::Disputed);
  EXPECT_EQ(type("A?"), Refusal::Disputed);
  EXPECT_EQ(sendRequest(Request::Fault), Refusal::None) << "an answer to a poll is true, whoever asked";
  pair.run(ClaimService::kConflictOver);
  EXPECT_EQ(sendRequest(Request::ZeroAxes), Refusal::None);
}

TEST_F(OnBus, AConflictWhileClaimingIsSaidOnceTheAddressIsOurs) {
  pair.intend(intent::Unlock{});
  pair.run(ClaimService::kListen + kClaimTime / 2);
  ASSERT_EQ(pair.claim().progress, Claim::Claiming);
  pair.inject(frame("18EF80F9", "02"));
  pair.run(kClaimTime);
  ASSERT_EQ(pair.claim().progress, Claim::Claimed);
  EXPECT_TRUE(pair.claim().isDisputed);
}

TEST_F(OnBus, AConflictLongAgoIsAnotherOne) {
  pair.unlock();
  pair.inject(frame("18EF80F9", "02"));
  pair.run(ClaimService::kConflictOver + 1s);
  EXPECT_FALSE(pair.claim().isDisputed);
  pair.inject(frame("18EF80F9", "02"));
  pair.run(1s);
  EXPECT_EQ(pair.claim().address, Address{0xF9});
  EXPECT_EQ(pair.claim().conflicts, 2u);
}

TEST_F(OnBus, TheLoadIsOfTheRateThatTheDriverSays) {
  const double before = all().busLoad;
  ASSERT_GT(before, 0);
  console().services.setBitRate(500'000);
  EXPECT_DOUBLE_EQ(all().busLoad, before / 2);
}

TEST_F(OnBus, AClaimWhoseEchoIsLostIsMadeAgain) {
  console().echo = [](const Frame& f) { return isClaim(f) ? Fate{.copies = 0} : Fate{}; };
  pair.intend(intent::Unlock{});
  pair.run(ClaimService::kListen + 500ms);
  console().echo = [](const Frame&) { return Fate{}; };
  pair.loseEchoes(console());
  pair.run(2s);
  EXPECT_EQ(pair.claim().progress, Claim::Claimed);
}

// --- polls

TEST_F(OnBus, APollsClockStartsAtItsEcho) {
  pair.unlock();
  keep(kFaultPoll, 400ms);
  pair.wire = [](const Frame& f) {
    return Fate{1, isType(f, kFaultPoll) && f.length == 7 ? Duration(450ms) : Duration(0ns)};
  };
  sendRequest(Request::Fault);
  pair.run(1s);
  EXPECT_EQ(request(Request::Fault).end, RequestEnd::Answered);
  EXPECT_EQ(request(Request::Fault).tries, 1);
  EXPECT_LT(request(Request::Fault).latency, 460ms);
}

TEST_F(OnBus, AnAnswerBeforeThePollIsOnTheBusIsNotItsOwn) {
  pair.unlock();
  keep(kFaultPoll, std::nullopt);
  sendRequest(Request::Fault);
  pair.inject(fromMonitor("02000000000000"));
  pair.run(10ms);
  EXPECT_EQ(request(Request::Fault).progress, Progress::Waiting);
  EXPECT_EQ(request(Request::Fault).unasked, 1u);
}

TEST_F(OnBus, APollWithoutItsEchoEndsAsNotOnTheBusAndIsNotRepeated) {
  pair.unlock();
  keep(kFaultPoll, std::nullopt);
  sendRequest(Request::Fault);
  pair.run(5s);
  EXPECT_EQ(request(Request::Fault).end, RequestEnd::NotOnBus);
  EXPECT_EQ(written(kFaultPoll), 1);
  EXPECT_EQ(all().unconfirmed, 1u);
}

TEST_F(OnBus, APollThatTheQueueRefusesEndsAtOnce) {
  pair.unlock();
  refuse(kFaultPoll, WriteResult::QueueFull);
  sendRequest(Request::Fault);
  EXPECT_EQ(request(Request::Fault).end, RequestEnd::NotOnBus);
  EXPECT_EQ(all().notTaken, 1u);
}

TEST_F(OnBus, ASecondTryThatIsRefusedLeavesTheFirstItsAnswer) {
  pair.unlock();
  pair.wire = [](const Frame& f) {
    return Fate{1, isType(f, kFaultPoll) && f.length == 7 ? Duration(800ms) : Duration(0ns)};
  };
  sendRequest(Request::Fault);
  pair.run(100ms);
  refuse(kFaultPoll, WriteResult::QueueFull);
  pair.run(1s);
  EXPECT_EQ(request(Request::Fault).end, RequestEnd::Answered);
}

// --- commands

struct KeptCommand : OnBus {
  KeptCommand() {
    pair.unlock();
    keep(kZeroAxes, 2s);
    sendRequest(Request::ZeroAxes);
  }
};

TEST_F(KeptCommand, IsSaidToBeNotOnTheBusAfterATenthOfASecond) {
  pair.run(kOnBusTime - 1ms);
  EXPECT_EQ(request(Request::ZeroAxes).progress, Progress::Waiting);
  EXPECT_TRUE(all().waitingCommands.empty());
  pair.run(1ms);
  EXPECT_EQ(request(Request::ZeroAxes).progress, Progress::NotOnBusYet);
  ASSERT_EQ(all().waitingCommands.size(), 1u);
  EXPECT_EQ(all().waitingCommands[0].device, monitor);
  EXPECT_EQ(all().waitingCommands[0].request, Request::ZeroAxes);
  EXPECT_EQ(notes<note::RequestWaits>(), 1);
}

TEST_F(KeptCommand, EndsAsWentOutLateAtItsEcho) {
  const Instant begin = pair.now();
  pair.run(1900ms);
  EXPECT_EQ(request(Request::ZeroAxes).progress, Progress::NotOnBusYet);
  EXPECT_EQ(sendRequest(Request::ZeroAxes), Refusal::Busy);
  pair.run(100ms + Pair::kFlight);
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::WentOutLate);
  EXPECT_EQ(request(Request::ZeroAxes).ended - begin, 2s + Pair::kFlight);
  EXPECT_TRUE(all().waitingCommands.empty());
  pair.run(1s);
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::AnsweredLate) << "its acknowledgement is shown";
  EXPECT_EQ(written(kZeroAxes), 1);
}

TEST_F(KeptCommand, EndsAsGoneWithTheInterface) {
  pair.run(500ms);
  pair.setLink(console(), false);
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::GoneWithInterface);
  EXPECT_TRUE(all().waitingCommands.empty());
  EXPECT_EQ(ends(), std::vector{RequestEnd::GoneWithInterface});
}

TEST_F(KeptCommand, EndsWithoutAWordOfItsFateWhenItsEchoMayBeAmongLostFrames) {
  pair.run(500ms);
  pair.loseEchoes(console());
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::CannotTell);
  EXPECT_TRUE(all().waitingCommands.empty());
  EXPECT_EQ(ends(), std::vector{RequestEnd::CannotTell}) << "never that it went out late";
  EXPECT_EQ(sendRequest(Request::ZeroAxes), Refusal::None) << "the person may decide to send it again";
}

TEST_F(KeptCommand, EndsSoWhenABusOffHasThrownAwayWhatTheControllerHeld) {
  pair.run(500ms);
  Frame restarted;
  restarted.id = kErrorBit | kRestartedClass;
  restarted.length = 8;
  pair.inject(restarted);
  pair.run(10ms);
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::CannotTell);
  EXPECT_EQ(all().unconfirmed, 0u);
}

TEST_F(KeptCommand, IsSaidAtALockAndItsFateAfterIt) {
  pair.run(10ms);
  pair.intend(intent::Lock{});
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::Cancelled);
  EXPECT_EQ(all().waitingCommands.size(), 1u) << "nothing takes it back";
  EXPECT_EQ(notes<note::RequestWaits>(), 1);
  EXPECT_EQ(notes<note::StillWaits>(), 1);
  pair.run(3s);
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::WentOutLate);
  EXPECT_TRUE(all().waitingCommands.empty());
  EXPECT_EQ(ends(), (std::vector{RequestEnd::Cancelled, RequestEnd::WentOutLate}));
}

TEST_F(KeptCommand, IsSaidOnceMoreAtACloseAfterTheLock) {
  pair.run(10ms);
  pair.intend(intent::Lock{});
  ASSERT_EQ(notes<note::StillWaits>(), 1);
  console().services.close(pair.now(), console().state);
  pair.run(1ms);
  EXPECT_EQ(notes<note::StillWaits>(), 2);
}

TEST_F(KeptCommand, IsSaidWhenOurAddressIsLost) {
  pair.run(10ms);
  pair.inject(frame("18EEFFF9", "0100000000000000"));
  pair.run(10ms);
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::AddressLost);
  EXPECT_EQ(all().waitingCommands.size(), 1u);
  EXPECT_EQ(notes<note::StillWaits>(), 1);
}

TEST_F(OnBus, ACommandWhoseEchoComesInTimeAfterALockDidNotGoOutLate) {
  pair.unlock();
  keep(kZeroAxes, kOnBusTime / 2);
  sendRequest(Request::ZeroAxes);
  pair.run(10ms);
  pair.intend(intent::Lock{});
  pair.run(1s);
  EXPECT_TRUE(all().waitingCommands.empty());
  EXPECT_EQ(ends(), std::vector{RequestEnd::Cancelled}) << "its echo is no news";
}

TEST_F(OnBus, ALostAddressLeavesNothingWaitingThatWasOnTheBus) {
  pair.unlock();
  pair.inject(frame("18EEFFF9", "0100000000000000"));
  pair.run(10ms);
  EXPECT_NE(pair.claim().address, Address{0xF9});
  EXPECT_EQ(notes<note::StillWaits>(), 0) << "the claim of the next address is not counted";
}

TEST_F(OnBus, ACommandWhoseEchoIsLostBeforeItWasSaidToWaitEndsTheSameWay) {
  Frame restarted;
  restarted.id = kErrorBit | kRestartedClass;
  restarted.length = 8;
  for (const bool isBusOff : {false, true}) {
    TruckPair truck;
    truck.unlock();
    truck.console().leaves = [](const Frame&) { return std::nullopt; };
    truck.intend(intent::SendRequests{monitor, RequestSet{Request::ZeroAxes}});
    truck.run(10ms);
    if (isBusOff) {
      truck.inject(restarted);
    } else {
      truck.loseEchoes(truck.console());
    }
    truck.run(10ms);
    EXPECT_EQ(truck.console().request(truck.now(), monitor, Request::ZeroAxes).end, RequestEnd::CannotTell);
  }
}

TEST_F(KeptCommand, WaitsAloneEvenAfterItWasGivenUp) {
  pair.run(500ms);
  pair.intend(intent::Cancel{monitor});
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::Cancelled);
  EXPECT_EQ(sendRequest(Request::ZeroAxes), Refusal::Busy) << "the first may still go out";
  pair.run(2s);
  EXPECT_EQ(sendRequest(Request::ZeroAxes), Refusal::None);
}

TEST_F(OnBus, AfterOneLostEchoTheNextPollsOfTheKindAreAnswered) {
  pair.unlock();
  console().echo = [](const Frame& f) { return isType(f, kFaultPoll) ? Fate{.copies = 0} : Fate{}; };
  sendRequest(Request::Fault);
  pair.run(5ms);
  console().echo = [](const Frame&) { return Fate{}; };
  pair.loseEchoes(console());
  pair.run(1s);
  EXPECT_EQ(request(Request::Fault).answered, 1u) << "its answer came after its echo was given up";
  sendRequest(Request::Fault);
  pair.run(1s);
  EXPECT_EQ(request(Request::Fault).end, RequestEnd::Answered);
  EXPECT_EQ(request(Request::Fault).answered, 2u);
}

TEST_F(OnBus, ACommandThatIsRefusedWasNotSent) {
  pair.unlock();
  refuse(kZeroAxes, WriteResult::Failed);
  sendRequest(Request::ZeroAxes);
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::NotOnBus);
  pair.run(1s);
  EXPECT_TRUE(all().waitingCommands.empty());
  EXPECT_EQ(notes<note::RequestWaits>(), 0);
  EXPECT_EQ(written(kZeroAxes), 1);
}

TEST_F(OnBus, ACommandIsOnTimeWhenItsEchoIsHoweverLateTheThreadIs) {
  pair.unlock();
  keep(kZeroAxes, 90ms);
  sendRequest(Request::ZeroAxes);
  pair.freeze(console(), 500ms);
  pair.run(600ms);
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::Answered);
  EXPECT_EQ(notes<note::RequestWaits>(), 0);
}

TEST_F(OnBus, TwoCommandsWhoseEchoesComeInTheOtherOrderKeepTheirOwn) {
  pair.unlock();
  console().echo = [](const Frame& f) { return Fate{1, isType(f, kZeroAxes) ? 300ms : 0ms}; };
  sendRequest(Request::ZeroAxes);
  sendRequest(Request::SetupMode);
  pair.run(1s);
  EXPECT_EQ(request(Request::SetupMode).end, RequestEnd::Answered);
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::WentOutLate);
}

TEST_F(OnBus, AnEchoOfTheKernelsQueueNeverProvesThatACommandWentOut) {
  console().services.setEchoProves(false);
  pair.unlock();
  EXPECT_EQ(pair.claim().progress, Claim::Claimed);
  EXPECT_FALSE(all().echoes) << "shown as: cannot tell";
  keep(kZeroAxes, 2s);
  sendRequest(Request::ZeroAxes);
  pair.run(2s + 2 * Pair::kFlight);
  EXPECT_EQ(request(Request::ZeroAxes).end, RequestEnd::CannotTell);
}

TEST_F(OnBus, WithoutEchoesACommandIsNeverSaidToWait) {
  Console& deaf = pair.addConsole({.echoes = false, .claim = {.identityNumber = 7}});
  pair.run(2s);
  pair.intend(deaf, intent::Unlock{});
  pair.run(1s);
  ASSERT_EQ(pair.intend(deaf, intent::SendRequests{monitor, RequestSet{Request::SetupMode}}), Refusal::None);
  pair.run(1s);
  EXPECT_EQ(deaf.request(pair.now(), monitor, Request::SetupMode).end, RequestEnd::Answered);
  EXPECT_FALSE(deaf.status(pair.now()).echoes);
}

// --- the data pipe

TEST_F(OnBus, AnAcksTimeRunsFromThePacketsEcho) {
  pair.unlock();
  keep(kPipe, 900ms);
  type("abc");
  pair.run(1500ms);
  EXPECT_EQ(pipe().progress, PipeStatus::Progress::Idle);
  EXPECT_EQ(pipe().acks, 1u);
  EXPECT_LT(pipe().ackLast, 100ms);
}

TEST_F(OnBus, APacketThatIsNotOnTheBusStopsThePipeAndIsNotSentAgainMeanwhile) {
  pair.unlock();
  keep(kPipe, 3s);
  type("abc");
  pair.run(1100ms);
  EXPECT_EQ(pipe().progress, PipeStatus::Progress::Stalled);
  EXPECT_EQ(pipe().stall, PipeStatus::Stall::NotOnBus);
  EXPECT_EQ(pair.intend(intent::PipeAction{monitor, intent::PipeAction::What::Resend}), Refusal::Busy);
  pair.run(2500ms);
  EXPECT_EQ(pipe().progress, PipeStatus::Progress::Idle) << "it went out and was acknowledged";
  EXPECT_EQ(pipe().acks, 1u);
}

TEST_F(OnBus, APacketGivenUpInTheAdapterHoldsTheNextUntilAnAckOfItCanComeNoMore) {
  using What = intent::PipeAction::What;
  for (const What how : {What::Skip, What::Abort}) {
    TruckPair truck;
    truck.unlock();
    truck.console().leaves = [](const Frame& f) { return isType(f, kPipe) ? 3s : Duration(0ns); };
    truck.intend(intent::PipeWrite{monitor, "abc"});
    truck.run(1100ms);
    ASSERT_EQ(truck.intend(intent::PipeAction{monitor, how}), Refusal::None);
    truck.console().leaves = [](const Frame&) { return Duration(0ns); };
    truck.intend(intent::PipeWrite{monitor, "x"});
    truck.run(2500ms);
    ASSERT_EQ(truck.sent(kPipe, &truck.console()).size(), 1u) << "the first went out 3 s late";
    EXPECT_EQ(truck.console().pipe(truck.now(), monitor).strayAcks, 1u);
    truck.run(300ms);
    EXPECT_EQ(truck.sent(kPipe, &truck.console()).size(), 1u);
    truck.run(1s);
    EXPECT_EQ(truck.sent(kPipe, &truck.console()).size(), 2u);
    EXPECT_EQ(truck.console().pipe(truck.now(), monitor).acks, 1u);
  }
}

TEST_F(OnBus, APacketThatTheAdapterRefusedMayBeSentAgain) {
  pair.unlock();
  refuse(kPipe, WriteResult::QueueFull, 1);
  type("abc");
  EXPECT_EQ(pipe().progress, PipeStatus::Progress::Stalled);
  EXPECT_EQ(pipe().stall, PipeStatus::Stall::NotTaken);
  EXPECT_EQ(pair.intend(intent::PipeAction{monitor, intent::PipeAction::What::Resend}), Refusal::None);
  pair.run(100ms);
  EXPECT_EQ(pipe().acks, 1u);
}

TEST_F(OnBus, AnAckThatAFullQueueRefusedIsTriedAgainOnce) {
  pair.unlock();
  refuse(kPipe, WriteResult::QueueFull, 1);
  pair.inject(fromMonitor("FE4142"));
  pair.run(10ms);
  EXPECT_TRUE(pair.sent(kPipe, &console()).empty());
  pair.run(kTryAgain);
  EXPECT_EQ(pair.sent(kPipe, &console()).size(), 1u);
  EXPECT_EQ(all().notTaken, 0u);
  refuse(kPipe, WriteResult::QueueFull);
  const auto before = written(kPipe);
  pair.inject(fromMonitor("FE4142"));
  pair.run(1s);
  EXPECT_EQ(written(kPipe) - before, 2);
  EXPECT_EQ(all().notTaken, 1u);
}

TEST_F(OnBus, OfEqualPacketsTheFirstEchoIsTheFirstOnes) {
  pair.unlock();
  pair.wire = [](const Frame& f) { return Fate{f.length == 1 ? 0 : 1, 0ns}; };
  type("abc");
  pair.run(1100ms);
  ASSERT_EQ(pipe().stall, PipeStatus::Stall::NoAck);
  keep(kPipe, 200ms);
  pair.intend(intent::PipeAction{monitor, intent::PipeAction::What::Resend});
  pair.run(100ms);
  EXPECT_EQ(all().unconfirmed, 1u) << "the first one's echo came long ago";
  pair.run(150ms);
  EXPECT_EQ(all().unconfirmed, 0u);
}

}  // namespace
}  // namespace deckpipe::test
