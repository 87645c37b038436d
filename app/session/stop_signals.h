// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl+C, a polite kill and a terminal that is closed. For programs that run until they are stopped.
#pragma once

#include <functional>

namespace deckpipe {

// From here on: `stop` is called on the calling thread's event loop, each time. Once a program; call it
// before any other thread is started, which would take the signals otherwise.
void onStopSignals(std::function<void()> stop);

// The same for work without an event loop: from here on a signal only makes wasStopped() true.
void noteStopSignals();
bool wasStopped();

}  // namespace deckpipe
