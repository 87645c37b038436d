// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/stop_signals.h"

#include <QCoreApplication>
#include <csignal>
#include <thread>
#include <utility>

namespace deckpipe {
namespace {

volatile std::sig_atomic_t g_wasStopped = 0;

}  // namespace

// A thread waits for them, as a handler may do next to nothing.
void onStopSignals(std::function<void()> stop) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGHUP);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals, stop = std::move(stop)] {
    for (int caught = 0; sigwait(&signals, &caught) == 0;) {
      if (auto* program = QCoreApplication::instance())
        QMetaObject::invokeMethod(program, stop, Qt::QueuedConnection);
    }
  }).detach();
}

void noteStopSignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, [](int) { g_wasStopped = 1; });
}

bool wasStopped() { return g_wasStopped != 0; }

}  // namespace deckpipe
