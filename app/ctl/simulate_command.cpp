// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl simulate: the simulator on an interface in real time, or into a log at once.
#include <QCoreApplication>
#include <QFile>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <system_error>

#include "command.h"
#include "counts.h"
#include "link/adapters.h"
#include "link_words.h"
#include "live_options.h"
#include "log/log_format.h"
#include "log/sidecar.h"
#include "misbehave_option.h"
#include "moves_monitors.h"
#include "output.h"
#include "session/mark_keeper.h"
#include "session/simulator_runner.h"
#include "session/stop_signals.h"
#include "session/whole_file.h"

namespace deckpipe::ctl {
namespace {

// Logs start at a fixed wall-clock time, so that the same seed gives the same bytes.
constexpr std::int64_t kLogStart = 1'700'000'000'000'000'000;
constexpr int kMaxLoad = static_cast<int>(simulator::Background::kMax * 100);

// Hands over pieces of the log; false from `write` ends it. So does a signal, after which the frames that were
// made by then are the log.
bool simulateInto(simulator::StandardSimulator& simulator, double seconds, const LogFormat& format,
                  std::uint64_t& frames, const std::function<bool(const std::string&)>& write) {
  constexpr std::size_t kPiece = 1 << 20;
  const Instant end = Instant{} + Duration(std::llround(seconds * 1e9));
  const auto writer = format.makeWriter();
  std::string text;
  std::vector<simulator::DueFrame> due;
  writer->begin(text);
  writer->channel("can0", text);
  simulator.simulator.powerOn({});
  while (simulator.simulator.nextTime() <= end && !wasStopped()) {
    simulator.simulator.timeCame(simulator.simulator.nextTime());
    due.clear();
    simulator.simulator.takeFrames(due);
    for (simulator::DueFrame& frame : due) {
      frame.frame.stamp = kLogStart + frame.time.ns;
      writer->frame(frame.frame, Instant{frame.frame.stamp}, text);
    }
    frames += due.size();
    if (text.size() < kPiece) continue;
    if (!write(text)) return false;
    text.clear();
  }
  writer->end(text);
  return write(text);
}

ExitStatus written(const QString& path, std::uint64_t frames) {
  if (!wasStopped()) return kDone;
  std::fprintf(stderr, "deckpipectl: stopped; %s written to %s\n", framesThat(frames, "was", "were").c_str(),
               path == QLatin1String("-") ? "standard output" : qPrintable(path));
  return kNotWhole;
}

ExitStatus writeLog(simulator::StandardSimulator& simulator, double seconds, const QString& path,
                    bool replacesNotes) {
  const LogFormat& format = formatToWrite(path.toStdString());
  std::uint64_t frames = 0;
  noteStopSignals();
  if (path == QLatin1String("-")) {
    Output output;
    const bool isWhole = simulateInto(simulator, seconds, format, frames, [&](const std::string& text) {
      output.text() += text;
      return output.flush();
    });
    return isWhole ? written(path, frames) : kNotWhole;
  }
  // A regular file is replaced when all of it is there; a pipe or device is written to as it stands.
  const auto fail = [](const QString& file, const QString& reason) {
    std::fprintf(stderr, "deckpipectl: %s: %s\n", qPrintable(file), qPrintable(reason));
    return kNotWhole;
  };
  std::error_code none;
  const auto target = std::filesystem::status(QFile::encodeName(path).toStdString(), none);
  if (std::filesystem::exists(target) && !std::filesystem::is_regular_file(target)) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) return fail(path, file.errorString());
    QString reason;
    simulateInto(simulator, seconds, format, frames, [&](const std::string& text) {
      reason = writeAll(file, text);
      return reason.isEmpty();
    });
    return reason.isEmpty() ? written(path, frames) : fail(path, reason);
  }
  // A person's marks and labels of the log that is there. They may come while this is written.
  const auto hasNotes = [&] { return !replacesNotes && hasSidecar(QFile::encodeName(path).toStdString()); };
  const auto refuse = [&] {
    return badUsage(QStringLiteral("%1: the marks and labels of the log that is there would be lost; "
                                   "--replace-notes replaces both")
                        .arg(sidecarOf(path)));
  };
  if (hasNotes()) return refuse();
  WholeFile file(path);
  const bool isWritten =
      file.open() && simulateInto(simulator, seconds, format, frames,
                                  [&](const std::string& text) { return file.write(text); });
  if (isWritten && hasNotes()) return refuse();
  if (!isWritten || !file.commit()) return fail(path, file.reason());
  // The sidecar of the log that was there before is of no other log.
  QFile sidecar(sidecarOf(path));
  if (sidecar.exists() && !sidecar.remove()) return fail(sidecar.fileName(), sidecar.errorString());
  return written(path, frames);
}

