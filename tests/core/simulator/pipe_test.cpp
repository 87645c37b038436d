// SPDX-License-Identifier: GPL-3.0-or-later
// The devices' end of the data pipe: the shell, packets and acknowledgements, files, and what goes wrong.
#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

#include "terminal.h"

namespace deckpipe::simulator::test {
namespace {

constexpr const char* kBanner = "6032 Universal II 1032AE100801035 v2.6\r\n";

std::string crcText(std::string_view bytes) {
  const uLong crc = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
  char hex[9];
  std::snprintf(hex, sizeof hex, "%08lX", crc);
  return hex;
}
std::string randomBytes(std::size_t count, unsigned seed) {
  std::mt19937 engine(seed);
  std::string bytes(count, '\0');
  for (char& c : bytes) c = static_cast<char>(engine());
  return bytes;
}

class Pipe : public ::testing::Test {
 protected:
  MonitorRig rig;
  Terminal terminal{rig, rig.monitor};
};

TEST_F(Pipe, AcknowledgesEachPacketAndAnswersWhenTheLineEnds) {
  terminal.type("A?");
  terminal.run(100ms);
  EXPECT_EQ(terminal.acks, 1u);
  EXPECT_EQ(terminal.packets, 0u) << "the line has not ended";
  terminal.type("\r\n");
  terminal.run(1s);
  EXPECT_EQ(terminal.text, kBanner);
  EXPECT_EQ(terminal.acks, 2u);
}

TEST_F(Pipe, TakesCrLfAndBothAsLineEnds) {
  for (const char* line : {"A?\r", "A?\n", "A?\r\n", "a?\r\n", "  A?  \r\n", "\r\n\n\rA?\r"})
    EXPECT_EQ(terminal.request(line), kBanner) << ::testing::PrintToString(line);
}

TEST_F(Pipe, AnswersEachCommand) {
  struct Row {
    const char* line;
    const char* answer;
  };
  const Row rows[] = {
      {"VER\r",
       "FIXED BOOT 1.11\r\nBOOTLOADER 2.4\r\nSYSTEM 2.6\r\nPCODE 3356.14 2.4\r\nCONFIG 60320014 2.4\r\n"},
      {"ECHO some  text\r", "some  text\r\n"},
      {"ECHO\r", "\r\n"},
      {"SEND 0\r", "SENT 0 CRC32 00000000\r\n"},
      {"FILE 0\r", "READY 0\r\nOK 0 CRC32 00000000\r\n"},
      {"FILE\r", "ERROR a number up to 16777216\r\n"},
      {"FILE -1\r", "ERROR a number up to 16777216\r\n"},
      {"SEND 99999999\r", "ERROR a number up to 16777216\r\n"},
      {"dance\r", "ERROR unknown command, ? lists them\r\n"},
  };
  for (const Row& row : rows) EXPECT_EQ(terminal.request(row.line), row.answer) << row.line;
  for (const char* help : {"?\r", "help\r"})
    EXPECT_EQ(terminal.request(help, 2s), std::string(PipeShell::kHelp)) << help;
}

TEST_F(Pipe, StatusSaysWhatTheMonitorIsDoing) {
  rig.monitor.misbehave({.rotationSensorError = true, .faultBits = faultBit("internal_fuse")});
  const std::string text = terminal.request("STAT\r", 2s);
  for (const char* line : {"ADDRESS 80\r\n", "FAULTS 00200000\r\n", "ERROR CODE 11\r\n",
                           "PIPE IN 1 OUT 0\r\n", "ROTATION 0.0\r\n", "ENABLED\r\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << " in " << text;
}

TEST_F(Pipe, EchoesCharactersOnRequest) {
  EXPECT_EQ(terminal.request("ECHO ON\r"), "OK\r\n");
  EXPECT_EQ(terminal.request("A?\r\n"), std::string("A?\r\n") + kBanner);
  EXPECT_EQ(terminal.request("echo off\r"), "echo off\r\nOK\r\n");
  EXPECT_EQ(terminal.request("A?\r"), kBanner);
}

TEST_F(Pipe, ALineThatIsTooLongIsAnErrorAndTheNextIsNot) {
  EXPECT_EQ(terminal.request(std::string(2000, 'a') + "\r", 3s), "ERROR line too long\r\n");
  EXPECT_EQ(terminal.request("A?\r"), kBanner);
}

TEST_F(Pipe, EveryAkronDeviceHasOne) {
  Rig bus;
  bus.simulator = standardSimulator(1).simulator;
  bus.simulator.powerOn(bus.now());
  bus.run(4s);
  const char* banners[] = {kBanner, "6033 Mini Universal 1033AE100802117 v2.6\r\n",
                           "6039 CAN I/O Module v2.6\r\n", "6035 Joystick 1035AE100804442 v2.6\r\n"};
  std::vector<Terminal> terminals;
  for (std::size_t i = 0; i < bus.simulator.size(); ++i) terminals.emplace_back(bus, bus.simulator.device(i));
  for (std::size_t i = 0; i < terminals.size(); ++i) EXPECT_EQ(terminals[i].request("A?\r"), banners[i]);
}

TEST(PipesOfOneBus, RunAtTheSameTime) {
  Rig bus;
  StandardSimulator standard = standardSimulator(1);
  standard.joystick->release();
  bus.simulator = std::move(standard.simulator);
  bus.simulator.powerOn(bus.now());
  bus.run(4s);
  std::vector<Terminal> terminals;
  for (std::size_t i = 0; i < bus.simulator.size(); ++i) {
    terminals.emplace_back(bus, bus.simulator.device(i));
    terminals.back().type("SEND 700\r");
  }
  for (int i = 0; i < 3000; ++i) {
    for (Terminal& terminal : terminals) terminal.step();
    bus.run(1ms);
  }
  for (const Terminal& terminal : terminals)
    EXPECT_EQ(terminal.text.substr(700), "SENT 700 CRC32 " + crcText(terminal.text.substr(0, 700)) + "\r\n");
}

TEST_F(Pipe, OnePeerAtATime) {
  Terminal other(rig, rig.monitor, 0xF8);
  terminal.type("ECHO ha");
  terminal.run(100ms);
  other.type("A?\r");
  other.run(5s);
  EXPECT_EQ(other.acks, 0u) << "in the middle of the first one's line";
  EXPECT_EQ(terminal.request("lf\r"), "half\r\n");
  other.packet("A?\r");
  other.run(1s);
  EXPECT_EQ(other.text, kBanner);
}

TEST_F(Pipe, APeerThatFellSilentGivesItUp) {
  Terminal other(rig, rig.monitor, 0xF8);
  terminal.type("ECHO ha");
  terminal.run(100ms);
  rig.run(PipeEnd::kPeerSilence);
  EXPECT_EQ(other.request("A?\r"), kBanner);
}

TEST_F(Pipe, WaitsForEachAcknowledgementThenGivesUpAndSaysSoLater) {
  terminal.acknowledges = false;
  terminal.type("A?\r");
  terminal.run(5s);
  EXPECT_EQ(terminal.text, "6032 Un");
  terminal.acknowledges = true;
  EXPECT_EQ(terminal.request("A?\r"), std::string("LOST 40 characters of the answers before\r\n") + kBanner);
  EXPECT_EQ(terminal.request("A?\r"), kBanner) << "once";
}

TEST_F(Pipe, SendPrintsSoManyBytesWithTheirCrc) {
  const std::string text = terminal.request("SEND 1000\r", 3s);
  ASSERT_GT(text.size(), 1000u);
  EXPECT_EQ(text.substr(1000), "SENT 1000 CRC32 " + crcText(text.substr(0, 1000)) + "\r\n");
}

TEST_F(Pipe, CtrlCEndsSend) {
  terminal.type("SEND 1000000\r");
  terminal.run(1s);
  terminal.packet("\x03");
  terminal.run(100ms);
  EXPECT_EQ(terminal.request("A?\r"), kBanner);
}

TEST_F(Pipe, AFileIsTakenByteForByteAndItsCrcSaid) {
  for (const std::size_t size :
       {std::size_t{1}, std::size_t{6}, std::size_t{7}, std::size_t{8}, std::size_t{5000}}) {
    const std::string file = randomBytes(size, static_cast<unsigned>(size));
    const std::string bytes = std::to_string(size);
    EXPECT_EQ(terminal.request("FILE " + bytes + "\r\n"), "READY " + bytes + "\r\n");
    EXPECT_EQ(terminal.request(file, 1s + size * 2ms), "OK " + bytes + " CRC32 " + crcText(file) + "\r\n");
    EXPECT_EQ(terminal.request("A?\r"), kBanner);
  }
}

TEST_F(Pipe, AFileMayFollowItsCommandAtOnceAndMayBeginWithALineFeed) {
  const std::string file = "\n\r\n\x03x";
  EXPECT_EQ(terminal.request("FILE 5\r\n" + file), "READY 5\r\nOK 5 CRC32 " + crcText(file) + "\r\n");
  EXPECT_EQ(terminal.request("FILE 5\r"), "READY 5\r\n");
  EXPECT_EQ(terminal.request(file), "OK 5 CRC32 " + crcText(file) + "\r\n");
  EXPECT_EQ(terminal.request("FILE 5\n" + file), "READY 5\r\nOK 5 CRC32 " + crcText(file) + "\r\n");
}

TEST_F(Pipe, BothDirectionsInterleave) {
  const std::string file = randomBytes(2000, 7);
  terminal.type("SEND 4000\rFILE 2000\r" + file);
  terminal.run(1s);
  EXPECT_GT(terminal.sent, 100u);
  EXPECT_GT(terminal.packets, 100u);
  terminal.run(10s);
  EXPECT_EQ(terminal.text.substr(4000), "SENT 4000 CRC32 " + crcText(terminal.text.substr(0, 4000)) +
                                            "\r\nREADY 2000\r\nOK 2000 CRC32 " + crcText(file) + "\r\n");
}

TEST_F(Pipe, AFileThatStopsComingIsGivenUp) {
  EXPECT_EQ(terminal.request("FILE 100\rabc", 11s), "READY 100\r\nERROR 3 of 100 bytes came\r\n");
  EXPECT_EQ(terminal.request("A?\r"), kBanner);
}

TEST_F(Pipe, WhatWaitsToGoOutIsBounded) {
  terminal.acknowledges = false;
  for (int i = 0; i < 100; ++i) {
    terminal.packet("HELP\r");
    rig.run(5ms);
  }
  terminal.run(2s);
  terminal.text.clear();
  terminal.acknowledges = true;
  terminal.type("A?\r");
  terminal.run(2s);
  EXPECT_EQ(terminal.text.substr(0, 5), "LOST ");
  EXPECT_GT(std::stoul(terminal.text.substr(5)), 99 * PipeShell::kHelp.size());
}

TEST_F(Pipe, LostAcksAreTheNthOrEveryNth) {
  struct Row {
    const char* name;
    Losses losses;
    std::vector<int> lost;
  };
  const Row rows[] = {{"every third", {1, 3}, {3, 6, 9}},
                      {"the third", {1, 3, true}, {3}},
                      {"two of four", {2, 4}, {3, 4, 7, 8}},
                      {"all", {1, 1}, {1, 2, 3, 4, 5, 6, 7, 8, 9}}};
  for (const Row& row : rows) {
    rig.monitor.misbehave({});
    rig.monitor.misbehave({.pipe = {.acksLost = row.losses}});
    std::vector<int> lost;
    for (int i = 1; i <= 9; ++i) {
      const unsigned before = terminal.acks;
      terminal.packet("x");
      terminal.run(10ms);
      if (terminal.acks == before) lost.push_back(i);
    }
    EXPECT_EQ(lost, row.lost) << row.name;
  }
  rig.monitor.misbehave({});
  EXPECT_EQ(terminal.request("\r"), "ERROR unknown command, ? lists them\r\n")
      << "they were taken all the same";
}

TEST_F(Pipe, SlowAcksHoldUpNothingElse) {
  rig.monitor.misbehave({.pipe = {.ackLate = 400ms}});
  const Instant from = rig.now();
  terminal.packet("ECHO x\r");
  terminal.run(395ms);
  EXPECT_EQ(terminal.acks, 0u);
  EXPECT_EQ(terminal.text, "x\r\n");
  EXPECT_GE(rig.all(MessageId::PositionLimitStatus, from).size(), 3u);
  terminal.run(10ms);
  EXPECT_EQ(terminal.acks, 1u);
}

TEST_F(Pipe, AcksCanComeTwice) {
  rig.monitor.misbehave({.pipe = {.ackTwice = true}});
  terminal.packet("A");
  terminal.run(10ms);
  EXPECT_EQ(terminal.acks, 2u);
}

TEST_F(Pipe, ALostPacketOfTheDeviceIsGivenUpAfterASecond) {
  rig.monitor.misbehave({.pipe = {.packetsLost = {1, 2}}});
  EXPECT_EQ(terminal.request("A?\r", 3s), "6032 Un");
  rig.monitor.misbehave({});
  EXPECT_EQ(terminal.request("A?\r"), std::string("LOST 33 characters of the answers before\r\n") + kBanner);
}

TEST_F(Pipe, AnUnheardPacketIsNeitherTakenNorAcknowledged) {
  rig.monitor.misbehave({.pipe = {.packetsUnheard = {1, 2}}});
  terminal.packet("ECHO a");
  terminal.packet("lost");
  terminal.packet("b\r");
  terminal.run(100ms);
  EXPECT_EQ(terminal.acks, 2u);
  EXPECT_EQ(terminal.text, "ab\r\n");
}

TEST_F(Pipe, ADeviceThatVanishesInMidTransferComesBackAndKnowsNothingOfIt) {
  rig.monitor.misbehave({.pipe = {.vanishAfter = 20, .returnAfter = 3s}});
  terminal.type("FILE 1000\r" + randomBytes(1000, 3));
  terminal.run(1s);
  EXPECT_FALSE(rig.monitor.address() != kNullAddress);
  EXPECT_TRUE(terminal.isWaiting);
  EXPECT_LE(terminal.sent, 20u);
  const Instant from = rig.now();
  rig.run(1500ms);
  for (const Seen& seen : rig.log) EXPECT_LE(seen.time, from) << "not a frame";
  rig.run(3s);
  EXPECT_EQ(rig.all(MessageId::AddressAnnouncement, from).size(), 1u);
  Terminal again(rig, rig.monitor);
  again.type("A?\r");
  again.step();
  again.text.clear();
  again.run(1s);
  EXPECT_EQ(again.text, kBanner);
}

TEST_F(Pipe, ADeviceThatLosesItsAddressDropsThePipe) {
  terminal.type("SEND 100000\r");
  terminal.run(500ms);
  rig.monitor.misbehave({.addressTaken = true});
  rig.run(100ms);
  const unsigned before = terminal.packets;
  rig.monitor.misbehave({});
  rig.run(2s);
  terminal.run(10ms);
  EXPECT_LE(terminal.packets, before + 2);
}

// Whatever goes wrong, for many seeds: one packet of the device is on its way at a time, the next one comes
// after an acknowledgement or a second later, and in the end the shell answers as ever.
TEST(PipeUnderFaults, StaysPacedAndComesBack) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937 engine(seed);
    const auto random = [&](unsigned most) { return static_cast<unsigned>(engine() % (most + 1)); };
    MonitorRig rig;
    Terminal terminal(rig, rig.monitor);
    Misbehaviour how;
    if (random(1) != 0) how.pipe.acksLost = {1, 2 + random(5)};
    if (random(1) != 0) how.pipe.packetsLost = {1, 2 + random(9)};
    if (random(1) != 0) how.pipe.packetsUnheard = {1, 2 + random(9)};
    how.pipe.ackLate = Duration(1ms) * random(300);
    how.pipe.ackTwice = random(2) == 0;
    if (random(2) == 0) how.pipe.vanishAfter = 1 + random(60);
    how.pipe.returnAfter = Duration(1ms) * (1 + random(3000));
    how.elsewhere = random(1) != 0;
    rig.monitor.misbehave(how);
    for (int step = 0; step < 20; ++step) {
      const char* lines[] = {"SEND 300\r", "FILE 50\r", "HELP\r\n", "A?\n", "\x03", "STAT\r"};
      terminal.isWaiting = false;  // goes on without the acknowledgement, as a person may
      terminal.acknowledges = random(9) != 0;
      terminal.type(lines[random(5)]);
      terminal.run(Duration(1ms) * random(400));
    }
    Instant sentAt = kNotYet;
    bool isOnItsWay = false;
    for (const Seen& seen : rig.log) {
      const bool isPipe = seen.what.isDecoded() && (seen.what.message == MessageId::PipeData ||
                                                    seen.what.message == MessageId::PipeAck);
      if (seen.what.isDecoded() && seen.what.message == MessageId::Name) isOnItsWay = false;
      if (!isPipe) continue;
      if (seen.what.message == MessageId::PipeAck && seen.source() == Address{0xF9}) isOnItsWay = false;
      if (seen.what.message != MessageId::PipeData || seen.source() == Address{0xF9}) continue;
      EXPECT_TRUE(!isOnItsWay || seen.time - sentAt >= PipeEnd::kAckTimeout) << seed;
      isOnItsWay = true;
      sentAt = seen.time;
    }
    rig.monitor.misbehave({});
    rig.run(PipeShell::kFileSilence + 5s);  // a file that was begun is given up, a lost device is back
    Terminal after(rig, rig.monitor);
    after.packet("\x03");
    after.run(100ms);
    after.request("\r", 3s);  // what was lost is said, a line that was begun ends
    EXPECT_EQ(after.request("A?\r"), std::string(rig.monitor.isPowered() ? kBanner : "")) << seed;
  }
}

}  // namespace
}  // namespace deckpipe::simulator::test
