// SPDX-License-Identifier: GPL-3.0-or-later
// Address claims against those who did not read our code: can-utils' j1939acd, the kernel's can-j1939, a
// second console, and frames that nobody should send. We are on can0, they on can1. Our NAME begins with 80
// hex: 1… is lower and wins, F… is higher and loses.
#include "guest_simulator.h"
#include "kernel_peer.h"

namespace deckpipe::guest {
namespace {

using Progress = ClaimStatus::Progress;

constexpr const char* kLower = "1000420028C00001";
constexpr const char* kHigher = "F000420028C00001";

// A console that has unlocked.
struct Peer : Console {
  explicit Peer(std::uint32_t identity = 1)
      : Console(QStringLiteral("can0"), 250'000, {.identityNumber = identity}) {}

  bool unlock() {
    if (!waitFor(SourceStatus::Progress::Running)) return false;
    session.intend(intent::Unlock{});
    return waitUntil([&] { return claim().progress >= Progress::Claimed; });
  }
  const ClaimStatus& claim() const { return session.snapshot().services->claim; }
  bool isAt(unsigned address) const {
    return claim().progress == Progress::Claimed && claim().address.value == address;
  }
  std::uint64_t nameAt(unsigned address) const {
    return channel().book.lastHolder(Address{static_cast<std::uint8_t>(address)}).value;
  }
  std::size_t claimsSentFrom(unsigned address) const {
    const FrameStore& frames = document().frames;
    std::size_t count = 0;
    for (std::uint64_t i = 0; i < frames.count(); ++i) {
      const Frame& frame = frames[i];
      count += (frame.flags & Frame::kSent) != 0 && (frame.id & 0x1FFF'FFFFu) == (0x18EE'FF00u | address);
    }
    return count;
  }
};

QString daemon(const char* name, const char* range) {
  return QStringLiteral("j1939acd -v -r %1 -c /tmp/%2.jacd %2 can1")
      .arg(QLatin1String(range), QLatin1String(name));
}
std::uint64_t number(const char* name) { return std::strtoull(name, nullptr, 16); }

TEST(Peers, ADaemonOfALowerNameTakesOurAddressAndWeMove) {
  Peer console;
  ASSERT_TRUE(console.unlock());
  ASSERT_TRUE(console.isAt(0xF9));
  const Program peer(daemon(kLower, "0xf9"));
  EXPECT_TRUE(console.waitUntil([&] { return console.isAt(0xFA); }));
  EXPECT_EQ(console.claim().lost, 1u);
  EXPECT_EQ(console.nameAt(0xF9), number(kLower));
}

TEST(Peers, ADaemonOfAHigherNameLeavesOurAddressToUs) {
  Peer console;
  ASSERT_TRUE(console.unlock());
  const Program peer(daemon(kHigher, "0xf8-0xf9"));
  EXPECT_TRUE(console.waitUntil([&] { return console.nameAt(0xF8) == number(kHigher); }));
  EXPECT_TRUE(console.isAt(0xF9));
  EXPECT_EQ(console.claim().lost, 0u);
}

TEST(Peers, ADaemonThatHasOurAddressIsLeftInPeaceWhateverItsName) {
  Peer console;
  ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running));
  const Program peer(daemon(kHigher, "0xf9"));
  ASSERT_TRUE(console.waitUntil([&] { return console.nameAt(0xF9) == number(kHigher); }));
  ASSERT_TRUE(console.unlock());
  EXPECT_TRUE(console.isAt(0xFA));
  EXPECT_EQ(console.claim().won + console.claim().lost, 0);
}

// The kernel learns who holds what only while somebody uses its J1939, hence the onlooker.
TEST(Peers, TheKernelThatClaimsOurAddressWithAHigherNameLosesIt) {
  KernelPeer onlooker("can1", number("F000420028C00002"), 0x90);
  ASSERT_TRUE(onlooker.isOpen());
  Peer console;
  ASSERT_TRUE(console.unlock());
  ASSERT_TRUE(onlooker.claim());
  KernelPeer peer("can1", number(kHigher), 0xF9);
  ASSERT_TRUE(peer.claim());
  EXPECT_TRUE(console.waitUntil([&] { return console.claim().won == 1; }));
  EXPECT_TRUE(console.isAt(0xF9));
  EXPECT_EQ(console.claimsSentFrom(0xF9), 2u) << "the second is our answer";
  // For the kernel the address is ours, and the loser has none to send from.
  EXPECT_TRUE(console.waitUntil([&] { return onlooker.sendTo(console.claim().name, 0xEF00); }));
  EXPECT_TRUE(console.waitUntil([&] { return console.hasHeard(0x98EFF990u); }));
  EXPECT_FALSE(peer.sendTo(console.claim().name, 0xEF00));
}

TEST(Peers, TheKernelThatClaimsOurAddressWithALowerNameHasIt) {
  Peer console;
  ASSERT_TRUE(console.unlock());
  KernelPeer peer("can1", number(kLower), 0xF9);
  ASSERT_TRUE(peer.claim());
  EXPECT_TRUE(console.waitUntil([&] { return console.isAt(0xFA); }));
  EXPECT_EQ(console.claim().lost, 1u);
  EXPECT_TRUE(console.waitUntil([&] { return peer.sendTo(console.claim().name, 0xEF00); }));
  EXPECT_TRUE(console.waitUntil([&] { return console.hasHeard(0x98EFFAF9u); }))
      << "the kernel did not follow our NAME to FA";
}

TEST(Peers, TwoConsolesShareABus) {
  Peer first(1), second(2);
  ASSERT_TRUE(first.unlock());
  ASSERT_TRUE(second.unlock());
  EXPECT_TRUE(first.isAt(0xF9));
  EXPECT_TRUE(second.isAt(0xFA));
  EXPECT_EQ(first.nameAt(0xFA), second.claim().name);
}

TEST(Peers, TwoConsolesOfOneNameAreToldSo) {
  Peer first(1), second(1);
  ASSERT_TRUE(first.unlock());
  ASSERT_TRUE(second.unlock());
  EXPECT_EQ(second.claim().progress, Progress::SameName);
  EXPECT_TRUE(first.isAt(0xF9)) << "who was there first goes on";
}

// No remote frames here: QEMU's controller takes what follows one for something else.
TEST(Peers, ForgedClaimsChangeNothingAndRequestsAreAnswered) {
  Peer console;
  ASSERT_TRUE(console.unlock());
  const std::size_t before = console.claimsSentFrom(0xF9);
  for (const char* forged : {"18EEFFF9#00000000000010",    // 7 bytes
                             "18EEFFF9#0000000000000000",  // NAME 0
                             "18EEFFFF#0100C02800420010",  // from everyone
                             "18EAFFF9#00EE00",            // a request in our own name
                             "18EAFA33#00EE00",            // a request to somebody else
                             "18EAFF33#00EB00",            // a request for something else
                             "18EAFF33#00EE"}) {           // half a request
    ASSERT_EQ(shell(QStringLiteral("cansend can1 ") + QLatin1String(forged)), 0);
  }
  ASSERT_EQ(shell(QStringLiteral("cansend can1 18EAFF33#00EE00; cansend can1 18EAF933#00EE00")), 0);
  EXPECT_TRUE(console.waitUntil([&] { return console.claimsSentFrom(0xF9) >= before + 3; }));
  console.lines(QStringLiteral("forged.log"));
  QTest::qWait(500);  // one more would be as wrong
  // A request from our own address is odd, and answering it does no harm.
  EXPECT_EQ(console.claimsSentFrom(0xF9), before + 3);
  EXPECT_TRUE(console.isAt(0xF9));
  EXPECT_EQ(console.claim().won + console.claim().lost, 0);
}

}  // namespace
}  // namespace deckpipe::guest
