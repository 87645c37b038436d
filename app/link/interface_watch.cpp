// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/interface_watch.h"

#include <QSocketNotifier>

#include <linux/rtnetlink.h>
#include <sys/socket.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#ifdef __linux__
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

// The state that reader and worker share. The mutex guards all of it; nobody holds the mutex while reading.
struct InterfaceReader::Desk {
  std::mutex mutex;
  std::condition_variable changed;
  InterfaceReader* reader = nullptr;  // null once the reader was destroyed: the worker ends
  std::optional<std::string> question;
  int number = 0;  // of the newest question; forget() counts too, so that no answer fits any more
  std::optional<Answer> answer;  // to that question
};

InterfaceReader::InterfaceReader(Read read, QObject* parent)
    : QObject(parent), m_desk(std::make_shared<Desk>()), m_read(std::move(read)) {
  m_desk->reader = this;
}

InterfaceReader::~InterfaceReader() {
  {
    const std::lock_guard lock(m_desk->mutex);
    m_desk->reader = nullptr;
  }
  m_desk->changed.notify_one();
}

void InterfaceReader::request(const std::string& name) {
  forget();
  {
    const std::lock_guard lock(m_desk->mutex);
    m_desk->question = name;
  }
  m_desk->changed.notify_one();
  // Detached, as joining would wait for a read that hangs.
  if (m_read) std::thread([desk = m_desk, read = std::exchange(m_read, {})] { work(*desk, read); }).detach();
}

void InterfaceReader::forget() {
  const std::lock_guard lock(m_desk->mutex);
  ++m_desk->number;
  m_desk->question.reset();
  m_desk->answer.reset();
}

void InterfaceReader::work(Desk& desk, const Read& read) {
  std::unique_lock lock(desk.mutex);
  for (;;) {
    desk.changed.wait(lock, [&] { return desk.reader == nullptr || desk.question; });
    if (desk.reader == nullptr) return;
    const std::string name = *std::exchange(desk.question, std::nullopt);
    const int number = desk.number;
    lock.unlock();
    Answer answer = read(name);
    lock.lock();
    if (desk.reader == nullptr) return;
    if (desk.number != number) continue;
    desk.answer = std::move(answer);
    // The answer waits on the desk, and only the call is queued: nothing crosses threads but by the mutex.
    QMetaObject::invokeMethod(desk.reader, &InterfaceReader::handOver, Qt::QueuedConnection);
  }
}

void InterfaceReader::handOver() {
  std::optional<Answer> answer;
  {
    const std::lock_guard lock(m_desk->mutex);
    answer = std::exchange(m_desk->answer, std::nullopt);
  }
  if (answer) Q_EMIT answered(*answer);
}

}  // namespace deckpipe
