// SPDX-License-Identifier: GPL-3.0-or-later
// QCanBusFrame <-> Frame, the only place where one becomes the other. CanLink calls it for every frame; the
// header is for this room and its tests, as nobody else sees QtSerialBus.
#pragma once

#include <QCanBusFrame>

#include "base/result.h"
#include "bus/port.h"

namespace deckpipe {

// Flags stay 0; CanLink sets them, as it knows whose frame it is. CAN FD frames, unknown kinds and identifiers out of
// range are refused with their reason. A stamp of exactly zero is what plugins leave when
// the driver gave none, and becomes kNoStamp.
Result<Frame, NotKept> fromCanBusFrame(const QCanBusFrame& frame, Channel channel);

// Data and remote frames; a remote frame carries its length as that many zero bytes, as the plugins want it.
// Error frames are not for sending (see CanLink::write), but convert faithfully.
QCanBusFrame toCanBusFrame(const Frame& frame);

}  // namespace deckpipe
