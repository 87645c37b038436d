// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of a log as rows of the trace: classified with the roles that hold there and put into words,
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
  std::optional<Duration>
      delta;  // log time since the row before; none for the first of the log, or in one without times
  Classified what;
  QString title;
  QString summary;
  bool isSettled = false;  // nothing that is learned later of earlier frames can change what it is
};

// These frames of the log, which must have them, in order; `before` is the row before the first. What is
// settled, and words where a frame is classified alike, are taken over from `known`, also in order.
std::vector<TraceRow> readTraceRows(const LogDocument& log, std::span<const std::uint64_t> frames,
                                    std::optional<std::uint64_t> before,
                                    std::span<const TraceRow> known = {});

// What one frame is, where no rows are around it.
Classified classifyAt(const LogDocument& log, std::uint64_t index);

}  // namespace deckpipe
