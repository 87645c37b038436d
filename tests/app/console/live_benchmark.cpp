// SPDX-License-Identifier: GPL-3.0-or-later
// The whole window on a live link, as busy as a bus can be: how long an event waits until the window's thread
// has time for it (99th percentile), what of a core window and bus thread take together, and that every frame
// that was sent is in the store. The first rate, that of one monitor, is the floor of the others: 80 % of 250
// kbit/s, one and four channels full of 1 Mbit/s.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QSettings>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <QUrl>
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <ctime>
#include <functional>

#include "console/main_window.h"
#include "link/virtual_bus.h"

namespace deckpipe {
namespace {

constexpr int kMilliseconds = 10'000;

double cpuOf(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

// A bus and who sends on it, in a thread whose time is not the console's.
class Truck : public QThread {
 public:
  // Every five milliseconds `beat` is called in its thread, while somebody drives.
  Truck(std::uint64_t rate, std::function<void()> beat) : m_rate(rate), m_beat(std::move(beat)) { start(); }
  ~Truck() override {
    quit();
    wait();
  }
  bool isReady() const { return m_isReady; }
  QString interfaceName() const { return m_name; }
  void drive(bool isOn) { m_isOn = isOn; }
  std::uint64_t sent() const { return m_sent; }
  double cpu() const { return m_cpu; }

 protected:
  void run() override {
    VirtualBus bus;
    if (!bus.start()) std::abort();
    m_name = bus.interfaceName(0);
    const QUrl url(m_name);
    QTcpSocket socket;
    QObject::connect(&socket, &QTcpSocket::readyRead, &socket, [&] { socket.readAll(); });  // its echoes
    socket.connectToHost(url.host(), static_cast<quint16>(url.port()));
    socket.write("connect:can0\n");
    QElapsedTimer since;
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer, &QTimer::timeout, &socket, [&] {
      m_cpu = cpuOf(CLOCK_THREAD_CPUTIME_ID);
      if (!m_isOn) return since.invalidate();
      if (!since.isValid()) since.start();
      send(socket, static_cast<std::uint64_t>(since.elapsed()) * m_rate / 1000);
      m_beat();
    });
    timer.start(5);
    m_isReady = true;
    exec();
  }

 private:
  void send(QTcpSocket& socket, std::uint64_t due) {
    QByteArray lines;
    char line[64];
    for (; m_sent < due; ++m_sent) {
      const auto n = static_cast<unsigned>(m_sent);
      std::snprintf(line, sizeof line, "can0:%u#X#01%02X%02X0371000041\n", 0x18EFFF80 + n % 8, n >> 8 & 3,
                    n & 0xF8);
      lines += line;
    }
    socket.write(lines);
  }

  std::uint64_t m_rate;
  std::function<void()> m_beat;
  QString m_name;
  std::atomic<bool> m_isReady = false, m_isOn = false;
  std::atomic<std::uint64_t> m_sent = 0;
  std::atomic<double> m_cpu = 0;
};

double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

// Unlike QTest::qWait(), which sleeps between events.
void runFor(int milliseconds) {
  QEventLoop loop;
  QTimer::singleShot(milliseconds, Qt::PreciseTimer, &loop, &QEventLoop::quit);
  loop.exec();
}

void aLiveBus(benchmark::State& state) {
  static double floorOfWaits = 0;
  for (auto _ : state) {
    QObject here;
    QElapsedTimer clock;
    clock.start();
    std::vector<double> waits;  // milliseconds
    Truck truck(static_cast<std::uint64_t>(state.range(0)), [&] {
      QMetaObject::invokeMethod(
          &here,
          [&, posted = clock.nsecsElapsed()] {
            waits.push_back(static_cast<double>(clock.nsecsElapsed() - posted) * 1e-6);
          },
          Qt::QueuedConnection);
    });
    if (!QTest::qWaitFor([&] { return truck.isReady(); })) return state.SkipWithError("no virtual bus");
    Session session;
    MainWindow window(session);
    window.resize(1366, 768);
    window.show();
    LinkSettings link;
    link.plugin = QStringLiteral("virtualcan");
    link.interfaceName = truck.interfaceName();
    session.openLink(link);
    if (!QTest::qWaitFor(
            [&] { return session.snapshot().source.progress == SourceStatus::Progress::Running; }))
      return state.SkipWithError("no link");
    truck.drive(true);
    runFor(1000);
    waits.clear();
    const auto console = [&] { return cpuOf(CLOCK_PROCESS_CPUTIME_ID) - truck.cpu(); };
    const double before = console(), windowBefore = cpuOf(CLOCK_THREAD_CPUTIME_ID);
    QElapsedTimer wall;
    wall.start();
    runFor(kMilliseconds);
    const double seconds = static_cast<double>(wall.nsecsElapsed()) * 1e-9;
    state.SetIterationTime(seconds);
    state.counters["core_%"] = 100 * (console() - before) / seconds;
    state.counters["window_%"] = 100 * (cpuOf(CLOCK_THREAD_CPUTIME_ID) - windowBefore) / seconds;
    truck.drive(false);
    const double late = percentile(waits, 0.99);
    if (floorOfWaits == 0) floorOfWaits = late;
    state.counters["wait_p99_ms"] = late;
    state.counters["wait_median_ms"] = percentile(waits, 0.5);
    state.counters["to_floor"] = late / floorOfWaits;
    runFor(500);
    const Snapshot& seen = session.snapshot();
    state.counters["sent"] = static_cast<double>(truck.sent());
    state.counters["lost"] = static_cast<double>(truck.sent()) - static_cast<double>(seen.view.frameCount);
  }
}
BENCHMARK(aLiveBus)
    ->ArgName("frames/s")
    ->Arg(30)
    ->Arg(1'600)
    ->Arg(9'000)
    ->Arg(36'000)
    ->Iterations(1)
    ->UseManualTime();

}  // namespace
}  // namespace deckpipe

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  const QApplication application(argc, argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
