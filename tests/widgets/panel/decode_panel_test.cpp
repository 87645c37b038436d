// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/decode_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include "paint/payload_bits.h"
#include "support/child.h"
#include "support/frames.h"
#include "support/logs.h"
#include "support/look.h"
#include "support/raw_frames.h"

namespace deckpipe {
namespace {

struct DecodePanelTest : testing::Test {
  DecodePanel panel;
  DecodeModel& model = *panel.model();
  std::shared_ptr<LogDocument> log = test::logOf({
      test::frame("18EFFF80", "FF83150206021A0B", 0, 1),
      test::frame("18EFFF80", "011D940371000041", 0, 2),
      test::frame("18EFFF80", "01FFFF0371000041", 0, 3),
      test::frame("18EFFF80", "011D94", 0, 4),
      test::remoteFrame(0x701, 8),
      test::frameOf(kErrorBit | 0x40, {}),
  });

  DecodePanelTest() {
    panel.resize(520, 600);
    panel.show();
    panel.showBits(true);
    QCoreApplication::sendPostedEvents();  // bits and fields take their places
    model.setView(test::viewOf(log));
  }
  void selectField(const char* name) {
    for (int row = 0; row < model.rowCount(); ++row) {
      if (model.index(row, 0).data().toString() == QString::fromUtf8(name))
        panel.list()->setCurrentIndex(model.index(row, 0));
    }
  }
  QRect rectOf(const char* name) const {
    for (int row = 0; row < model.rowCount(); ++row) {
      const QModelIndex index = model.index(row, 0);
      if (index.data().toString() != QString::fromUtf8(name)) continue;
      panel.list()->scrollTo(index);
      return panel.list()->visualRect(index);
    }
    return {};
  }
  QPoint centreOf(const char* name) const { return rectOf(name).center(); }
  QImage pictureOf(const char* name) const { return panel.list()->viewport()->grab(rectOf(name)).toImage(); }
  static void leave(QWidget* widget) {
    QEvent event(QEvent::Leave);
    QApplication::sendEvent(widget, &event);
  }
  std::string field() const {
    return panel.list()->currentIndex().siblingAtColumn(0).data().toString().toStdString();
  }
};

TEST_F(DecodePanelTest, HasItsBitsFoldedUntilTheyAreAskedFor) {
  DecodePanel fresh;
  fresh.resize(520, 300);
  fresh.show();
  fresh.model()->setView(test::viewOf(log));
  fresh.model()->setFrame(1);
  EXPECT_FALSE(fresh.payload()->isVisible());
  EXPECT_TRUE(fresh.list()->isColumnHidden(DecodeModel::Raw));
  EXPECT_TRUE(fresh.list()->isColumnHidden(DecodeModel::Place));
  EXPECT_GE(fresh.list()->columnWidth(DecodeModel::Value), 200);
  auto* fold = test::child<QToolButton>(fresh, "decodeBits");
  EXPECT_FALSE(fold->accessibleName().isEmpty());
  EXPECT_GE(fold->height(), 32);
  EXPECT_LE(fold->geometry().right(), fresh.list()->viewport()->width())
      << "the scroll bar does not cover it";
  QTest::mouseClick(fold, Qt::LeftButton);
  EXPECT_TRUE(fresh.payload()->isVisible());
  EXPECT_FALSE(fresh.list()->isColumnHidden(DecodeModel::Place));
  QTest::keyClick(fold, Qt::Key_Space);
  EXPECT_FALSE(fresh.payload()->isVisible());
}

TEST_F(DecodePanelTest, SaysWhatTheFrameSaysBeforeHowItIsMade) {
  model.setFrame(1);
  const auto rowOf = [this](const char* name) {
    for (int row = 0; row < model.rowCount(); ++row) {
      if (model.index(row, 0).data().toString() == QString::fromUtf8(name)) return row;
    }
    return -1;
  };
  EXPECT_EQ(rowOf("Message"), 0);
  EXPECT_LT(rowOf("Rotation"), rowOf("Message type"));
  EXPECT_LT(rowOf("Calibrated"), rowOf("Identifier"));
  EXPECT_NE(rowOf("Source"), -1);
}

TEST_F(DecodePanelTest, HasRowsForGlovesInTheField) {
  model.setFrame(1);
  for (const Density density : {Density::Desk, Density::Field}) {
    const test::Look look(Theme::Light, density);
    QCoreApplication::sendPostedEvents();
    EXPECT_EQ(panel.list()->rowHeight(0) >= 44, density == Density::Field) << panel.list()->rowHeight(0);
  }
}

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

TEST_F(DecodePanelTest, BringsOutTheBitsOfTheFieldUnderThePointerUntilItLeaves) {
  model.setFrame(1);
  selectField("Elevation");
  QWidget* rows = panel.list()->viewport();
  QTest::mouseMove(rows, centreOf("Rotation"));
  EXPECT_EQ(panel.payload()->values().pointed, 0x00F0FF00u);
  EXPECT_EQ(panel.payload()->values().shown(), 0x00F0FF00u);
  EXPECT_EQ(panel.payload()->values().related, 0x000F0000u);
  EXPECT_EQ(panel.payload()->values().selected, 0x00F0FF000000u) << "the selection stays what it is";
  QTest::mouseMove(rows, centreOf("Source"));
  EXPECT_EQ(panel.payload()->values().shown(), 0x00F0FF000000u) << "it has no bits of the payload";
  QTest::mouseMove(rows, centreOf("Rotation"));
  leave(rows);
  EXPECT_EQ(panel.payload()->values().shown(), 0x00F0FF000000u);
  EXPECT_EQ(field(), "Elevation");
}

TEST_F(DecodePanelTest, MarksTheFieldOfTheBitUnderThePointer) {
  model.setFrame(1);
  const PayloadGeometry g = PayloadGeometry::fitting(panel.payload()->size());
  const QImage before = pictureOf("Rotation");
  QTest::mouseMove(panel.payload(), g.cell(8).center().toPoint());
  EXPECT_EQ(panel.payload()->values().pointed, 0x00F0FF00u);
  EXPECT_NE(pictureOf("Rotation"), before);
  EXPECT_NE(field(), "Rotation") << "pointing selects nothing";
  leave(panel.payload());
  EXPECT_EQ(panel.payload()->values().pointed, 0u);
  EXPECT_EQ(pictureOf("Rotation"), before);
}

TEST_F(DecodePanelTest, PointsAtNothingOnceTheFieldsAreOthers) {
  model.setFrame(1);
  QTest::mouseMove(panel.list()->viewport(), centreOf("Rotation"));
  model.setFrame(2);
  EXPECT_EQ(panel.payload()->values().pointed, 0x00F0FF00u) << "the same message";
  model.setFrame(0);
  EXPECT_EQ(panel.payload()->values().pointed, 0u);
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
    const test::Look look(theme);
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
