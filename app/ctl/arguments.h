// SPDX-License-Identifier: GPL-3.0-or-later
// The command-line arguments of one subcommand, from a table of its options:
//
//   Arguments arguments(given, "What it does.\n");
//   arguments.add({{"json", "One JSON object a line."}, {"seconds", "Listen so long.", "N", "3"}});
//   if (const auto status = arguments.parse()) return *status;
//   const double seconds = arguments.seconds("seconds");
//   if (arguments.areBad()) return kBadUsage;
//
// The first argument that cannot be used is said on standard error. After that a value that was read means nothing.
#pragma once

#include <QCommandLineParser>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "base/ids.h"
#include "exit_status.h"

namespace deckpipe::ctl {

class Arguments {
 public:
  struct Option {
    const char* name;
    std::string help;
    const char* value = nullptr;  // what --help calls its value; null: it has none
    std::string byDefault{};
  };

  // `given`: what main() hands over, the first argument being "deckpipectl SUBCOMMAND".
  Arguments(const QStringList& given, const std::string& description);
  void add(const std::vector<Option>& options);
  // The one argument that is no option, and is needed.
  void addArgument(const char* name, const std::string& help);
  // The exit status where the arguments are no such ones, or where help or the version was asked for.
  std::optional<ExitStatus> parse();

  bool has(const char* name) const { return m_parser.isSet(QLatin1String(name)); }
  QString text(const char* name) const { return m_parser.value(QLatin1String(name)); }
  QStringList texts(const char* name) const { return m_parser.values(QLatin1String(name)); }
  QString argument() const { return m_parser.positionalArguments().value(0); }
  // Above 0, at most 1000000.
  double seconds(const char* name);
  std::uint64_t number(const char* name, std::uint64_t least, std::uint64_t most);
  Address address(const char* name);
  // Which of these words it is.
  std::size_t oneOf(const char* name, std::initializer_list<const char*> words);

  // "deckpipectl: SUBCOMMAND: …" on standard error; returns kBadUsage, for `return arguments.bad(…)`.
  ExitStatus bad(const QString& why);
  bool areBad() const { return m_areBad; }
  QString command() const { return m_given.constFirst().section(QLatin1Char(' '), 1); }

 private:
  QStringList m_given;
  QCommandLineParser m_parser;
  QString m_argument;
  bool m_areBad = false;
};

// An address in hex, 00..FD.
std::optional<Address> parseAddress(const QString& text);
// Two hex digits, in upper case: "F9".
QString addressText(Address address);

// Prints --help, --version or a table to standard output. Returns a failure if that cannot be written.
ExitStatus print(const std::string& text);
// "deckpipectl decode 0.1.0"
ExitStatus printVersion(const QString& program);

// The paragraph of every --help that lists the exit statuses.
std::string exitStatusHelp();

// "deckpipectl: …" on standard error; returns kBadUsage, for `return badUsage(…)`.
ExitStatus badUsage(const QString& message);

}  // namespace deckpipe::ctl
