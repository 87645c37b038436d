// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/adapter_scan.h"

#include <QThread>
#include <algorithm>
#include <utility>

#include "link/interface_watch.h"
#include "session/worker_thread.h"

namespace deckpipe {

AdapterScan::AdapterScan(QObject* parent) : QObject(parent) {
  m_timer.setInterval(kLookAgain);
  connect(&m_timer, &QTimer::timeout, this, &AdapterScan::look);
}

AdapterScan::~AdapterScan() { endThread(m_thread); }

void AdapterScan::setRunning(bool isRunning) {
  if (isRunning == m_timer.isActive()) return;
  if (!isRunning) {
    m_timer.stop();
    m_watch.reset();
    return;
  }
  m_timer.start();
  m_watch = std::make_unique<InterfaceWatch>();
  connect(m_watch.get(), &InterfaceWatch::changed, this, &AdapterScan::look, Qt::QueuedConnection);
  connect(m_watch.get(), &InterfaceWatch::overrun, this, &AdapterScan::look, Qt::QueuedConnection);
  m_watch->start();
  search();
}

void AdapterScan::search() {
  if (m_isSearching) return;
  m_isSearching = true;
  request(&listAdapters, &AdapterScan::found);
  Q_EMIT changed();
}

void AdapterScan::request(std::function<AdapterList()> question, void (AdapterScan::*answered)(AdapterList)) {
  if (m_thread == nullptr) {
    m_thread = new QThread(this);
    m_thread->setObjectName(QStringLiteral("adapters"));
    m_worker = new QObject;
    m_worker->moveToThread(m_thread);
    connect(m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    m_thread->start();
  }
  // The answer is a signal of an object that ends with the work, so that it cannot reach a destroyed scan.
  const auto list = std::make_shared<AdapterList>();
  const auto answer = std::make_shared<QObject>();
  connect(
      answer.get(), &QObject::destroyed, this, [this, list, answered] { (this->*answered)(*list); },
      Qt::QueuedConnection);
  answer->moveToThread(m_thread);
  QMetaObject::invokeMethod(
      m_worker, [answer, list, question = std::move(question)] { *list = question(); }, Qt::QueuedConnection);
}

void AdapterScan::found(AdapterList list) {
  m_isSearching = false;
  m_before = list;
  m_list = std::move(list);
  Q_EMIT changed();
}

void AdapterScan::look() {
  if (m_isSearching || std::exchange(m_isLooking, true)) return;
  request(
      [list = m_list] {
        AdapterList now = list;
        refreshInterfaces(now);
        return now;
      },
      &AdapterScan::looked);
}

void AdapterScan::looked(AdapterList list) {
  m_isLooking = false;
  m_before = std::exchange(m_list, std::move(list));
  Q_EMIT changed();
}

bool AdapterScan::isHeard(const Adapter& adapter) const {
  const auto before =
      std::find_if(m_before.adapters.begin(), m_before.adapters.end(), [&](const Adapter& other) {
        return other.plugin == adapter.plugin && other.interfaceName == adapter.interfaceName;
      });
  return before != m_before.adapters.end() && adapter.receivedFrames > before->receivedFrames;
}

}  // namespace deckpipe
