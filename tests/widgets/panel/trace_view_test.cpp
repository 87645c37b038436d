// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/trace_view.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QHelpEvent>
#include <QImage>
#include <QPaintEvent>
#include <QScreen>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>

#include "support/frames.h"
#include "support/logs.h"
#include "support/look.h"
#include "support/raw_frames.h"
#include "widgets/panel/panel_samples.h"

namespace deckpipe {
namespace {

std::vector<Frame> manyFrames(std::size_t count, std::size_t from = 0) {
  std::vector<Frame> frames;
  for (std::size_t i = from; i < from + count; ++i)
    frames.push_back(
        test::frame("18EFFF80", "011D940371000041", 0, static_cast<std::int64_t>(i) * 1'000'000));
  return frames;
}

struct TraceViewTest : testing::Test {
  TraceModel model;
  TraceView view;
  std::shared_ptr<LogDocument> log;

  TraceViewTest() {
    view.setModel(&model);
    view.resize(1366, 480);
    view.show();
    view.setFocus();
  }
  void open(std::size_t frames, std::optional<std::uint64_t> cursor = {}) {
    log = test::logOf(manyFrames(frames));
    tick(cursor);
  }
  void tick(std::optional<std::uint64_t> cursor = {}) { model.setView(test::viewOf(log, cursor)); }
  void grow(std::size_t by) { ASSERT_TRUE(log->frames.append(manyFrames(by, log->frames.count()))); }

  std::uint64_t page() const { return view.scroll().pageRows; }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&view, key, modifiers);
  }
  void wheel(int angle) {
    const QPointF at(200, 200);
    QWheelEvent event(at, view.viewport()->mapToGlobal(at), {}, {0, angle}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view.viewport(), &event);
  }
  QPoint pointOf(std::uint64_t row) const {
    return {300, static_cast<int>(row - view.topRow()) * view.rowHeight() + view.rowHeight() / 2};
  }
  void click(std::uint64_t row, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::mouseClick(view.viewport(), Qt::LeftButton, modifiers, pointOf(row));
  }
};

TEST_F(TraceViewTest, LivesWithoutALogAndWithAnEmptyOne) {
  view.grab();
  for (const Qt::Key k : {Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Home,
                          Qt::Key_End, Qt::Key_Return, Qt::Key_Left, Qt::Key_Right})
    key(k);
  key(Qt::Key_C, Qt::ControlModifier);
  key(Qt::Key_A, Qt::ControlModifier);
  wheel(-120);
  QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, {300, 50});
  EXPECT_FALSE(view.currentFrame());
  log = std::make_shared<LogDocument>();
  tick();
  view.grab();
  key(Qt::Key_End);
  EXPECT_FALSE(view.currentFrame());
  EXPECT_TRUE(view.copyText().isEmpty());
}

