// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/stranger_watch.h"

#include <gtest/gtest.h>

#include "service/claim_service.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

using test::frame;
using Kind = Stranger::Kind;

LinkSettings link(const char* plugin, const char* name) {
  return {QString::fromLatin1(plugin), QString::fromLatin1(name), 250'000, {}};
}

CanInterface kernelSays(const char* kind, bool isCan = true) {
  CanInterface facts;
  facts.kind = kind;
  facts.isCan = isCan;
  return facts;
}

TEST(Rule20SimulatedBus, IsVirtualcanOrAVcanByTheWordOfTheDriverAndNotByTheName) {
  EXPECT_TRUE(isSimulatedBus(link("virtualcan", "can0"), kernelSays("can")));
  EXPECT_TRUE(isSimulatedBus(link("socketcan", "can0"), kernelSays("vcan")));
  EXPECT_FALSE(isSimulatedBus(link("socketcan", "vcan0"), kernelSays("can")))
      << "an adapter that was renamed";
  EXPECT_FALSE(isSimulatedBus(link("socketcan", "vcan0"), kernelSays("vxcan")));
  EXPECT_FALSE(isSimulatedBus(link("socketcan", "vcan0"), kernelSays("vcan", false)));
  EXPECT_FALSE(isSimulatedBus(link("socketcan", "vcan0"), kernelSays(""))) << "a driver that names none";
  EXPECT_FALSE(isSimulatedBus(link("peakcan", "usb0"), kernelSays("vcan")));
  EXPECT_FALSE(isSimulatedBus(link("socketcan", "vcan0"), std::nullopt)) << "the kernel is silent";
}

// A program that sends from 33 and 80 hex has listened on a bus.
struct Rule20Listening : ::testing::Test {
  void hear(const Frame& f) { watch.received(f, now = now + 20ms); }
  void hear(const char* identifier, const char* data) { hear(frame(identifier, data)); }
  void hearName(std::uint8_t address, Name name) {
    Frame f;
    f.id = J1939Id{6, pgn::kAddressClaimed, Address{address}, kGlobalAddress}.frameId();
    f.length = 8;
    f.data = std::bit_cast<Payload>(name.value);
    hear(f);
  }
  Stranger only() const {
    const auto found = watch.strangers();
    EXPECT_EQ(found.size(), 1u);
    return found.empty() ? Stranger{} : found.front();
  }

  StrangerWatch watch{{Address{0x33}, Address{0x80}}};
  Instant now;
};

TEST_F(Rule20Listening, ASilentBusHasNone) { EXPECT_TRUE(watch.strangers().empty()); }

TEST_F(Rule20Listening, FindsAnAkronDeviceByItsNameItsAnnouncementOrItsStatus) {
  hearName(0x90, {0x80'00'00'00'28'C0'00'05});
  EXPECT_EQ(only(), (Stranger{.kind = Kind::Akron, .address = Address{0x90}}));
  watch = StrangerWatch({});
  hear("18EFFF91", "FF83150206021A0B");
  EXPECT_EQ(only().kind, Kind::Akron);
  EXPECT_EQ(only().address, Address{0x91});
  EXPECT_FALSE(only().pin.isNull());
  watch = StrangerWatch({});
  hear("18EFFF92", "011D940371000041");  // it never says who it is
  EXPECT_EQ(only(), (Stranger{.kind = Kind::Akron, .address = Address{0x92}}));
}

TEST_F(Rule20Listening, FindsAJoystickWhateverItsAddressAndLength) {
  for (const char* identifier : {"0CFDD633", "0CFDD638", "0CFDD742", "0CFDD6F9", "0CFDD6FE"}) {
    watch = StrangerWatch({});
    hear(identifier, "0100010000000000");
    EXPECT_EQ(only().kind, Kind::Joystick) << identifier;
    EXPECT_EQ(only().address, J1939Id::of(frame(identifier, "").identifier()).source);
  }
  watch = StrangerWatch({});
  hear("0CFDD634", "0100");
  EXPECT_EQ(only().kind, Kind::Joystick);
}

TEST_F(Rule20Listening, FindsWhoeverSendsFromAnAddressOfItsOwn) {
  hear("18FECA80", "0000000000000000");
  EXPECT_EQ(only(), (Stranger{.kind = Kind::OwnAddress, .address = Address{0x80}}));
}

TEST_F(Rule20Listening, FindsAGatewaysNodeButNotAnyCanopenDevice) {
  hear("705", "05");  // a heartbeat
  EXPECT_TRUE(watch.strangers().empty());
  hear("185", "011D940371000041");
  EXPECT_EQ(only(), (Stranger{.kind = Kind::Akron, .node = {5}}));
}

TEST_F(Rule20Listening, AnotherConsoleIsNoneWhateverItAsks) {
  hearName(0xF9, consoleName(77));
  hear("18EF90F9", "02");      // a poll
  hear("18EF90F9", "FE41");    // the pipe
  hear("18EAFFF9", "00EE00");  // who is there
  EXPECT_TRUE(watch.strangers().empty());
  hearName(0x80, consoleName(78));
  EXPECT_TRUE(watch.strangers().empty()) << "nor at an address of its own";
  hear("0CFDD6F9", "0100010000000000");
  EXPECT_EQ(only().kind, Kind::Joystick) << "unless it moves monitors";
}

TEST_F(Rule20Listening, OtherMakersElsewhereAreNone) {
  hearName(0x00, {0x1234});
  hear("0CF00400", "FFFFFF0000FFFFFF");
  EXPECT_TRUE(watch.strangers().empty());
}

TEST_F(Rule20Listening, WhatItSentItselfIsNone) {
  Frame own = frame("0CFDD633", "0100010000000000");
  own.flags = Frame::kSent | Frame::kConfirmed;
  hear(own);
  EXPECT_TRUE(watch.strangers().empty());
}

}  // namespace
}  // namespace deckpipe
