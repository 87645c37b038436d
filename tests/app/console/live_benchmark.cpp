// SPDX-License-Identifier: GPL-3.0-or-later
// The whole window on a live link.
// aLiveBus, as busy as a bus can be: how long an event waits until the window's thread has time for it (99th
// percentile), what of a core window and bus thread take together, and that every frame that was sent is in
// the store. The first rate, that of one monitor, is the floor of the others: 80 % of 250 kbit/s, one and four
// channels full of 1 Mbit/s.
// frameToPixel: from the moment that a position frame is written to the bus until a pixel of the dial shows it.
// theQuietDemo: what of a core the demo takes, and the window's thread in that.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QRandomGenerator>
#include <QScreen>
#include <QSettings>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <QUrl>
#include <QWindow>
#include <atomic>
#include <cstdio>
#include <ctime>
#include <functional>

#include "app/console/event_waits.h"
#include "console/main_window.h"
#include "link/virtual_bus.h"
#include "paint/dial.h"
#include "support/child.h"

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
  // Writes one frame at once. `written` is called in the truck's thread just before.
  void write(const QByteArray& line, std::function<void()> written) {
    QMetaObject::invokeMethod(m_driver, [this, line, written = std::move(written)] {
      written();
      m_socket->write(line);
      m_socket->flush();
    });
  }
  std::uint64_t sent() const { return m_sent; }
  double cpu() const { return m_cpu; }

 protected:
  void run() override {
    VirtualBus bus;
    if (!bus.start()) std::abort();
    m_name = bus.interfaceName(0);
    const QUrl url(m_name);
    QTcpSocket socket;
    QObject driver;
    m_socket = &socket;
    m_driver = &driver;
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
      std::snprintf(line, sizeof line, "can0:%u#X#01%02X%02X0371000041\n", 0x18EFFF81 + n % 8, n >> 8 & 3,
                    n & 0xF8);
      lines += line;
    }
    socket.write(lines);
  }

  std::uint64_t m_rate;
  std::function<void()> m_beat;
  QString m_name;
  QTcpSocket* m_socket = nullptr;  // the thread's own, and so is the next
  QObject* m_driver = nullptr;
  std::atomic<bool> m_isReady = false, m_isOn = false;
  std::atomic<std::uint64_t> m_sent = 0;
  std::atomic<double> m_cpu = 0;
};

using test::percentile;
using test::runFor;

bool connectTo(const Truck& truck, Session& session) {
  LinkSettings link;
  link.plugin = QStringLiteral("virtualcan");
  link.interfaceName = truck.interfaceName();
  session.openLink(link);
  return QTest::qWaitFor(
      [&] { return session.snapshot().source.progress == SourceStatus::Progress::Running; });
}

// The processor's time of the process and of the window's thread over a stretch of time, less what the truck
// takes of it.
class Shares {
 public:
  explicit Shares(const Truck* truck = nullptr)
      : m_truck(truck), m_process(process()), m_window(cpuOf(CLOCK_THREAD_CPUTIME_ID)) {
    m_wall.start();
  }
  void putInto(benchmark::State& state) const {
    const double seconds = static_cast<double>(m_wall.nsecsElapsed()) * 1e-9;
    state.SetIterationTime(seconds);
    state.counters["core_%"] = 100 * (process() - m_process) / seconds;
    state.counters["window_%"] = 100 * (cpuOf(CLOCK_THREAD_CPUTIME_ID) - m_window) / seconds;
  }

 private:
  double process() const {
    return cpuOf(CLOCK_PROCESS_CPUTIME_ID) - (m_truck == nullptr ? 0 : m_truck->cpu());
  }
  const Truck* m_truck;
  QElapsedTimer m_wall;
  double m_process, m_window;
};

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
    if (!connectTo(truck, session)) return state.SkipWithError("no link");
    truck.drive(true);
    runFor(1000);
    waits.clear();
    const Shares shares(&truck);
    runFor(kMilliseconds);
    shares.putInto(state);
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

