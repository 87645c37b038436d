// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"

#include <QCoreApplication>
#include <cstdio>

#include "output.h"

namespace deckpipe::ctl {

std::optional<ChannelAddress> parseChannelAddress(const QString& text) {
  const qsizetype colon = text.lastIndexOf(QLatin1Char(':'));
  bool ok = false;
  const uint address = text.mid(colon + 1).toUInt(&ok, 16);
  if (!ok || address > 0xFD || colon == 0) return {};
  return ChannelAddress{text.left(std::max<qsizetype>(colon, 0)).toStdString(),
                        {static_cast<std::uint8_t>(address)}};
}

QString addressText(Address address) {
  return QString::number(address.value, 16).toUpper().rightJustified(2, QLatin1Char('0'));
}

std::optional<ExitStatus> parse(QCommandLineParser& parser, const QStringList& arguments) {
  const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")},
                                QStringLiteral("Show this help."));
  const QCommandLineOption version(QStringLiteral("version"), QStringLiteral("Show the version."));
  parser.addOptions({help, version});
  if (!parser.parse(arguments)) return badUsage(parser.errorText());
  if (parser.isSet(help)) {
    // Qt names the program alone in the usage line.
    QString text = parser.helpText();
    const QString program = QCoreApplication::arguments().constFirst();
    if (const qsizetype at = text.indexOf(program); at >= 0)
      text.replace(at, program.size(), arguments.constFirst());
    return print(text.toStdString() + '\n' + exitStatusHelp());
  }
  if (parser.isSet(version)) return printVersion(arguments.constFirst());
  return {};
}

ExitStatus print(const std::string& text) {
  Output output;
  output.text() = text;
  return output.flush() ? kDone : kNotWhole;
}

ExitStatus printVersion(const QString& program) {
  return print(program.toStdString() + " " DECKPIPE_VERSION "\n");
}

std::string exitStatusHelp() {
  std::string text = "Exit status:\n";
  for (const ExitStatus status : kAllOf<ExitStatus>)
    text += "  " + std::to_string(status) + "  " + kExitMeanings[status] + '\n';
  return text;
}

ExitStatus badUsage(const QString& message) {
  std::fprintf(stderr, "deckpipectl: %s\nTry 'deckpipectl --help'.\n", qPrintable(message));
  return kBadUsage;
}

}  // namespace deckpipe::ctl
