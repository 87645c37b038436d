// SPDX-License-Identifier: GPL-3.0-or-later
// What any Akron device of the simulator answers to polls 02-05 (CAN Messaging manual, message types 02, 03,
// 04, 05). Device asks for it, and may then spoil the answer.
#pragma once

#include <optional>

#include "simulator/identity.h"

namespace deckpipe::simulator {

struct PollAnswer {
  MessageId message;
  Encoded data;
};
struct FaultReport {
  std::uint32_t map = 0;
  std::uint16_t pcodeError = 0;
  bool isShort = false;  // 5 bytes: older firmware has no pCode error code
};

// `type` is byte 1 of the poll; nothing where it is none of the four.
std::optional<PollAnswer> pollAnswer(std::uint8_t type, const Identity& identity, const FaultReport& faults);

}  // namespace deckpipe::simulator
