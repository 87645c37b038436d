// SPDX-License-Identifier: GPL-3.0-or-later
// What a link is opened with, and what is known of it besides its frames. Plain values: the session copies
// the status into its snapshots.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string>

#include "base/link_fault.h"
#include "bus/port.h"
#include "link/can_interface.h"

namespace deckpipe {

struct LinkSettings {
  QString plugin;         // a key of QCanBus::plugins(): "socketcan", "virtualcan", "peakcan" ...
  QString interfaceName;  // in the plugin's way: "can0", "usb0", "tcp://127.0.0.1:41234/can0?echo"
  int bitRate = 250'000;  // bit/s. 0: as the interface has it, which only socketcan can do
  Channel channel;        // put into every frame
};

// Counters are since open().
struct LinkStatus {
  LinkState state = LinkState::Closed;
  LinkFault fault = LinkFault::None;
  std::string reason;                    // of the last fault or refused write, in words
  std::optional<CanInterface> hardware;  // bit rate, listen-only, controller; of socketcan only
  std::uint64_t received = 0;            // frames of others
  std::uint64_t written = 0;             // frames that the adapter accepted
  std::uint64_t confirmed = 0;           // of these: came back as echoes
  std::uint64_t refused = 0;             // writes that were not Accepted
  std::uint64_t notKept = 0;
  std::uint64_t errors = 0;  // reports of the adapter that left the link up
};

}  // namespace deckpipe