// Sees when a pixel of the dial, as the screen has it, takes the colour that a new position gives it.
class PixelWatch : public QObject {
 public:
  explicit PixelWatch(MainWindow& window) : m_window(window), m_dial(test::child<Dial>(window)) {
    m_dial->installEventFilter(this);
    m_clock.start();
  }
  QImage grab(QRect of) const {
    of.moveTopLeft(m_dial->mapTo(&m_window, of.topLeft()));
    return m_window.screen()
        ->grabWindow(m_window.winId(), of.x(), of.y(), of.width(), of.height())
        .toImage()
        .convertToFormat(QImage::Format_RGB32);
  }
  QImage grabDial() const { return grab(m_dial->rect()); }
  // False where the pictures do not differ.
  bool watchWhatDiffers(const QImage& a, const QImage& b) {
    int most = 0;
    for (int y = 0; y < std::min(a.height(), b.height()); ++y) {
      for (int x = 0; x < std::min(a.width(), b.width()); ++x) {
        const int difference = std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
        if (difference > most) m_pixel = {x, y};
        most = std::max(most, difference);
      }
    }
    return most > 32;
  }
  QPoint pixel() const { return m_pixel; }
  qint64 now() const { return m_clock.nsecsElapsed(); }
  // Milliseconds from `written`, which another thread sets, until the pixel has that colour; negative: never.
  double waitFor(QRgb colour, const std::atomic<qint64>& written) {
    m_awaited = colour;
    m_seen = -1;
    QElapsedTimer patience;
    patience.start();
    while (m_seen < 0 && patience.elapsed() < 1000) runFor(1);
    return m_seen < 0 ? -1 : static_cast<double>(m_seen - written) * 1e-6;
  }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    // The event comes before the painting; a posted call comes after it.
    if (event->type() == QEvent::Paint)
      QMetaObject::invokeMethod(
          this,
          [this] {
            if (m_seen < 0 && grab(QRect(m_pixel, QSize(1, 1))).pixel(0, 0) == m_awaited) m_seen = now();
          },
          Qt::QueuedConnection);
    return false;
  }

 private:
  MainWindow& m_window;
  Dial* m_dial;
  QElapsedTimer m_clock;
  QPoint m_pixel;
  QRgb m_awaited = 0;
  qint64 m_seen = -1;
};

void frameToPixel(benchmark::State& state) {
  constexpr int kTimes = 300;
  const QByteArray positions[] = {"can0:418381696#X#011D940371000041\n",
                                  "can0:418381696#X#01000C0371000041\n"};
  for (auto _ : state) {
    Truck truck(static_cast<std::uint64_t>(state.range(0)), [] {});
    if (!QTest::qWaitFor([&] { return truck.isReady(); })) return state.SkipWithError("no virtual bus");
    Session session;
    MainWindow window(session);
    window.resize(1366, 768);
    window.show();
    if (!connectTo(truck, session)) return state.SkipWithError("no link");
    truck.write("can0:418381696#X#FF83150206021A0B\n", [] {});
    runFor(500);
    truck.drive(true);
    PixelWatch watch(window);
    QImage shown[2];
    for (const int i : {0, 1}) {
      for (int again = 0; again < 10; ++again) {  // the position must not grow old
        truck.write(positions[i], [] {});
        runFor(50);
      }
      shown[i] = watch.grabDial();
    }
    if (!watch.watchWhatDiffers(shown[0], shown[1])) return state.SkipWithError("the dial shows no position");
    std::vector<double> waits;
    int never = 0;
    const Shares shares(&truck);
    for (int i = 0; i < kTimes; ++i) {
      runFor(QRandomGenerator::global()->bounded(10, 60));
      std::atomic<qint64> written = 0;
      truck.write(positions[i % 2], [&] { written = watch.now(); });
      const double wait = watch.waitFor(shown[i % 2].pixel(watch.pixel()), written);
      wait < 0 ? ++never : (waits.push_back(wait), 0);
    }
    shares.putInto(state);
    state.counters["p50_ms"] = percentile(waits, 0.5);
    state.counters["p99_ms"] = percentile(waits, 0.99);
    state.counters["worst_ms"] = percentile(waits, 1);
    state.counters["never"] = never;
  }
}
BENCHMARK(frameToPixel)->ArgName("frames/s")->Arg(100)->Arg(9'000)->Iterations(1)->UseManualTime();

void theQuietDemo(benchmark::State& state) {
  for (auto _ : state) {
    Session session;
    MainWindow window(session);
    window.resize(1366, 768);
    window.show();
    session.openDemo();
    runFor(3000);
    const Shares shares;
    runFor(kMilliseconds);
    shares.putInto(state);
  }
}
BENCHMARK(theQuietDemo)->Iterations(3)->UseManualTime();

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
