// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "service/request_service.h"
#include "support/enums.h"
#include "support/pair.h"

namespace deckpipe::test {
namespace {

using Progress = RequestStatus::Progress;

std::vector<Request> polls() {
  std::vector<Request> all = allOf<Request>();
  std::erase_if(all, isCommand);
  return all;
}

struct RequestServiceTest : ::testing::Test {
  RequestServiceTest() { pair.unlock(); }
  TruckPair pair;
  const DeviceKey monitor = TruckPair::monitor();

  Refusal request(Request what) { return pair.intend(intent::SendRequests{monitor, RequestSet{what}}); }
  RequestStatus status(Request what) { return pair.console().request(pair.now(), monitor, what); }
  RequestEnd end(Request what) {
    const RequestStatus s = status(what);
    return s.progress == Progress::Ended ? s.end : RequestEnd::None;
  }
  std::size_t sent(unsigned type, Instant from = kNotYet) {
    return pair.sent(static_cast<std::uint8_t>(type), &pair.console(), from).size();
  }
  // An answer from the monitor to us, forged.
  Frame answer(std::string_view data, std::uint8_t source) {
    Frame f = frame("18EF0000", data);
    f.id = J1939Id{6, pgn::kProprietaryA, Address{source}, Address{0xF9}}.frameId();
    return f;
  }
  std::uint8_t monitorAddress() { return pair.addressOf(monitor).value; }
  // The monitor hears no polls of this type.
  void deafen(std::uint8_t type) {
    pair.wire = [type, own = &pair.console(), this](const Frame& f) {
      const bool isOurs = J1939Id::of(f.identifier()).source == Address{0xF9};
      return Pair::Fate{isOurs && f.data[0] == type ? 0 : 1, 0ns};
    };
  }
};

TEST_F(RequestServiceTest, EachPollIsAnsweredOnceAndInTheState) {
  ASSERT_EQ(pair.intend(intent::SendRequests{monitor, kPolls}), Refusal::None);
  pair.run(1s);
  for (const Request poll : polls()) {
    EXPECT_EQ(end(poll), RequestEnd::Answered) << static_cast<int>(poll);
    EXPECT_EQ(status(poll).tries, 1);
    EXPECT_GT(status(poll).latency, 0ns);
  }
  const Device& device = *pair.console().state.devices().byPin(monitor.pin);
  EXPECT_TRUE(device.faults().isKnown() && device.firmware().isKnown() && device.pcode().isKnown() &&
              device.config().isKnown());
  for (const unsigned type : {0x02u, 0x03u, 0x04u, 0x05u, 0x21u}) EXPECT_EQ(sent(type), 1u) << type;
}

TEST_F(RequestServiceTest, GoesToTheDeviceFromOurAddressAtPrioritySix) {
  request(Request::Fault);
  const Pair::Seen poll = pair.sent(0x02, &pair.console()).at(0);
  EXPECT_EQ(poll.id().source, Address{0xF9});
  EXPECT_EQ(poll.id().destination, Address{monitorAddress()});
  EXPECT_EQ(poll.id().priority, 6);
  EXPECT_EQ(poll.frame.length, 1);
}

TEST_F(RequestServiceTest, NoAnswerIsSaidAfterThreeTries) {
  deafen(0x03);
  const Instant begin = pair.now();
  request(Request::Firmware);
  pair.run(499ms);
  EXPECT_EQ(sent(0x03), 1u);
  pair.run(1010ms);
  EXPECT_EQ(end(Request::Firmware), RequestEnd::NoAnswer);
  EXPECT_EQ(sent(0x03), 3u);
  EXPECT_EQ(status(Request::Firmware).ended - begin, 3 * (500ms + Pair::kFlight)) << "each from its echo";
  pair.run(5s);
  EXPECT_EQ(sent(0x03), 3u);
}

TEST_F(RequestServiceTest, ASecondTryThatIsAnsweredIsAnAnswer) {
  pair.wire = [n = 0](const Frame& f) mutable {
    return Pair::Fate{f.data[0] == 0x04 && f.length == 1 && n++ == 0 ? 0 : 1, 0ns};
  };
  request(Request::Pcode);
  pair.run(1s);
  EXPECT_EQ(end(Request::Pcode), RequestEnd::Answered);
  EXPECT_EQ(status(Request::Pcode).tries, 2);
}

TEST_F(RequestServiceTest, NeverTwoOfOneKindInFlight) {
  deafen(0x02);
  EXPECT_EQ(request(Request::Fault), Refusal::None);
  EXPECT_EQ(request(Request::Fault), Refusal::Busy);
  EXPECT_EQ(pair.intend(intent::SendRequests{DeviceKey::at(Channel{}, Address{monitorAddress()}),
                                             RequestSet{Request::Fault}}),
            Refusal::Busy)
      << "the same device by its address";
  EXPECT_EQ(sent(0x02), 1u);
}

TEST_F(RequestServiceTest, AVistaPollWantsBothMessages) {
  pair.wire = [](const Frame& f) { return Pair::Fate{f.data[0] == 0x22 ? 0 : 1, 0ns}; };
  request(Request::Vista);
  pair.run(2s);
  EXPECT_EQ(end(Request::Vista), RequestEnd::NoAnswer);
  pair.wire = [](const Frame&) { return Pair::Fate{}; };
  request(Request::Vista);
  pair.run(1s);
  EXPECT_EQ(end(Request::Vista), RequestEnd::Answered);
}

TEST_F(RequestServiceTest, AnAnswerOfAWrongLengthIsNone) {
  deafen(0x02);
  request(Request::Fault);
  pair.inject(answer("0200000000", monitorAddress()));  // 5 bytes: older firmware, that is an answer
  pair.run(10ms);
  EXPECT_EQ(end(Request::Fault), RequestEnd::Answered);
  pair.run(100ms);
  request(Request::Fault);
  pair.inject(answer("020000000000", monitorAddress()));
  pair.run(10ms);
  EXPECT_EQ(status(Request::Fault).progress, Progress::Waiting);
  pair.run(2s);
  EXPECT_EQ(end(Request::Fault), RequestEnd::WrongAnswer);
  EXPECT_EQ(status(Request::Fault).wrong, 1u);
}

TEST_F(RequestServiceTest, AnAnswerOfAnotherDeviceIsNotIts) {
  deafen(0x02);
  request(Request::Fault);
  pair.inject(answer("02000000000000", pair.addressOf(TruckPair::riser()).value));
  pair.run(2s);
  EXPECT_EQ(end(Request::Fault), RequestEnd::NoAnswer);
}

TEST_F(RequestServiceTest, AnAnswerThatComesTwiceIsOneAnswer) {
  pair.wire = [](const Frame& f) { return Pair::Fate{f.data[0] == 0x02 && f.length == 7 ? 2 : 1, 0ns}; };
  request(Request::Fault);
  pair.run(1s);
  EXPECT_EQ(end(Request::Fault), RequestEnd::Answered);
  EXPECT_EQ(status(Request::Fault).answered, 1u);
  EXPECT_EQ(status(Request::Fault).unasked, 1u);
}

// Slower than our patience: what it answers to each of our tries is not an answer too many.
TEST_F(RequestServiceTest, EachTryOfASlowDeviceMayBeAnswered) {
  pair.wire = [](const Frame& f) {
    const bool isAnswer = f.data[0] == 0x02 && f.length == 7;
    return Pair::Fate{1, isAnswer ? Duration(800ms) : Duration(0ns)};
  };
  request(Request::Fault);
  pair.run(5s);
  EXPECT_EQ(end(Request::Fault), RequestEnd::Answered);
  EXPECT_EQ(status(Request::Fault).tries, 2);
  EXPECT_GE(status(Request::Fault).ended - status(Request::Fault).firstSent, 800ms);
  EXPECT_EQ(status(Request::Fault).unasked, 0u);
}

TEST_F(RequestServiceTest, AnAnswerAfterItWasGivenUpIsSaidToBeLate) {
  deafen(0x02);
  request(Request::Fault);
  pair.run(2s);
  ASSERT_EQ(end(Request::Fault), RequestEnd::NoAnswer);
  pair.inject(answer("02000000000000", monitorAddress()));
  pair.run(10ms);
  EXPECT_EQ(end(Request::Fault), RequestEnd::AnsweredLate);
}

TEST_F(RequestServiceTest, AnAnswerThatCameInTimeIsNoSilenceHoweverLateTheThreadIs) {
  pair.wire = [](const Frame& f) {
    return Pair::Fate{1, f.data[0] == 0x02 && f.length == 7 ? Duration(400ms) : Duration(0ns)};
  };
  request(Request::Fault);
  pair.run(200ms);
  pair.freeze(pair.console(), 500ms);  // the answer comes meanwhile
  pair.run(600ms);
  EXPECT_EQ(end(Request::Fault), RequestEnd::Answered);
  EXPECT_EQ(status(Request::Fault).tries, 1);
  EXPECT_LT(status(Request::Fault).latency, 410ms) << "when it came, not when it was read";
  EXPECT_EQ(sent(0x02), 1u);
}

// What a person asks for meanwhile judges nothing either.
TEST_F(RequestServiceTest, AnIntentOfALateThreadEndsNothingWhoseAnswerWaits) {
  pair.wire = [](const Frame& f) {
    return Pair::Fate{1, f.data[0] == 0x02 && f.length == 7 ? Duration(400ms) : Duration(0ns)};
  };
  request(Request::Fault);
  pair.run(200ms);
  pair.freeze(pair.console(), 500ms);
  pair.run(450ms);
  request(Request::Firmware);
  EXPECT_EQ(status(Request::Fault).progress, Progress::Waiting);
  EXPECT_EQ(sent(0x02), 1u);
}

TEST_F(RequestServiceTest, RepeatedPollsKeepTheirPeriodUntilTheyAreEnded) {
  pair.intend(intent::Repeat{monitor, RequestSet{Request::Fault}, 1s});
  pair.run(10500ms);
  EXPECT_EQ(sent(0x02), 11u);
  EXPECT_EQ(status(Request::Fault).answered, 11u);
  pair.intend(intent::Repeat{monitor, RequestSet{Request::Fault}, 0s});
  pair.run(5s);
  EXPECT_EQ(sent(0x02), 11u);
  EXPECT_EQ(status(Request::Fault).progress, Progress::Ended);
}

TEST_F(RequestServiceTest, OfRepeatedPollsOnlyWhatChangesIsNoted) {
  pair.intend(intent::Repeat{monitor, RequestSet{Request::Fault}, 1s});
  pair.run(5500ms);
  deafen(0x02);
  pair.run(6s);
  std::vector<RequestEnd> ends;
  for (const Note& note : pair.console().notes) {
    if (const auto* ended = std::get_if<note::RequestEnded>(&note.value)) ends.push_back(ended->end);
  }
  EXPECT_EQ(ends, (std::vector{RequestEnd::Answered, RequestEnd::NoAnswer}));
}

TEST_F(RequestServiceTest, TheShortestPeriodIsKept) {
  pair.intend(intent::Repeat{monitor, RequestSet{Request::Fault}, 1ms});
  pair.run(5s);
  EXPECT_LE(sent(0x02), 11u);
}

TEST_F(RequestServiceTest, CommandsGoOnceAndAreAcknowledged) {
  EXPECT_EQ(request(Request::ZeroAxes), Refusal::None);
  EXPECT_EQ(request(Request::SetupMode), Refusal::None);
  pair.run(100ms);
  EXPECT_EQ(end(Request::ZeroAxes), RequestEnd::Answered);
  EXPECT_EQ(end(Request::SetupMode), RequestEnd::Answered);
}

TEST_F(RequestServiceTest, ACommandWithoutAckIsNeverRepeated) {
  deafen(0x41);
  request(Request::ZeroAxes);
  pair.run(10s);
  EXPECT_EQ(sent(0x41), 1u);
  EXPECT_EQ(end(Request::ZeroAxes), RequestEnd::NoAnswer);
}

TEST_F(RequestServiceTest, AResetIsSeenWhenTheDeviceAnnouncesItself) {
  request(Request::Reset);
  pair.run(1s);
  EXPECT_EQ(status(Request::Reset).progress, Progress::Waiting);
  pair.run(3s);
  EXPECT_EQ(end(Request::Reset), RequestEnd::Answered);
  EXPECT_EQ(sent(0x45), 1u);
}

TEST_F(RequestServiceTest, AResetThatIsNotSeenWithinTenSecondsIsSaidSo) {
  deafen(0x45);
  request(Request::Reset);
  pair.run(9900ms);
  EXPECT_EQ(status(Request::Reset).progress, Progress::Waiting);
  pair.run(200ms);
  EXPECT_EQ(end(Request::Reset), RequestEnd::NoAnswer);
}

TEST_F(RequestServiceTest, OnlyWhatTheTypeTakesIsOfferedAndDone) {
  const ServiceStatus status = pair.console().status(pair.now());
  EXPECT_TRUE(status.find(monitor)->takes.has(Request::ZeroAxes));
  const RequestSet riser = status.find(TruckPair::riser())->takes;
  EXPECT_TRUE(riser.has(Request::Fault));
  for (const Request request : {Request::Vista, Request::ZeroAxes, Request::Reset, Request::SetupMode})
    EXPECT_FALSE(riser.has(request));
  EXPECT_EQ(pair.intend(intent::SendRequests{TruckPair::riser(), RequestSet{Request::Reset}}),
            Refusal::NotTaken);
  EXPECT_EQ(pair.intend(intent::SendRequests{DeviceKey::of(*Pin::parse("1032AE000000001")), kPolls}),
            Refusal::NoDevice);
}

TEST_F(RequestServiceTest, OfEveryoneOnlyPollsAreAsked) {
  EXPECT_EQ(
      pair.intend(intent::SendRequests{{}, RequestSet{Request::Fault, Request::Reset, Request::ZeroAxes}}),
      Refusal::None);
  pair.run(3s);
  EXPECT_EQ(sent(0x02), pair.console().status(pair.now()).devices.size());
  EXPECT_EQ(sent(0x45) + sent(0x41), 0u);
}

TEST_F(RequestServiceTest, ACommandToADeviceThatIsSilentForASecondIsRefusedAndAPollIsNot) {
  pair.wire = [](const Frame&) { return Pair::Fate{0, 0ns}; };  // it is not heard any more
  pair.run(900ms);
  EXPECT_EQ(request(Request::SetupMode), Refusal::None);
  pair.run(300ms);
  EXPECT_EQ(request(Request::ZeroAxes), Refusal::NotHeard);
  EXPECT_EQ(request(Request::Fault), Refusal::None);
  EXPECT_EQ(sent(0x41), 0u);
}

TEST_F(RequestServiceTest, NothingIsAskedOfAContestedAddressUntilItIsDecided) {
  Frame claim = frame("18EEFF00", "FFFFFFFFFFFFFFFF");  // would lose, and the holder does not answer yet
  claim.id = J1939Id{6, pgn::kAddressClaimed, Address{monitorAddress()}, kGlobalAddress}.frameId();
  pair.wire = [](const Frame& f) {
    return Pair::Fate{J1939Id::of(f.identifier()).pgn == pgn::kAddressClaimed && f.data[0] != 0xFF ? 0 : 1,
                      0ns};
  };
  pair.inject(claim);
  pair.run(Pair::kFlight);
  EXPECT_EQ(request(Request::ZeroAxes), Refusal::Contested);
  EXPECT_EQ(request(Request::Fault), Refusal::Contested);
  EXPECT_EQ(sent(0x41), 0u);
  EXPECT_EQ(sent(0x02), 0u);
}

TEST_F(RequestServiceTest, NothingIsUnlockedOnAListenOnlyAdapter) {
  Console& console = pair.console();
  console.services.setListenOnly(pair.now(), console.state, true);
  EXPECT_TRUE(console.status(pair.now()).locked) << "what was unlocked is locked";
  EXPECT_EQ(pair.intend(intent::Unlock{}), Refusal::ListenOnly);
  pair.run(1s);
  const Instant before = pair.now();
  pair.run(1s);
  EXPECT_TRUE(pair.sentBy(&console, before).empty());
  console.services.setListenOnly(pair.now(), console.state, false);
  EXPECT_EQ(pair.intend(intent::Unlock{}), Refusal::None);
}

TEST_F(RequestServiceTest, LockingEndsWhatIsOpenAndRepeated) {
  deafen(0x02);
  pair.intend(intent::Repeat{monitor, RequestSet{Request::Fault}, 1s});
  pair.intend(intent::Lock{});
  EXPECT_EQ(end(Request::Fault), RequestEnd::Cancelled);
  const Instant before = pair.now() + 1ns;
  pair.run(10s);
  EXPECT_TRUE(pair.sentBy(&pair.console(), before).empty());
  EXPECT_EQ(request(Request::Fault), Refusal::Locked);
}

TEST_F(RequestServiceTest, ALostLinkEndsWhatIsOpen) {
  deafen(0x02);
  request(Request::Fault);
  pair.setLink(pair.console(), false);
  EXPECT_EQ(end(Request::Fault), RequestEnd::LinkLost);
  EXPECT_EQ(request(Request::Fault), Refusal::NoLink);
}

TEST_F(RequestServiceTest, OurAddressLostToAnotherEndsWhatIsOpen) {
  deafen(0x02);
  request(Request::Fault);
  Frame claim = frame("18EEFFF9", "0100000000000000");
  pair.inject(claim);
  pair.run(10ms);
  EXPECT_EQ(end(Request::Fault), RequestEnd::AddressLost);
}

TEST_F(RequestServiceTest, ACopleyDriveIsNeverPolled) {
  pair.console().state.apply(
      Note{.time = pair.now(), .value = note::DriveSaid{Channel{}, Address{monitorAddress()}}});
  EXPECT_EQ(request(Request::Fault), Refusal::NotTaken);
}

TEST_F(RequestServiceTest, APinOfBeforeAGapIsNobodyUntilItIsHeardAnew) {
  pair.run(2s);
  ASSERT_EQ(request(Request::Fault), Refusal::None);
  pair.run(1s);
  State& state = pair.console().state;
  state.apply(Note{.time = pair.now(), .value = note::LinkDown{}});
  state.apply(Note{.time = pair.now(), .value = note::LinkUp{}});
  pair.run(100ms);
  const std::size_t before = sent(0x02);
  EXPECT_EQ(request(Request::Fault), Refusal::FormerPin);
  EXPECT_EQ(request(Request::Reset), Refusal::FormerPin);
  EXPECT_EQ(pair.intend(intent::Repeat{monitor, kPolls, 500ms}), Refusal::FormerPin);
  EXPECT_EQ(pair.intend(intent::PipeWrite{monitor, "A?"}), Refusal::FormerPin);
  EXPECT_EQ(sent(0x02), before);
  pair.intend(intent::RequestNames{});
  pair.run(2s);
  EXPECT_EQ(request(Request::Fault), Refusal::None);
}

// The link goes down and comes back; who was there says nothing anew.
struct RequestsBehindAGap : RequestServiceTest {
  void gap() {
    Console& console = pair.console();
    console.state.apply(Note{.time = pair.now(), .value = note::LinkDown{}});
    pair.setLink(console, false);
    pair.run(3s);
    console.state.apply(Note{.time = pair.now(), .value = note::LinkUp{}});
    pair.setLink(console, true);
  }
  // A node that is none of the simulator's sends a status.
  void speak(std::uint8_t source) {
    Frame status = frame("18EFFF00", "83C051");
    status.id = J1939Id{6, pgn::kProprietaryA, Address{source}, kGlobalAddress}.frameId();
    pair.inject(status);
    pair.run(2 * Pair::kFlight);
  }
  Refusal poll(std::uint8_t address) {
    return pair.intend(
        intent::SendRequests{DeviceKey::at(Channel{}, Address{address}), RequestSet{Request::Fault}});
  }
};

TEST_F(RequestsBehindAGap, WhereAnotherMakersNodeWasNothingIsAsked) {
  pair.inject(frame("18EEFF90", "0100200000000000"));
  speak(0x90);
  gap();
  pair.unlock();
  speak(0x90);
  ASSERT_NE(pair.console().state.devices().byAddress(Channel{}, Address{0x90}), nullptr);
  EXPECT_EQ(poll(0x90), Refusal::NotTaken);
  pair.inject(frame("18EEFF90", "0B1AC22800420090"));
  speak(0x90);
  EXPECT_EQ(poll(0x90), Refusal::None);
}

TEST_F(RequestsBehindAGap, WhoWasNotHeardAnewIsNotAsked) {
  speak(0x90);
  ASSERT_EQ(poll(0x90), Refusal::None);
  gap();
  pair.unlock();
  EXPECT_EQ(poll(0x90), Refusal::NotHeard);
  const Instant from = pair.now();
  pair.intend(intent::SendRequests{{}, RequestSet{Request::Fault}});
  pair.run(1s);
  for (const Pair::Seen& seen : pair.sent(0x02, &pair.console(), from))
    EXPECT_NE(seen.id().destination, Address{0x90});
  speak(0x90);
  EXPECT_EQ(poll(0x90), Refusal::None);
}

TEST_F(RequestsBehindAGap, WhatAnAddressWasAskedIsNotWhatItsNextDeviceWasAsked) {
  speak(0x90);
  ASSERT_EQ(poll(0x90), Refusal::None);
  pair.inject(answer("02000000000000", 0x90));
  pair.run(100ms);
  gap();
  pair.unlock();
  pair.inject(frame("18EFFF90", "FF83150206021A0C"));
  pair.run(1s);
  const DeviceKey next = DeviceKey::of(*Pin::parse("1032AE100801036"));
  pair.intend(intent::SendRequests{next, RequestSet{Request::Firmware}});
  EXPECT_EQ(pair.console().request(pair.now(), next, Request::Fault).answered, 0u);
  EXPECT_EQ(pair.console().request(pair.now(), next, Request::Fault).progress, Progress::Idle);
}

TEST_F(RequestServiceTest, RepeatedPollsEndWhenThePersonSaysThatItIsADrive) {
  pair.intend(intent::Repeat{monitor, kPolls, 500ms});
  pair.run(1s);
  ASSERT_GT(sent(0x02), 0u);
  pair.console().state.apply(
      Note{.time = pair.now(), .value = note::DriveSaid{Channel{}, Address{monitorAddress()}}});
  const std::size_t before = sent(0x02);
  pair.run(3s);
  EXPECT_EQ(sent(0x02), before);
}

TEST_F(RequestServiceTest, RepeatedPollsWaitWhileTheAddressIsContested) {
  pair.intend(intent::Repeat{monitor, kPolls, 500ms});
  pair.run(1s);
  pair.wire = [](const Frame& f) {  // the holder does not answer
    return Pair::Fate{J1939Id::of(f.identifier()).pgn == pgn::kAddressClaimed && f.data[0] != 0xFF ? 0 : 1,
                      0ns};
  };
  const std::uint8_t address = monitorAddress();
  const auto contest = [&] {
    Frame claim = frame("18EEFF00", "FFFFFFFFFFFFFFFF");
    claim.id = J1939Id{6, pgn::kAddressClaimed, Address{address}, kGlobalAddress}.frameId();
    pair.inject(claim);
    pair.run(Pair::kFlight);
  };
  contest();
  const std::size_t before = sent(0x02);
  pair.run(kClaimTime - 2ms);
  EXPECT_EQ(sent(0x02), before);
  EXPECT_TRUE(pair.console().state.channel({}).book.isContested(Address{address}));
}

TEST_F(RequestServiceTest, LockUnlockPollsAndTheirEndsAreNotes) {
  request(Request::Fault);
  pair.run(1s);
  std::vector<std::string_view> kinds;
  for (const Note& note : pair.console().notes) kinds.push_back(noteKey(note.value));
  ASSERT_EQ(kinds, (std::vector<std::string_view>{"unlocked", "own_address", "asked", "ask_ended"}));
  EXPECT_EQ(std::get<note::Asked>(pair.console().notes[2].value).pin.text(), TruckPair::kMonitor);
}

std::vector<note::AnglesBefore> anglesIn(const std::vector<Note>& notes) {
  std::vector<note::AnglesBefore> found;
  for (const Note& note : notes) {
    if (const auto* angles = std::get_if<note::AnglesBefore>(&note.value)) found.push_back(*angles);
  }
  return found;
}

TEST_F(RequestServiceTest, WhereADeviceStoodBeforeACommandIsANote) {
  pair.run(1s);
  const PositionLimitStatus before = pair.console().state.devices().byPin(monitor.pin)->position().value();
  ASSERT_EQ(before.rotation.state, PositionState::Ok);
  request(Request::ZeroAxes);
  pair.run(1s);
  const auto noted = anglesIn(pair.console().notes);
  ASSERT_EQ(noted.size(), 1u);
  EXPECT_EQ(noted[0].request, Request::ZeroAxes);
  EXPECT_EQ(noted[0].pin, monitor.pin);
  EXPECT_EQ(noted[0].rotation.tenths, before.rotation.tenths);
  EXPECT_EQ(noted[0].elevation.tenths, before.elevation.tenths);
}

TEST_F(RequestServiceTest, OfAPollOrOfAStaleReportNoAnglesAreNoted) {
  request(Request::Fault);
  pair.run(1s);
  pair.wire = [](const Frame& f) {  // its positions do not come any more, its other statuses do
    return Pair::Fate{f.data[0] == 0x01 && J1939Id::of(f.identifier()).pgn == pgn::kProprietaryA ? 0 : 1,
                      0ns};
  };
  pair.run(1s);
  ASSERT_EQ(request(Request::Reset), Refusal::None);
  EXPECT_TRUE(anglesIn(pair.console().notes).empty());
}

TEST_F(RequestServiceTest, ARepeatedPollOfADeviceWithoutAnAddressComesBackAPeriodLater) {
  pair.intend(intent::Repeat{monitor, RequestSet{Request::Fault}, 1s});
  pair.run(2500ms);
  // Its address goes to another, and it hears nothing of that.
  pair.wire = [](const Frame&) { return Pair::Fate{0, 0ns}; };
  pair.console().state.apply(frame("18EEFF80", "0100000000000000"), pair.now());
  pair.console().state.apply(frame("18EEFF81", "0200000000000000"), pair.now());
  pair.run(kClaimTime);
  ASSERT_EQ(pair.addressOf(monitor), kNullAddress);
  const std::size_t before = sent(0x02);
  pair.run(5s);
  EXPECT_EQ(sent(0x02), before);
  EXPECT_EQ(status(Request::Fault).end, RequestEnd::Gone);
}

TEST_F(RequestServiceTest, AnAnnouncementThatWasAskedForIsNoReset) {
  deafen(0x45);
  request(Request::Reset);
  pair.run(500ms);
  pair.intend(intent::RequestNames{});
  pair.run(1s);
  EXPECT_EQ(status(Request::Reset).progress, Progress::Waiting);
  pair.run(10s);
  EXPECT_EQ(end(Request::Reset), RequestEnd::NoAnswer);
}

TEST_F(RequestServiceTest, WhatWasAskedOfAnAddressIsTheDevicesOnceItsPinIsKnown) {
  Pair blind;  // a console that comes later than the announcements
  simulator::StandardSimulator truck = simulator::standardSimulator(1);
  blind.simulator = std::move(truck.simulator);
  blind.simulator.powerOn(blind.now());
  blind.run(4s);
  blind.addConsole();
  blind.wire = [](const Frame& f) { return Pair::Fate{f.data[0] == 0xFF ? 0 : 1, 0ns}; };
  blind.run(1s);
  blind.unlock();
  const DeviceKey byAddress = DeviceKey::at(Channel{}, Address{0x80});
  ASSERT_EQ(blind.intend(intent::Repeat{byAddress, RequestSet{Request::Fault}, 500ms}), Refusal::None);
  blind.run(2s);
  blind.wire = [](const Frame&) { return Pair::Fate{}; };
  blind.intend(intent::RequestNames{});
  blind.run(1s);
  const Device* device = blind.console().state.devices().byAddress(Channel{}, Address{0x80});
  ASSERT_FALSE(device->pin.isNull());
  blind.intend(intent::Cancel{DeviceKey::of(device->pin)});
  const Instant from = blind.now() + 1ns;
  blind.run(5s);
  EXPECT_TRUE(blind.sent(0x02, &blind.console(), from).empty());
}

TEST_F(RequestServiceTest, ARefusalIsForgottenWithTheNextIntentThatIsCarriedOut) {
  deafen(0x02);
  request(Request::Fault);
  EXPECT_EQ(request(Request::Fault), Refusal::Busy);
  EXPECT_EQ(pair.console().status(pair.now()).refusal, Refusal::Busy);
  request(Request::Firmware);
  EXPECT_EQ(pair.console().status(pair.now()).refusal, Refusal::None);
}

// Answers as they should not come, to everything that is answered at all.
struct HostileAnswer : RequestServiceTest, ::testing::WithParamInterface<Request> {
  HostileAnswer() {
    deafen(static_cast<std::uint8_t>(messageOf(rule.request).firstByte));
    request(GetParam());
    pair.run(Pair::kFlight);
  }
  const RequestRule& rule = ruleOf(GetParam());

