// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/interface_watch.h"

#include <QPointer>
#include <QSocketNotifier>

#ifdef __linux__
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#endif

namespace deckpipe {

#ifdef __linux__

InterfaceWatch::InterfaceWatch(int index, QObject* parent) : QObject(parent), m_index(index) {
  m_socket = ::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE);
  if (m_socket < 0) return;
  sockaddr_nl address{};
  address.nl_family = AF_NETLINK;
  address.nl_groups = RTMGRP_LINK;
  if (::bind(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) < 0) {
    ::close(m_socket);
    m_socket = -1;
    return;
  }
  m_notifier = new QSocketNotifier(m_socket, QSocketNotifier::Read, this);
  connect(m_notifier, &QSocketNotifier::activated, this, &InterfaceWatch::readEvents);
}

InterfaceWatch::~InterfaceWatch() {
  delete m_notifier;  // before the descriptor that it watches
  if (m_socket >= 0) ::close(m_socket);
}

void InterfaceWatch::readEvents() {
  const QPointer<InterfaceWatch> alive(this);
  std::array<std::byte, 32768> buffer;
  while (alive) {
    const ssize_t size = ::recv(m_socket, buffer.data(), buffer.size(), 0);
    if (size < 0 && errno == ENOBUFS) {
      // Events were lost, so the state is asked for. An interface that is no more answers nothing.
      char name[IF_NAMESIZE];
      CanInterface gone;
      gone.index = m_index;
      gone.isRemoved = true;
      const auto facts = ::if_indextoname(static_cast<unsigned>(m_index), name) != nullptr
                             ? readInterface(name)
                             : Result<CanInterface, std::string>(gone);
      if (facts) Q_EMIT changed(facts.value());
      continue;
    }
    if (size <= 0) return;
    const std::span<const std::byte> datagram(buffer.data(), static_cast<std::size_t>(size));
    for (const CanInterface& link : parseLinkMessages(datagram)) {
      if (alive && (m_index == kEvery || link.index == m_index)) Q_EMIT changed(link);
    }
  }
}

#else

InterfaceWatch::InterfaceWatch(int index, QObject* parent) : QObject(parent), m_index(index) {}
InterfaceWatch::~InterfaceWatch() = default;
void InterfaceWatch::readEvents() {}

#endif

}  // namespace deckpipe
