// SPDX-License-Identifier: GPL-3.0-or-later
// CRC-32 as zlib and Ethernet have it (reflected 04C11DB7, start and end inverted), a byte at a time: what
// the pipe's shell says of a file it got, so that a person can compare with `crc32 FILE`.
#pragma once

#include <array>
#include <cstdint>

namespace deckpipe::simulator {

class Crc32 {
 public:
  constexpr void add(std::uint8_t byte) { m_rest = kTable[(m_rest ^ byte) & 0xFF] ^ (m_rest >> 8); }
  constexpr std::uint32_t value() const { return ~m_rest; }

 private:
  static constexpr std::array<std::uint32_t, 256> kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t rest = i;
      for (int bit = 0; bit < 8; ++bit) rest = (rest & 1) != 0 ? 0xEDB8'8320u ^ (rest >> 1) : rest >> 1;
      table[i] = rest;
    }
    return table;
  }();
  std::uint32_t m_rest = 0xFFFF'FFFF;
};

}  // namespace deckpipe::simulator
