// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of deckpipectl. Each gets its own arguments and returns the exit status.
#pragma once

#include <QStringList>

namespace deckpipe::ctl {

// Exit statuses that scripts can trust.
inline constexpr int kDone = 0;
inline constexpr int kNotWhole = 1;  // something could not be read, written, answered or done
inline constexpr int kBadUsage = 2;  // unusable arguments

int decodeCommand(const QStringList& arguments);
int infoCommand(const QStringList& arguments);
int recordingsCommand(const QStringList& arguments);
int simulateCommand(const QStringList& arguments);
int nodesCommand(const QStringList& arguments);
int watchCommand(const QStringList& arguments);
int pollCommand(const QStringList& arguments);
int pipeCommand(const QStringList& arguments);
int commandCommand(const QStringList& arguments);

}  // namespace deckpipe::ctl