ExitStatus runOnInterface(SimulatorRunner& runner, const LinkSettings& settings, bool movesMonitors) {
  ExitStatus status = kDone;
  QObject::connect(&runner, &SimulatorRunner::busReady, [&](const QString& interfaceName) {
    std::fprintf(stderr,
                 "deckpipectl: the simulated truck is on %s and drives every monitor there; Ctrl+C ends it\n",
                 qPrintable(interfaceName));
  });
  const auto say = [&](const QString& text) {
    std::fprintf(stderr, "deckpipectl: %s: %s\n", qPrintable(settings.interfaceName), qPrintable(text));
  };
  const auto fail = [&](const QString& reason) {
    say(reason);
    status = kNotWhole;
    QCoreApplication::quit();
  };
  QObject::connect(&runner, &SimulatorRunner::failed,
                   [&](const LinkError& why) { fail(linkErrorText(why)); });
  QObject::connect(&runner, &SimulatorRunner::lost, [&](const LinkError& why) {
    if (!isSocketCan(settings.plugin)) return fail(linkErrorText(why));
    say(linkErrorText(why) + QStringLiteral("; waiting for it."));
  });
  QObject::connect(&runner, &SimulatorRunner::wordMissing, [&] {
    status = badUsage(QStringLiteral("simulate: ") + movesMonitorsMissing(settings.interfaceName));
    QCoreApplication::quit();
  });
  QObject::connect(&runner, &SimulatorRunner::strangersHeard, [&](const std::vector<Stranger>& strangers) {
    fail(QStringLiteral("the simulated truck stays off this bus: heard ") + strangersText(strangers));
  });
  onStopSignals([] { QCoreApplication::quit(); });
  QMetaObject::invokeMethod(
      &runner, [&] { runner.start(settings, movesMonitors); }, Qt::QueuedConnection);
  QCoreApplication::exec();
  return status;
}

}  // namespace

ExitStatus simulateCommand(const QStringList& given) {
  Arguments arguments(
      given,
      R"(Simulates a truck: a 6032 monitor, a 6033 riser, a 6039 I/O module and a 6035 joystick whose
scripted hand drives the monitor; on an interface in real time, or into a log.
On an interface its joystick drives every monitor that hears it: never put it on a truck. Where real
monitors may be, it wants --moves-monitors, listens 1 s first, and stays off the bus if it hears an
Akron device, a joystick, or somebody at an address of its own.)");
  arguments.add({
      {"plugin", "Qt CAN bus plugin, e.g. socketcan.", "PLUGIN"},
      {"interface", "Interface of the plugin, e.g. vcan0.", "NAME"},
      bitRateOption(),
      movesMonitorsOption(),
      {"log", "Write a log instead (" + formatNames(LogUse::Write) + "); - is standard output.", "FILE"},
      {"replace-notes",
       "Replace a log that has a file of marks, notes and labels beside it, and remove that."},
      {"seconds", "Length of the log; 60 by default.", "N", "60"},
      {"seed", "The same seed gives the same truck; 1 by default.", "S", "1"},
      {"monitors",
       "So many 6032 monitors instead of one, up to " + std::to_string(simulator::kMaxMonitors) +
           "; about 40 fill a real bus of 250 kbit/s.",
       "N", "1"},
      {"load",
       "Other traffic that fills so much of the bus, up to " + std::to_string(kMaxLoad) +
           " per cent; none by default.",
       "PERCENT", "0"},
      {"misbehave",
       "What goes wrong, and from when on; may be given more than once. '--misbehave help' lists what there "
       "is.",
       "DEVICE:WHAT[=VALUE][@SECONDS]"},
  });
  if (const auto status = arguments.parse()) return *status;

  if (arguments.texts("misbehave").contains(QLatin1String("help")))
    return print(misbehaveTable().toStdString());

  const std::uint64_t seed = arguments.number("seed", 0, std::numeric_limits<std::uint64_t>::max());
  const double seconds = arguments.seconds("seconds");
  const auto monitors = static_cast<unsigned>(arguments.number("monitors", 1, simulator::kMaxMonitors));
  const int rate = bitRate(arguments);
  bool isLoad = false;
  const double percent = arguments.text("load").toDouble(&isLoad);
  if (!isLoad || !(percent >= 0) || percent > kMaxLoad)
    arguments.bad(QStringLiteral("--load wants per cent, 0 to %1").arg(kMaxLoad));
  const bool toLog = arguments.has("log"), hasPlugin = arguments.has("plugin");
  if (hasPlugin != arguments.has("interface"))
    arguments.bad(QStringLiteral("--plugin and --interface go together"));
  if (toLog == hasPlugin) arguments.bad(QStringLiteral("either --log, or --plugin and --interface"));
  if (arguments.areBad()) return kBadUsage;

  const LinkSettings link{arguments.text("plugin"), arguments.text("interface"), rate, {}};
  if (!toLog) {
    if (const auto trouble = pluginTrouble(link)) return arguments.bad(*trouble);
    if (const auto trouble = movesMonitorsTrouble(arguments, link)) return arguments.bad(*trouble);
  }

  SimulatorRunner runner(seed, monitors);
  MisbehavePlan plan(monitors);
  for (const QString& text : arguments.texts("misbehave")) {
    if (!plan.add(text))
      return arguments.bad(
          QStringLiteral("--misbehave '%1' is not understood; '--misbehave help' lists what is").arg(text));
  }
  plan.apply(runner.simulator());
  runner.simulator().simulator.fill({}, percent / 100, rate > 0 ? rate : 250'000);
  if (toLog)
    return writeLog(runner.simulator(), seconds, arguments.text("log"), arguments.has("replace-notes"));
  return runOnInterface(runner, link, arguments.has("moves-monitors"));
}

}  // namespace deckpipe::ctl
