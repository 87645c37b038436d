// SPDX-License-Identifier: GPL-3.0-or-later
// The bit rate that was asked for, or none: whatever we do, `ip` must never find an interface at Qt's own 500
// kbit/s.
#include "guest_simulator.h"
#include "link/can_interface.h"
#include "link/can_link.h"

namespace deckpipe::guest {
namespace {

struct Rate : ::testing::Test {
  void TearDown() override { set(250'000); }
  static void set(int bitRate, bool up = true) {
    QString batch = QStringLiteral("link set can0 down\\nlink set can0 type can bitrate %1\\n").arg(bitRate);
    if (up) batch += QStringLiteral("link set can0 up\\n");
    ASSERT_EQ(shell(QStringLiteral("printf '%1' | ip -batch -").arg(batch)), 0);
  }
  // What ip says, which is not our reading of netlink.
  static bool isAt(int bitRate) {
    return shell(QStringLiteral("ip -details link show can0 | grep -q 'bitrate %1 '").arg(bitRate)) == 0;
  }
};

TEST_F(Rate, AskedForAndReadBack) {
  for (const int rate : {250'000, 125'000, 1'000'000}) {
    set(rate);
    Console console(QStringLiteral("can0"), rate);
    ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running)) << rate;
    EXPECT_TRUE(isAt(rate));
    EXPECT_EQ(readInterface("can0").value().bitRate, static_cast<std::uint32_t>(rate));
  }
}

TEST_F(Rate, AnyOtherIsRefusedAndLeftAlone) {
  for (const int rate : {125'000, 500'000}) {
    set(rate);
    Console console(QStringLiteral("can0"));
    ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Failed)) << rate;
    const auto* error = std::get_if<LinkError>(&console.session.snapshot().source.error);
    ASSERT_NE(error, nullptr);
    EXPECT_EQ(error->fault, LinkFault::WrongBitRate);
    EXPECT_EQ(error->bitRate, static_cast<std::uint32_t>(rate));
    EXPECT_TRUE(isAt(rate));
  }
}

TEST_F(Rate, NoneAskedForLeavesItAsItIs) {
  set(125'000);
  Console console(QStringLiteral("can0"), 0);
  ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running));
  EXPECT_TRUE(isAt(125'000));
}

// Down, the interface could be set to anything by whoever tries to.
TEST_F(Rate, AnInterfaceThatIsDownIsRefusedAndNotTouched) {
  set(125'000, false);
  for (const int rate : {250'000, 0}) {
    Console console(QStringLiteral("can0"), rate);
    ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Failed));
    EXPECT_TRUE(isAt(125'000));
    EXPECT_FALSE(readInterface("can0").value().isUp);
  }
}

TEST_F(Rate, ListenOnlyIsSeenAndNotTakenOff) {
  ASSERT_TRUE(ip(QStringLiteral("set can0 down")));
  ASSERT_TRUE(ip(QStringLiteral("set can0 up type can bitrate 250000 listen-only on")));
  Console console(QStringLiteral("can0"));
  ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running));
  EXPECT_TRUE(readInterface("can0").value().isListenOnly);
  EXPECT_EQ(shell(QStringLiteral("ip -details link show can0 | grep -q LISTEN-ONLY")), 0);
  shell(QStringLiteral("cansend can1 123#01"));
  EXPECT_TRUE(console.waitUntil([&] { return console.hasHeard(0x123); }));
  console.session.closeSource();
  ASSERT_TRUE(ip(QStringLiteral("set can0 down")));
  ASSERT_TRUE(ip(QStringLiteral("set can0 type can listen-only off")));
}

}  // namespace
}  // namespace deckpipe::guest