  std::vector<MessageId> parts() const {
    return rule.answers[1] == kNoAnswer ? std::vector{rule.answers[0]}
                                        : std::vector{rule.answers[0], rule.answers[1]};
  }
  static std::string bytes(MessageId part, unsigned length) {
    char type[3];
    std::snprintf(type, sizeof type, "%02X", static_cast<unsigned>(messageOf(part).firstByte));
    return length == 0 ? std::string() : type + std::string(2 * (length - 1), '0');
  }
  // The whole answer as it should be, from there.
  void answerFrom(std::uint8_t source, Address destination = Address{0xF9}) {
    for (const MessageId part : parts()) {
      Frame f = answer(bytes(part, messageOf(part).maxLength()), source);
      f.id = J1939Id{6, pgn::kProprietaryA, Address{source}, destination}.frameId();
      pair.inject(f);
    }
    pair.run(Pair::kFlight);
  }
  void expectUnanswered(const char* after) {
    EXPECT_EQ(status(GetParam()).progress, Progress::Waiting) << after;
  }
};

TEST_P(HostileAnswer, OfAWrongLengthIsNone) {
  std::uint32_t wrong = 0;
  for (const MessageId part : parts()) {
    for (unsigned length = 1; length <= 8; ++length) {
      if (allows(messageOf(part).lengths, length)) continue;
      pair.inject(answer(bytes(part, length), monitorAddress()));
      ++wrong;
    }
  }
  pair.run(Pair::kFlight);
  expectUnanswered("wrong lengths");
  EXPECT_EQ(status(GetParam()).wrong, wrong);
  pair.run(2s);
  EXPECT_EQ(end(GetParam()), RequestEnd::WrongAnswer);
}

TEST_P(HostileAnswer, OfAnotherOrToAnotherIsNone) {
  answerFrom(pair.addressOf(TruckPair::riser()).value);
  expectUnanswered("of another device");
  answerFrom(0xB7);
  expectUnanswered("of nobody known");
  answerFrom(0xFE);
  expectUnanswered("of the null address");
  answerFrom(0xF9);
  expectUnanswered("of ourselves");
  answerFrom(monitorAddress(), Address{0xFA});
  expectUnanswered("to another");
  answerFrom(monitorAddress(), kGlobalAddress);
  expectUnanswered("to everyone");
}

TEST_P(HostileAnswer, AsNoDataFrameIsNone) {
  for (const MessageId part : parts()) {
    Frame remote = answer(bytes(part, messageOf(part).maxLength()), monitorAddress());
    remote.id |= kRemoteBit;
    pair.inject(remote);
    Frame error = answer(bytes(part, messageOf(part).maxLength()), monitorAddress());
    error.id |= kErrorBit;
    pair.inject(error);
    Frame standard = answer(bytes(part, messageOf(part).maxLength()), monitorAddress());
    standard.id = standard.id & 0x7FF;
    pair.inject(standard);
  }
  pair.run(Pair::kFlight);
  expectUnanswered("no data frame");
}

TEST_P(HostileAnswer, TwiceIsOne) {
  answerFrom(monitorAddress());
  answerFrom(monitorAddress());
  EXPECT_EQ(end(GetParam()), RequestEnd::Answered);
  EXPECT_EQ(status(GetParam()).answered, 1u);
  EXPECT_EQ(status(GetParam()).unasked, parts().size());
  pair.run(5s);
  EXPECT_EQ(sent(static_cast<unsigned>(messageOf(rule.request).firstByte)), 1u);
}

TEST_P(HostileAnswer, LateIsSaidSoAndMuchLaterIsNobodysAnswer) {
  pair.run(2s);
  ASSERT_EQ(end(GetParam()), RequestEnd::NoAnswer);
  pair.run(RequestService::kLate);
  answerFrom(monitorAddress());
  EXPECT_EQ(end(GetParam()), RequestEnd::NoAnswer);
  EXPECT_EQ(status(GetParam()).unasked, parts().size());
  request(GetParam());
  pair.run(2s);
  answerFrom(monitorAddress());
  EXPECT_EQ(end(GetParam()), RequestEnd::AnsweredLate);
  EXPECT_EQ(status(GetParam()).answered, 0u);
}

INSTANTIATE_TEST_SUITE_P(Asks, HostileAnswer,
                         ::testing::ValuesIn(allBut(Request::Reset)),  // which has no answer
                         [](const auto& row) {
                           const auto key = messageOf(ruleOf(row.param).request).key;
                           return std::string(key.substr(0, key.find('_')));
                         });

// Thirty monitors that all answer, and thirty that do not: what polling everyone takes of the bus.
struct Crowd : ::testing::Test {
  Crowd() {
    pair.addConsole();
    for (int i = 0; i < 30; ++i) {
      const auto pin = Pin::make(1032, 'A', 'E', 100 + static_cast<unsigned>(i));
      simulator::MonitorSettings settings;
      pair.simulator.add<simulator::Monitor6032>(i * 37ms, pin->text(), settings,
                                                 static_cast<std::uint64_t>(i) + 1);
    }
    pair.simulator.powerOn(pair.now());
    pair.run(10s);
    pair.unlock();
  }
  // What all took of the bus for so long from now on.
  double loadOf(Duration d) {
    const Instant from = pair.now();
    pair.run(d);
    double bits = 0;
    for (const Pair::Seen& seen : pair.log) {
      if (seen.time >= from) bits += estimatedBits(seen.frame);
    }
    return bits / (250'000 * std::chrono::duration<double>(d).count());
  }
  // Of the bus, what is between us and others, in the busiest second.
  double worstShare(Instant from) {
    std::map<std::int64_t, double> seconds;
    for (const Pair::Seen& seen : pair.log) {
      const J1939Id id = seen.id();
      const bool isOurs =
          id.source == Address{0xF9} || (id.hasDestination() && id.destination == Address{0xF9});
      if (seen.time >= from && isOurs) seconds[(seen.time - from) / 1s] += estimatedBits(seen.frame);
    }
    double worst = 0;
    for (const auto& [second, bits] : seconds) worst = std::max(worst, bits / 250'000);
    return worst;
  }
  Pair pair;
};

TEST_F(Crowd, PollingEveryoneGetsAllAnswersWithinTheBudget) {
  const Instant from = pair.now();
  pair.intend(intent::SendRequests{{}, kPolls});
  pair.run(20s);
  std::size_t answered = 0;
  for (const DeviceServices& device : pair.console().status(pair.now()).devices) {
    for (const RequestStatus& request : device.requests) answered += request.answered;
  }
  EXPECT_EQ(answered, 150u);
  EXPECT_LE(worstShare(from), BusBudget::kShare * 1.1);
}

TEST_F(Crowd, RepeatedFasterThanTheBudgetAllowsEveryoneStillHasHisTurn) {
  const Instant from = pair.now();
  pair.intend(intent::Repeat{{}, kPolls, 500ms});
  pair.run(30s);
  EXPECT_LE(worstShare(from), BusBudget::kShare * 1.1);
  std::uint32_t least = ~0u, most = 0;
  for (const DeviceServices& device : pair.console().status(pair.now()).devices) {
    for (const Request poll : polls()) {
      least = std::min(least, device.of(poll).answered);
      most = std::max(most, device.of(poll).answered);
    }
  }
  EXPECT_GT(least, 0u);
  EXPECT_LE(most - least, 1u);
}

// Thirty monitors fill half of a bus by themselves; the rest up to the load is others' traffic.
TEST_F(Crowd, OnABusyBusPollingEveryoneEndsAndLeavesTheBusToOthers) {
  const double own = loadOf(5s);
  ASSERT_GT(own, 0.3);
  for (const double load : {0.8, 0.95}) {
    pair.simulator.fill(pair.now(), load - own);
    EXPECT_NEAR(loadOf(5s), load, 0.01);
    const Instant from = pair.now();
    pair.intend(intent::SendRequests{{}, kPolls});
    const auto isOver = [&] {
      const ServiceStatus status = pair.console().status(pair.now());
      return std::ranges::all_of(status.devices, [](const DeviceServices& device) {
        return std::ranges::all_of(device.requests, [](const RequestStatus& request) {
          return request.progress == Progress::Idle || request.progress == Progress::Ended;
        });
      });
    };
    for (int i = 0; i < 60 && !isOver(); ++i) pair.run(1s);
    EXPECT_TRUE(isOver()) << load;
    EXPECT_LE(worstShare(from), (load < BusBudget::kFull ? BusBudget::kShare : BusBudget::kMin) * 1.2);
  }
  for (const DeviceServices& device : pair.console().status(pair.now()).devices) {
    for (const Request poll : polls()) EXPECT_EQ(device.of(poll).answered, 2u);
  }
}

TEST_F(Crowd, OfSilentOnesTheRetriesStayWithinTheBudgetToo) {
  pair.wire = [](const Frame& f) {
    return Pair::Fate{J1939Id::of(f.identifier()).source == Address{0xF9} ? 0 : 1, 0ns};
  };
  const Instant from = pair.now();
  pair.intend(intent::SendRequests{{}, kPolls});
  pair.run(40s);
  EXPECT_LE(worstShare(from), BusBudget::kShare * 1.1);
  for (const DeviceServices& device : pair.console().status(pair.now()).devices) {
    for (const Request poll : polls()) EXPECT_EQ(device.of(poll).end, RequestEnd::NoAnswer);
  }
}

}  // namespace
}  // namespace deckpipe::test
