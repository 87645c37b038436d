// SPDX-License-Identifier: GPL-3.0-or-later
// Counts and lengths in words, for the lines that people read. Everything of the tool that says either takes it from
// here, so that nothing says "1 frames" or "after 86400000 ms".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/time.h"

namespace deckpipe::ctl {

// "frame" of 1, "frames" of any other number.
constexpr std::string_view pluralOf(std::uint64_t number, std::string_view one, std::string_view many) {
  return number == 1 ? one : many;
}
// "1 frame", "3 frames".
std::string counted(std::uint64_t number, std::string_view one, std::string_view many);
inline std::string framesText(std::uint64_t number) { return counted(number, "frame", "frames"); }
// "3 frames are", for what is said of them.
std::string framesThat(std::uint64_t number, std::string_view doesOne, std::string_view doMany);

// "150 ms", "4.0 s", "93 s", "25 min 04 s", "24 h 10 min", "9 d 02 h": cut as base/time.h cuts them.
std::string lengthText(Duration length);

}  // namespace deckpipe::ctl
