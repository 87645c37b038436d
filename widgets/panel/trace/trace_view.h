// SPDX-License-Identifier: GPL-3.0-or-later
// The trace: rows of a log of any length, of which only those in sight are ever asked for. The console gives
// it the model that it feeds on each tick, listens for the selected frame (the decode panel shows it) and for
// the intent to put the cursor at a frame.
//
//   1. Positions are 64-bit rows of the log (trace_scroll.h); the scroll bar only mirrors them.
//   2. While it follows, the view stands at the log's end and goes with it. Scrolling up ends that, reaching
//      the end by wheel, key or bar resumes it, and so does the cursor when it comes to the live edge; the
//      cursor leaving the live edge ends it, so that what a person stopped to look at stays.
//   3. A cursor that was in sight is kept in sight while it moves.
//   4. What is current and selected are frames, which a filter does not change; what is scrolled are rows.
//      When the filter changes, the frame that was looked at, or the next one that is let through, stays in
//      place.
//   5. Nothing here sends anything.
#pragma once

#include <QAbstractScrollArea>
#include <cstdint>
#include <memory>
#include <optional>

#include "model/trace_model.h"
#include "paint/palette.h"
#include "panel/common/flat_header.h"
#include "panel/trace/trace_painter.h"
#include "panel/trace/trace_scroll.h"

namespace deckpipe {

class TraceScrollBar;

class TraceView : public QAbstractScrollArea {
  Q_OBJECT

 public:
  // Of a longer selection only so many rows are copied, and the copy says at its end how many are not.
  static constexpr std::uint64_t kMaxCopied = 100'000;

  explicit TraceView(QWidget* parent = nullptr);

  // Not owned; it lives longer than the view.
  void setModel(TraceModel* model);
  TraceModel* model() const { return m_model; }

  std::optional<std::uint64_t> currentFrame() const { return m_current; }
  void setCurrentFrame(std::optional<std::uint64_t> frame);
  bool isFollowing() const { return m_isFollowing; }
  void setFollowing(bool isFollowing);
  std::uint64_t topRow() const { return m_scroll.top; }
  const TraceScroll& scroll() const { return m_scroll; }
  int rowHeight() const { return m_rowHeight; }
  FlatHeader* header() const { return m_header; }

  // The selected rows as text of the usual log format; what Ctrl+C puts on the clipboard.
  QString copyText() const;
  // The first frame of the selection and the one behind its last; nothing selected: empty.
  struct FrameRange {
    std::uint64_t first = 0, end = 0;
    bool has(std::uint64_t frame) const { return frame >= first && frame < end; }
    bool isEmpty() const { return first >= end; }
  };
  FrameRange selection() const { return m_selection; }
  // What a person points at or has chosen, for a menu: the frame, and the column under the pointer.
  struct Cell {
    std::uint64_t frame = 0;
    int column = 0;
  };
  std::optional<Cell> cellAt(QPoint viewportPoint) const;

  void copy();
  QModelIndex indexOfFrame(std::uint64_t frame, int column) const;

  void setColumnShown(int column, bool isShown);
  void resetColumns();
  // Column widths, for the caller's settings.
  QByteArray saveState() const;
  bool restoreState(const QByteArray& state);

  QSize sizeHint() const override { return {1100, 360}; }

 Q_SIGNALS:
  void currentFrameChanged(std::optional<std::uint64_t> frame);
  void cursorRequested(std::uint64_t frame);
  void detailRequested();
  void followingChanged(bool isFollowing);
  void menuRequested(std::optional<deckpipe::TraceView::Cell> cell, const QPoint& global);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;
  bool viewportEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void takeView();
  void keepInPlace();
  void notePlace();
  void layOut();
  void stretchDecoded();
  void setUsualWidths();
  void updateFonts();
  std::vector<TraceColumn> columns() const;

  // After m_scroll changed: window, bar, picture.
  void showScroll();
  void syncScroll();
  // The same log grew or its cursor moved: what is drawn already moves along, and the rest is drawn.
  void showGrowth(const TraceScroll& before, std::uint64_t cursorRowBefore);
  QRect rectOfRows(std::uint64_t first, std::uint64_t end) const;
  void scrollByHand(std::int64_t rows);
  void barActed(int action);
  void select(std::uint64_t frame, bool extend);
  void selectRow(std::uint64_t row, bool extend);
  void moveCurrent(std::int64_t by, bool extend);
  void selectAll();
  std::optional<std::uint64_t> rowAt(QPointF point) const;
  QModelIndex indexOf(std::uint64_t row, int column = 0) const;
  void describe();
  void showToolTip(const QPoint& at, const QPoint& global);

  TraceModel* m_model = nullptr;
  FlatHeader* m_header = nullptr;
  TraceScrollBar* m_bar;
  TraceFonts m_fonts;
  int m_rowHeight = 24;
  TraceScroll m_scroll;
  std::shared_ptr<const LogDocument> m_log;  // whose rows the numbers below are
  std::optional<std::uint64_t> m_current;
  std::uint64_t m_anchor = 0;  // the frame where extending the selection began
  FrameRange m_selection;
  std::uint64_t m_cursorRow = 0;
  std::uint64_t m_cursorFrames = 0;
  // While a new filter is looked through: the frame that stays in sight, and how many rows from the top.
  struct Kept {
    std::uint64_t frame = 0, rowsBelowTop = 0;
  };
  std::optional<Kept> m_kept;
  Kept m_place;  // what would stay, if the filter were to change now
  bool m_wasAtEnd = true;
  bool m_isFollowing = true;
  int m_wheelRest = 0;
};

}  // namespace deckpipe
