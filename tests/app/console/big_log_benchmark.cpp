// SPDX-License-Identifier: GPL-3.0-or-later
// The whole window on a log of ten million frames: what a person does by keys, and how long an event waits
// meanwhile until the window's thread has time for it (99th percentile), beside the same of a window in which
// nothing happens. The log is written to a temporary folder for the run.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>
#include <functional>
#include <memory>

#include "app/console/event_waits.h"
#include "console/main_window.h"
#include "panel/trace/id_view.h"
#include "panel/trace/trace_panel.h"
#include "support/child.h"

namespace deckpipe {
namespace {

constexpr std::uint64_t kFrames = 10'000'000;
constexpr int kPatience = 300'000;  // ms; only ever used up by a failure

// Eight monitors that turn, a joystick, limits and outputs, now and then a fault.
bool writeLog(const QString& path) {
  std::FILE* file = std::fopen(path.toLocal8Bit().constData(), "w");
  if (file == nullptr) return false;
  for (unsigned n = 0; n < kFrames; ++n) {
    const unsigned device = n / 8 % 8, angle = n >> 9 & 0xFFF;
    std::fprintf(file, "(17000%05u.%06u) can%u ", n / 5'000, n % 5'000 * 200, device & 1);
    switch (n % 8) {
      case 0:
        if (n < 64 || n % 80'000 == 0) {
          std::fprintf(file, "18EFFF%02X#FF83150206021A0B\n", 0x80 + device);
          break;
        }
        [[fallthrough]];
      case 1:
      case 2:
        std::fprintf(file, "18EFFF%02X#01%02X%X40371000041\n", 0x80 + device, angle >> 4, angle & 0xF);
        break;
      case 3: std::fprintf(file, "18EFFF%02X#81FED401C280\n", 0x80 + device); break;
      case 4: std::fprintf(file, "18EFFF%02X#83C05%u\n", 0x80 + device, n >> 12 & 7); break;
      case 5:
        std::fprintf(file, "18EF05%02X#02000000000%X\n", 0x80 + device, n % 40'000 < 8 ? 0xB : 0);
        break;
      default: std::fprintf(file, "0CFDD633#%02X7D046400%02X0000\n", n >> 3 & 0xFF, n >> 6 & 0xFF);
    }
  }
  return std::fclose(file) == 0;
}

struct BigLog {
  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("big.log"));
  Session session;
  MainWindow window{session};
  double idle = 0;  // how long events wait where nothing happens

  BigLog() {
    if (!writeLog(path)) std::abort();
    window.resize(1366, 768);
    window.show();
  }
  TracePanel& trace() const { return *test::child<TracePanel>(window); }
  TraceView& rows() const { return *trace().view(); }
  template <typename T>
  T* named(const char* name) const {
    return test::child<T>(window, name);
  }
};
std::unique_ptr<BigLog> theLog;

void wait(benchmark::State& state, const std::function<bool()>& isDone) {
  QElapsedTimer patience;
  patience.start();
  while (!isDone() && patience.elapsed() < kPatience) test::runFor(5);
  if (!isDone()) state.SkipWithError("it does not end");
}

// Does it once, and prints how events waited meanwhile.
void measure(benchmark::State& state, const std::function<void()>& act) {
  for (auto _ : state) {
    const test::EventWaits events;
    QElapsedTimer clock;
    clock.start();
    act();
    state.SetIterationTime(static_cast<double>(clock.nsecsElapsed()) * 1e-9);
    const double late = test::percentile(events.waits(), 0.99);
    if (theLog->idle == 0) theLog->idle = late;
    state.counters["wait_p99_ms"] = late;
    state.counters["wait_median_ms"] = test::percentile(events.waits(), 0.5);
    // Of the stretches that do something: most events are those that measure.
    std::vector<double> busy = events.stretches();
    std::erase_if(busy, [](double ms) { return ms < 0.5; });
    state.counters["busy_median_ms"] = test::percentile(busy, 0.5);
    state.counters["busy_p99_ms"] = test::percentile(busy, 0.99);
    state.counters["to_idle"] = late / theLog->idle;
  }
}

// A key so often as a keyboard repeats it, as the event queue gives it; then what that leaves to be painted.
void hold(Qt::Key key, int times) {
  for (int i = 0; i < times; ++i) {
    QTest::keyClick(&theLog->rows(), key);
    test::runFor(33);
  }
}

void nothing(benchmark::State& state) {
  measure(state, [] { test::runFor(3'000); });
}
void open(benchmark::State& state) {
  measure(state, [&] {
    theLog->session.openLog(theLog->path);
    wait(state, [] {
      const Snapshot& snapshot = theLog->session.snapshot();
      return snapshot.source.progress == SourceStatus::Progress::Done &&
             snapshot.view.state->cursor() == snapshot.view.cursor;
    });
  });
  state.counters["frames"] = static_cast<double>(theLog->session.snapshot().view.frameCount);
}
void openAndIdle(benchmark::State& state) {
  measure(state, [] { test::runFor(3'000); });
}
void scrollByPages(benchmark::State& state) {
  theLog->rows().setFocus();
  measure(state, [] {
    for (const Qt::Key key : {Qt::Key_Home, Qt::Key_PageDown, Qt::Key_End, Qt::Key_PageUp})
      hold(key, key == Qt::Key_Home || key == Qt::Key_End ? 1 : 60);
  });
}
void scrollByRows(benchmark::State& state) {
  measure(state, [] {
    for (const Qt::Key key : {Qt::Key_Home, Qt::Key_Down, Qt::Key_End, Qt::Key_Up})
      hold(key, key == Qt::Key_Home || key == Qt::Key_End ? 1 : 60);
  });
}
// As one who drags along the timeline.
void seek(benchmark::State& state) {
  measure(state, [] {
    for (std::uint64_t i = 0; i < 100; ++i) {
      theLog->session.seekFrames(i * 7'777'777 % kFrames);
      test::runFor(33);
    }
  });
}
void play(benchmark::State& state) {
  measure(state, [] {
    theLog->session.seekFrames(kFrames / 2);
    theLog->session.setSpeed(64);
    theLog->session.play();
    test::runFor(3'000);
    theLog->session.pause();
  });
}
void filter(benchmark::State& state, const char* expression) {
  measure(state, [&] {
    theLog->trace().setFilter(QLatin1String(expression));
    wait(state, [] { return !theLog->trace().model()->isFiltering(); });
  });
  state.counters["rows"] = static_cast<double>(theLog->trace().model()->rows());
}
void search(benchmark::State& state) {
  theLog->rows().setFocus();
  QTest::keyClick(&theLog->rows(), Qt::Key_Home);
  QTest::keyClick(&theLog->rows(), Qt::Key_F, Qt::ControlModifier);
  measure(state, [&] {
    theLog->named<QLineEdit>("traceSearch")->setText(QStringLiteral("nowhere to be found"));
    wait(state, [] {
      return !theLog->named<QLabel>("traceSearchSaid")->text().startsWith(QStringLiteral("Searching"));
    });
  });
  QTest::keyClick(theLog->named<QLineEdit>("traceSearch"), Qt::Key_Escape);
}
void byIdentifier(benchmark::State& state) {
  theLog->session.goToEnd();
  measure(state, [&] {
    theLog->named<QTabBar>("traceOrder")->setCurrentIndex(1);
    wait(state, [] {
      return !theLog->trace().ids()->rows()->isBehind() && theLog->trace().ids()->rows()->rowCount() > 0;
    });
  });
  theLog->named<QTabBar>("traceOrder")->setCurrentIndex(0);
}

#define ONCE ->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond)
BENCHMARK(nothing) ONCE;
BENCHMARK(open) ONCE;
BENCHMARK(openAndIdle) ONCE;
BENCHMARK(scrollByPages) ONCE;
BENCHMARK(scrollByRows) ONCE;
BENCHMARK(seek) ONCE;
BENCHMARK(play) ONCE;
BENCHMARK(search) ONCE;
BENCHMARK(byIdentifier) ONCE;
BENCHMARK_CAPTURE(filter, by_bytes, "sa=80 and type=01") ONCE;
BENCHMARK_CAPTURE(filter, by_field, "rotation_deg>30") ONCE;
BENCHMARK(scrollByPages)->Name("scrollByPages_filtered") ONCE;
BENCHMARK(byIdentifier)->Name("byIdentifier_filtered") ONCE;
BENCHMARK_CAPTURE(filter, none, "") ONCE;

}  // namespace
}  // namespace deckpipe

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  const QApplication application(argc, argv);
  benchmark::Initialize(&argc, argv);
  deckpipe::theLog = std::make_unique<deckpipe::BigLog>();
  benchmark::RunSpecifiedBenchmarks();
  deckpipe::theLog.reset();
}
