// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/can_interface.h"

#ifdef __linux__

#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>

namespace deckpipe {
namespace {

constexpr std::size_t kFlexibleDataRateMtu = 72;
constexpr unsigned kEcho = 1u << 18;  // IFF_ECHO of linux/if.h, which cannot be included beside net/if.h

using Bytes = std::span<const std::byte>;

template <typename T>
T load(Bytes bytes, std::size_t offset = 0) {
  T value{};
  if (offset + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

constexpr std::size_t aligned(std::size_t size) { return (size + 3) & ~std::size_t{3}; }

// Calls visit(type, payload) for every whole attribute.
template <typename Visit>
void forEachAttribute(Bytes bytes, Visit visit) {
  while (bytes.size() >= sizeof(rtattr)) {
    const auto header = load<rtattr>(bytes);
    if (header.rta_len < sizeof(rtattr) || header.rta_len > bytes.size()) return;
    visit(header.rta_type & NLA_TYPE_MASK, bytes.subspan(sizeof(rtattr), header.rta_len - sizeof(rtattr)));
    bytes = bytes.subspan(std::min(aligned(header.rta_len), bytes.size()));
  }
}

std::string text(Bytes bytes) {
  const auto* from = reinterpret_cast<const char*>(bytes.data());
  return {from, std::find(from, from + bytes.size(), '\0')};
}

ControllerState controllerState(std::uint32_t state) {
  switch (state) {
    case CAN_STATE_ERROR_ACTIVE: return ControllerState::ErrorActive;
    case CAN_STATE_ERROR_WARNING: return ControllerState::ErrorWarning;
    case CAN_STATE_ERROR_PASSIVE: return ControllerState::ErrorPassive;
    case CAN_STATE_BUS_OFF: return ControllerState::BusOff;
    case CAN_STATE_STOPPED: return ControllerState::Stopped;
    case CAN_STATE_SLEEPING: return ControllerState::Sleeping;
    default: return ControllerState::Unknown;
  }
}

void readControllerFacts(Bytes attributes, CanInterface& out) {
  forEachAttribute(attributes, [&](int type, Bytes value) {
    switch (type) {
      case IFLA_CAN_BITTIMING: out.bitRate = load<can_bittiming>(value).bitrate; break;
      case IFLA_CAN_STATE: out.controller = controllerState(load<std::uint32_t>(value)); break;
      case IFLA_CAN_CTRLMODE:
        out.isListenOnly = (load<can_ctrlmode>(value).flags & CAN_CTRLMODE_LISTENONLY) != 0;
        break;
      case IFLA_CAN_RESTART_MS: out.restartMs = load<std::uint32_t>(value); break;
      case IFLA_CAN_BERR_COUNTER:
        out.sendErrors = load<can_berr_counter>(value).txerr;
        out.receiveErrors = load<can_berr_counter>(value).rxerr;
        break;
      default: break;
    }
  });
}

CanInterface linkFacts(std::uint16_t messageType, Bytes message) {
  const auto info = load<ifinfomsg>(message);
  CanInterface out;
  out.index = info.ifi_index;
  out.isCan = info.ifi_type == ARPHRD_CAN;
  out.isUp = (info.ifi_flags & IFF_UP) != 0;
  out.echoesInDriver = (info.ifi_flags & kEcho) != 0;
  out.isRemoved = messageType == RTM_DELLINK;
  Bytes controller;
  forEachAttribute(message.subspan(aligned(sizeof(ifinfomsg))), [&](int type, Bytes value) {
    if (type == IFLA_IFNAME) out.name = text(value);
    if (type == IFLA_MTU) out.hasFlexibleDataRate = load<std::uint32_t>(value) >= kFlexibleDataRateMtu;
    if (type == IFLA_STATS64) {
      const auto counted = load<rtnl_link_stats64>(value);
      out.receivedFrames = counted.rx_packets;
      out.overruns = counted.rx_over_errors + counted.rx_dropped;
    }
    if (type != IFLA_LINKINFO) return;
    forEachAttribute(value, [&](int inner, Bytes innerValue) {
      if (inner == IFLA_INFO_KIND) out.kind = text(innerValue);
      if (inner == IFLA_INFO_DATA) controller = innerValue;
    });
  });
  // The same attribute numbers mean other things for other kinds of link.
  if (out.isCan) readControllerFacts(controller, out);
  out.hasFlexibleDataRate = out.isCan && out.hasFlexibleDataRate;
  return out;
}

// Asks for one link, or for all with index 0. The kernel writes the answer inside send() and recv(), where
// it may wait for its network lock. When they return the answer is there, hence MSG_DONTWAIT.
Result<std::vector<CanInterface>, std::string> askKernel(int index) {
  const auto failed = [] { return Failure{std::generic_category().message(errno)}; };
  const int fd = ::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE);
  if (fd < 0) return failed();
  struct {
    nlmsghdr header;
    ifinfomsg info;
  } request{};
  request.header.nlmsg_len = sizeof request;
  request.header.nlmsg_type = RTM_GETLINK;
  request.header.nlmsg_flags = static_cast<std::uint16_t>(NLM_F_REQUEST | (index == 0 ? NLM_F_DUMP : 0));
  request.info.ifi_family = AF_UNSPEC;
  request.info.ifi_index = index;

  std::vector<CanInterface> links;
  std::optional<std::string> error;
  if (::send(fd, &request, sizeof request, 0) < 0) error = failed().error;
  std::array<std::byte, 32768> buffer;
  for (bool more = !error; more;) {
    const ssize_t size = ::recv(fd, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (size < 0 && links.empty()) error = failed().error;
    if (size <= 0) break;
    const auto part = parseLinkMessages(Bytes(buffer.data(), static_cast<std::size_t>(size)));
    links.insert(links.end(), part.begin(), part.end());
    more = index == 0 && !part.empty();
  }
  ::close(fd);
  if (error) return Failure{*error};
  return links;
}

}  // namespace

std::vector<CanInterface> parseLinkMessages(std::span<const std::byte> datagram) {
  std::vector<CanInterface> links;
  while (datagram.size() >= sizeof(nlmsghdr)) {
    const auto header = load<nlmsghdr>(datagram);
    if (header.nlmsg_len < sizeof(nlmsghdr) || header.nlmsg_len > datagram.size()) break;
    const Bytes message = datagram.subspan(sizeof(nlmsghdr), header.nlmsg_len - sizeof(nlmsghdr));
    const bool aboutLink = header.nlmsg_type == RTM_NEWLINK || header.nlmsg_type == RTM_DELLINK;
    if (aboutLink && message.size() >= aligned(sizeof(ifinfomsg))) {
      links.push_back(linkFacts(header.nlmsg_type, message));
    }
    datagram = datagram.subspan(std::min(aligned(header.nlmsg_len), datagram.size()));
  }
  return links;
}

Result<CanInterface, std::string> readInterface(const std::string& name) {
  const unsigned index = ::if_nametoindex(name.c_str());
  if (index == 0) return Failure{std::generic_category().message(errno)};
  auto links = askKernel(static_cast<int>(index));
  if (!links) return Failure{links.error()};
  if (links.value().empty()) return Failure{std::generic_category().message(ENODEV)};
  return links.value().front();
}

std::vector<CanInterface> readCanInterfaces() {
  auto links = askKernel(0);
  if (!links) return {};
  std::vector<CanInterface> out;
  std::copy_if(links.value().begin(), links.value().end(), std::back_inserter(out),
               [](const CanInterface& link) { return link.isCan; });
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return out;
}

}  // namespace deckpipe

#else

namespace deckpipe {

Result<CanInterface, std::string> readInterface(const std::string&) {
  return Failure{std::string("only Linux tells of CAN interfaces")};
}
std::vector<CanInterface> readCanInterfaces() { return {}; }
std::vector<CanInterface> parseLinkMessages(std::span<const std::byte>) { return {}; }

}  // namespace deckpipe

#endif
