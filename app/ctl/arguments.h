// SPDX-License-Identifier: GPL-3.0-or-later
// Command-line arguments of one subcommand: QCommandLineParser with our exit statuses and channel addresses.
#pragma once

#include <QCommandLineParser>
#include <optional>
#include <string>
#include <vector>

#include "base/ids.h"
#include "exit_status.h"

namespace deckpipe::ctl {

// "[CHANNEL:]ADDR", ADDR in hex 00..FD; without a channel it applies to all of them.
struct ChannelAddress {
  std::string channel;
  Address address;
};
std::optional<ChannelAddress> parseChannelAddress(const QString& text);

// Two hex digits, in upper case: "F9".
QString addressText(Address address);

// Parses what main() hands over, the first argument being "deckpipectl SUBCOMMAND"; where that fails, or
// where help or the version was asked for, says so and returns the exit status.
std::optional<ExitStatus> parse(QCommandLineParser& parser, const QStringList& arguments);

// Prints --help, --version or a table to standard output. Returns a failure if that cannot be written.
ExitStatus print(const std::string& text);
// "deckpipectl decode 0.1.0"
ExitStatus printVersion(const QString& program);

// The paragraph of every --help that lists the exit statuses.
std::string exitStatusHelp();

// "deckpipectl: …" on standard error; returns kBadUsage, for `return badUsage(…)`.
ExitStatus badUsage(const QString& message);

}  // namespace deckpipe::ctl
