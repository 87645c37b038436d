// SPDX-License-Identifier: GPL-3.0-or-later
// How threads that work with adapters end: a maker's library may hang for as long as it likes while it opens
// or lists, and the window must not hang with it.
#pragma once

#include <chrono>

class QThread;

namespace deckpipe {

// How long a thread that works with an adapter is waited for: links close within a few ms, and what services
// say at the end takes 1 s at most.
inline constexpr std::chrono::milliseconds kThreadPatience{2'000};

// A thread that hangs owns what it works with (by its finished signal). It is gone when that returns.
void leaveThread(QThread* thread);

// Asks the thread's event loop to end, waits kThreadPatience at most, and leaves a thread that hangs. Null:
// nothing to do.
void endThread(QThread* thread);

}  // namespace deckpipe
