// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/interface_watch.h"

#include <QSocketNotifier>
#include <utility>

#ifdef __linux__
#include <linux/rtnetlink.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#endif

namespace deckpipe {

InterfaceWatch::InterfaceWatch(QObject* parent) : InterfaceSource(parent), m_reader(readInterface) {
  connect(&m_reader, &InterfaceReader::answered, this, &InterfaceWatch::answered);
}

InterfaceWatch::~InterfaceWatch() { stop(); }

void InterfaceWatch::request(const std::string& name) { m_reader.request(name); }

#ifdef __linux__

void InterfaceWatch::start() {
  if (m_socket >= 0) return;
  m_socket = ::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE);
  if (m_socket < 0) return;
  sockaddr_nl address{};
  address.nl_family = AF_NETLINK;
  address.nl_groups = RTMGRP_LINK;
  if (::bind(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) < 0) return stop();
  m_notifier = new QSocketNotifier(m_socket, QSocketNotifier::Read, this);
  connect(m_notifier, &QSocketNotifier::activated, this, &InterfaceWatch::readEvents);
}

void InterfaceWatch::stop() {
  m_reader.forget();
  if (m_notifier != nullptr) {
    m_notifier->setEnabled(false);
    std::exchange(m_notifier, nullptr)->deleteLater();  // it may be what called
  }
  if (m_socket >= 0) ::close(std::exchange(m_socket, -1));
  ++m_stops;
}

void InterfaceWatch::readEvents() {
  // A listener may stop and start again from inside; the rest of these news is then of no interest.
  const int stops = m_stops;
  bool isOverrun = false;
  std::array<std::byte, 32768> buffer;
  while (m_stops == stops) {
    const ssize_t size = ::recv(m_socket, buffer.data(), buffer.size(), 0);
    if (size < 0 && errno == ENOBUFS) {
      isOverrun = true;  // told last: the news that still wait are older than those that were lost
      continue;
    }
    if (size <= 0) break;
    const std::span<const std::byte> datagram(buffer.data(), static_cast<std::size_t>(size));
    for (const CanInterface& link : parseLinkMessages(datagram)) {
      if (m_stops == stops) Q_EMIT changed(link);
    }
  }
  if (isOverrun && m_stops == stops) Q_EMIT overrun();
}

#else

void InterfaceWatch::start() {}
void InterfaceWatch::stop() { m_reader.forget(); }
void InterfaceWatch::readEvents() {}

#endif

}  // namespace deckpipe
