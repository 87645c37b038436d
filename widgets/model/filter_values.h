// SPDX-License-Identifier: GPL-3.0-or-later
// What a test of the filter language (trace_filter.h) is compared with: words of an expression made into
// numbers, bytes, names and channels of a node, each key in its own way. Used by the parser alone.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>

#include "model/trace_filter.h"

namespace deckpipe {

// One more value of a test whose key and operator are known. What was expected instead, as a sentence; empty
// where it is taken.
QString takeFilterValue(FilterNode& node, const QString& text);

// 80, 0x80; nothing where it is no hex number.
std::optional<std::uint64_t> filterHexNumber(QString text);

}  // namespace deckpipe
