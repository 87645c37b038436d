// SPDX-License-Identifier: GPL-3.0-or-later
// Whether frames of a log pass a filter, asked one after another from the log's first on: what a saving of
// the trace needs on its own thread, so that it saves what the filter shows without knowing filters.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "model/trace_filter.h"
#include "state/log_view.h"

namespace deckpipe {

// Empty where everything passes. Meanings come from the frames and notes themselves, as in the trace's sieve.
std::function<bool(std::uint64_t frame)> frameTest(std::shared_ptr<const LogDocument> log,
                                                   const TraceFilter& filter);

}  // namespace deckpipe
