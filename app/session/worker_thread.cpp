// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/worker_thread.h"

#include <QDeadlineTimer>
#include <QThread>

namespace deckpipe {

void leaveThread(QThread* thread) {
  thread->setParent(nullptr);
  QObject::connect(thread, &QThread::finished, thread, &QObject::deleteLater);
}

void endThread(QThread* thread) {
  if (thread == nullptr) return;
  thread->quit();
  if (thread->wait(QDeadlineTimer(kThreadPatience))) {
    delete thread;
  } else {
    leaveThread(thread);
  }
}

}  // namespace deckpipe
