// SPDX-License-Identifier: GPL-3.0-or-later
// The text of the trace's cells: identifiers, times and bytes as people who read buses write them.
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

// Frames of a log as rows of the trace: classified with the roles that hold there and put into words,
// once, so that the model only formats. Plain values; made for the rows that can be seen and few more.
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

// "1745600961.335462", a dash where the log has no time.
QString stampText(const Frame& frame);
// "12.500000": log time since the log's begin.
QString sinceText(Duration since);
// "0.000123", "8999.100"; empty for the first row.
QString deltaText(std::optional<Duration> delta);
// "18EFFF80", "5A4".
QString identifierText(const Frame& frame);
// "EF00"; empty for 11-bit and error frames.
QString pgnText(const Frame& frame);
// "80→FF", "33" (a broadcast without destination), "node 24"; empty where the identifier names nobody.
QString endsText(const Frame& frame);
// "01 1D 94"; of a remote frame what it asks for.
QString bytesText(const Frame& frame);
// "Rx", "Tx".
QString directionText(const Frame& frame);

// The Decoded cell's whole story, a line a field, what is off included.
QString detailText(const TraceRow& row);

}  // namespace deckpipe
