// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/decode_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "protocol/catalogue.h"
#include "protocol/samples.h"
#include "support/frames.h"
#include "support/logs.h"
#include "support/raw_frames.h"

namespace deckpipe {
namespace {

struct DecodeModelTest : testing::Test {
  DecodeModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};

  void show(const std::vector<Frame>& frames, std::uint64_t which) {
    model.setView(test::viewOf(test::logOf(frames)));
    model.setFrame(which);
  }
  int rowOf(const char* name) const {
    for (int row = 0; row < model.rowCount(); ++row) {
      if (model.index(row, DecodeModel::Name).data().toString() == QString::fromUtf8(name)) return row;
    }
    return -1;
  }
  std::string line(const char* name) const {
    const int row = rowOf(name);
    if (row < 0) return "none";
    QStringList cells;
    for (int column = 0; column < DecodeModel::ColumnCount; ++column)
      cells += model.index(row, column).data().toString();
    return cells.join(QStringLiteral(" | ")).toStdString();
  }
  quint64 bits(const char* name, int role = DecodeModel::BitsRole) const {
    return model.index(rowOf(name), 0).data(role).toULongLong();
  }
};

const Frame kAnnouncement = test::frame("18EFFF80", "FF83150206021A0B");

TEST_F(DecodeModelTest, IsEmptyWithoutAFrame) {
  EXPECT_EQ(model.rowCount(), 0);
  EXPECT_EQ(model.content(), nullptr);
  model.setFrame(3);
  EXPECT_EQ(model.rowCount(), 0);
  show({kAnnouncement}, 1);
  EXPECT_EQ(model.rowCount(), 0);
  model.setFrame(0);
  EXPECT_GT(model.rowCount(), 0);
  ASSERT_NE(model.content(), nullptr);
  EXPECT_EQ(model.content()->length, 8);
  model.setFrame({});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST_F(DecodeModelTest, TakesAPositionApartAsTheManualCounts) {
  show({kAnnouncement, test::frame("18EFFF80", "011D940371000041")}, 1);
  EXPECT_EQ(line("Message"), "Message | Position / limit status |  | ");
  EXPECT_EQ(line("Note"), "none");
  EXPECT_EQ(line("Identifier"), "Identifier | 18EFFF80, 29 bits |  | ");
  EXPECT_EQ(line("Priority"), "Priority | 6 |  | ID 28–26");
  EXPECT_EQ(line("PGN"), "PGN | EF00 hex (61184) |  | ID 25–16");
  EXPECT_EQ(line("Destination"), "Destination | FF hex (255), all |  | ID 15–8");
  EXPECT_EQ(line("Source"), "Source | 80 hex (128) |  | ID 7–0");
  EXPECT_EQ(line("Message type"), "Message type | 01 hex | 0000 0001 | B1");
  EXPECT_EQ(line("Rotation"), "Rotation | 47.3° | 0001 1101 1001 | B2.8–B3.5");
  EXPECT_EQ(line("Rotation right (+)"), "Rotation right (+) | on | 01 | B3.4–3");
  EXPECT_EQ(line("Elevation"), "Elevation | −5.5° | 0000 0011 0111 | B4.8–B5.5");
  EXPECT_EQ(line("Axis 5 (+) hard stop"), "Axis 5 (+) hard stop | on | 01 | B8.8–7");
  EXPECT_EQ(line("Calibrated"), "Calibrated | on | 01 | B8.2–1");
  EXPECT_EQ(bits("Rotation"), 0x00F0FF00u);
  EXPECT_EQ(bits("Rotation", DecodeModel::SignBitsRole), 0x000F0000u);
  EXPECT_EQ(bits("Calibrated"), 0x0300000000000000u);
  EXPECT_FALSE(model.index(rowOf("Calibrated"), 0).data(DecodeModel::QuietRole).toBool());
  EXPECT_TRUE(model.index(rowOf("Operational error"), 0).data(DecodeModel::QuietRole).toBool());
  EXPECT_TRUE(model.index(rowOf("Rotation"), 0)
                  .data(Qt::ToolTipRole)
                  .toString()
                  .startsWith(QStringLiteral("CAN Messaging manual")));
}

TEST_F(DecodeModelTest, TakesAJoysticksAxisApart) {
  show({test::frame("0CFDD633", "107D046400100000")}, 0);
  EXPECT_EQ(line("Stick X"), "Stick X | 50.0 % | 01 1111 0100 | B1.8–7, B2");
  EXPECT_EQ(bits("Stick X"), 0xFFC0u);
  EXPECT_EQ(line("Destination"), "Destination | all, by its PGN |  | ");
  EXPECT_EQ(line("PGN"), "PGN | FDD6 hex (64982) |  | ID 25–8");
  EXPECT_EQ(line("Switch 2: fog"), "Switch 2: fog | on | 01 | B6.6–5");
}

TEST_F(DecodeModelTest, TakesAnSdoApart) {
  show({test::frame("5A4", "4B0150020B00")}, 0);
  EXPECT_EQ(line("Function"), "Function | 580 (SDO, from the node) |  | ID 10–7");
  EXPECT_EQ(line("Node"), "Node | 24 hex (36) |  | ID 6–0");
  EXPECT_EQ(line("Command specifier"), "Command specifier | 4B hex | 0100 1011 | B1");
  EXPECT_EQ(line("Object index"), "Object index | 5001 | 0101 0000 0000 0001 | B2–B3");
  EXPECT_EQ(line("Value"), "Value | 11 | 0000 0000 0000 1011 | B5–B6");
  EXPECT_EQ(line("Operational error code"),
            "Operational error code | 11 (rotation sensor error) | 0000 0000 0000 1011 | B5–B6");
  EXPECT_EQ(line("Size in bytes"), "Size in bytes | 2 |  | ");
}

TEST_F(DecodeModelTest, SaysHowSureItIs) {
  show({test::frame("18EFFF80", "011D940371000041")}, 0);
  EXPECT_EQ(line("Note"),
            "Note | Presumed: neither end has been heard to be an Akron device since the link came up, but "
            "type, length and "
            "direction fit. |  | ");
  show({test::frame("18EF81A0", "FE0102")}, 0);
  EXPECT_EQ(line("Note"),
            "Note | Ambiguous: a data pipe packet of an Akron device or another maker's message. Nothing "
            "heard so far decides. |  | ");
  EXPECT_EQ(line("Byte 2"), "Byte 2 | 01 hex (1) | 0000 0001 | B2");
}

TEST_F(DecodeModelTest, ShowsBytesWhereNothingIsDecoded) {
  show({kAnnouncement, test::frame("18EFFF80", "011D94")}, 1);
  EXPECT_EQ(line("Message"), "Message | Malformed: Position / limit status |  | ");
  EXPECT_EQ(line("Note"), "Note | Malformed: 8 bytes wanted, 3 came. |  | ");
  EXPECT_EQ(line("Byte 3"), "Byte 3 | 94 hex (148) | 1001 0100 | B3");
  EXPECT_EQ(line("Byte 4"), "none");
  show({test::remoteFrame(0x1A4, 8)}, 0);
  EXPECT_EQ(line("Message"), "Message | Remote request |  | ");
  EXPECT_EQ(line("Byte 1"), "none");
  show({test::frameOf(kErrorBit | 0x44, {0, 0x30, 0, 0, 0, 0, 0, 0})}, 0);
  EXPECT_EQ(line("Error classes"), "Error classes | controller problem, bus off |  | ");
  EXPECT_EQ(line("Byte 2"), "Byte 2 | 30 hex (48) | 0011 0000 | B2");
  show({test::frame("123", "")}, 0);
  EXPECT_EQ(line("Message"), "Message | unknown |  | ");
}

TEST_F(DecodeModelTest, KeepsItsRowsWhileOneStepsThroughOneMessage) {
  show({kAnnouncement, test::frame("18EFFF80", "011D940371000041"),
        test::frame("18EFFF80", "01FFFF0371000041")},
       1);
  QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
  QSignalSpy another(&model, &DecodeModel::frameChanged);
  model.setFrame(2);
  EXPECT_EQ(reset.count(), 0);
  EXPECT_EQ(another.count(), 1);
  EXPECT_EQ(line("Rotation sensor"), "Rotation sensor | no sensor fitted | 1111 1111 1111 | B2.8–B3.5");
  EXPECT_EQ(line("Rotation"), "Rotation | no value | 1111 1111 1111 | B2.8–B3.5");
  model.setFrame(0);
  EXPECT_EQ(reset.count(), 1);
}

TEST_F(DecodeModelTest, FindsTheFieldOfABit) {
  show({kAnnouncement, test::frame("18EFFF80", "011D940371000041")}, 1);
  EXPECT_EQ(model.rowOfBit(1u << 8), rowOf("Rotation"));
  EXPECT_EQ(model.rowOfBit(1u), rowOf("Message type"));
  EXPECT_EQ(model.rowOfBit(1ull << 56), rowOf("Calibrated"));
  show({test::frame("18EFFF81", "848002")}, 0);
  EXPECT_EQ(model.rowOfBit(1ull << 8), -1) << "reserved";
  EXPECT_EQ(model.rowOfBit(1ull << 40), -1) << "not in the frame";
}

TEST(BitPlace, CountsAsTheManualsDo) {
  EXPECT_EQ(placeText(big(2, 8, 12)).toStdString(), "B2.8–B3.5");
  EXPECT_EQ(placeText(big(6, 8, 2)).toStdString(), "B6.8–7");
  EXPECT_EQ(placeText(big(3, 1, 1)).toStdString(), "B3.1");
  EXPECT_EQ(placeText(big(2, 8, 16)).toStdString(), "B2–B3");
  EXPECT_EQ(placeText(little(1, 64)).toStdString(), "B1–B8");
  EXPECT_EQ(placeText({ByteOrder::Little, 21, 11}).toStdString(), "B3.8–6, B4");
  EXPECT_EQ(placeText({ByteOrder::Little, 0, 21}).toStdString(), "B1, B2, B3.5–1");
  EXPECT_EQ(placeText({}).toStdString(), "");
}

// Whatever a frame is, its detail names bits of the frame only and the sets agree with the places.
TEST_F(DecodeModelTest, StaysWithinTheFrameForEverySample) {
  for (const Sample& sample : kSamples) {
    const Frame frame = test::frame(sample.id, sample.data);
    const Message& message = messageOf(sample.message);
    const BitSet64 there = frame.length == 8 ? ~BitSet64{0} : (BitSet64{1} << 8 * frame.length) - 1;
    for (const DecodeRow& row : decodeRows(frame, {message.family, message.id, false, message.lengths})) {
      EXPECT_FALSE(row.name.isEmpty()) << sample.name;
      EXPECT_FALSE(row.value.isEmpty()) << sample.name << row.name.toStdString();
      EXPECT_EQ(row.bits == 0, row.raw.isEmpty()) << sample.name << row.name.toStdString();
      const bool missing = row.value == QStringLiteral("no value");
      EXPECT_TRUE(missing || (row.bits & ~there) == 0) << sample.name << row.name.toStdString();
    }
  }
}

}  // namespace
}  // namespace deckpipe
