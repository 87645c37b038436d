// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/decode_panel.h"

#include <gtest/gtest.h>

#include <QTableView>
#include <QTest>

#include "paint/payload_bits.h"
#include "support/frames.h"
#include "support/logs.h"
#include "support/raw_frames.h"

namespace deckpipe {
namespace {

struct DecodePanelTest : testing::Test {
  DecodeModel model;
  DecodePanel panel;
  std::shared_ptr<LogDocument> log = test::logOf({
      test::frame("18EFFF80", "FF83150206021A0B", 0, 1),
      test::frame("18EFFF80", "011D940371000041", 0, 2),
      test::frame("18EFFF80", "01FFFF0371000041", 0, 3),
      test::frame("18EFFF80", "011D94", 0, 4),
      test::remoteFrame(0x701, 8),
      test::frameOf(kErrorBit | 0x40, {}),
  });

  DecodePanelTest() {
    panel.setModel(&model);
    panel.resize(520, 600);
    panel.show();
    model.setView(test::viewOf(log));
  }
  void selectField(const char* name) {
    for (int row = 0; row < model.rowCount(); ++row) {
      if (model.index(row, 0).data().toString() == QString::fromUtf8(name))
        panel.list()->setCurrentIndex(model.index(row, 0));
    }
  }
  std::string field() const {
    return panel.list()->currentIndex().siblingAtColumn(0).data().toString().toStdString();
  }
};

TEST_F(DecodePanelTest, BringsOutTheBitsOfTheSelectedField) {
  EXPECT_EQ(panel.payload()->values().length, 0);
  model.setFrame(1);
  EXPECT_EQ(panel.payload()->values().length, 8);
  EXPECT_EQ(panel.payload()->values().selected, 0u);
  selectField("Rotation");
  EXPECT_EQ(panel.payload()->values().selected, 0x00F0FF00u);
  EXPECT_EQ(panel.payload()->values().related, 0x000F0000u);
  selectField("Source");
  EXPECT_EQ(panel.payload()->values().selected, 0u);
}

TEST_F(DecodePanelTest, SelectsTheFieldOfABitThatIsPicked) {
  model.setFrame(1);
  const PayloadGeometry g = PayloadGeometry::fitting(panel.payload()->size());
  QTest::mouseClick(panel.payload(), Qt::LeftButton, {}, g.cell(8 * 7 + 1).center().toPoint());
  EXPECT_EQ(field(), "Calibrated");
  QTest::keyClick(panel.payload(), Qt::Key_Up);
  EXPECT_EQ(field(), "Axis 4 (-) hard stop");
}

TEST_F(DecodePanelTest, KeepsTheFieldWhileOneStepsThroughOneMessage) {
  model.setFrame(1);
  selectField("Elevation");
  model.setFrame(2);
  EXPECT_EQ(field(), "Elevation");
  EXPECT_EQ(panel.payload()->values().selected, 0x00F0FF000000u);
  EXPECT_EQ(panel.payload()->values().bytes[1], 0xFF);
  model.setFrame(0);
  EXPECT_EQ(panel.payload()->values().selected, 0u);
}

TEST_F(DecodePanelTest, DrawsWhateverComesAtEveryWidth) {
  for (const Theme theme : kThemes) {
    panel.setColours(coloursOf(theme));
    for (const QSize size : {QSize(1366, 300), QSize(520, 600), QSize(300, 300), QSize(1, 1)}) {
      panel.resize(size);
      for (std::uint64_t frame = 0; frame <= log->frames.count(); ++frame) {
        model.setFrame(frame);
        EXPECT_FALSE(panel.grab().isNull());
      }
    }
  }
  model.setView(test::viewOf(nullptr));
  panel.grab();
  EXPECT_EQ(model.rowCount(), 0);
}

}  // namespace
}  // namespace deckpipe
