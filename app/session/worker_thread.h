// SPDX-License-Identifier: GPL-3.0-or-later
// How threads that work with adapters end: a maker's library may hang for as long as it likes while it opens
// or lists, and the window must not hang with it.
#pragma once

class QThread;

namespace deckpipe {

enum class Quit : bool {
  Now,
  ByItself,  // it was told before to end its work and then its event loop
};

// Asks the thread's event loop to end, unless it does so by itself, and waits two seconds at most. A thread
// that hangs is left to itself: it owns what it works with (by its finished signal) and is gone when that
// returns; then this returns false. Null: nothing to do.
bool endThread(QThread* thread, Quit quit = Quit::Now);

}  // namespace deckpipe
