// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/exchanges.h"

#include <gtest/gtest.h>

#include "state/log_view.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

using test::frame;

constexpr auto kPin = "FF83150206021A0B";  // 1032AE100801035
const DeviceKey kMonitor = DeviceKey::of(*Pin::parse("1032AE100801035"));

struct ExchangesOf {
  LogDocument document;

  void add(const std::vector<Frame>& frames) {
    ASSERT_TRUE(document.frames.append(frames));
    while (document.roles.build(1000)) {
    }
    while (document.exchanges.build(1000)) {
    }
  }
  std::size_t size() const { return document.exchanges.list()->size(); }
  const Exchange& operator[](std::size_t i) const { return (*document.exchanges.list())[i]; }
};

TEST(Exchanges, APollAndItsAnswerBelongToTheDeviceByItsPin) {
  ExchangesOf log;
  log.add({frame("18EFFF80", kPin), frame("18EF80F9", "02"), frame("18EFF980", "02000000000000")});
  ASSERT_EQ(log.size(), 2u);
  EXPECT_EQ(log[0].message, MessageId::FaultPoll);
  EXPECT_FALSE(log[0].isFromDevice);
  EXPECT_EQ(log[0].device, kMonitor);
  EXPECT_EQ(log[1].message, MessageId::FaultResponse);
  EXPECT_TRUE(log[1].isFromDevice);
  EXPECT_EQ(log[1].device, kMonitor);
  EXPECT_EQ(log[1].frame, 2u);
}

TEST(Exchanges, ThePipeGoesBothWays) {
  ExchangesOf log;
  log.add({frame("18EFFF80", kPin), frame("18EF80F9", "FE41"), frame("18EFF980", "FE"),
           frame("18EFF980", "FE42")});
  ASSERT_EQ(log.size(), 3u);
  EXPECT_FALSE(log[0].isFromDevice);
  EXPECT_EQ(log[1].message, MessageId::PipeAck);
  EXPECT_TRUE(log[1].isFromDevice && log[2].isFromDevice);
}

TEST(Exchanges, GoOnWithTheDeviceAtItsNewAddress) {
  ExchangesOf log;
  log.add({frame("18EFFF80", kPin), frame("18EF80F9", "03"), frame("18EFFF85", kPin), frame("18EF85F9", "03"),
           frame("18EF80F9", "03")});
  ASSERT_EQ(log.size(), 3u);
  EXPECT_EQ(log[1].device, kMonitor);
  EXPECT_EQ(log[2].device, DeviceKey::at(Channel{}, Address{0x80})) << "nobody known is left there";
}

TEST(Exchanges, AnAddressThatAnotherNameTookIsNotTheDeviceAnyMore) {
  ExchangesOf log;
  log.add({frame("18EFFF80", kPin), frame("18EEFF80", "0100C02800420090"), frame("18EF80F9", "02")});
  ASSERT_EQ(log.size(), 1u);
  EXPECT_EQ(log[0].device, DeviceKey::at(Channel{}, Address{0x80}));
}

TEST(Exchanges, LeaveOutBroadcastsAndOtherMakers) {
  ExchangesOf log;
  log.add({frame("18EFFF80", kPin), frame("18EFFF80", "011D940371000041"),
           frame("18EEFFA0", "3412A00000420090"), frame("18EFB0A0", "FE41424344454647"),
           frame("0CFDD633", "0100010000000000")});
  EXPECT_EQ(log.size(), 0u);
}

TEST(Exchanges, AreTheSameHoweverSmallThePieces) {
  std::vector<Frame> frames{frame("18EFFF80", kPin)};
  for (int i = 0; i < 50; ++i) {
    frames.push_back(frame("18EF80F9", "02"));
    frames.push_back(frame("18EFF980", "02000000000000"));
  }
  ExchangesOf whole;
  whole.add(frames);
  LogDocument document;
  ASSERT_TRUE(document.frames.append(frames));
  while (document.roles.build(7)) {
  }
  while (document.exchanges.build(3)) {
  }
  const auto pieces = document.exchanges.list();
  ASSERT_EQ(pieces->size(), whole.size());
  for (std::size_t i = 0; i < pieces->size(); ++i) EXPECT_EQ((*pieces)[i].frame, whole[i].frame);
}

TEST(Exchanges, WaitForTheIndexOfRoles) {
  LogDocument document;
  ASSERT_TRUE(document.frames.append(std::array{frame("18EFFF80", kPin), frame("18EF80F9", "02")}));
  EXPECT_FALSE(document.exchanges.build(100));
  while (document.roles.build(100)) {
  }
  EXPECT_TRUE(document.exchanges.build(100));
  EXPECT_EQ(document.exchanges.list()->size(), 1u);
}

// What was read of the old list stays whole.
TEST(Exchanges, AreFoundAnewInAnotherList) {
  ExchangesOf log;
  log.add({frame("18EFFF80", kPin), frame("18EF80F9", "02")});
  const auto before = log.document.exchanges.list();
  log.document.exchanges.restart();
  EXPECT_EQ(log.size(), 0u);
  while (log.document.exchanges.build(1)) {
  }
  EXPECT_EQ(log.size(), 1u);
  EXPECT_NE(log.document.exchanges.list(), before);
  EXPECT_EQ((*before)[0].device, kMonitor);
}

}  // namespace
}  // namespace deckpipe
