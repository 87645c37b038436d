// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/interface_reader.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace deckpipe {

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
