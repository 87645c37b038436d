// SPDX-License-Identifier: GPL-3.0-or-later
// What a snapshot's state needs said above the work, in words: why nothing is heard, that the traffic is not
// what Deckpipe reads, that the link went away, that the cursor stands in the past, what of a file could not
// be read. The worst alone, of a file all that is to be said of it, and with it what came of the last thing that a
// person wanted; a pure function, so that every state is tested without a window.
#pragma once

#include "model/bus_rates.h"
#include "panel/common/notice_bar.h"
#include "session/snapshot.h"

namespace deckpipe {

Notice noticeOf(const Snapshot& snapshot, const BusRates& rates);

// The kept preferred address is a joystick's or a monitor's, so that `used` is claimed instead.
Notice refusedAddressNotice(Address refused, Address used);

// What to type so that a Linux interface listens at a bit rate: "sudo ip link set can0 …".
QString setUpCommand(const QString& interfaceName, int bitRate, bool isListenOnly);

}  // namespace deckpipe
