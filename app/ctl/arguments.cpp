// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"

#include <QCoreApplication>
#include <algorithm>
#include <cstdio>
#include <utility>

#include "output.h"

namespace deckpipe::ctl {

Arguments::Arguments(const QStringList& given, const std::string& description) : m_given(given) {
  m_parser.setApplicationDescription(QString::fromStdString(description));
}

void Arguments::add(const std::vector<Option>& options) {
  for (const Option& option : options) {
    QCommandLineOption added(QLatin1String(option.name), QString::fromStdString(option.help));
    if (option.value != nullptr) added.setValueName(QLatin1String(option.value));
    if (!option.byDefault.empty()) added.setDefaultValue(QString::fromStdString(option.byDefault));
    m_parser.addOption(added);
  }
}

void Arguments::addArgument(const char* name, const std::string& help) {
  m_argument = QLatin1String(name);
  m_parser.addPositionalArgument(m_argument, QString::fromStdString(help));
}

std::optional<ExitStatus> Arguments::parse() {
  const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")},
                                QStringLiteral("Show this help."));
  const QCommandLineOption version(QStringLiteral("version"), QStringLiteral("Show the version."));
  m_parser.addOptions({help, version});
  if (!m_parser.parse(m_given)) return badUsage(m_parser.errorText());
  if (m_parser.isSet(help)) {
    // Qt names the program alone in the usage line.
    QString text = m_parser.helpText();
    const QString program = QCoreApplication::arguments().constFirst();
    if (const qsizetype at = text.indexOf(program); at >= 0)
      text.replace(at, program.size(), m_given.constFirst());
    return print(text.toStdString() + '\n' + exitStatusHelp());
  }
  if (m_parser.isSet(version)) return printVersion(m_given.constFirst());
  const qsizetype count = m_parser.positionalArguments().size();
  if (m_argument.isEmpty() && count != 0) return bad(QStringLiteral("takes options only"));
  if (!m_argument.isEmpty() && count != 1) return bad(QStringLiteral("one %1 is wanted").arg(m_argument));
  return {};
}

double Arguments::seconds(const char* name) {
  bool ok = false;
  const double seconds = text(name).toDouble(&ok);
  if (!ok || !(seconds > 0) || seconds > 1e6)
    bad(QStringLiteral("--%1 wants a number of seconds above 0, at most 1000000").arg(QLatin1String(name)));
  return seconds;
}

std::uint64_t Arguments::number(const char* name, std::uint64_t least, std::uint64_t most) {
  bool ok = false;
  const std::uint64_t number = text(name).toULongLong(&ok);
  if (!ok || number < least || number > most)
    bad(QStringLiteral("--%1 wants a number from %2 to %3").arg(QLatin1String(name)).arg(least).arg(most));
  return number;
}

Address Arguments::address(const char* name) {
  const auto address = parseAddress(text(name));
  if (!address) bad(QStringLiteral("--%1 wants an address in hex, 00 to FD").arg(QLatin1String(name)));
  return address.value_or(kNullAddress);
}

std::size_t Arguments::oneOf(const char* name, std::initializer_list<const char*> words) {
  const QString word = text(name);
  const auto found =
      std::ranges::find_if(words, [&](const char* known) { return word == QLatin1String(known); });
  if (found == words.end()) {
    QStringList known;
    for (const char* each : words) known << QLatin1String(each);
    bad(QStringLiteral("--%1 '%2' is none of %3")
            .arg(QLatin1String(name), word, known.join(QStringLiteral(", "))));
  }
  return static_cast<std::size_t>(found - words.begin());
}

ExitStatus Arguments::bad(const QString& why) {
  return std::exchange(m_areBad, true) ? kBadUsage : badUsage(command() + QStringLiteral(": ") + why);
}

std::optional<Address> parseAddress(const QString& text) {
  bool ok = false;
  const uint value = text.toUInt(&ok, 16);
  if (!ok || value > 0xFD) return {};
  return Address{static_cast<std::uint8_t>(value)};
}

QString addressText(Address address) {
  return QString::number(address.value, 16).toUpper().rightJustified(2, QLatin1Char('0'));
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
