// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the rule that no program moves a monitor without a word for it (session/stranger_watch.h), for
// the subcommands that could.
#pragma once

#include <QCommandLineOption>
#include <vector>

#include "session/stranger_watch.h"

namespace deckpipe::ctl {

// --moves-monitors
QCommandLineOption movesMonitorsOption();
// The sentence for badUsage() if --moves-monitors was left out.
QString movesMonitorsMissing(const QString& command, const QString& interfaceName);
// "1032AE100801035 (6032 Universal II) at address 80; a joystick at address 33"
QString strangersText(const std::vector<Stranger>& strangers);

}  // namespace deckpipe::ctl
