// SPDX-License-Identifier: GPL-3.0-or-later
// What can be filtered for by pointing at a cell of the trace: this identifier, PGN, source, message, value.
// For the trace panel's menu.
#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "state/log_view.h"

namespace deckpipe {

struct CellFilter {
  QString what;        // "ID 18EFFF80"
  QString expression;  // "id=18EFFF80"
};

// Of a frame of this log; `column` is one of TraceModel's, the value pointed at, or less than 0.
std::vector<CellFilter> cellFilters(const LogDocument& log, std::uint64_t frame, int column);

// Both must pass; nothing that is said twice is said twice.
QString narrowed(const QString& expression, const QString& by);
// What passes `without` is gone.
QString reduced(const QString& expression, const QString& without);

}  // namespace deckpipe
