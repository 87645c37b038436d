// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl simulate: the simulator on an interface in real time, or into a log at once.
#include <QCoreApplication>
#include <QFileInfo>
#include <QSaveFile>
#include <cmath>
#include <cstdio>
#include <functional>

#include "arguments.h"
#include "command.h"
#include "counts.h"
#include "link/plugins.h"
#include "link_words.h"
#include "live_options.h"
#include "log/log_format.h"
#include "log/sidecar.h"
#include "misbehave_option.h"
#include "moves_monitors.h"
#include "output.h"
#include "session/simulator_runner.h"
#include "signals.h"

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

ExitStatus writeLog(simulator::StandardSimulator& simulator, double seconds, const QString& path) {
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
  const QFileInfo target(path);
  QSaveFile whole(path);
  QFile asItStands(path);
  const bool replaces = !target.exists() || target.isFile();
  QFileDevice& file = replaces ? static_cast<QFileDevice&>(whole) : asItStands;
  const auto write = [&](const std::string& text) {
    return file.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size());
  };
  const bool isWhole = file.open(QIODevice::WriteOnly) &&
                       simulateInto(simulator, seconds, format, frames, write) &&
                       (replaces ? whole.commit() : asItStands.flush());
  if (isWhole) {
    // The sidecar of a log that was there before is of no other log.
    QFile::remove(path + QLatin1String(kSidecarSuffix.data(), kSidecarSuffix.size()));
    return written(path, frames);
  }
  std::fprintf(stderr, "deckpipectl: %s: %s\n", qPrintable(path), qPrintable(file.errorString()));
  return kNotWhole;
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
    status = badUsage(movesMonitorsMissing(QStringLiteral("simulate"), settings.interfaceName));
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

