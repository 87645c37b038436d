// SPDX-License-Identifier: GPL-3.0-or-later
// What rtnetlink says, from bytes built as the kernel builds them, and from the kernel itself where the
// machine lets a test have network interfaces of its own.
#include "link/can_interface.h"

#include <gtest/gtest.h>

#ifdef __linux__

#include <fcntl.h>
#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/rtnetlink.h>
#include <linux/sockios.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <QSignalSpy>
#include <QTest>
#include <cstring>

#include "link/interface_watch.h"
#include "link/kernel_socket.h"

namespace deckpipe {
namespace {

using Datagram = std::vector<std::byte>;

template <typename T>
Datagram bytesOf(const T& value) {
  Datagram bytes(sizeof value);
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}
Datagram bytesOf(const char* text) {
  Datagram bytes(std::strlen(text) + 1);
  std::memcpy(bytes.data(), text, bytes.size());
  return bytes;
}
void append(Datagram& to, const Datagram& from) {
  to.insert(to.end(), from.begin(), from.end());
  to.resize((to.size() + 3) & ~std::size_t{3});
}
Datagram attribute(int type, const Datagram& value) {
  Datagram out = bytesOf(
      rtattr{static_cast<unsigned short>(sizeof(rtattr) + value.size()), static_cast<unsigned short>(type)});
  append(out, value);
  return out;
}
Datagram joined(std::initializer_list<Datagram> parts) {
  Datagram out;
  for (const Datagram& part : parts) append(out, part);
  return out;
}
Datagram message(std::uint16_t type, unsigned short hardware, unsigned flags, const Datagram& attributes) {
  ifinfomsg info{};
  info.ifi_type = hardware;
  info.ifi_index = 7;
  info.ifi_flags = flags;
  const Datagram body = joined({bytesOf(info), attributes});
  nlmsghdr header{};
  header.nlmsg_len = static_cast<std::uint32_t>(sizeof header + body.size());
  header.nlmsg_type = type;
  return joined({bytesOf(header), body});
}

Datagram canLink(std::uint16_t type = RTM_NEWLINK, unsigned flags = IFF_UP) {
  can_bittiming timing{};
  timing.bitrate = 250'000;
  const Datagram data =
      joined({attribute(IFLA_CAN_BITTIMING, bytesOf(timing)),
              attribute(IFLA_CAN_STATE, bytesOf(std::uint32_t{CAN_STATE_BUS_OFF})),
              attribute(IFLA_CAN_CTRLMODE, bytesOf(can_ctrlmode{0, CAN_CTRLMODE_LISTENONLY})),
              attribute(IFLA_CAN_RESTART_MS, bytesOf(std::uint32_t{100})),
              attribute(IFLA_CAN_BERR_COUNTER, bytesOf(can_berr_counter{130, 5}))});
  const Datagram info =
      joined({attribute(IFLA_INFO_KIND, bytesOf("can")), attribute(IFLA_INFO_DATA | NLA_F_NESTED, data)});
  rtnl_link_stats64 counted{};
  counted.rx_over_errors = 3;
  counted.rx_dropped = 4;
  return message(type, ARPHRD_CAN, flags,
                 joined({attribute(IFLA_STATS64, bytesOf(counted)), attribute(IFLA_IFNAME, bytesOf("can0")),
                         attribute(IFLA_MTU, bytesOf(16u)), attribute(IFLA_TXQLEN, bytesOf(10u)),
                         attribute(IFLA_LINKINFO | NLA_F_NESTED, info)}));
}

TEST(LinkMessages, TellAllThatIsKnownOfAController) {
  const auto links = parseLinkMessages(canLink());
  ASSERT_EQ(links.size(), 1u);
  const CanInterface& link = links[0];
  EXPECT_EQ(link.index, 7);
  EXPECT_EQ(link.name, "can0");
  EXPECT_EQ(link.kind, "can");
  EXPECT_TRUE(link.isCan);
  EXPECT_TRUE(link.isUp);
  EXPECT_FALSE(link.isRemoved);
  EXPECT_TRUE(link.isListenOnly);
  EXPECT_FALSE(link.hasFlexibleDataRate);
  EXPECT_FALSE(link.echoesInDriver);
  EXPECT_EQ(link.bitRate, 250'000u);
  EXPECT_EQ(link.restartMs, 100u);
  EXPECT_EQ(link.sendErrors, 130);
  EXPECT_EQ(link.receiveErrors, 5);
  EXPECT_EQ(link.overruns, 7u);
  EXPECT_EQ(link.controller, ControllerState::BusOff);
}

// The flag is bit 18, as linux/if.h has it; net/if.h does not name it.
TEST(LinkMessages, TellWhetherTheDriverItselfEchoes) {
  const auto links = parseLinkMessages(canLink(RTM_NEWLINK, IFF_UP | 0x40000u));
  ASSERT_EQ(links.size(), 1u);
  EXPECT_TRUE(links[0].echoesInDriver);
  EXPECT_TRUE(links[0].isUp);
}

TEST(LinkMessages, TellOfDownAndOfRemoval) {
  const auto links = parseLinkMessages(joined({canLink(RTM_NEWLINK, 0), canLink(RTM_DELLINK)}));
  ASSERT_EQ(links.size(), 2u);
  EXPECT_FALSE(links[0].isUp);
  EXPECT_TRUE(links[1].isRemoved);
}

TEST(LinkMessages, OfVirtualCanHaveNoRateAndNoController) {
  const Datagram info = attribute(IFLA_INFO_KIND, bytesOf("vcan"));
  const auto links =
      parseLinkMessages(message(RTM_NEWLINK, ARPHRD_CAN, IFF_UP,
                                joined({attribute(IFLA_MTU, bytesOf(72u)), attribute(IFLA_LINKINFO, info)})));
  ASSERT_EQ(links.size(), 1u);
  EXPECT_EQ(links[0].kind, "vcan");
  EXPECT_TRUE(links[0].hasFlexibleDataRate);
  EXPECT_EQ(links[0].bitRate, 0u);
  EXPECT_EQ(links[0].controller, ControllerState::Unknown);
}

// Whatever is cut off or made up: no crash, no read past the end (the sanitizers watch), only whole messages.
TEST(LinkMessages, CutShortOrBrokenAreHarmless) {
  const Datagram whole = canLink();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_TRUE(parseLinkMessages(std::span(whole).first(size)).empty()) << size;
  }
  for (std::size_t at = sizeof(std::uint32_t); at < whole.size(); ++at) {
    for (const int value : {0x00, 0x01, 0xFF}) {
      Datagram broken = whole;
      broken[at] = static_cast<std::byte>(value);
      EXPECT_LE(parseLinkMessages(broken).size(), 1u);
    }
  }
}

TEST(ReadInterface, LoopbackIsThereAndNoCan) {
  const auto loopback = readInterface("lo");
  if (!loopback) GTEST_SKIP() << loopback.error();
  EXPECT_EQ(loopback.value().name, "lo");
  EXPECT_FALSE(loopback.value().isCan);
  for (const CanInterface& link : readCanInterfaces()) EXPECT_TRUE(link.isCan);
}

TEST(ReadInterface, UnknownNameIsASentence) {
  const auto missing = readInterface("nosuchcan9");
  ASSERT_FALSE(missing);
  EXPECT_FALSE(missing.error().empty());
}

// A network of its own for this thread, where the loopback interface can be set up and down at will.
class OwnNetwork {
 public:
  OwnNetwork() : m_old(::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC)) {
    m_isThere = m_old >= 0 && ::unshare(CLONE_NEWNET) == 0;
  }
  ~OwnNetwork() {
    if (m_isThere) (void)::setns(m_old, CLONE_NEWNET);
    if (m_old >= 0) ::close(m_old);
  }
  bool isThere() const { return m_isThere; }
  static bool setUp(const char* name, bool up) {
    const int fd = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    ifreq request{};
    std::strncpy(request.ifr_name, name, IFNAMSIZ - 1);
    request.ifr_flags = up ? IFF_UP : 0;
    const bool done = fd >= 0 && ::ioctl(fd, SIOCSIFFLAGS, &request) == 0;
    if (fd >= 0) ::close(fd);
    return done;
  }

