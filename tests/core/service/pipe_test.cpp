// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <zlib.h>

#include "core/service/pipe_rig.h"
#include "simulator/random.h"

namespace deckpipe::test {
namespace {

using Progress = PipeStatus::Progress;
using Stall = PipeStatus::Stall;
using FileEnd = PipeStatus::FileEnd;
using Pipe = PipeRig;

TEST_F(Pipe, SendsSevenCharactersAPacketAndTheNextOnlyAfterTheAck) {
  acks([](int) { return Pair::Fate{1, 100ms}; });
  type("Good morning");
  EXPECT_EQ(packets(), (std::vector<std::string>{"Good mo"}));
  pair.run(90ms);
  EXPECT_EQ(packets().size(), 1u);
  pair.run(30ms);
  EXPECT_EQ(packets(), (std::vector<std::string>{"Good mo", "rning"}));
  pair.run(200ms);
  EXPECT_EQ(status().progress, Progress::Idle);
  EXPECT_EQ(status().sent, 12u);
  EXPECT_GE(status().ackWorst, 100ms);
}

TEST_F(Pipe, WhatComesInIsAcknowledgedAtOnceWhileWeSend) {
  type("A?\n");
  pair.run(2s);
  EXPECT_GT(status().received, 0u);
  EXPECT_EQ(acksSent(), (status().received + 6) / 7);
  const Instant before = pair.now();
  pair.inject(fromDevice("FE4142", address()));
  pair.run(Pair::kFlight);
  EXPECT_EQ(pair.sent(kPipe, &pair.console(), before).size(), 1u) << "at once";
}

TEST_F(Pipe, AFileGoesWholeAndInOrder) {
  std::string content;
  for (int i = 0; i < 1000; ++i) content += static_cast<char>(i * 7);
  ASSERT_EQ(send(content), Refusal::None);
  ASSERT_TRUE(pair.runUntil([&] { return status().fileEnd == FileEnd::Done; }, 60s));
  EXPECT_EQ(sentText(), content);
  EXPECT_EQ(status().fileSent, 1000u);
  EXPECT_EQ(status().acks, 143u);
  EXPECT_GT(status().fileEnded - status().fileBegan, 0ns);
}

// Other traffic takes 80 % of the bus, and every frame waits its turn. What arrived is told by the device.
TEST_F(Pipe, AHundredKilobytesArriveWholeOnABusyBus) {
  simulator::Random random(80);
  std::string content(100'000, '\0');
  for (char& c : content) c = static_cast<char>(random.next());
  const uLong crc = crc32(0, reinterpret_cast<const Bytef*>(content.data()), 100'000);
  pair.simulator.fill(pair.now(), 0.8);
  pair.wire = [&random](const Frame&) { return Pair::Fate{1, random.between(0, 1500) * Duration(1us)}; };
  type("FILE 100000\r");
  pair.run(1s);
  EXPECT_GT(pair.console().status(pair.now()).busLoad, 0.8);
  ASSERT_EQ(send(content), Refusal::None);
  for (int i = 0; i < 300 && status().fileEnd == FileEnd::None; ++i) {
    pair.run(1s);
    ASSERT_NE(status().progress, Progress::Stalled);
  }
  EXPECT_EQ(status().fileEnd, FileEnd::Done);
  EXPECT_EQ(status().acks, 100'000u / 7 + 1 + 2) << "and the line before";
  pair.run(1s);
  std::string said;
  for (const Pair::Seen& seen : pair.sent(kPipe, nullptr)) {
    if (seen.frame.length > 1)
      said.append(seen.frame.data.begin() + 1, seen.frame.data.begin() + seen.frame.length);
  }
  char expected[64];
  std::snprintf(expected, sizeof expected, "OK 100000 CRC32 %08lX", crc);
  EXPECT_NE(said.find(expected), std::string::npos) << said;
}

TEST_F(Pipe, AnEmptyFileIsDoneAtOnce) {
  EXPECT_EQ(send(""), Refusal::None);
  EXPECT_EQ(status().fileEnd, FileEnd::Done);
  EXPECT_TRUE(packets().empty());
}

TEST_F(Pipe, WhileAFileGoesNothingElseGetsIntoIt) {
  send(std::string(500, 'x'));
  EXPECT_EQ(type("y"), Refusal::Busy);
  EXPECT_EQ(send("z"), Refusal::Busy);
  pair.run(10s);
  EXPECT_EQ(sentText(), std::string(500, 'x'));
  EXPECT_EQ(type("y"), Refusal::None);
}

TEST_F(Pipe, AnAckThatCameInTimeIsInTimeHoweverLateTheThreadIs) {
  acks([](int) { return Pair::Fate{1, 900ms}; });
  type("0123456789");
  pair.run(700ms);
  pair.freeze(pair.console(), 500ms);  // the ack comes meanwhile
  pair.run(600ms);
  EXPECT_EQ(status().progress, Progress::Sending);
  EXPECT_EQ(packets(), (std::vector<std::string>{"0123456", "789"}));
  EXPECT_EQ(status().lateAcks, 0u);
  EXPECT_GE(status().ackLast, 900ms);
  EXPECT_LT(status().ackLast, 910ms) << "when it came, not when it was read";
}

TEST_F(Pipe, AMissingAckStopsItAndNothingIsSentAgainByItself) {
  acks([](int n) { return Pair::Fate{n == 1 ? 0 : 1, 0ns}; });
  send("0123456789abcdefghijk");
  pair.run(900ms);
  EXPECT_EQ(status().progress, Progress::Sending);
  pair.run(10s);
  EXPECT_EQ(status().progress, Progress::Stalled);
  EXPECT_EQ(status().stall, Stall::NoAck);
  EXPECT_EQ(packets().size(), 2u);
}

struct Stalled : Pipe {
  Stalled() {
    acks([](int n) { return Pair::Fate{n == 1 ? 0 : 1, 0ns}; });
    send("0123456789abcdefghijk");
    pair.run(2s);
  }
};

TEST_F(Stalled, ResendSendsThatPacketAgainAndGoesOnAfterASecond) {
  ASSERT_EQ(status().progress, Progress::Stalled);
  EXPECT_EQ(act(What::Resend), Refusal::None);
  pair.run(100ms);
  EXPECT_EQ(packets(), (std::vector<std::string>{"0123456", "789abcd", "789abcd"}));
  EXPECT_EQ(status().progress, Progress::Settling);
  pair.run(5s);
  EXPECT_EQ(status().fileEnd, FileEnd::Done);
  EXPECT_EQ(packets().size(), 4u);
  EXPECT_EQ(status().resent, 1u);
  EXPECT_EQ(status().fileResent, 1u);
}

TEST_F(Stalled, SaysWhenTheDeviceGoesElsewhereMeanwhile) {
  ASSERT_EQ(status().stall, Stall::NoAck);
  pair.inject(
      frame(address() == 0x80 ? "18EEFF80" : "18EEFF81", "0100000000000000"));  // its address is taken
  pair.run(2s);
  EXPECT_EQ(status().progress, Progress::Stalled);
  EXPECT_EQ(status().stall, Stall::Moved);
}

TEST_F(Stalled, APauseIsSeenAndTakenBackBeforeThePersonDecides) {
  EXPECT_EQ(act(What::Pause), Refusal::None);
  EXPECT_TRUE(status().isPaused);
  EXPECT_EQ(status().progress, Progress::Stalled);
  EXPECT_EQ(act(What::Resume), Refusal::None);
  EXPECT_FALSE(status().isPaused);
}

TEST_F(Stalled, SkipGoesOnBehindIt) {
  EXPECT_EQ(act(What::Skip), Refusal::None);
  pair.run(5s);
  EXPECT_EQ(sentText(), "0123456789abcdefghijk");
  EXPECT_EQ(packets().size(), 3u);
  EXPECT_EQ(status().fileEnd, FileEnd::Done);
  EXPECT_EQ(status().skipped, 1u);
  EXPECT_EQ(status().fileSkipped, 1u);
}

TEST_F(Stalled, AbortSendsNothingMore) {
  EXPECT_EQ(act(What::Abort), Refusal::None);
  pair.run(5s);
  EXPECT_EQ(packets().size(), 2u);
  EXPECT_EQ(status().fileEnd, FileEnd::Aborted);
  EXPECT_EQ(status().progress, Progress::Idle);
  EXPECT_EQ(type("on"), Refusal::None);
}

TEST_F(Stalled, AnAckThatComesAfterAllResolvesTheDoubt) {
  pair.inject(fromDevice("FE", address()));
  pair.run(5s);
  EXPECT_EQ(sentText(), "0123456789abcdefghijk");
  EXPECT_EQ(status().fileEnd, FileEnd::Done);
  EXPECT_EQ(status().lateAcks, 1u);
}

TEST_F(Stalled, TheSecondAckOfAPacketSentAgainIsNotTakenForTheNext) {
  pair.wire = [](const Frame&) { return Pair::Fate{}; };
  act(What::Resend);
  pair.run(20ms);
  pair.inject(fromDevice("FE", address()));  // the first one's, very late
  pair.run(100ms);
  EXPECT_EQ(packets().size(), 3u);
  EXPECT_EQ(status().strayAcks, 1u);
  pair.run(5s);
  EXPECT_EQ(packets().size(), 4u);
}

TEST_F(Stalled, CancellingTheFileEndsTheStallToo) {
  EXPECT_EQ(act(What::Cancel), Refusal::None);
  EXPECT_EQ(status().fileEnd, FileEnd::Cancelled);
  EXPECT_EQ(status().progress, Progress::Settling);
  const Instant before = pair.now();
  EXPECT_EQ(type("on"), Refusal::None);
  pair.run(900ms);
  EXPECT_TRUE(packets(before).empty()) << "the ack in doubt may still come";
  pair.run(1s);
  EXPECT_EQ(sentText(before), "on");
}

TEST_F(Stalled, SkippedAndCancelledTheNextPacketStillWaitsForALateAck) {
  act(What::Skip);
  act(What::Cancel);
  const Instant before = pair.now();
  type("on");
  pair.run(900ms);
  EXPECT_TRUE(packets(before).empty());
  pair.run(1s);
  EXPECT_EQ(sentText(before), "on");
}

TEST_F(Stalled, WithoutADecisionOnlyThoseOfAStallAreRefused) {
  act(What::Abort);
  pair.run(2s);
  for (const What what : {What::Resend, What::Skip}) EXPECT_EQ(act(what), Refusal::Busy);
}

TEST_F(Pipe, AnAckFromBeforeThePacketWasOnTheBusIsNotItsOwn) {
  type("0123456789abcd");
  // Before our own echo has come back.
  pair.console().services.received(pair.now(), pair.console().state, fromDevice("FE", address()));
  EXPECT_EQ(packets().size(), 1u);
  EXPECT_EQ(status().strayAcks, 1u);
  pair.run(1s);
  EXPECT_EQ(packets().size(), 2u);
}

TEST_F(Pipe, DoubledAcksAreCountedAndEveryPacketGoesOnce) {
  acks([](int) { return Pair::Fate{2, 0ns}; });
  std::string content(350, 'a');
  for (std::size_t i = 0; i < content.size(); ++i) content[i] = static_cast<char>('a' + i % 26);
  send(content);
  ASSERT_TRUE(pair.runUntil([&] { return status().fileEnd != FileEnd::None; }, 60s));
  pair.run(1s);
  EXPECT_EQ(sentText(), content);
  EXPECT_EQ(status().resent, 0u);
}

TEST_F(Pipe, PauseHoldsAfterThePacketInFlightAndCancelEndsTheFile) {
  acks([](int) { return Pair::Fate{1, 50ms}; });
  send(std::string(200, 'x'));
  pair.run(120ms);
  act(What::Pause);
  pair.run(1s);
  const std::size_t paused = packets().size();
  EXPECT_EQ(status().progress, Progress::Paused);
  pair.run(3s);
  EXPECT_EQ(packets().size(), paused);
  act(What::Resume);
  pair.run(200ms);
  EXPECT_GT(packets().size(), paused);
  EXPECT_GE(status().filePaused, 3s);
  act(What::Cancel);
  pair.run(1s);
  const std::size_t cancelled = packets().size();
  EXPECT_EQ(status().fileEnd, FileEnd::Cancelled);
  EXPECT_EQ(status().progress, Progress::Idle);
  pair.run(3s);
  EXPECT_EQ(packets().size(), cancelled);
}

TEST_F(Pipe, APauseEndsWithItsFile) {
  acks([](int) { return Pair::Fate{1, 50ms}; });
  send("0123456");
  act(What::Pause);
  pair.run(1s);
  EXPECT_EQ(status().fileEnd, FileEnd::Done);
  send(std::string(200, 'x'));
  pair.run(100ms);
  act(What::Pause);
  act(What::Cancel);
  const Instant before = pair.now();
  type("on");
  pair.run(2s);
  EXPECT_EQ(sentText(before), "on");
}

TEST_F(Pipe, ADeviceThatIsElsewhereByThenStopsIt) {
  acks([](int) { return Pair::Fate{0, 0ns}; });
  type("0123456789");
  const std::uint8_t old = address();
  pair.inject(frame(old == 0x80 ? "18EEFF80" : "18EEFF81", "0100000000000000"));  // its address is taken
  pair.run(3s);
  EXPECT_EQ(status().progress, Progress::Stalled);
  EXPECT_EQ(status().stall, Stall::Moved);
  EXPECT_EQ(packets().size(), 1u);
  ASSERT_NE(address(), old);
  const Instant before = pair.now();
  pair.wire = [](const Frame&) { return Pair::Fate{}; };
  act(What::Resend);
  pair.run(3s);
  EXPECT_EQ(sentText(before), "0123456789");
  EXPECT_EQ(pair.sent(kPipe, &pair.console(), before)[0].id().destination, Address{address()});
}

// What looks like the ack and is not: the next packet waits, and in the end the person is asked.
struct HostileAck {
  const char* name;
  void (*spoil)(Frame& ack, std::uint8_t monitor);
};
void setId(Frame& f, Address from, Address to) { f.id = J1939Id{6, pgn::kProprietaryA, from, to}.frameId(); }
constexpr Address kUs{0xF9};
constexpr HostileAck kHostileAcks[] = {
    {"OfNoLength", [](Frame& f, std::uint8_t) { f.length = 0; }},
    {"OfAnotherType", [](Frame& f, std::uint8_t) { f.data[0] = 0xFD; }},
    {"OfAnotherDevice",
     [](Frame& f, std::uint8_t m) { setId(f, {m == 0x81 ? std::uint8_t{0x80} : std::uint8_t{0x81}}, kUs); }},
    {"OfNobodyKnown", [](Frame& f, std::uint8_t) { setId(f, {0xB7}, kUs); }},
    {"OfTheNullAddress", [](Frame& f, std::uint8_t) { setId(f, kNullAddress, kUs); }},
    {"OfOurselves", [](Frame& f, std::uint8_t) { setId(f, kUs, kUs); }},
    {"ToAnother", [](Frame& f, std::uint8_t m) { setId(f, {m}, {0xFA}); }},
    {"ToEveryone", [](Frame& f, std::uint8_t m) { setId(f, {m}, kGlobalAddress); }},
    {"Remote", [](Frame& f, std::uint8_t) { f.id |= kRemoteBit; }},
    {"AnErrorFrame", [](Frame& f, std::uint8_t) { f.id |= kErrorBit; }},
    {"OfElevenBits", [](Frame& f, std::uint8_t) { f.id &= 0x7FF; }},
};

struct NoAck : Pipe, ::testing::WithParamInterface<HostileAck> {};

TEST_P(NoAck, LetsNothingPassAndStopsInTime) {
  acks([](int) { return Pair::Fate{0, 0ns}; });
  type("0123456789");
  pair.run(2 * Pair::kFlight);
  Frame ack = fromDevice("FE", address());
  GetParam().spoil(ack, address());
  pair.wire = [](const Frame& f) { return Pair::Fate{isAck(f) && isOfDevice(f) ? 0 : 1, 0ns}; };
  pair.console().state.apply(ack, pair.now());
  pair.console().services.received(pair.now(), pair.console().state, ack);
  pair.run(900ms);
  EXPECT_EQ(packets().size(), 1u);
  EXPECT_EQ(status().progress, Progress::Sending);
  pair.run(1s);
  EXPECT_EQ(packets().size(), 1u);
  EXPECT_EQ(status().stall, Stall::NoAck);
  EXPECT_EQ(status().sent, 0u);
}

INSTANTIATE_TEST_SUITE_P(Pipe, NoAck, ::testing::ValuesIn(kHostileAcks),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_F(Pipe, AnAckTwiceOrTooManyNeverLetsAPacketPassThatIsNotOnTheBus) {
  acks([](int) { return Pair::Fate{0, 0ns}; });
  type("0123456789abcdefghijk");
  pair.run(2 * Pair::kFlight);
  for (int i = 0; i < 5; ++i) {
    const Frame ack = fromDevice("FE", address());
    pair.console().services.received(pair.now(), pair.console().state, ack);
  }
  pair.run(Pair::kFlight / 2);
  EXPECT_EQ(packets().size(), 2u);
  EXPECT_EQ(status().strayAcks, 4u);
}

// A device that moved where nobody heard it say its PIN: known at 90, and an Akron address at 91.
struct Moved : Pipe {
  Moved() {
    pair.inject(frame("18EEFF90", "4523C12800420090"));
    pair.inject(frame("18EFFF90", kAnnouncement));
    pair.run(1s);
    pair.inject(frame("18EEFF91", "4623C12800420090"));
    pair.inject(frame("18EFFF91", "011D940371000041"));
    pair.run(1s);
  }
  static constexpr std::string_view kAnnouncement = "FF83150206021A0C";
  const DeviceKey byPin = DeviceKey::of(*Pin::parse("1032AE100801036"));
  const DeviceKey byAddress = DeviceKey::at(Channel{}, Address{0x91});

  // They are devices of the test's own: what is silent is sent nothing.
  void speak() {
    for (const char* status : {"18EFFF90", "18EFFF91"}) pair.inject(frame(status, "85"));
    pair.run(Pair::kFlight);
  }
  Refusal typeTo(const DeviceKey& key, std::string text) {
    speak();
    return pair.intend(intent::PipeWrite{key, std::move(text)});
  }
  Refusal sendTo(const DeviceKey& key, std::size_t size) {
    speak();
    return pair.intend(intent::PipeFile{key, "f", std::make_shared<const std::string>(size, 'f')});
  }
  PipeStatus of(const DeviceKey& key) { return pair.console().pipe(pair.now(), key); }
  void announce() {
    pair.inject(frame("18EFFF91", kAnnouncement));
    pair.run(2 * Pair::kFlight);
  }
  void ack(std::uint8_t from) {
    pair.inject(fromDevice("FE", from));
    pair.run(2 * Pair::kFlight);
  }
  std::ptrdiff_t pipes() {
    return std::ranges::count_if(
        pair.console().status(pair.now()).devices, [&](const DeviceServices& device) {
          return device.pipe && (device.device == byPin || device.device == byAddress);
        });
  }
};

TEST_F(Moved, WhatGoesToTheAddressGoesOnAsTheDevicesPipe) {
  typeTo(byPin, "A");
  pair.run(Pair::kFlight);
  ack(0x90);
  ASSERT_EQ(of(byPin).sent, 1u);
  ASSERT_EQ(sendTo(byAddress, 14), Refusal::None);
  pair.run(Pair::kFlight);
  announce();
  EXPECT_EQ(pipes(), 1);
  EXPECT_EQ(of(byPin).progress, Progress::Sending);
  EXPECT_EQ(typeTo(byPin, "x"), Refusal::Busy) << "the file is its own now";
  ack(0x91);
  ack(0x91);
  EXPECT_EQ(of(byPin).fileEnd, FileEnd::Done);
  EXPECT_EQ(of(byPin).sent, 15u);
}

TEST_F(Moved, WhatGoesToTheDeviceGoesOnBesideAnIdlePipeToItsAddress) {
  typeTo(byAddress, "A");
  pair.run(Pair::kFlight);
  ack(0x91);
  ASSERT_EQ(sendTo(byPin, 14), Refusal::None);
  pair.run(Pair::kFlight);
  announce();
  EXPECT_EQ(pipes(), 1);
  EXPECT_EQ(of(byPin).sent, 1u);
  EXPECT_EQ(of(byPin).fileEnd, FileEnd::None);
}

TEST_F(Moved, TwoThatBothHaveAPacketInFlightEndAndNoAckIsTakenForTheOthers) {
  typeTo(byPin, "0123456789");
  sendTo(byAddress, 140);
  pair.run(Pair::kFlight);
  announce();
  EXPECT_EQ(pipes(), 1);
  EXPECT_EQ(of(byPin).progress, Progress::Settling);
  const Instant joined = pair.now();
  typeTo(byPin, "new");
  ack(0x91);
  pair.run(500ms);
  EXPECT_TRUE(packets(joined).empty()) << "an ack in doubt may still come";
  pair.run(1s);
  EXPECT_EQ(packets(joined), (std::vector<std::string>{"new"}));
  EXPECT_EQ(events(), (std::vector{PipeEvent::FileBegan, PipeEvent::FileAborted, PipeEvent::Dropped}));
}

TEST_F(Pipe, NothingGoesToADeviceThatIsSilentForASecond) {
  acks([](int) { return Pair::Fate{0, 0ns}; });
  type("0123456789");
  pair.run(2s);
  ASSERT_EQ(status().progress, Progress::Stalled);
  pair.wire = [](const Frame&) { return Pair::Fate{0, 0ns}; };  // it is not heard any more
  pair.run(1s + 200ms);
  EXPECT_EQ(type("x"), Refusal::NotHeard);
  EXPECT_EQ(send("x"), Refusal::NotHeard);
  EXPECT_EQ(act(What::Resend), Refusal::NotHeard);
  EXPECT_EQ(packets().size(), 1u);
  EXPECT_EQ(act(What::Abort), Refusal::None);
}

TEST_F(Pipe, ThePacketsAfterTheFirstGoOnlyToADeviceThatIsHeardToo) {
  act(What::Pause);
  type("0123456");
  act(What::Pause);
  type("789");
  pair.run(100ms);
  pair.wire = [](const Frame& f) { return Pair::Fate{isOfDevice(f) ? 0 : 1, 0ns}; };  // it falls silent
  pair.run(2s);
  const std::size_t before = packets().size();
  act(What::Resume);
  EXPECT_EQ(status().progress, Progress::Stalled);
  EXPECT_EQ(status().stall, Stall::NotSent);
  EXPECT_EQ(status().refusal, Refusal::NotHeard);
  EXPECT_EQ(packets().size(), before);
  pair.run(5s);
  EXPECT_EQ(status().stall, Stall::NotSent) << "it never becomes an ack that did not come";
  EXPECT_EQ(act(What::Resend), Refusal::NotHeard);
  pair.wire = [](const Frame&) { return Pair::Fate{}; };
  pair.run(1s);
  EXPECT_EQ(act(What::Resend), Refusal::None);
  pair.run(1s);
  EXPECT_EQ(status().progress, Progress::Idle);
  EXPECT_EQ(sentText(), "0123456789");
  EXPECT_EQ(status().resent, 0u) << "it went for the first time";
}

TEST_F(Pipe, NothingGoesToAnAddressWhoseAcksWouldNotCount) {
  const auto write = [&](std::uint8_t address) {
    return pair.intend(intent::PipeWrite{DeviceKey::at(Channel{}, Address{address}), "A?"});
  };
  pair.inject(frame("18EFFF90", "83C051"));
  pair.run(2 * Pair::kFlight);
  EXPECT_EQ(write(0x90), Refusal::NotTaken) << "presumed to be Akron's by its message alone";
  State& state = pair.console().state;
  state.apply(Note{.time = pair.now(), .value = note::LinkDown{}});
  pair.run(1ms);
  state.apply(Note{.time = pair.now(), .value = note::LinkUp{}});
  pair.run(300ms);
  EXPECT_EQ(write(address()), Refusal::NoDevice);
  const Address was = state.channel(Channel{}).book.formerAddress(monitor.pin);
  EXPECT_EQ(write(was.value), Refusal::FormerPin);
  EXPECT_TRUE(packets().empty());
}

TEST_F(Pipe, WhatWentToAnAddressBeforeAGapIsNotItsNextDevices) {
  pair.inject(frame("18EEFF90", "0B1AC22800420090"));
  pair.inject(frame("18EFFF90", "83C051"));
  pair.run(2 * Pair::kFlight);
  const DeviceKey byAddress = DeviceKey::at(Channel{}, Address{0x90});
  ASSERT_EQ(pair.intend(intent::PipeWrite{byAddress, "A?"}), Refusal::None);
  pair.run(Pair::kFlight);
  pair.inject(fromDevice("FE", 0x90));
  pair.run(2 * Pair::kFlight);
  ASSERT_EQ(pair.console().pipe(pair.now(), byAddress).sent, 2u);
  Console& console = pair.console();
  console.state.apply(Note{.time = pair.now(), .value = note::LinkDown{}});
  pair.setLink(console, false);
  pair.run(3s);
  console.state.apply(Note{.time = pair.now(), .value = note::LinkUp{}});
  pair.setLink(console, true);
  pair.unlock();
  pair.inject(frame("18EFFF90", "FF83150206021A0C"));
  pair.run(2 * Pair::kFlight);
  const DeviceKey next = DeviceKey::of(*Pin::parse("1032AE100801036"));
  pair.intend(intent::PipeWrite{next, "B"});
  pair.run(Pair::kFlight);
  pair.inject(fromDevice("FE", 0x90));
  pair.run(2 * Pair::kFlight);
  EXPECT_EQ(console.pipe(pair.now(), next).sent, 1u);
}

TEST_F(Pipe, OthersFramesThatLookTheSameAreNotAnswered) {
  const Instant before = pair.now();
  pair.inject(frame("18EEFFA0", "1234560000000000"));  // another maker's NAME
  pair.inject(frame("18EFF9A0", "FE41424344454647"));
  pair.inject(frame("18EFF9B7", "FE41424344454647"));  // nobody knows who that is
  pair.inject(frame("18EF8081", "FE4142"));            // not to us
  pair.run(100ms);
  EXPECT_TRUE(pair.sent(kPipe, &pair.console(), before).empty());
}

TEST_F(Pipe, LockingDropsWhatWaits) {
  send(std::string(5000, 'x'));
  pair.run(100ms);
  pair.intend(intent::Lock{});
  const Instant before = pair.now();
  EXPECT_EQ(status().fileEnd, FileEnd::Aborted);
  pair.run(5s);
  EXPECT_TRUE(pair.sentBy(&pair.console(), before).empty());
}

TEST_F(Pipe, MoreThanMayWaitIsRefusedWhole) {
  EXPECT_EQ(type(std::string(deckpipe::Pipe::kMaxTyped + 1, 'x')), Refusal::TooMuch);
  EXPECT_TRUE(packets().empty());
  EXPECT_EQ(pair.intend(intent::PipeWrite{DeviceKey::of(*Pin::parse("1032AE000000001")), "x"}),
            Refusal::NoDevice);
}

TEST_F(Pipe, BeginAndEndOfAFileAndWhatThePersonDecidedAreNotes) {
  acks([](int n) { return Pair::Fate{n == 0 ? 0 : 1, 0ns}; });
  send("0123456789");
  pair.run(2s);
  act(What::Resend);
  pair.run(5s);
  EXPECT_EQ(events(),
            (std::vector{PipeEvent::FileBegan, PipeEvent::Stalled, PipeEvent::Resent, PipeEvent::FileDone}));
}

}  // namespace
}  // namespace deckpipe::test
