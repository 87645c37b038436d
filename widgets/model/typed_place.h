// SPDX-License-Identifier: GPL-3.0-or-later
// A place in a log as a person types it: a time since the begin, a time of the log's clock, a way from the cursor,
// or in a log without times the number of a frame.
#pragma once

#include <QString>
#include <cstdint>
#include <variant>

#include "base/result.h"
#include "state/log_view.h"

namespace deckpipe {

// A log time, or behind so many frames.
using TypedPlace = std::variant<Instant, std::uint64_t>;

// "1:23.5" and "0:01:23.5" since the begin, "83.5", "83.5 s", "1 min 23 s"; "14:03:22" and "2023-11-14 14:03:22" local
// time; "+5", "-0.2", "+1:30" from the cursor. Otherwise a sentence that says what is wrong.
Result<TypedPlace, QString> placeOf(const QString& typed, const LogView& view);

// What can be typed for this log, in a sentence.
QString placeHelp(const LogView& view);

}  // namespace deckpipe