 private:
  int m_old;
  bool m_isThere = false;
};

TEST(InterfaceWatch, AnswersFromTheEventLoopAndNotAfterStop) {
  const auto loopback = readInterface("lo");
  if (!loopback) GTEST_SKIP() << loopback.error();
  InterfaceWatch watch;
  std::vector<std::string> told;
  QObject::connect(&watch, &InterfaceWatch::answered, &watch, [&](const InterfaceReader::Answer& answer) {
    told.push_back(answer ? answer.value().name : "none: " + answer.error());
  });
  watch.request("nosuchcan9");
  watch.stop();
  watch.request("lo");
  EXPECT_TRUE(told.empty());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !told.empty(); }, 20'000));
  EXPECT_EQ(told, std::vector<std::string>{"lo"});
}

TEST(InterfaceWatch, TellsOfUpAndDown) {
  const OwnNetwork network;
  if (!network.isThere()) GTEST_SKIP() << "this needs the right to make a network namespace";
  const auto before = readInterface("lo");
  ASSERT_TRUE(before);
  EXPECT_FALSE(before.value().isUp);

  InterfaceWatch watch;
  std::vector<bool> seen;
  QObject::connect(&watch, &InterfaceWatch::changed, &watch, [&](const CanInterface& facts) {
    if (facts.index == before.value().index) seen.push_back(facts.isUp);
  });
  watch.start();
  ASSERT_TRUE(OwnNetwork::setUp("lo", true));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !seen.empty() && seen.back(); }, 20'000));
  ASSERT_TRUE(OwnNetwork::setUp("lo", false));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !seen.back(); }, 20'000));
}

