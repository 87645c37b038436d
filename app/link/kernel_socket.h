// SPDX-License-Identifier: GPL-3.0-or-later
// The socket behind Qt's socketcan plugin, which itself never says when the kernel had to drop frames, and
// asks for stamps only once it has read the first frame. CanLink finds the descriptor by the plugin's
// QSocketNotifier. Linux only.
#pragma once

#include <cstdint>
#include <optional>

namespace deckpipe {

struct ReceiveBuffer {
  std::uint32_t bytes = 0;  // its size; the kernel counts some 800 bytes for a classic CAN frame
  std::uint32_t used = 0;
  std::uint32_t drops = 0;  // frames dropped since the socket was opened; wraps
};

// nullopt if the kernel does not tell.
std::optional<ReceiveBuffer> readReceiveBuffer(int descriptor);

// Requests a receive buffer of `bytes`. The system's limit (net.core.rmem_max) may give less; failure is ignored.
void growReceiveBuffer(int descriptor, int bytes);

// Has the kernel stamp frames when they arrive. Without it, frames that wait when the first one is read get the
// time at which they are read.
void startStamping(int descriptor);

}  // namespace deckpipe
