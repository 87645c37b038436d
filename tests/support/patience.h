// SPDX-License-Identifier: GPL-3.0-or-later
// How long a test waits for something that takes no time unless there is a fault.
#pragma once

namespace deckpipe {

inline constexpr int kPatience = 30'000;  // ms; only ever used up by a failure

}  // namespace deckpipe
