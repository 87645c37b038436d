// SPDX-License-Identifier: GPL-3.0-or-later
// candump logs (the forms: candump_line.h), as a format of the table in log_format.h; and what writes one.
#pragma once

#include <string>
#include <string_view>

#include "log/candump_parser.h"
#include "log/text_format.h"

namespace deckpipe {

// One line of log form with its line feed, appended to `out`: what reading makes the same frame of, but for
// kConfirmed (the form knows sent or not) and kTimeJump (which the store works out). The stamp has six
// decimals, as can-utils reads nine as if they were microseconds; what is finer is cut off. A frame without a
// stamp becomes a line of the screen form, the only one that programs read without. The name is candumpName().
void writeCandump(const Frame& frame, std::string_view channelName, std::string& out);

// The name of a channel as it is read back: what would not be becomes '_'.
std::string candumpName(std::string_view channelName);

inline constexpr LogFormat kCandumpFormat =
    writable<writeCandump, candumpName>(textFormat<CandumpParser>("candump", "*.log *.txt *.candump"));

}  // namespace deckpipe
