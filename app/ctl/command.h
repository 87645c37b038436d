// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of deckpipectl. Each gets its own arguments and returns the exit status.
#pragma once

#include <QStringList>

#include "exit_status.h"

namespace deckpipe::ctl {

ExitStatus decodeCommand(const QStringList& given);
ExitStatus eventsCommand(const QStringList& given);
ExitStatus infoCommand(const QStringList& given);
ExitStatus recordingsCommand(const QStringList& given);
ExitStatus simulateCommand(const QStringList& given);
ExitStatus nodesCommand(const QStringList& given);
ExitStatus watchCommand(const QStringList& given);
ExitStatus pollCommand(const QStringList& given);
ExitStatus pipeCommand(const QStringList& given);
ExitStatus commandCommand(const QStringList& given);
ExitStatus moveCommand(const QStringList& given);

}  // namespace deckpipe::ctl
