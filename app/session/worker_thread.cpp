// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/worker_thread.h"

#include <QThread>

namespace deckpipe {
namespace {

constexpr unsigned long kPatience =
    2'000;  // ms; links close within a few, what is said at the end takes 1 s at most

}  // namespace

bool endThread(QThread* thread, Quit quit) {
  if (thread == nullptr) return true;
  if (quit == Quit::Now) thread->quit();
  if (thread->wait(kPatience)) {
    delete thread;
    return true;
  }
  thread->setParent(nullptr);
  QObject::connect(thread, &QThread::finished, thread, &QObject::deleteLater);
  return false;
}

}  // namespace deckpipe