ExitStatus simulateCommand(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral(
      "Simulates a truck: a 6032 monitor, a 6033 riser, a 6039 I/O module and a 6035 joystick whose\n"
      "scripted hand drives the monitor; on an interface in real time, or into a log.\n"
      "On an interface its joystick drives every monitor that hears it: never put it on a truck. Where real\n"
      "monitors may be, it wants --moves-monitors, listens 1 s first, and stays off the bus if it hears an\n"
      "Akron device, a joystick, or somebody at an address of its own."));
  const QCommandLineOption plugin(QStringLiteral("plugin"),
                                  QStringLiteral("Qt CAN bus plugin, e.g. socketcan."),
                                  QStringLiteral("PLUGIN"));
  const QCommandLineOption interfaceName(QStringLiteral("interface"),
                                         QStringLiteral("Interface of the plugin, e.g. vcan0."),
                                         QStringLiteral("NAME"));
  const QCommandLineOption bitRate(QStringLiteral("bitrate"),
                                   QStringLiteral("Bit rate to ask for; 250000 by default, 0 as it is."),
                                   QStringLiteral("BITS"), QStringLiteral("250000"));
  const QCommandLineOption log(QStringLiteral("log"),
                               QStringLiteral("Write a log instead (%1); - is standard output.")
                                   .arg(QString::fromStdString(formatNames(LogUse::Write))),
                               QStringLiteral("FILE"));
  const QCommandLineOption seconds(QStringLiteral("seconds"),
                                   QStringLiteral("Length of the log; 60 by default."), QStringLiteral("N"),
                                   QStringLiteral("60"));
  const QCommandLineOption seed(QStringLiteral("seed"),
                                QStringLiteral("The same seed gives the same truck; 1 by default."),
                                QStringLiteral("S"), QStringLiteral("1"));
  const QCommandLineOption misbehave(QStringLiteral("misbehave"), misbehaveHelp(),
                                     QStringLiteral("DEVICE:WHAT[=VALUE][@SECONDS]"));
  const QCommandLineOption monitors(
      QStringLiteral("monitors"),
      QStringLiteral(
          "So many 6032 monitors instead of one, up to %1; about 40 fill a real bus of 250 kbit/s.")
          .arg(simulator::kMaxMonitors),
      QStringLiteral("N"), QStringLiteral("1"));
  const QCommandLineOption load(
      QStringLiteral("load"),
      QStringLiteral("Other traffic that fills so much of the bus, up to %1 per cent; none by default.")
          .arg(kMaxLoad),
      QStringLiteral("PERCENT"), QStringLiteral("0"));
  const QCommandLineOption moves = movesMonitorsOption();
  parser.addOptions({plugin, interfaceName, bitRate, moves, log, seconds, seed, monitors, load, misbehave});
  if (const auto status = parse(parser, arguments)) return *status;
  if (!parser.positionalArguments().isEmpty())
    return badUsage(QStringLiteral("simulate: takes options only"));

  if (parser.values(misbehave).contains(QLatin1String("help"))) return print(misbehaveTable().toStdString());

  bool monitorsOk = false, seedOk = false, secondsOk = false, rateOk = false;
  const quint64 seedValue = parser.value(seed).toULongLong(&seedOk);
  const double secondsValue = parser.value(seconds).toDouble(&secondsOk);
  const unsigned monitorCount = parser.value(monitors).toUInt(&monitorsOk);
  const int rate = parser.value(bitRate).toInt(&rateOk);
  if (!seedOk) return badUsage(QStringLiteral("simulate: --seed wants a whole number"));
  if (!secondsOk || !(secondsValue > 0) || secondsValue > 1e6) {
    return badUsage(QStringLiteral("simulate: --seconds wants a number above 0, at most 1000000"));
  }
  if (!monitorsOk || monitorCount < 1 || monitorCount > simulator::kMaxMonitors) {
    return badUsage(
        QStringLiteral("simulate: --monitors wants a number from 1 to %1").arg(simulator::kMaxMonitors));
  }
  if (!rateOk || rate < 0) return badUsage(QStringLiteral("simulate: --bitrate wants bits a second"));
  bool loadOk = false;
  const double percent = parser.value(load).toDouble(&loadOk);
  if (!loadOk || !(percent >= 0) || percent > kMaxLoad)
    return badUsage(QStringLiteral("simulate: --load wants per cent, 0 to %1").arg(kMaxLoad));
  const bool toLog = parser.isSet(log);
  if (toLog == (parser.isSet(plugin) || parser.isSet(interfaceName))) {
    return badUsage(QStringLiteral("simulate: either --log, or --plugin and --interface"));
  }
  if (!toLog && !(parser.isSet(plugin) && parser.isSet(interfaceName))) {
    return badUsage(QStringLiteral("simulate: --plugin and --interface go together"));
  }

  const LinkSettings link{parser.value(plugin), parser.value(interfaceName), rate, {}};
  if (!toLog) {
    if (const auto trouble = pluginTrouble(link)) return badUsage(QStringLiteral("simulate: ") + *trouble);
    std::optional<CanInterface> facts;
    if (isSocketCan(link.plugin)) {
      const auto read = readInterface(link.interfaceName.toStdString());
      if (!read || !read.value().isCan)
        return badUsage(QStringLiteral("simulate: no such CAN interface: '%1'").arg(link.interfaceName));
      facts = read.value();
    }
    if (!parser.isSet(moves) && !isSimulatedBus(link, facts))
      return badUsage(movesMonitorsMissing(QStringLiteral("simulate"), link.interfaceName));
  }

  SimulatorRunner runner(seedValue, monitorCount);
  MisbehavePlan plan(monitorCount);
  for (const QString& text : parser.values(misbehave)) {
    if (!plan.add(text))
      return badUsage(
          QStringLiteral("simulate: --misbehave '%1' is not understood; '--misbehave help' lists what is")
              .arg(text));
  }
  plan.apply(runner.simulator());
  runner.simulator().simulator.fill({}, percent / 100, rate > 0 ? rate : 250'000);
  if (toLog) return writeLog(runner.simulator(), secondsValue, parser.value(log));
  return runOnInterface(runner, link, parser.isSet(moves));
}

}  // namespace deckpipe::ctl
