// SPDX-License-Identifier: GPL-3.0-or-later
// Which message of the catalogue a frame is. Total: any frame in, one answer out. Pure: the same frame, time
// and address book give the same answer, so the trace, the headless tool and the state agree at every row.
#pragma once

#include "base/time.h"
#include "bus/frame.h"
#include "protocol/message.h"

namespace deckpipe {

class AddressBook;

struct Classified {
  Family family = Family::None;
  MessageId message = MessageId::Count;  // Count = not decoded
  bool malformed = false;                // the type is known, the length is not one of `wanted`
  Lengths wanted = 0;

  bool isDecoded() const { return message != MessageId::Count && !malformed; }
  friend bool operator==(const Classified&, const Classified&) = default;
};

// `time` is the frame's log time, `book` what was known of its channel before it.
Classified classify(const Frame& frame, Instant time, const AddressBook& book);

}  // namespace deckpipe
