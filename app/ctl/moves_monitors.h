// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the rule that no program moves a monitor without a word for it (session/stranger_watch.h), for
// the subcommands that could.
#pragma once

#include <optional>
#include <vector>

#include "arguments.h"
#include "session/stranger_watch.h"

namespace deckpipe::ctl {

// --moves-monitors
Arguments::Option movesMonitorsOption();
// The sentence for bad() if --moves-monitors was left out.
QString movesMonitorsMissing(const QString& interfaceName);
// The same where it was, or where there is no such interface. It asks the system, and opens nothing.
std::optional<QString> movesMonitorsTrouble(const Arguments& arguments, const LinkSettings& link);
// Whether the interface is another than virtualcan's or a vcan, as its driver says. It asks the system, and opens nothing.
bool mayHoldRealMonitors(const LinkSettings& link);
// "1032AE100801035 (6032 Universal II) at address 80; a joystick at address 33"
QString strangersText(const std::vector<Stranger>& strangers);

}  // namespace deckpipe::ctl
