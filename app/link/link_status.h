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

// Why a link is not up or, without a fault, an error that it survived. The window and the headless tool each have their
// own sentences for it.
struct LinkError {
  LinkFault fault = LinkFault::None;
  std::uint32_t bitRate =
      0;                 // of the interface, in bit/s, if the fault is that it has another than asked for
  std::string detail{};  // the system's or the adapter's own words, never ours; may be empty
  friend bool operator==(const LinkError&, const LinkError&) = default;
};

// Counters are since open().
struct LinkStatus {
  LinkState state = LinkState::Closed;
  LinkFault fault = LinkFault::None;
  std::string reason;  // of the last fault or refused write: the system's or the adapter's own words
  std::optional<CanInterface> hardware;  // bit rate, listen-only, controller; of socketcan only
  std::uint64_t received = 0;            // frames of others
  std::uint64_t written = 0;             // frames that the adapter accepted
  std::uint64_t confirmed = 0;           // of these: came back as echoes
  std::uint64_t refused = 0;             // writes that were not Accepted
  std::uint64_t notKept = 0;
  std::uint64_t errors = 0;  // reports of the adapter that left the link up

  LinkError error() const {
    const bool isOther = fault == LinkFault::WrongBitRate && hardware;
    return {.fault = fault, .bitRate = isOther ? hardware->bitRate : 0, .detail = reason};
  }
};

}  // namespace deckpipe
