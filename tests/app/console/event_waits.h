// SPDX-License-Identifier: GPL-3.0-or-later
// How long events wait until the window's thread has time for them: what a person feels as a stall. For the
// benchmarks of the whole window.
#pragma once

#include <QAbstractEventDispatcher>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QThread>
#include <QTimer>
#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

namespace deckpipe::test {

inline double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

// Unlike QTest::qWait(), which sleeps between events.
inline void runFor(int milliseconds) {
  QEventLoop loop;
  QTimer::singleShot(milliseconds, Qt::PreciseTimer, &loop, &QEventLoop::quit);
  loop.exec();
}

// Posts an event every few milliseconds from a thread of its own, as long as it lives; and measures by the
// processor's time, which other programs do not change, how long the window's thread is busy at a stretch.
class EventWaits {
 public:
  EventWaits() {
    m_clock.start();
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(kEveryMs);
    m_timer.moveToThread(&m_thread);
    QObject::connect(&m_thread, &QThread::started, &m_timer, qOverload<>(&QTimer::start));
    QObject::connect(&m_thread, &QThread::finished, &m_timer, &QTimer::stop);
    QObject::connect(
        &m_timer, &QTimer::timeout, &m_timer,
        [this] {
          const qint64 posted = m_clock.nsecsElapsed();
          QMetaObject::invokeMethod(
              &m_here,
              [this, posted] {
                m_waits.push_back(static_cast<double>(m_clock.nsecsElapsed() - posted) * 1e-6);
              },
              Qt::QueuedConnection);
        },
        Qt::DirectConnection);
    // Once a turn of the event loop; while it sleeps it takes no processor.
    QObject::connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::awake, &m_here, [this] {
      const double now = threadTime();
      m_stretches.push_back(now - std::exchange(m_awake, now));
    });
    m_thread.start();
  }
  ~EventWaits() {
    m_thread.quit();
    m_thread.wait();
  }
  // In milliseconds.
  const std::vector<double>& waits() const { return m_waits; }
  const std::vector<double>& stretches() const { return m_stretches; }

 private:
  static constexpr int kEveryMs = 2;

  static double threadTime() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
  }

  double m_awake = threadTime();
  std::vector<double> m_stretches;
  QElapsedTimer m_clock;
  std::vector<double> m_waits;
  QObject m_here;
  QTimer m_timer;
  QThread m_thread;
};

}  // namespace deckpipe::test
