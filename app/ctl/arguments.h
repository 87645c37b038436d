// SPDX-License-Identifier: GPL-3.0-or-later
// Command-line arguments of one subcommand: QCommandLineParser with our exit statuses and channel addresses.
#pragma once

#include <QCommandLineParser>
#include <optional>
#include <string>
#include <vector>

#include "base/ids.h"

namespace deckpipe::ctl {

// "[CHANNEL:]ADDR", ADDR in hex 00..FD; without a channel it holds on all of them.
struct ChannelAddress {
  std::string channel;
  Address address;
};
std::optional<ChannelAddress> parseChannelAddress(const QString& text);

// Two hex digits, in upper case: "F9".
QString addressText(Address address);

// Parses what main() hands over, the first argument being "deckpipectl SUBCOMMAND"; where that fails, or
// where help was asked for, says so and returns the exit status.
std::optional<int> parse(QCommandLineParser& parser, const QStringList& arguments);

// "deckpipectl: …" on standard error; returns kBadUsage, for `return badUsage(…)`.
int badUsage(const QString& message);

}  // namespace deckpipe::ctl
