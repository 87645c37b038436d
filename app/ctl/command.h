// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of deckpipectl. Each gets its own arguments and returns the exit status.
#pragma once

#include <QStringList>

#include "exit_status.h"

namespace deckpipe::ctl {

ExitStatus decodeCommand(const QStringList& arguments);
ExitStatus eventsCommand(const QStringList& arguments);
ExitStatus infoCommand(const QStringList& arguments);
ExitStatus recordingsCommand(const QStringList& arguments);
ExitStatus simulateCommand(const QStringList& arguments);
ExitStatus nodesCommand(const QStringList& arguments);
ExitStatus watchCommand(const QStringList& arguments);
ExitStatus pollCommand(const QStringList& arguments);
ExitStatus pipeCommand(const QStringList& arguments);
ExitStatus commandCommand(const QStringList& arguments);

}  // namespace deckpipe::ctl
