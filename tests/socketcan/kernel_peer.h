// SPDX-License-Identifier: GPL-3.0-or-later
// A node that the kernel's own J1939 (can-j1939) speaks for: it claims an address for its NAME, and the
// kernel, not we, says who holds which.
#pragma once

#include <linux/can.h>
#include <linux/can/j1939.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>

namespace deckpipe::guest {

class KernelPeer {
 public:
  KernelPeer(const char* interfaceName, std::uint64_t name, std::uint8_t address) : m_name(name) {
    m_fd = ::socket(PF_CAN, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_J1939);
    const int on = 1;
    ::setsockopt(m_fd, SOL_SOCKET, SO_BROADCAST, &on, sizeof on);
    sockaddr_can own = place(interfaceName);
    own.can_addr.j1939.name = name;
    own.can_addr.j1939.addr = address;
    own.can_addr.j1939.pgn = J1939_NO_PGN;
    m_isOpen = m_fd >= 0 && ::bind(m_fd, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0;
    m_interface = interfaceName;
  }
  ~KernelPeer() {
    if (m_fd >= 0) ::close(m_fd);
  }
  KernelPeer(const KernelPeer&) = delete;
  KernelPeer& operator=(const KernelPeer&) = delete;

  bool isOpen() const { return m_isOpen; }
  // Claims the address that it was bound to.
  bool claim() {
    std::array<std::uint8_t, 8> bytes{};
    std::memcpy(bytes.data(), &m_name, sizeof m_name);  // J1939 is little-endian, and so is this machine
    sockaddr_can everyone = place(m_interface);
    everyone.can_addr.j1939.name = J1939_NO_NAME;
    everyone.can_addr.j1939.addr = J1939_NO_ADDR;
    everyone.can_addr.j1939.pgn = J1939_PGN_ADDRESS_CLAIMED;
    return send(bytes.data(), bytes.size(), everyone);
  }
  // To the node of that NAME, wherever the kernel has it; false where it has it nowhere, or has no address
  // for us any more.
  bool sendTo(std::uint64_t name, std::uint32_t pgn) {
    const std::array<std::uint8_t, 3> bytes{1, 2, 3};
    sockaddr_can to = place(m_interface);
    to.can_addr.j1939.name = name;
    to.can_addr.j1939.addr = J1939_NO_ADDR;
    to.can_addr.j1939.pgn = pgn;
    return send(bytes.data(), bytes.size(), to);
  }

 private:
  static sockaddr_can place(const char* interfaceName) {
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(::if_nametoindex(interfaceName));
    return address;
  }
  bool send(const std::uint8_t* bytes, std::size_t length, const sockaddr_can& to) const {
    return ::sendto(m_fd, bytes, length, 0, reinterpret_cast<const sockaddr*>(&to), sizeof to) ==
           static_cast<ssize_t>(length);
  }

  std::uint64_t m_name;
  const char* m_interface = "";
  int m_fd = -1;
  bool m_isOpen = false;
};

}  // namespace deckpipe::guest
