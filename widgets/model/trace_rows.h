// SPDX-License-Identifier: GPL-3.0-or-later
// A stretch of a log as rows of the trace: classified with the roles that hold there and put into words,
// once, so that the model only formats. Plain values; made for the rows that can be seen and few more.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/time.h"
#include "bus/frame.h"
#include "protocol/classify.h"
#include "state/log_view.h"

namespace deckpipe {

struct TraceRow {
  std::uint64_t index = 0;  // in the log
  Frame frame;
  std::optional<Duration> delta;  // log time since the row before; none for the first of the log
  Classified what;
  QString title;
  QString summary;
};

// Rows [first, first + count), which the log must have. Words are taken over from `known` where a row there
// is of the same frame and was classified alike.
std::vector<TraceRow> readTraceRows(const LogDocument& log, std::uint64_t first, std::size_t count,
                                    std::span<const TraceRow> known = {});

// What one frame is, where no rows are around it.
Classified classifyAt(const LogDocument& log, std::uint64_t index);

}  // namespace deckpipe
