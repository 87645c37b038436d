// SPDX-License-Identifier: GPL-3.0-or-later
#include "counts.h"

#include <cstdio>

namespace deckpipe::ctl {

std::string counted(std::uint64_t number, std::string_view one, std::string_view many) {
  return std::to_string(number).append(" ").append(pluralOf(number, one, many));
}

std::string framesThat(std::uint64_t number, std::string_view doesOne, std::string_view doMany) {
  return framesText(number).append(" ").append(pluralOf(number, doesOne, doMany));
}

std::string lengthText(Duration length) {
  const auto ms = std::chrono::round<std::chrono::milliseconds>(length).count();
  if (ms < 1000) return std::to_string(ms) + " ms";
  if (ms < 9950) {
    char text[16];
    std::snprintf(text, sizeof text, "%.1f s", static_cast<double>(ms) / 1000);
    return text;
  }
  const auto seconds = ms / 1000;
  if (seconds < 100) return std::to_string(seconds) + " s";
  if (seconds < 100 * 60) return std::to_string(seconds / 60) + " min";
  if (seconds < 48 * 3600) return std::to_string(seconds / 3600) + " h";
  return std::to_string(seconds / 86400) + " d";
}

}  // namespace deckpipe::ctl
