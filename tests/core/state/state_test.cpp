// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/state.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/frames.h"

namespace deckpipe {
namespace {

using test::frame;

constexpr Channel kCan0{0};
constexpr char kPinA[] = "1032AE100801035";
constexpr char kAnnouncesA[] = "FF83150206021A0B";
constexpr char kAnnouncesB[] = "FF83150206021A0C";  // 1032AE100801036
constexpr char kNameOfA[] = "0B1AC22800420090";     // low 21 bits of A's serial
constexpr char kLowerForeignName[] = "0100200000000000";
constexpr char kHigherForeignName[] = "01002001000000FF";
constexpr char kPosition[] = "011D940371000041";

class StateOfOneChannel : public testing::Test {
 protected:
  void hear(std::string_view id, std::string_view data) { m_state.apply(frame(id, data), m_now); }
  void pass(Duration d) {
    m_now = m_now + d;
    m_state.timeCame(m_now);
  }
  const Device* device(std::string_view pin) const { return m_state.devices().byPin(*Pin::parse(pin)); }
  const Device* at(unsigned address) const {
    return m_state.devices().byAddress(kCan0, {static_cast<std::uint8_t>(address)});
  }
  const AddressBook& book() const { return m_state.channel(kCan0).book; }
  Node node(unsigned address) const {
    return m_state.channel(kCan0).nodes[{static_cast<std::uint8_t>(address)}];
  }
  ClaimState claim(unsigned address) const {
    return book().claim({static_cast<std::uint8_t>(address)}, m_state.cursor().time);
  }

