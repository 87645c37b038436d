// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/bus_threads.h"

#include <QDeadlineTimer>
#include <QThread>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "session/live_bus.h"
#include "session/worker_thread.h"

namespace deckpipe {

BusThreads::BusThreads(QObject* parent) : QObject(parent) {}

void BusThreads::start(QObject* worker, std::function<void()> start, std::function<void()> stop) {
  if (m_open == nullptr) {
    m_open = new QThread(this);
    m_open->setObjectName(QStringLiteral("bus"));
    m_open->start();
  }
  worker->moveToThread(m_open);
  connect(m_open, &QThread::finished, worker, std::move(stop));
  connect(m_open, &QThread::finished, worker, &QObject::deleteLater);
  QMetaObject::invokeMethod(worker, std::move(start), Qt::QueuedConnection);
}

void BusThreads::end(LiveBus* live, const std::shared_ptr<LogDocument>& document) {
  QThread* thread = std::exchange(m_open, nullptr);
  if (thread == nullptr) return;
  const std::uint64_t number = ++m_number;
  m_ending.push_back({number, thread, document});
  connect(thread, &QThread::finished, this, [this, number] { hasEnded(number); });
  QTimer::singleShot(kThreadPatience, this, [this, number] { hangs(number); });
  if (live != nullptr) {
    QMetaObject::invokeMethod(live, &LiveBus::close, Qt::QueuedConnection);
  } else {
    thread->quit();
  }
}

bool BusThreads::isWriting(const std::shared_ptr<LogDocument>& document) const {
  return std::ranges::find(m_ending, document, &Ending::document) != m_ending.end();
}

void BusThreads::whenEnded(std::function<void()> then) {
  m_whenEnded = std::move(then);
  if (m_whenEnded && std::ranges::all_of(m_ending, &Ending::hangs)) std::exchange(m_whenEnded, nullptr)();
}

std::shared_ptr<LogDocument> BusThreads::forget(std::uint64_t number) {
  const auto found = std::ranges::find(m_ending, number, &Ending::number);
  if (found == m_ending.end()) return {};
  auto document = std::move(found->document);
  found->thread->deleteLater();
  m_ending.erase(found);
  return isWriting(document) ? nullptr : document;
}

void BusThreads::hasEnded(std::uint64_t number) {
  if (const auto document = forget(number)) Q_EMIT ended(document);
  whenEnded(std::exchange(m_whenEnded, nullptr));
}

void BusThreads::hangs(std::uint64_t number) {
  const auto found = std::ranges::find(m_ending, number, &Ending::number);
  if (found == m_ending.end()) return;
  found->hangs = true;
  leaveThread(found->thread);
  whenEnded(std::exchange(m_whenEnded, nullptr));
}

std::vector<std::shared_ptr<LogDocument>> BusThreads::waitForEnd() {
  std::vector<std::shared_ptr<LogDocument>> ended;
  const QDeadlineTimer deadline(kThreadPatience);
  for (const Ending& bus : std::vector(m_ending)) {
    if (bus.hangs) continue;
    if (!bus.thread->wait(deadline)) {
      hangs(bus.number);
    } else if (auto document = forget(bus.number)) {
      ended.push_back(std::move(document));
    }
  }
  whenEnded(std::exchange(m_whenEnded, nullptr));
  return ended;
}

}  // namespace deckpipe
