// SPDX-License-Identifier: GPL-3.0-or-later
// The services in words: what is asked, how it ended, why something was refused, how our own address and a
// data pipe are doing. For panels and for the notes of a log.
#pragma once

#include <QString>

#include "base/link_fault.h"
#include "control/pipe_event.h"
#include "control/status.h"

namespace deckpipe {

// "Faults", "Firmware".
QString requestText(Request request);
// "answered", "no answer".
// A reset that was seen is "restarted".
QString requestEndText(Request request, RequestEnd end);
// A whole sentence.
QString refusalText(Refusal refusal);
// "a monitor's enable is off", why motion ended.
QString motionCauseText(MotionCause cause);
// "the interface is down"; empty for None.
QString linkFaultText(LinkFault fault);
// With the adapter's own words, where it has any: "the adapter is gone (Network is down)".
QString linkFaultText(LinkFault fault, const QString& words);
// "address F9", "claiming address F9", "no address free".
QString claimText(const ClaimStatus& claim);
// "file sent", "no ack".
QString pipeEventText(PipeEvent event);
// "no ack from the device within 1 s".
QString stallText(const PipeStatus& pipe);
// "Packets without an ack are skipped, so far 3", as the person said for the rest; empty where nothing was
// said.
QString restText(const PipeStatus& pipe);
// "Of what was typed last, 2 packets were skipped …"; empty where all of it was acknowledged.
QString typedDoubtText(const PipeStatus& pipe);

}  // namespace deckpipe
