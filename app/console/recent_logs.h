// SPDX-License-Identifier: GPL-3.0-or-later
// The logs that were opened or saved last, newest first, kept in the settings.
#pragma once

#include <QStringList>

namespace deckpipe {

inline constexpr int kMaxRecentLogs = 10;

QStringList recentLogs();
void rememberLog(const QString& path);
void forgetLogs();

}  // namespace deckpipe
