// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "log/candump.h"

namespace deckpipe {
namespace {

std::string written(const Frame& frame, std::string_view name = "can0") {
  std::string out;
  writeCandump(frame, name, out);
  return out;
}

Frame usual() {
  Frame frame;
  frame.stamp = 1'700'000'000'123'456'000;
  frame.id = kExtendedBit | 0x18EF'FF80;
  frame.length = 8;
  frame.data = {0x01, 0x1D, 0x94, 0x03, 0x71, 0x00, 0x00, 0x41};
  return frame;
}

TEST(CandumpWriter, WritesWhatCandumpWrites) {
  EXPECT_EQ(written(usual()), "(1700000000.123456) can0 18EFFF80#011D940371000041\n");
  Frame frame = usual();
  frame.flags = Frame::kSent | Frame::kConfirmed;
  frame.stamp = 5'000'001'999;
  frame.id = 0x7F;
  frame.length = 1;
  frame.data = {0xFF};
  EXPECT_EQ(written(frame, "vcan1"), "(0000000005.000001) vcan1 07F#FF T\n");
  frame.id |= kRemoteBit;
  frame.data = {};
  EXPECT_EQ(written(frame), "(0000000005.000001) can0 07F#R1 T\n");
  frame.id = kErrorBit | 4;
  frame.flags = 0;
  frame.length = 2;
  EXPECT_EQ(written(frame), "(0000000005.000001) can0 20000004#0000\n");
}

TEST(CandumpWriter, WritesFramesWithoutStampAsTheScreenShowsThem) {
  Frame frame = usual();
  frame.stamp = kNoStamp;
  EXPECT_EQ(written(frame), "  can0  18EFFF80   [8]  01 1D 94 03 71 00 00 41\n");
}

TEST(CandumpWriter, WritesNamesThatAreReadBackAsOneName) {
  for (const auto& [name, expected] : {std::pair<std::string, std::string>{"PCAN 1", "PCAN_1"},
                                       {"", std::string(kUnnamedInterface)},
                                       {"(x)", "_x)"},
                                       {"#1", "_1"},
                                       {"<0x", "_0x"},
                                       {"b\xC3\xBCs", "b__s"},
                                       {std::string(100, 'n'), std::string(63, 'n')}}) {
    for (const std::int64_t stamp : {kNoStamp, std::int64_t{5}}) {
      Frame frame = usual();
      frame.stamp = stamp;
      FrameStore store;
      SkippedList skipped;
      ASSERT_TRUE(readLog(BytesInMemory(written(frame, name)), {store, skipped}));
      ASSERT_EQ(store.count(), 1u) << name;
      EXPECT_EQ(store.channelName(0), expected);
    }
  }
}

Frame randomFrame(std::mt19937_64& random) {
  Frame frame;
  switch (random() % 6) {
    case 0: break;
    case 1: frame.stamp = static_cast<std::int64_t>(random()); break;
    case 2: frame.stamp = static_cast<std::int64_t>(random() % 10'000'000'000); break;
    default:
      frame.stamp =
          1'700'000'000'000'000'000 + static_cast<std::int64_t>(random() % 1'000'000'000'000) * 1000;
  }
  const auto bits = static_cast<std::uint32_t>(random());
  switch (random() % 5) {
    case 0: frame.id = bits & 0x7FF; break;
    case 1: frame.id = (bits & 0x7FF) | kRemoteBit; break;
    case 2: frame.id = (bits & kIdMask) | kErrorBit; break;
    case 3: frame.id = (bits & kIdMask) | kExtendedBit | kRemoteBit; break;
    default: frame.id = (bits & kIdMask) | kExtendedBit;
  }
  frame.length = static_cast<std::uint8_t>(random() % 9);
  for (std::size_t i = 0; i < frame.bytes().size(); ++i) frame.data[i] = static_cast<std::uint8_t>(random());
  if (random() % 4 == 0) frame.flags = Frame::kSent;
  frame.channel = static_cast<std::uint8_t>(random() % 4);
  return frame;
}

TEST(CandumpWriter, LogsItWroteAreReadBackFrameForFrame) {
  constexpr std::uint64_t n = 100'000;
  std::mt19937_64 random(42);
  FrameStore original;
  for (const char* name : {"can0", "vcan1", "a_long_name_of_a_bus", "x"}) original.channel(name);
  std::string text;
  // Every channel in order first, so that the indexes agree.
  for (std::uint64_t i = 0; i < n; ++i) {
    Frame frame = randomFrame(random);
    if (i < 4) frame.channel = static_cast<std::uint8_t>(i);
    ASSERT_TRUE(original.append({&frame, 1}, Follows::More));
    writeCandump(frame, original.channelName(frame.channel), text);
  }
  ASSERT_TRUE(original.append({}, Follows::Nothing));
  FrameStore copy;
  SkippedList skipped;
  ReadOptions options;
  options.threads = 2;
  const auto result = readLog(BytesInMemory(text), {copy, skipped}, options);
  ASSERT_TRUE(result);
  EXPECT_EQ(skipped.content().unreadable(), 0u);
  ASSERT_EQ(copy.count(), n);
  for (std::uint64_t i = 0; i < n; ++i) {
    Frame rounded = original[i];
    if (rounded.hasStamp()) rounded.stamp -= rounded.stamp % 1000;  // the form has microseconds
    ASSERT_EQ(copy[i], rounded) << i;
    ASSERT_EQ(copy.channelName(copy[i].channel), original.channelName(original[i].channel));
  }
}

}  // namespace
}  // namespace deckpipe
