// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/payload_bits.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

namespace deckpipe {
namespace {

TEST(PayloadGeometry, HasBitEightOfByteOneAtTheTopLeft) {
  const PayloadGeometry g{.cellWidth = 30, .cellHeight = 20};
  EXPECT_EQ(g.cell(7), QRectF(36, 22, 30, 20));
  EXPECT_EQ(g.cell(0), QRectF(36 + 7 * 30, 22, 30, 20));
  EXPECT_EQ(g.cell(8 * 7 + 4), QRectF(36 + 3 * 30, 22 + 7 * 20, 30, 20));
  for (int bit = 0; bit < 64; ++bit) EXPECT_EQ(g.bitAt(g.cell(bit).center()), bit);
  EXPECT_EQ(g.bitAt({10, 40}), -1);
  EXPECT_EQ(g.bitAt({40, 10}), -1);
  EXPECT_EQ(g.bitAt({40, 22 + 8 * 20}), -1);
  EXPECT_EQ(g.bitAt({36 + 8 * 30, 40}), -1);
}

TEST(PayloadGeometry, OutlinesBitsThatTouchAsOneShape) {
  const PayloadGeometry g;
  EXPECT_TRUE(g.outline(0).empty());
  EXPECT_EQ(g.outline(1).size(), 4u);
  EXPECT_EQ(g.outline(3).size(), 6u) << "two cells without the line between them";
  EXPECT_EQ(g.outline(0x0101).size(), 6u) << "one below the other";
  EXPECT_EQ(g.outline(0xFF).size(), 18u);
  EXPECT_EQ(g.outline(~0ull).size(), 32u);
}

struct PayloadBitsTest : testing::Test {
  PayloadBits bits;
  QSignalSpy picked{&bits, &PayloadBits::bitPicked};

  PayloadBitsTest() {
    bits.resize(bits.sizeHint());
    bits.show();
    bits.setValues({.bytes = {0x01, 0x1D, 0x94}, .length = 3});
  }
  std::uint64_t last() const { return picked.isEmpty() ? 0 : picked.last()[0].value<std::uint64_t>(); }
};

TEST_F(PayloadBitsTest, PicksTheBitThatIsClicked) {
  const PayloadGeometry g = PayloadGeometry::fitting(bits.size());
  QTest::mouseClick(&bits, Qt::LeftButton, {}, g.cell(10).center().toPoint());
  EXPECT_EQ(last(), 1ull << 10);
  QTest::mouseClick(&bits, Qt::LeftButton, {}, g.cell(30).center().toPoint());
  EXPECT_EQ(picked.count(), 1) << "the frame has three bytes";
}

TEST_F(PayloadBitsTest, PicksBitsWithTheArrowKeysInReadingOrder) {
  QTest::keyClick(&bits, Qt::Key_Right);
  EXPECT_EQ(last(), 1ull << 6);
  QTest::keyClick(&bits, Qt::Key_Down);
  EXPECT_EQ(last(), 1ull << 14);
  QTest::keyClick(&bits, Qt::Key_End);
  EXPECT_EQ(last(), 1ull << 16);
  QTest::keyClick(&bits, Qt::Key_Right);
  EXPECT_EQ(picked.count(), 3);
  QTest::keyClick(&bits, Qt::Key_Home);
  EXPECT_EQ(last(), 1ull << 7);
  QTest::keyClick(&bits, Qt::Key_Left);
  QTest::keyClick(&bits, Qt::Key_Up);
  EXPECT_EQ(picked.count(), 4);
  bits.setValues({.bytes = {0x01, 0x1D, 0x94}, .length = 3, .selected = 0x0F0000});
  QTest::keyClick(&bits, Qt::Key_Right);
  EXPECT_EQ(last(), 1ull << 18) << "goes on from the selected field";
}

TEST_F(PayloadBitsTest, SaysItsBytes) {
  EXPECT_EQ(bits.accessibleDescription().toStdString(), "hex 01 1D 94");
  bits.setValues({});
  EXPECT_EQ(bits.accessibleDescription().toStdString(), "no data");
  QTest::keyClick(&bits, Qt::Key_End);
  EXPECT_EQ(picked.count(), 0);
  bits.grab();
}

}  // namespace
}  // namespace deckpipe