  State m_state;
  Instant m_now{1'000'000'000};
};

TEST_F(StateOfOneChannel, KnowsADeviceByItsPinThroughChangesOfAddress) {
  hear("18EFFF80", kAnnouncesA);
  hear("18EFFF80", kPosition);
  pass(5s);
  hear("18EFFF81", kAnnouncesA);
  ASSERT_NE(device(kPinA), nullptr);
  EXPECT_EQ(device(kPinA)->address, Address{0x81});
  EXPECT_EQ(device(kPinA)->previousAddress(), Address{0x80});
  EXPECT_EQ(device(kPinA)->addressChanges, 1);
  EXPECT_EQ(device(kPinA)->position().value().rotation.tenths, 473);
  EXPECT_EQ(at(0x80), nullptr);
}

TEST_F(StateOfOneChannel, RemembersTheAddressesThatADeviceHadAndUntilWhen) {
  std::array<Instant, 5> moved{};
  for (unsigned i = 0; i < 5; ++i) {
    char id[9];
    std::snprintf(id, sizeof id, "18EFFF%02X", 0x80 + i);
    hear(id, kAnnouncesA);
    moved[i] = m_now;
    pass(1s);
  }
  const Device& d = *device(kPinA);
  EXPECT_EQ(d.address, Address{0x84});
  EXPECT_EQ(d.formerAddresses[0], (FormerAddress{moved[4], {0x83}}));
  EXPECT_EQ(d.formerAddresses[1], (FormerAddress{moved[3], {0x82}}));
  EXPECT_EQ(d.formerAddresses[2], (FormerAddress{moved[2], {0x81}})) << "the oldest is forgotten";
  EXPECT_EQ(d.addressChanges, 4);
}

TEST_F(StateOfOneChannel, KnowsAnAddressThatItsDeviceLeftUntilSomebodyIsHeardThere) {
  hear("18EFFF80", kAnnouncesA);
  hear("18EFFF81", kAnnouncesA);
  EXPECT_TRUE(book().wasLeft({0x80}));
  EXPECT_FALSE(book().wasLeft({0x81}));
  hear("18FF0080", "00");
  EXPECT_FALSE(book().wasLeft({0x80}));
}

// What the filter held back may have asked for them. That a node booted it says itself.
TEST_F(StateOfOneChannel, TakesNoAnnouncementOfALogSavedThroughAFilterForARestart) {
  for (const bool isFiltered : {false, true}) {
    m_state = {};
    if (isFiltered) m_state.apply(Note{.time = m_now, .value = note::Filtered{"sa=80"}});
    hear("18EEFF80", kNameOfA);
    hear("18EFFF80", kAnnouncesA);
    hear("18EFFF80", kPosition);
    hear("724", "05");
    pass(10s);
    hear("18EFFF80", kAnnouncesA);
    ASSERT_NE(device(kPinA), nullptr);
    EXPECT_EQ(device(kPinA)->restarted, isFiltered ? kNotYet : m_now);
    pass(10s);
    hear("18EEFF80", kNameOfA);
    hear("724", "00");
    EXPECT_EQ(device(kPinA)->restarted, isFiltered ? kNotYet : m_now);
    EXPECT_EQ(m_state.devices().byNode(kCan0, NodeId{0x24})->restarted, m_now);
  }
}

TEST_F(StateOfOneChannel, TakesOnePinOnTwoChannelsForTwoDevices) {
  hear("18EFFF80", kAnnouncesA);
  m_state.apply(frame("18EFFF90", kAnnouncesA, 1), m_now);
  m_state.apply(frame("18EFFF90", kPosition, 1), m_now);
  const Device* first = m_state.devices().byPin(kCan0, *Pin::parse(kPinA));
  const Device* second = m_state.devices().byPin(Channel{1}, *Pin::parse(kPinA));
  ASSERT_NE(first, nullptr);
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(first->address, Address{0x80});
  EXPECT_FALSE(first->position().isKnown());
  EXPECT_EQ(first->addressChanges, 0);
  EXPECT_EQ(second->address, Address{0x90});
  EXPECT_TRUE(second->position().isKnown());
  EXPECT_EQ(device(kPinA), first);
}

TEST_F(StateOfOneChannel, CountsFramesASecondInWholeSeconds) {
  for (int i = 0; i < 25; ++i) {
    hear("18EFFF80", kPosition);
    pass(100ms);
  }
  // Heard from 1.0 s to 3.4 s of log time.
  EXPECT_EQ(at(0x80)->rate.at(m_now, at(0x80)->lastHeard), 10u);
  EXPECT_EQ(node(0x80).rate.at(m_now, node(0x80).lastHeard), 10u);
  pass(1s);
  EXPECT_EQ(at(0x80)->rate.at(m_now, at(0x80)->lastHeard), 5u) << "five in the second that ended";
  pass(1s);
  EXPECT_EQ(at(0x80)->rate.at(m_now, at(0x80)->lastHeard), 0u);
}

TEST_F(StateOfOneChannel, GivesAnAddressToWhoAnnouncedItLast) {
  hear("18EFFF80", kAnnouncesA);
  hear("18EFFF80", kAnnouncesB);
  EXPECT_EQ(at(0x80), device("1032AE100801036"));
  EXPECT_EQ(device(kPinA)->address, kNullAddress);
  hear("18EFFF80", kPosition);
  EXPECT_FALSE(device(kPinA)->position().isKnown());
  EXPECT_TRUE(at(0x80)->position().isKnown());
}

TEST_F(StateOfOneChannel, ShowsASenderWithoutPinAndKeepsWhatItSaidOnceItIsKnown) {
  hear("18EFFF80", kPosition);
  ASSERT_NE(at(0x80), nullptr);
  EXPECT_EQ(at(0x80)->kind, Device::Kind::Address);
  hear("18EFFF80", kAnnouncesA);
  EXPECT_EQ(at(0x80), device(kPinA));
  EXPECT_TRUE(at(0x80)->position().isKnown());
}

TEST_F(StateOfOneChannel, TakesTheAddressFromADeviceWhoseNameItCannotBe) {
  hear("18EFFF80", kAnnouncesA);
  hear("18EEFF80", kNameOfA);
  EXPECT_EQ(device(kPinA)->address, Address{0x80});
  hear("18EEFF80", kLowerForeignName);
  EXPECT_EQ(device(kPinA)->address, kNullAddress);
  EXPECT_EQ(device(kPinA)->previousAddress(), Address{0x80});
}

TEST_F(StateOfOneChannel, TakesTheAddressFromADeviceThatCannotClaim) {
  hear("18EEFF80", kNameOfA);
  hear("18EFFF80", kAnnouncesA);
  hear("18EEFFFE", kNameOfA);
  EXPECT_EQ(device(kPinA)->address, kNullAddress);
  EXPECT_EQ(claim(0x80), ClaimState::CannotClaim);
}

TEST_F(StateOfOneChannel, DoesNotGiveANewPinWhatAnotherDeviceSaidAtItsAddress) {
  hear("18EEFF80", kNameOfA);
  hear("18EFFF80", kPosition);
  hear("18EEFF80", kLowerForeignName);
  pass(kClaimTime);
  hear("18EFFF80", kAnnouncesB);
  EXPECT_TRUE(at(0x80) == nullptr || !at(0x80)->position().isKnown());
}

TEST_F(StateOfOneChannel, EndsAtTheLastInstantThereIs) {
  m_now = {std::numeric_limits<std::int64_t>::max() - 1};
  hear("18EFFF80", kPosition);
  hear("0CFDD633", "107D046400100000");
  pass(1ns);
  hear("18EFFF80", kPosition);
  EXPECT_EQ(m_state.cursor().time, kNever);
  EXPECT_FALSE(at(0x80)->isStale(MessageId::PositionLimitStatus));
}

TEST_F(StateOfOneChannel, MakesNoDeviceOfWhatOnlyLooksLikeCanopen) {
  hear("5A4", "41");
  hear("736", "0102030405060708");
  EXPECT_EQ(m_state.devices().byNode(kCan0, {0x24}), nullptr);
  EXPECT_EQ(m_state.devices().byNode(kCan0, {0x36}), nullptr);
}

TEST_F(StateOfOneChannel, CallsAPeriodicValueStaleAfterThreePeriodsAndNotBefore) {
  hear("18EFFF80", kPosition);
  pass(300ms - 1ns);
  EXPECT_FALSE(at(0x80)->isStale(MessageId::PositionLimitStatus));
  pass(1ns);
  EXPECT_TRUE(at(0x80)->isStale(MessageId::PositionLimitStatus));
  hear("18EFFF80", kPosition);
  EXPECT_FALSE(at(0x80)->isStale(MessageId::PositionLimitStatus));
}

TEST_F(StateOfOneChannel, TakesTheAddressFromADeviceThatDoesNotAnswerAContest) {
  hear("18EEFF80", kNameOfA);
  hear("18EFFF80", kAnnouncesA);
  pass(1s);
  hear("18EEFF80", kHigherForeignName);
  EXPECT_EQ(claim(0x80), ClaimState::Contested);
  pass(250ms - 1ns);
  EXPECT_EQ(device(kPinA)->address, Address{0x80});
  pass(1ns);
  EXPECT_EQ(claim(0x80), ClaimState::Claimed);
  EXPECT_EQ(device(kPinA)->address, kNullAddress) << "without a frame: a silence is a fact, too";
  EXPECT_EQ(device(kPinA)->formerAddresses[0], (FormerAddress{m_now, {0x80}}));
}

TEST_F(StateOfOneChannel, LeavesTheAddressToADeviceThatAnswersAContest) {
  hear("18EEFF80", kNameOfA);
  hear("18EFFF80", kAnnouncesA);
  hear("18EEFF80", kHigherForeignName);
  pass(100ms);
  hear("18EEFF80", kNameOfA);
  pass(1s);
  EXPECT_EQ(device(kPinA)->address, Address{0x80});
  EXPECT_EQ(claim(0x80), ClaimState::Claimed);
}

TEST_F(StateOfOneChannel, MeasuresAJoysticksPeriodAndWorstGap) {
  for (int i = 0; i < 20; ++i) {
    hear("0CFDD633", "0100010000000000");
    pass(20ms);
  }
  pass(90ms);
  hear("0CFDD633", "107D046400100000");
  const Joystick* stick = m_state.channel(kCan0).joysticks.find({0x33});
  ASSERT_NE(stick, nullptr);
  EXPECT_EQ(stick->priority(), 0);
  EXPECT_EQ(stick->worstGap, 110ms);
  EXPECT_GE(stick->period, 20ms);
  EXPECT_LT(stick->period, 40ms);
  EXPECT_EQ(stick->basic.value().x.tenths, 500);
  EXPECT_EQ(stick->timeouts, 0u);
}

TEST_F(StateOfOneChannel, ClearsAJoysticksInputAfter200Milliseconds) {
  hear("0CFDD633", "107D046400100000");
  pass(200ms);
  const Joystick* stick = m_state.channel(kCan0).joysticks.find({0x33});
  EXPECT_FALSE(stick->isActive());
  EXPECT_EQ(stick->timeouts, 1u);
  pass(1h);
  hear("0CFDD633", "107D046400100000");
  EXPECT_TRUE(stick->isActive());
  EXPECT_EQ(stick->worstGap, 0ms) << "an hour without is a silence, not a gap";
}

TEST_F(StateOfOneChannel, AlwaysHasRoomForTheSourcesThatControllersListenTo) {
  for (int source = 0x40; source < 0x60; ++source) {
    char id[9];
    std::snprintf(id, sizeof id, "0CFDD6%02X", static_cast<unsigned>(source));
    hear(id, "0100010000000000");
  }
  for (const char* id : {"0CFDD633", "0CFDD634", "0CFDD635", "0CFDD636", "0CFDD637", "0CFDD638"}) {
    hear(id, "0100010000000000");
  }
  for (int source = 0x33; source <= 0x38; ++source) {
    EXPECT_NE(m_state.channel(kCan0).joysticks.find({static_cast<std::uint8_t>(source)}), nullptr);
  }
}

TEST_F(StateOfOneChannel, ShowsAPermissiveWithItsSenderUntilItTimesOut) {
  hear("18EFFF80", kAnnouncesA);
  hear("18EF8005", "A10009");
  EXPECT_TRUE(at(0x80)->permissive().value().axis1Plus);
  EXPECT_EQ(at(0x80)->permissiveFrom, Address{0x05});
  pass(300ms);
  EXPECT_TRUE(at(0x80)->isStale(MessageId::SoePermissive));
}

TEST_F(StateOfOneChannel, KeepsPolledAnswersWithTheirTime) {
  hear("18EFFF80", kAnnouncesA);
  hear("18EF0580", "0200200000000B");
  const Instant answered = m_now;
  pass(1h);
  EXPECT_EQ(at(0x80)->faults().value(), (FaultStatus{1u << 21, 11}));
  EXPECT_EQ(at(0x80)->faults().at, answered);
}

TEST_F(StateOfOneChannel, KnowsGatewayNodesByNodeId) {
  hear("724", "05");
  hear("5A4", "4300500116699803");
  hear("1A4", kPosition);
  hear("224", "107D046400100000");
  const Device* monitor = m_state.devices().byNode(kCan0, {0x24});
  ASSERT_NE(monitor, nullptr);
  EXPECT_EQ(monitor->heartbeat().value(), 0x05);
  EXPECT_EQ(monitor->partNumber.value, 60320022u);
  EXPECT_EQ(monitor->position().value().elevation.tenths, -55);
  EXPECT_EQ(monitor->commanded.value().x.tenths, 500);
  hear("5A4", "4301500100200000");
  EXPECT_EQ(monitor->faults().value(), (FaultStatus{1u << 21, {}}));
  hear("5A4", "4B0150020B00");
  EXPECT_EQ(monitor->operationalErrorCode.value, 11);
  pass(3s);
  EXPECT_TRUE(monitor->isStale(MessageId::Heartbeat));
}

TEST_F(StateOfOneChannel, MakesNoDeviceOfARequest) {
  hear("624", "40005001");
  hear("224", "107D046400100000");
  hear("18EF8005", "02");
  EXPECT_EQ(m_state.devices().byNode(kCan0, {0x24}), nullptr);
  EXPECT_EQ(at(0x80), nullptr);
  EXPECT_EQ(at(0x05), nullptr);
}

TEST_F(StateOfOneChannel, CountsByMessage) {
  hear("18EFFF80", kAnnouncesA);
  hear("18EFFF80", kPosition);
  hear("18EFFF80", kPosition);
  hear("18EFFF80", "0100");
  hear("18FF0005", "00");
  EXPECT_EQ(m_state.counter(MessageId::PositionLimitStatus).count, 2u);
  EXPECT_EQ(m_state.malformed().count, 1u);
  EXPECT_EQ(m_state.others().count, 1u);
  EXPECT_EQ(device(kPinA)->malformed, 1u);
  EXPECT_EQ(node(0x80).malformed, 1u);
  EXPECT_EQ(m_state.channel(kCan0).frames, 5u);
}

TEST_F(StateOfOneChannel, TakesLinkDropsLockAndDrivesFromNotes) {
  m_state.apply({.frame = 0, .time = m_now, .value = note::LinkUp{kCan0}});
  m_state.apply({.frame = 0, .time = m_now, .value = note::Unlocked{kCan0}});
  m_state.apply({.frame = 0, .time = m_now, .value = note::Dropped{kCan0, 7}});
  m_state.apply({.frame = 0, .time = m_now, .value = note::DriveSaid{kCan0, {0x21}}});
  EXPECT_EQ(m_state.channel(kCan0).link, ChannelLink::Up);
  EXPECT_EQ(m_state.channel(kCan0).dropped, 7u);
  EXPECT_FALSE(m_state.isLocked());
  hear("18EF2105", "022101");
  EXPECT_EQ(m_state.counter(MessageId::CopleyGetParameter).count, 1u);
  m_state.apply({.frame = 1, .time = m_now, .value = note::LinkDown{kCan0, {}, {}}});
  EXPECT_EQ(m_state.channel(kCan0).link, ChannelLink::Down);
}

TEST_F(StateOfOneChannel, TakesTheControllersStateFromErrorFramesUntilTheLinkComesUpAnew) {
  const auto error = [&](std::uint32_t id, std::string_view data) {
    Frame told = frame("000", data);
    told.id = kErrorBit | id;
    m_state.apply(told, m_now);
  };
  error(0x04, "0010000000000000");
  EXPECT_EQ(m_state.channel(kCan0).controller, ControllerState::ErrorPassive);
  error(0x02, "0500000000000000");  // lost arbitration: says nothing of it
  EXPECT_EQ(m_state.channel(kCan0).controller, ControllerState::ErrorPassive);
  EXPECT_EQ(m_state.channel(kCan0).errorFrames, 2u);
  m_state.apply({.frame = 2, .time = m_now, .value = note::LinkUp{kCan0}});
  EXPECT_EQ(m_state.channel(kCan0).controller, ControllerState::Unknown);
}

TEST_F(StateOfOneChannel, CountsFramesOfChannelsItDoesNotFollow) {
  m_state.apply(frame("18EFFF80", kPosition, kMaxChannels), m_now);
  EXPECT_EQ(m_state.untrackedFrames(), 1u);
  EXPECT_EQ(m_state.cursor().frames, 1u);
}

TEST_F(StateOfOneChannel, FollowsEveryChannelUpToTheLast) {
  constexpr std::uint8_t kLast = kMaxChannels - 1;
  m_state.apply(frame("18EFFF80", kAnnouncesA, kLast), m_now);
  m_state.apply(frame("18EFFF80", kPosition, kLast), m_now);
  EXPECT_EQ(m_state.untrackedFrames(), 0u);
  EXPECT_EQ(m_state.channelCount(), kMaxChannels);
  EXPECT_EQ(m_state.channel(Channel{kLast}).frames, 2u);
  EXPECT_EQ(m_state.channel(Channel{3}).frames, 0u);
  ASSERT_NE(device(kPinA), nullptr);
  EXPECT_TRUE(device(kPinA)->position().isKnown());
}

TEST_F(StateOfOneChannel, KnowsNothingOfAChannelThatWasNotHeard) {
  EXPECT_EQ(m_state.channelCount(), 0u);
  EXPECT_EQ(m_state.channel(kCan0).frames, 0u);
  EXPECT_FALSE(m_state.channel(Channel{200}).book.isHeard({0x80}));
}

TEST_F(StateOfOneChannel, KeepsWhatWasAskedInVainUntilTheAnswer) {
  hear("18EFFF80", kAnnouncesA);
  hear("18EF80F9", "03");
  const Instant first = m_now;
  pass(1s);
  hear("18EF80F9", "03");
  EXPECT_EQ(device(kPinA)->askedInVain(Request::Firmware), first);
  EXPECT_EQ(device(kPinA)->askedInVain(Request::Fault), kNotYet);
  hear("18EFF980", "03010001020105");
  EXPECT_EQ(device(kPinA)->askedInVain(Request::Firmware), kNotYet);
}

TEST_F(StateOfOneChannel, RunsOutOfDevicesWithoutHarm) {
  for (unsigned channel = 0; channel < kMaxChannels; ++channel) {
    for (unsigned address = 0x80; address < 0xF8; ++address) {
      char id[9];
      std::snprintf(id, sizeof id, "18EFFF%02X", address);
      m_state.apply(frame(id, kPosition, static_cast<std::uint8_t>(channel)), m_now);
    }
  }
  EXPECT_EQ(m_state.devices().untracked(), kMaxChannels * 0x78 - kMaxDevices);
}

TEST_F(StateOfOneChannel, MakesRoomForAPinInAFullTable) {
  unsigned made = 0;
  for (unsigned channel = 1; channel < kMaxChannels; ++channel) {
    for (unsigned address = 0x80; address < 0xF8 && made < kMaxDevices; ++address, ++made) {
      char id[9];
      std::snprintf(id, sizeof id, "18EFFF%02X", address);
      m_state.apply(frame(id, kPosition, static_cast<std::uint8_t>(channel)), m_now);
      pass(1ms);
    }
  }
  ASSERT_EQ(made, kMaxDevices);
  hear("18EFFF80", kAnnouncesA);
  hear("18EFFF80", kPosition);
  ASSERT_NE(device(kPinA), nullptr);
  EXPECT_TRUE(device(kPinA)->position().isKnown());
  EXPECT_EQ(m_state.devices().byAddress(Channel{1}, Address{0x80}), nullptr) << "heard longest ago";
  EXPECT_NE(m_state.devices().byAddress(Channel{1}, Address{0x81}), nullptr);
}

}  // namespace
}  // namespace deckpipe
