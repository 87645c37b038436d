// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/conversations.h"

#include <gtest/gtest.h>

#include "support/frames.h"

namespace deckpipe {
namespace {

using test::frame;

constexpr auto kPin = "FF83150206021A0B";  // 1032AE100801035
const DeviceKey kMonitor = DeviceKey::of(*Pin::parse("1032AE100801035"));

struct Talk {
  LogDocument document;
  Conversations talk;

  void add(const std::vector<Frame>& frames) {
    ASSERT_TRUE(document.frames.append(frames));
    while (document.roles.build(1000)) {
    }
    EXPECT_TRUE(talk.take(document, document.frames.count(), 1'000'000));
  }
  const Utterance& operator[](std::size_t i) const { return talk.list().at(i); }
};

TEST(Conversations, APollAndItsAnswerBelongToTheDeviceByItsPin) {
  Talk talk;
  talk.add({frame("18EFFF80", kPin), frame("18EF80F9", "02"), frame("18EFF980", "02000000000000")});
  ASSERT_EQ(talk.talk.list().size(), 2u);
  EXPECT_EQ(talk[0].message, MessageId::FaultPoll);
  EXPECT_FALSE(talk[0].isFromDevice);
  EXPECT_EQ(talk[0].device, kMonitor);
  EXPECT_EQ(talk[1].message, MessageId::FaultResponse);
  EXPECT_TRUE(talk[1].isFromDevice);
  EXPECT_EQ(talk[1].device, kMonitor);
  EXPECT_EQ(talk[1].frame, 2u);
}

TEST(Conversations, ThePipeGoesBothWays) {
  Talk talk;
  talk.add({frame("18EFFF80", kPin), frame("18EF80F9", "FE41"), frame("18EFF980", "FE"),
            frame("18EFF980", "FE42")});
  ASSERT_EQ(talk.talk.list().size(), 3u);
  EXPECT_FALSE(talk[0].isFromDevice);
  EXPECT_EQ(talk[1].message, MessageId::PipeAck);
  EXPECT_TRUE(talk[1].isFromDevice && talk[2].isFromDevice);
}

TEST(Conversations, GoOnWithTheDeviceAtItsNewAddress) {
  Talk talk;
  talk.add({frame("18EFFF80", kPin), frame("18EF80F9", "03"), frame("18EFFF85", kPin),
            frame("18EF85F9", "03"), frame("18EF80F9", "03")});
  ASSERT_EQ(talk.talk.list().size(), 3u);
  EXPECT_EQ(talk[1].device, kMonitor);
  EXPECT_EQ(talk[2].device, DeviceKey::at(Channel{}, Address{0x80})) << "nobody known is left there";
}

TEST(Conversations, AnAddressThatAnotherNameTookIsNotTheDeviceAnyMore) {
  Talk talk;
  talk.add({frame("18EFFF80", kPin), frame("18EEFF80", "0100C02800420090"), frame("18EF80F9", "02")});
  ASSERT_EQ(talk.talk.list().size(), 1u);
  EXPECT_EQ(talk[0].device, DeviceKey::at(Channel{}, Address{0x80}));
}

TEST(Conversations, LeaveOutBroadcastsAndOtherMakers) {
  Talk talk;
  talk.add({frame("18EFFF80", kPin), frame("18EFFF80", "011D940371000041"),
            frame("18EEFFA0", "3412A00000420090"), frame("18EFB0A0", "FE41424344454647"),
            frame("0CFDD633", "0100010000000000")});
  EXPECT_TRUE(talk.talk.list().empty());
}

TEST(Conversations, AreTheSameHoweverSmallThePieces) {
  std::vector<Frame> frames{frame("18EFFF80", kPin)};
  for (int i = 0; i < 50; ++i) {
    frames.push_back(frame("18EF80F9", "02"));
    frames.push_back(frame("18EFF980", "02000000000000"));
  }
  Talk whole;
  whole.add(frames);
  LogDocument document;
  ASSERT_TRUE(document.frames.append(frames));
  while (document.roles.build(7)) {
  }
  Conversations pieces;
  while (!pieces.take(document, document.frames.count(), 3)) {
  }
  ASSERT_EQ(pieces.list().size(), whole.talk.list().size());
  for (std::size_t i = 0; i < pieces.list().size(); ++i) EXPECT_EQ(pieces.list()[i].frame, whole[i].frame);
}

TEST(Conversations, WaitForTheIndexOfRoles) {
  LogDocument document;
  ASSERT_TRUE(document.frames.append(std::array{frame("18EFFF80", kPin), frame("18EF80F9", "02")}));
  Conversations talk;
  EXPECT_FALSE(talk.take(document, 2, 100));
  while (document.roles.build(100)) {
  }
  EXPECT_TRUE(talk.take(document, 2, 100));
  EXPECT_EQ(talk.list().size(), 1u);
}

}  // namespace
}  // namespace deckpipe
