// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/link_device.h"

#include <gtest/gtest.h>

#include "support/raw_frames.h"

namespace deckpipe {
namespace {

using namespace test;

// Both ways: what a plugin hands over, and the Frame that stands for it.
struct Row {
  const char* name;
  QCanBusFrame::FrameType type;
  std::uint32_t id;  // the identifier, or the error class
  bool isExtended;
  const char* hex;
  Frame frame;
};

Frame stamped(Frame frame) {
  frame.stamp = 1'700'000'000'123'456'000;
  return frame;
}

QCanBusFrame qtFrame(const Row& row) {
  QCanBusFrame frame(row.type);
  if (row.type == QCanBusFrame::ErrorFrame) {
    frame.setError(QCanBusFrame::FrameErrors::fromInt(static_cast<int>(row.id)));
  } else {
    frame.setFrameId(row.id);
    frame.setExtendedFrameFormat(row.isExtended);
  }
  frame.setPayload(QByteArray::fromHex(row.hex));
  frame.setTimeStamp(QCanBusFrame::TimeStamp(1'700'000'000, 123'456));
  return frame;
}

const Row kRows[] = {
    {"empty", QCanBusFrame::DataFrame, 0x000, false, "", frameOf(0x000, {})},
    {"base", QCanBusFrame::DataFrame, 0x7FF, false, "0180ff", frameOf(0x7FF, {0x01, 0x80, 0xFF})},
    {"extended", QCanBusFrame::DataFrame, 0x18EF0102, true, "0102030405060708",
     extendedFrame(0x18EF0102, {1, 2, 3, 4, 5, 6, 7, 8})},
    {"extended_with_a_small_number", QCanBusFrame::DataFrame, 0x123, true, "00", extendedFrame(0x123, {0})},
    {"largest", QCanBusFrame::DataFrame, 0x1FFFFFFF, true, "ffffffffffffffff",
     extendedFrame(0x1FFFFFFF, {255, 255, 255, 255, 255, 255, 255, 255})},
    {"remote", QCanBusFrame::RemoteRequestFrame, 0x701, false, "00", remoteFrame(0x701, 1)},
    {"remote_extended", QCanBusFrame::RemoteRequestFrame, 0x18EAFF38, true, "0000000000000000",
     remoteFrame(0x18EAFF38 | kExtendedBit, 8)},
    {"error_bus_off", QCanBusFrame::ErrorFrame, 0x40, false, "0000000000000000",
     frameOf(kErrorBit | 0x40, {0, 0, 0, 0, 0, 0, 0, 0})},
    {"error_controller_passive", QCanBusFrame::ErrorFrame, 0x204, false, "0020000000008000",
     frameOf(kErrorBit | 0x204, {0, 0x20, 0, 0, 0, 0, 0x80, 0})},
};

class Conversion : public ::testing::TestWithParam<Row> {};

TEST_P(Conversion, FromQt) {
  const auto frame = fromCanBusFrame(qtFrame(GetParam()), Channel{3});
  ASSERT_TRUE(frame);
  Frame expected = stamped(GetParam().frame);
  expected.channel = 3;
  EXPECT_EQ(frame.value(), expected);
}

TEST_P(Conversion, ToQt) {
  const QCanBusFrame frame = toCanBusFrame(stamped(GetParam().frame));
  const QCanBusFrame expected = qtFrame(GetParam());
  EXPECT_TRUE(frame.isValid());
  EXPECT_FALSE(frame.hasFlexibleDataRateFormat());
  EXPECT_FALSE(frame.hasLocalEcho());
  EXPECT_EQ(frame.frameType(), expected.frameType());
  EXPECT_EQ(frame.frameId(), expected.frameId());
  EXPECT_EQ(frame.error(), expected.error());
  EXPECT_EQ(frame.hasExtendedFrameFormat(), expected.hasExtendedFrameFormat());
  EXPECT_EQ(frame.payload(), expected.payload());
  EXPECT_EQ(frame.timeStamp().seconds(), expected.timeStamp().seconds());
  EXPECT_EQ(frame.timeStamp().microSeconds(), expected.timeStamp().microSeconds());
}

INSTANTIATE_TEST_SUITE_P(Link, Conversion, ::testing::ValuesIn(kRows),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(ConversionOfWhatIsNoFrame, FlexibleDataRateIsNotKeptHoweverShort) {
  QCanBusFrame frame(0x123, QByteArray(12, 'x'));
  EXPECT_EQ(fromCanBusFrame(frame, {}).error(), NotKept::FlexibleDataRate);
  frame.setPayload(QByteArray(2, 'x'));
  EXPECT_EQ(fromCanBusFrame(frame, {}).error(), NotKept::FlexibleDataRate);
}

TEST(ConversionOfWhatIsNoFrame, InvalidAndUnknownAreNotKept) {
  EXPECT_EQ(fromCanBusFrame(QCanBusFrame(QCanBusFrame::InvalidFrame), {}).error(), NotKept::Invalid);
  EXPECT_EQ(fromCanBusFrame(QCanBusFrame(QCanBusFrame::UnknownFrame), {}).error(), NotKept::Invalid);
  QCanBusFrame bigId(0x18EF0102, {});
  bigId.setExtendedFrameFormat(false);
  EXPECT_EQ(fromCanBusFrame(bigId, {}).error(), NotKept::Invalid);
  QCanBusFrame tooLong(0x123, QByteArray(9, 'x'));
  tooLong.setFlexibleDataRateFormat(false);
  EXPECT_EQ(fromCanBusFrame(tooLong, {}).error(), NotKept::Invalid);
}

TEST(ConversionOfStamps, ZeroIsNoStamp) {
  EXPECT_FALSE(fromCanBusFrame(QCanBusFrame(0x123, {}), {}).value().hasStamp());
  QCanBusFrame justAfter(0x123, {});
  justAfter.setTimeStamp(QCanBusFrame::TimeStamp(0, 1));
  EXPECT_EQ(fromCanBusFrame(justAfter, {}).value().stamp, 1'000);
}

}  // namespace
}  // namespace deckpipe
