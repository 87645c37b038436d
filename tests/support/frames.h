// SPDX-License-Identifier: GPL-3.0-or-later
// Frames for tests, written as candump writes them.
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>

#include "bus/frame.h"

namespace deckpipe::test {

// "18EFFF80" (29-bit) or "5A4" (11-bit), data in hex.
inline Frame frame(std::string_view id, std::string_view data, std::uint8_t channel = 0,
                   std::int64_t stampNs = 0) {
  Frame f;
  f.id = static_cast<std::uint32_t>(std::strtoul(std::string(id).c_str(), nullptr, 16)) |
         (id.size() == 8 ? kExtendedBit : 0u);
  for (std::size_t i = 0; i + 1 < data.size(); i += 2) {
    f.data[f.length++] =
        static_cast<std::uint8_t>(std::strtoul(std::string(data.substr(i, 2)).c_str(), nullptr, 16));
  }
  f.channel = channel;
  f.stamp = stampNs;
  return f;
}

}  // namespace deckpipe::test