TEST_F(TraceViewTest, AsksForTheRowsInSightAndFewMore) {
  open(10'000, 0);
  EXPECT_EQ(view.topRow(), 0u);
  EXPECT_LE(static_cast<std::uint64_t>(model.rowCount()), 3 * page() + 1);
  view.verticalScrollBar()->setValue(5'000);
  EXPECT_EQ(view.topRow(), 5'000u);
  EXPECT_LE(model.windowFirst(), 5'000u);
  EXPECT_GE(model.windowFirst() + static_cast<std::uint64_t>(model.rowCount()), 5'000 + page() + 1);
}

// How many pixels high the damage is that a viewport draws.
struct PaintedHeight : QObject {
  explicit PaintedHeight(QWidget* viewport) { viewport->installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) height += static_cast<QPaintEvent*>(event)->rect().height();
    return false;
  }
  int height = 0;
};

TEST_F(TraceViewTest, DrawsOnlyTheRowsThatCameAndMovesTheOthersAlong) {
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  open(1'000);
  view.clearFocus();
  const auto isAsDrawnAnew = [&] {
    QApplication::sendPostedEvents();
    const QRect area = view.viewport()->geometry();
    const QImage seen =
        view.screen()->grabWindow(view.winId(), area.x(), area.y(), area.width(), area.height()).toImage();
    const QImage anew = view.viewport()->grab().toImage();
    return seen.convertToFormat(QImage::Format_RGB32) == anew.convertToFormat(QImage::Format_RGB32);
  };
  EXPECT_TRUE(isAsDrawnAnew());
  for (const std::size_t frames : {1u, 3u, 0u, 2u, 1'000u}) {
    PaintedHeight painted(view.viewport());
    grow(frames);
    tick();
    QApplication::sendPostedEvents();
    if (frames < page()) {
      EXPECT_LE(painted.height, static_cast<int>(frames + 2) * view.rowHeight()) << frames;
    }
    EXPECT_EQ(painted.height == 0, frames == 0);
    EXPECT_TRUE(isAsDrawnAnew()) << frames;
  }
  // The cursor moves by itself, also while rows come that are not in sight.
  for (const std::uint64_t cursor : {2'005u, 2'004u, 1'995u}) {
    grow(2);
    tick(cursor);
    EXPECT_TRUE(isAsDrawnAnew()) << cursor;
  }
}

TEST_F(TraceViewTest, FollowsTheEndUntilOneScrollsUp) {
  open(10'000);
  EXPECT_TRUE(view.isFollowing());
  EXPECT_EQ(view.topRow(), 10'000 - page());
  grow(500);
  tick();
  EXPECT_EQ(view.topRow(), 10'500 - page());
  QSignalSpy following(&view, &TraceView::followingChanged);
  wheel(120);
  EXPECT_FALSE(view.isFollowing());
  const std::uint64_t top = view.topRow();
  EXPECT_EQ(top, 10'500 - page() - static_cast<std::uint64_t>(QApplication::wheelScrollLines()));
  grow(500);
  tick();
  EXPECT_EQ(view.topRow(), top);
  key(Qt::Key_End);
  EXPECT_TRUE(view.isFollowing());
  EXPECT_EQ(view.topRow(), 11'000 - page());
  EXPECT_EQ(following.count(), 2);
  wheel(120);
  wheel(-120);
  EXPECT_TRUE(view.isFollowing()) << "the wheel came back to the end";
}

TEST_F(TraceViewTest, StaysWhereTheCursorStoppedAndGoesOnWithIt) {
  open(10'000);
  const std::uint64_t top = view.topRow();
  grow(100);
  tick(10'000);
  EXPECT_FALSE(view.isFollowing());
  EXPECT_EQ(view.topRow(), top);
  grow(100);
  tick();
  EXPECT_TRUE(view.isFollowing());
  EXPECT_EQ(view.topRow(), 10'200 - page());
}

TEST_F(TraceViewTest, KeepsACursorInSightThatWasInSight) {
  open(10'000, 5);
  EXPECT_EQ(view.topRow(), 0u);
  tick(page() + 30);
  EXPECT_EQ(view.topRow(), 30u);
  key(Qt::Key_Home);
  EXPECT_EQ(view.topRow(), 0u);
  tick(page() + 60);
  EXPECT_EQ(view.topRow(), 0u) << "it was out of sight: the person looks elsewhere";
}

TEST_F(TraceViewTest, MovesByKeys) {
  open(10'000, 0);
  QSignalSpy current(&view, &TraceView::currentFrameChanged);
  key(Qt::Key_Down);
  EXPECT_EQ(view.currentFrame(), 0u);
  key(Qt::Key_Down);
  EXPECT_EQ(view.currentFrame(), 1u);
  key(Qt::Key_PageDown);
  EXPECT_EQ(view.currentFrame(), page());
  EXPECT_EQ(view.topRow(), 1u);
  key(Qt::Key_Up);
  EXPECT_EQ(view.currentFrame(), page() - 1);
  key(Qt::Key_PageUp);
  EXPECT_EQ(view.currentFrame(), 0u);
  key(Qt::Key_Up);
  EXPECT_EQ(view.currentFrame(), 0u);
  key(Qt::Key_End, Qt::ControlModifier);
  EXPECT_EQ(view.currentFrame(), 9'999u);
  EXPECT_EQ(view.topRow(), 10'000 - page());
  key(Qt::Key_Home, Qt::ControlModifier);
  EXPECT_EQ(view.currentFrame(), 0u);
  EXPECT_EQ(view.topRow(), 0u);
  EXPECT_EQ(current.count(), 7);
}

TEST_F(TraceViewTest, SelectsWithTheMouseAndAsksForTheCursor) {
  open(10'000, 0);
  QSignalSpy cursor(&view, &TraceView::cursorRequested);
  click(7);
  EXPECT_EQ(view.currentFrame(), 7u);
  EXPECT_TRUE(cursor.isEmpty());
  QTest::mouseDClick(view.viewport(), Qt::LeftButton, {}, pointOf(9));
  ASSERT_EQ(cursor.count(), 1);
  EXPECT_EQ(cursor[0][0].value<std::uint64_t>(), 9u);
  click(4);
  key(Qt::Key_Return);
  ASSERT_EQ(cursor.count(), 2);
  EXPECT_EQ(cursor[1][0].value<std::uint64_t>(), 4u);
}

TEST_F(TraceViewTest, CopiesTheSelectionAsCandumpReadsIt) {
  const std::string text = test::busyText(20);
  log = test::logOfText(text);
  tick(0);
  click(2);
  click(4, Qt::ShiftModifier);
  key(Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text().toStdString(),
            "(1700000000.310000) can1 5A4#4300500116699803\n"
            "(1700000000.500000) can0 18EFFF80#0100040371000001\n"
            "(1700000000.500400) can0 18EFFF80#83C071\n");
  key(Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(view.currentFrame(), 4u);
  EXPECT_EQ(view.copyText().toStdString(), text);
}

TEST_F(TraceViewTest, CopiesNoMoreThanAClipboardShouldHoldAndSaysSo) {
  open(TraceView::kMaxCopied + 50, 0);
  key(Qt::Key_A, Qt::ControlModifier);
  key(Qt::Key_C, Qt::ControlModifier);
  const QString copied = QApplication::clipboard()->text();
  EXPECT_EQ(copied.count(u'\n'), TraceView::kMaxCopied + 1);
  EXPECT_TRUE(copied.endsWith(
      QStringLiteral("\n# 50 more selected rows are not copied: save the selection instead.\n")))
      << copied.right(200).toStdString();
  const auto read = test::logOfText(copied.toStdString());
  EXPECT_EQ(read->frames.count(), TraceView::kMaxCopied);
  EXPECT_EQ(read->skipped.content().unreadable(), 0u);
}

TEST_F(TraceViewTest, TellsTheCurrentRowToWhoCannotSeeIt) {
  log = test::logOfText(test::busyText(20));
  tick(3);
  click(3);
  EXPECT_EQ(view.accessibleName(), QStringLiteral("Trace"));
  EXPECT_EQ(view.accessibleDescription().toStdString(),
            "frame 4, after the cursor, time 0.500000, can0, identifier 18EFFF80, Position / limit "
            "status, "
            "Rotation 0.0°, Elevation −5.5°");
}

TEST_F(TraceViewTest, ScrollsByRowsAndPagesOfItsBar) {
  open(10'000, 0);
  QScrollBar* bar = view.verticalScrollBar();
  bar->triggerAction(QAbstractSlider::SliderSingleStepAdd);
  EXPECT_EQ(view.topRow(), 1u);
  bar->triggerAction(QAbstractSlider::SliderPageStepAdd);
  EXPECT_EQ(view.topRow(), 1 + page());
  bar->triggerAction(QAbstractSlider::SliderSingleStepSub);
  EXPECT_EQ(view.topRow(), page());
  EXPECT_EQ(bar->value(), static_cast<int>(page()));
  bar->triggerAction(QAbstractSlider::SliderToMaximum);
  EXPECT_EQ(view.topRow(), 10'000 - page());
  EXPECT_TRUE(view.isFollowing());
  bar->triggerAction(QAbstractSlider::SliderToMinimum);
  EXPECT_EQ(view.topRow(), 0u);
  EXPECT_FALSE(view.isFollowing());
}

TEST_F(TraceViewTest, TellsInToolTipsWhatCellsHaveNoRoomFor) {
  log = test::logOf(
      {test::frame("18EFFF80", "FF83150206021A0B", 0, 1), test::frame("18EF80F2", "FE3C623E78", 0, 2)});
  tick(1);
  const auto tip = [this](int x, std::uint64_t row) {
    const QPoint at(x, pointOf(row).y());
    QHelpEvent event(QEvent::ToolTip, at, view.viewport()->mapToGlobal(at));
    QApplication::sendEvent(view.viewport(), &event);
    return QToolTip::text();
  };
  const int decoded = view.header()->sectionViewportPosition(TraceModel::Decoded) + 20;
  EXPECT_TRUE(tip(decoded, 0).contains(QStringLiteral("Device type: 1032 (6032 Universal II)")));
  EXPECT_TRUE(tip(decoded, 1).contains(QStringLiteral("“&lt;b&gt;x”"))) << "never taken for HTML";
  EXPECT_TRUE(tip(10, 1).contains(QStringLiteral("after the cursor")));
}

TEST_F(TraceViewTest, ForgetsTheSelectionWithAnotherLog) {
  open(100, 0);
  click(3);
  QSignalSpy current(&view, &TraceView::currentFrameChanged);
  open(100, 0);
  EXPECT_FALSE(view.currentFrame());
  EXPECT_EQ(current.count(), 1);
  view.setCurrentFrame(500);
  EXPECT_FALSE(view.currentFrame()) << "no such row";
  view.setCurrentFrame(99);
  EXPECT_EQ(view.currentFrame(), 99u);
  EXPECT_TRUE(view.scroll().shows(99));
}

TEST_F(TraceViewTest, RemembersItsColumns) {
  open(100, 0);
  view.header()->resizeSection(TraceModel::Name, 333);
  const QByteArray state = view.saveState();
  TraceModel other;
  TraceView again;
  again.setModel(&other);
  again.resize(1366, 480);
  EXPECT_TRUE(again.restoreState(state));
  EXPECT_EQ(again.header()->sectionSize(TraceModel::Name), 333);
  EXPECT_FALSE(again.restoreState(QByteArray("nonsense")));
  open(50, 0);
  EXPECT_EQ(view.header()->sectionSize(TraceModel::Name), 333) << "another log changes no column";
}

TEST_F(TraceViewTest, ColumnsHoldTheirWidestTextsAndFitTheWindow) {
  EXPECT_LE(view.header()->length() + TracePainter::kGutter, view.viewport()->width());
  EXPECT_GE(view.header()->sectionSize(TraceModel::Decoded), 300);
  EXPECT_GE(view.header()->height(), 32);
}

TEST_F(TraceViewTest, DrawsTheScrollBarOnlyWhereItsSliderMoves) {
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  open(10'000);
  QApplication::sendPostedEvents();
  PaintedHeight painted(view.verticalScrollBar());
  grow(3);
  tick();
  QApplication::sendPostedEvents();
  EXPECT_EQ(painted.height, 0);
  EXPECT_EQ(view.verticalScrollBar()->maximum(), static_cast<int>(10'003 - page()));
  EXPECT_EQ(view.verticalScrollBar()->value(), view.verticalScrollBar()->maximum());
  key(Qt::Key_Home);
  QApplication::sendPostedEvents();
  EXPECT_GT(painted.height, 0);
}

// Every kind of row in every theme, selected or not, with cells scrolled to the side.
TEST_F(TraceViewTest, DrawsWhateverComes) {
  Frame noTime = test::frame("7FF", "");
  noTime.stamp = kNoStamp;
  std::vector<Frame> odd{test::remoteFrame(0x701, 8),
                         test::frameOf(kErrorBit | 0x1FF, {1, 2, 3, 4, 5, 6, 7, 8}),
                         test::frameOf(kErrorBit | kExtendedBit, {}),
                         test::remoteFrame(0x18EFFF80 | kExtendedBit, 0),
                         noTime,
                         test::frame("18EFFF80", "01"),
                         test::frame("18EF80F2", "FE"),
                         test::frame("000", "")};
  log = test::logOf(odd);
  for (const Theme theme : kThemes) {
    const test::Look look(theme);
    tick(3);
    for (std::uint64_t row = 0; row < odd.size(); ++row) {
      view.setCurrentFrame(row);
      EXPECT_FALSE(view.grab().isNull());
    }
    view.resize(300, 200);
    view.horizontalScrollBar()->setValue(view.horizontalScrollBar()->maximum());
    EXPECT_FALSE(view.grab().isNull());
    view.resize(1366, 480);
  }
  view.resize(1, 1);
  view.grab();
}

}  // namespace
}  // namespace deckpipe
