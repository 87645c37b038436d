// SPDX-License-Identifier: GPL-3.0-or-later
// The text of the trace's cells: identifiers, times and bytes as people who read buses write them.
#pragma once

#include <QString>
#include <optional>

#include "model/trace_rows.h"

namespace deckpipe {

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
