// SPDX-License-Identifier: GPL-3.0-or-later
// The filters of the file dialogs, made from the table of log formats.
#pragma once

#include <QStringList>

#include "log/log_format.h"

namespace deckpipe {

// "candump (*.log *.txt)", one a format; for opening, all logs first where there are several; for saving,
// what other programs read first.
QStringList filtersForOpening();
QStringList filtersForSaving();
QString filterOf(const LogFormat& format);
// The usual suffix of a filter, without the dot: "log".
QString suffixOf(const QString& filter);

}  // namespace deckpipe
