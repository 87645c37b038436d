// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/bits.h"

#include <gtest/gtest.h>

namespace deckpipe {
namespace {

constexpr Payload kPayload{0x01, 0x1D, 0x94, 0x03, 0x71, 0x00, 0x00, 0x41};

TEST(Bits, BigEndianRangeStartsAtItsMostSignificantBit) {
  EXPECT_EQ(readBits(kPayload, {ByteOrder::Big, 8, 12}), 0x1D9u);  // B2.8–B3.5
  EXPECT_EQ(readBits(kPayload, {ByteOrder::Big, 62, 2}), 1u);      // B8.2–1
}

TEST(Bits, LittleEndianRangeCountsFromTheLeastSignificantBitOfByteOne) {
  const Payload joystick{0x10, 0x7D, 0x04, 0x64};
  EXPECT_EQ(readBits(joystick, {ByteOrder::Little, 6, 10}), 500u);
  EXPECT_EQ(readBits(joystick, {ByteOrder::Little, 22, 10}), 400u);
}

TEST(Bits, WritingChangesNothingOutsideTheRange) {
  for (const ByteOrder order : {ByteOrder::Big, ByteOrder::Little}) {
    for (unsigned offset = 0; offset < 64; ++offset) {
      for (unsigned width = 1; width <= 64 - offset; ++width) {
        const BitRange range{order, static_cast<std::uint8_t>(offset), static_cast<std::uint8_t>(width)};
        Payload ones;
        ones.fill(0xFF);
        writeBits(ones, range, 0);
        EXPECT_EQ(readBits(ones, range), 0u);
        EXPECT_EQ(std::popcount(loadBig(ones)), static_cast<int>(64 - width));
        Payload zeros{};
        writeBits(zeros, range, ~0ull);
        EXPECT_EQ(readBits(zeros, range), range.mask());
        EXPECT_EQ(std::popcount(loadBig(zeros)), static_cast<int>(width));
      }
    }
  }
}

TEST(Bits, SignExtendsFromTheFieldsOwnWidth) {
  EXPECT_EQ(signExtend(0xFED4, 16), -300);
  EXPECT_EQ(signExtend(0x01C2, 16), 450);
  EXPECT_EQ(signExtend(0xFFFFFFFF, 32), -1);
}

}  // namespace
}  // namespace deckpipe