TEST(InterfaceWatch, TellsOfEachStepHoweverQuickAndMayBeStoppedFromInside) {
  const OwnNetwork network;
  if (!network.isThere()) GTEST_SKIP() << "this needs the right to make a network namespace";
  InterfaceWatch watch;
  std::vector<bool> seen;
  QObject::connect(&watch, &InterfaceWatch::changed, &watch, [&](const CanInterface& facts) {
    if (seen.empty() || seen.back() != facts.isUp) seen.push_back(facts.isUp);
    if (seen.size() == 4) watch.stop();
  });
  watch.start();
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(OwnNetwork::setUp("lo", true));
    ASSERT_TRUE(OwnNetwork::setUp("lo", false));
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return seen.size() >= 4; }, 20'000));
  QTest::qWait(50);
  EXPECT_EQ(seen, (std::vector{true, false, true, false}));
}

TEST(KernelSocket, TellsWhatWasDropped) {
  const int receiver = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(::bind(receiver, reinterpret_cast<const sockaddr*>(&address), size), 0);
  ASSERT_EQ(::getsockname(receiver, reinterpret_cast<sockaddr*>(&address), &size), 0);
  growReceiveBuffer(receiver, 4'096);  // "grow" to less: little to fill
  const auto empty = readReceiveBuffer(receiver);
  if (!empty) GTEST_SKIP() << "no SO_MEMINFO";
  EXPECT_EQ(empty->drops, 0u);
  EXPECT_GT(empty->bytes, 0u);

  const int sender = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const std::vector<char> block(1'024);
  for (int i = 0; i < 100; ++i) {
    ASSERT_GT(
        ::sendto(sender, block.data(), block.size(), 0, reinterpret_cast<const sockaddr*>(&address), size),
        0);
  }
  EXPECT_GT(readReceiveBuffer(receiver)->drops, 0u);
  EXPECT_GT(readReceiveBuffer(receiver)->used, 0u);
  ::close(sender);
  ::close(receiver);
  EXPECT_FALSE(readReceiveBuffer(-1));
}

// A datagram that waits before the first is read has the time at which it came, not that of the reading.
TEST(KernelSocket, StampsWhatComesBeforeTheFirstReading) {
  const int receiver = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(::bind(receiver, reinterpret_cast<const sockaddr*>(&address), size), 0);
  ASSERT_EQ(::getsockname(receiver, reinterpret_cast<sockaddr*>(&address), &size), 0);
  startStamping(receiver);
  QTest::qWait(50);  // the kernel switches its stamps on a moment later
  char byte = 0;
  ASSERT_EQ(::sendto(receiver, &byte, 1, 0, reinterpret_cast<const sockaddr*>(&address), size), 1);
  timeval before{}, stamp{};
  ::gettimeofday(&before, nullptr);
  QTest::qWait(50);
  ASSERT_EQ(::recv(receiver, &byte, 1, 0), 1);
  ASSERT_EQ(::ioctl(receiver, SIOCGSTAMP, &stamp), 0);
  EXPECT_FALSE(timercmp(&stamp, &before, >)) << "stamped when it was read";
  ::close(receiver);
}

}  // namespace
}  // namespace deckpipe

#endif
