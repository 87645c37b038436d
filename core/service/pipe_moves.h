// SPDX-License-Identifier: GPL-3.0-or-later
// How a data pipe goes on: state × event → state. The pipe (pipe.h) asks this table and changes its state
// nowhere else.
#pragma once

#include <optional>

#include "base/enum_table.h"
#include "control/status.h"

namespace deckpipe {

enum class PipeMove : std::uint8_t {
  Next,      // a packet is handed over
  Nothing,   // none waits
  Hold,      // the person has paused before the next one
  Ack,       // of the packet in flight, which went once
  AckAgain,  // … which went twice: a second ack may come yet
  Silence,   // no ack in time, not on the bus, not taken by the adapter, nothing may go to the device
  LateEcho,  // the packet in flight is on the bus after all
  Resend,    // the person's decision on a packet whose fate is not known
  Skip,      // …
  GiveUp,    // nothing more of all that waits, or of the file whose packet is in flight
  Settled,   // no ack of a packet that was given up can come any more
  Joined,    // another pipe to the same device was under way: an ack of its packet may come yet
  Count,
};
inline constexpr std::size_t kPipeMoves = kCountOf<PipeMove>;
inline constexpr std::size_t kPipeStates = kCountOf<PipeStatus::Progress>;

namespace pipe_table {
using enum PipeStatus::Progress;
using Cell = std::optional<PipeStatus::Progress>;
inline constexpr Cell No;  // does not happen, or is refused: nothing changes
// clang-format off
inline constexpr EnumTable<PipeStatus::Progress, EnumArray<PipeMove, Cell>> kTable{{
    //           Next      Nothing Hold    Ack   AckAgain  Silence  LateEcho Resend   Skip      GiveUp    Settled Joined
    {Idle,     {{ Sending, Idle,   Paused, No,   No,       No,      No,      No,      No,       Idle,     No,     Settling}}},
    {Sending,  {{ No,      No,     No,     Idle, Settling, Stalled, Sending, No,      No,       Settling, No,     No}}},
    {Settling, {{ No,      No,     No,     No,   No,       No,      No,      No,      No,       Settling, Idle,   Settling}}},
    {Paused,   {{ Sending, Idle,   Paused, No,   No,       No,      No,      No,      No,       Idle,     No,     No}}},
    {Stalled,  {{ No,      No,     No,     Idle, Settling, No,      Sending, Sending, Settling, Settling, No,     No}}},
}};
// clang-format on
}  // namespace pipe_table

// The state after a move; nothing where it does not happen in this state.
constexpr std::optional<PipeStatus::Progress> after(PipeStatus::Progress state, PipeMove move) {
  return pipe_table::kTable[state][move];
}

}  // namespace deckpipe
