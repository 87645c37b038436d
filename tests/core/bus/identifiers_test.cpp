// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bus/canopen.h"
#include "bus/controller.h"
#include "bus/j1939.h"
#include "bus/load.h"

namespace deckpipe {
namespace {

TEST(J1939Id, TakesPdu1ApartIntoPgnAndDestination) {
  const J1939Id id = J1939Id::of(0x18EF8005);
  EXPECT_EQ(id.priority, 6);
  EXPECT_EQ(id.pgn, pgn::kProprietaryA);
  EXPECT_EQ(id.destination, Address{0x80});
  EXPECT_EQ(id.source, Address{0x05});
  EXPECT_TRUE(id.hasDestination());
}

TEST(J1939Id, KeepsThePduSpecificOfABroadcastInThePgn) {
  const J1939Id id = J1939Id::of(0x0CFDD633);
  EXPECT_EQ(id.pgn, pgn::kBasicJoystick);
  EXPECT_EQ(id.source, Address{0x33});
  EXPECT_FALSE(id.hasDestination());
}

TEST(J1939Id, CountsBothDataPagesAsPartOfThePgn) {
  EXPECT_EQ(J1939Id::of(0x19EF8005).pgn, 0x1EF00u);
  EXPECT_EQ(J1939Id::of(0x1AEF8005).pgn, 0x2EF00u);
}

TEST(J1939Id, IsPutTogetherAsItWasTakenApart) {
  for (const std::uint32_t id : {0x18EF8005u, 0x0CFDD633u, 0x18EEFF80u, 0x1BFFFFFFu, 0x00000000u}) {
    EXPECT_EQ(J1939Id::of(id).frameId(), id | kExtendedBit);
  }
}

TEST(CobId, SplitsFunctionAndNode) {
  const CobId id = CobId::of(0x5A4);
  EXPECT_EQ(id.function, static_cast<std::uint16_t>(CobFunction::SdoResponse));
  EXPECT_EQ(id.node, NodeId{0x24});
}

TEST(CobId, KnowsWhichFunctionsCarryANode) {
  EXPECT_TRUE(CobId::of(0x724).hasNode());
  EXPECT_TRUE(CobId::of(0x0A4).hasNode());
  EXPECT_FALSE(CobId::of(0x000).hasNode());
  EXPECT_FALSE(CobId::of(0x080).hasNode());
  EXPECT_FALSE(CobId::of(0x123).hasNode());
}

TEST(ErrorFrame, TellsTheControllersState) {
  const auto told = [](std::uint32_t id, std::uint8_t second, std::uint8_t length = 8) {
    Frame frame;
    frame.id = id;
    frame.length = length;
    frame.data[1] = second;
    return controllerStateOf(frame);
  };
  constexpr std::uint32_t kOfController = kErrorBit | 0x04;
  EXPECT_EQ(told(kOfController, 0x04), ControllerState::ErrorWarning);
  EXPECT_EQ(told(kOfController, 0x08), ControllerState::ErrorWarning);
  EXPECT_EQ(told(kOfController, 0x10), ControllerState::ErrorPassive);
  EXPECT_EQ(told(kOfController, 0x20 | 0x04), ControllerState::ErrorPassive) << "the worse of two";
  EXPECT_EQ(told(kOfController, 0x40), ControllerState::ErrorActive);
  EXPECT_EQ(told(kErrorBit | 0x40, 0), ControllerState::BusOff);
  EXPECT_EQ(told(kErrorBit | 0x100, 0), ControllerState::ErrorActive) << "restarted";
  EXPECT_FALSE(told(kOfController, 0x01)) << "an overrun is no state";
  EXPECT_FALSE(told(kOfController, 0x10, 1)) << "cut short";
  EXPECT_FALSE(told(kErrorBit | 0x20, 0x10)) << "a missing acknowledge";
  EXPECT_FALSE(told(0x04, 0x10)) << "no error frame";
}

TEST(BusLoad, CountsTheBitsOfAFrameBetweenUnstuffedAndFullyStuffed) {
  Frame frame;
  frame.id = kExtendedBit | 0x18EFFF80;
  frame.length = 8;
  EXPECT_GE(estimatedBits(frame), 131u);
  EXPECT_LE(estimatedBits(frame), 160u);
  frame.id |= kRemoteBit;
  EXPECT_LT(estimatedBits(frame), 80u);
}

}  // namespace
}  // namespace deckpipe
