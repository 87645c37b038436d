// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/worker_thread.h"

#include <QThread>

namespace deckpipe {
namespace {

constexpr unsigned long kPatience = 2'000;  // ms; links close within a few

}  // namespace

void endThread(QThread* thread) {
  if (thread == nullptr) return;
  thread->quit();
  if (thread->wait(kPatience)) {
    delete thread;
    return;
  }
  thread->setParent(nullptr);
  QObject::connect(thread, &QThread::finished, thread, &QObject::deleteLater);
}

}  // namespace deckpipe
