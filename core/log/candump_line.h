// SPDX-License-Identifier: GPL-3.0-or-later
// One line of what candump and its relatives write, in every form we know of:
//   (1700000000.123456) can0 18EFFF80#011D940371000041
//     written by candump -l and -L, cansend, python-can, SavvyCAN. Data with or without '.' between bytes; #R and #R8
//     are remote frames, 20000004#… an error frame, ##0… CAN FD, _E a raw DLC. The stamp has 0 to 9 decimals, or is
//     left out; with more decimals only its seconds count
//   (1700000000.123456) can0 18EFFF80#011D940371000041 T
//     written by candump -x and asc2log: sent (T) or received (R)
//   (1700000000.123456)  can0  RX - -  18EFFF80   [8]  01 1D 94 03 71 00 00 41   '....q..A'
//     candump's screen. The stamp is absent or a date (-t A, taken as UTC); "remote request", ERRORFRAME, [08] CAN FD,
//     {E} a raw DLC; -S bytes reversed and joined by '`'; -i bytes in binary; -c colours; -e lines about an error frame
//   <0x18eeff01> [8] 05 a0 be 1c 00 a0 a0 c0                    canutils 4, with or without an interface
//   interface = can0, family = 29, type = 3, proto = 1          … whose first line names it
// Deltas (-t d) look like times near 0: delta_times.h.
// This is the whole definition; CandumpParser has a faster way for the first form and must agree with it.
#pragma once

#include <string>
#include <string_view>

#include "log/text_parser.h"

namespace deckpipe {

// `line` without its line feed. `scratch` may come to hold what `interface` views.
TextLine readCandumpLine(std::string_view line, std::string& scratch);

}  // namespace deckpipe
