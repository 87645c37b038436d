// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"

#include <QCommandLineParser>
#include <cstdio>

#include "log/log_format.h"

namespace deckpipe {
namespace {

constexpr int kBadUsage = 2;

// Status 1 if standard output does not take it.
int print(const QString& message) {
  if (std::fputs(qPrintable(message), stdout) >= 0 && std::fflush(stdout) == 0) return 0;
  std::perror("deckpipe: standard output");
  return 1;
}

int say(const QString& message) {
  std::fprintf(stderr, "deckpipe: %s\nTry 'deckpipe --help'.\n", qPrintable(message));
  return kBadUsage;
}

constexpr int kMostPixels = 16'384;  // of a picture, each way

std::optional<QSize> sizeOf(const QString& text) {
  const QStringList sides = text.split(u'x');
  if (sides.size() != 2) return {};
  const QSize size(sides[0].toInt(), sides[1].toInt());
  const bool isSize =
      size.width() > 0 && size.height() > 0 && size.width() <= kMostPixels && size.height() <= kMostPixels;
  return isSize ? std::optional(size) : std::nullopt;
}

}  // namespace

std::optional<int> parseOptions(const QStringList& arguments, Options& options) {
  QCommandLineParser parser;
  parser.setApplicationDescription(
      QCoreApplication::translate("options", "Diagnostic console for fire monitors on CAN."));
  const auto text = [](const char* english) { return QCoreApplication::translate("options", english); };
  parser.addPositionalArgument(
      QStringLiteral("LOG"),
      text("Log file to open (%1).").arg(QString::fromStdString(formatNames(LogUse::Read))),
      QStringLiteral("[LOG]"));
  const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")}, text("Show this help."));
  const QCommandLineOption version(QStringLiteral("version"), text("Show the version."));
  const QCommandLineOption demo(QStringLiteral("demo"), text("Start with the simulated truck."));
  const QCommandLineOption plugin(QStringLiteral("plugin"),
                                  text("Qt CAN bus plugin to connect with, e.g. socketcan."),
                                  QStringLiteral("PLUGIN"), QStringLiteral("socketcan"));
  const QCommandLineOption interfaceName(QStringLiteral("interface"),
                                         text("Interface to connect to, e.g. can0."), QStringLiteral("NAME"));
  const QCommandLineOption bitRate(QStringLiteral("bitrate"), text("Bit rate of the bus; 250000 by default."),
                                   QStringLiteral("BITS"), QStringLiteral("250000"));
  const QCommandLineOption theme(QStringLiteral("theme"), text("light, dark or sunlight."),
                                 QStringLiteral("THEME"));
  const QCommandLineOption density(
      QStringLiteral("density"), text("desk, or field: larger text and buttons."), QStringLiteral("DENSITY"));
  const QCommandLineOption grab(QStringLiteral("grab"), text("Save a picture of the window, then end."),
                                QStringLiteral("PNG"));
  const QCommandLineOption after(QStringLiteral("after"), text("Seconds until --grab; 5 by default."),
                                 QStringLiteral("SECONDS"), QStringLiteral("5"));
  const QCommandLineOption size(QStringLiteral("size"), text("Size of that picture; 1366x720 by default."),
                                QStringLiteral("WxH"), QStringLiteral("1366x720"));
  parser.addOptions({help, version, demo, plugin, interfaceName, bitRate, theme, density, grab, after, size});
  if (!parser.parse(arguments)) return say(parser.errorText());
  if (parser.isSet(help)) return print(parser.helpText());
  if (parser.isSet(version)) return print(QStringLiteral("deckpipe " DECKPIPE_VERSION "\n"));

  const QStringList logs = parser.positionalArguments();
  if (logs.size() > 1) return say(text("one log at a time"));
  if (!logs.isEmpty()) options.logFile = logs.first();
  options.demo = parser.isSet(demo);
  if (parser.isSet(interfaceName)) {
    bool ok = false;
    const int rate = parser.value(bitRate).toInt(&ok);
    if (!ok || rate < 0) return say(text("--bitrate wants bits a second"));
    options.link = LinkSettings{parser.value(plugin), parser.value(interfaceName), rate, {}};
  }
  if (int{!options.logFile.isEmpty()} + int{options.demo} + int{options.link.has_value()} > 1) {
    return say(text("a log, --demo or --interface: one of them"));
  }
  options.theme = parser.value(theme);
  if (!options.theme.isEmpty() &&
      !QStringList{QStringLiteral("light"), QStringLiteral("dark"), QStringLiteral("sunlight")}.contains(
          options.theme)) {
    return say(text("--theme is light, dark or sunlight"));
  }
  options.density = parser.value(density);
  if (!options.density.isEmpty() && options.density != QLatin1String("desk") &&
      options.density != QLatin1String("field")) {
    return say(text("--density is desk or field"));
  }
  options.grabFile = parser.value(grab);
  bool ok = false;
  options.grabAfter = parser.value(after).toDouble(&ok);
  if (!ok || !(options.grabAfter >= 0 && options.grabAfter <= 3600))
    return say(text("--after wants seconds"));
  const auto wanted = sizeOf(parser.value(size));
  if (!wanted) return say(text("--size wants pixels, such as 1366x768"));
  options.grabSize = *wanted;
  return {};
}

}  // namespace deckpipe
