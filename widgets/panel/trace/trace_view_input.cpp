// SPDX-License-Identifier: GPL-3.0-or-later
// What a person does to the trace: wheel, scroll bar, keys, mouse, tooltips, clipboard.
#include <QApplication>
#include <QClipboard>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScrollBar>
#include <QToolTip>
#include <QWhatsThis>
#include <QWheelEvent>
#include <algorithm>

#include "paint/plain_tip.h"
#include "panel/trace/trace_view.h"

namespace deckpipe {
namespace {

constexpr int kWheelNotch = 120;

}  // namespace

void TraceView::scrollByHand(std::int64_t rows) {
  m_kept.reset();
  m_scroll.moveBy(rows);
  showScroll();
  setFollowing(m_scroll.isAtEnd());
}

// Steps are taken in rows, also where a step of the bar is many rows.
void TraceView::barActed(int action) {
  const auto page = static_cast<std::int64_t>(m_scroll.pageRows);
  switch (action) {
    case QAbstractSlider::SliderSingleStepAdd: scrollByHand(1); break;
    case QAbstractSlider::SliderSingleStepSub: scrollByHand(-1); break;
    case QAbstractSlider::SliderPageStepAdd: scrollByHand(page); break;
    case QAbstractSlider::SliderPageStepSub: scrollByHand(-page); break;
    default: return;
  }
  verticalScrollBar()->setSliderPosition(m_scroll.barValue());
}

void TraceView::scrollContentsBy(int dx, int) {
  if (dx != 0) {
    m_header->scrollTo(horizontalScrollBar()->value());
    viewport()->update();
  }
  const int value = verticalScrollBar()->value();
  if (value == m_scroll.barValue()) return;
  m_kept.reset();
  m_scroll.moveTo(m_scroll.topOf(value));
  showScroll();
  setFollowing(m_scroll.isAtEnd());
}

void TraceView::wheelEvent(QWheelEvent* event) {
  if (event->modifiers() & Qt::ShiftModifier || event->angleDelta().y() == 0) {
    QApplication::sendEvent(horizontalScrollBar(), event);
    return;
  }
  // Touchpads send parts of a notch.
  m_wheelRest += event->angleDelta().y() * QApplication::wheelScrollLines();
  const int rows = m_wheelRest / kWheelNotch;
  m_wheelRest -= rows * kWheelNotch;
  if (rows != 0) scrollByHand(-rows);
  event->accept();
}

void TraceView::setCurrentFrame(std::optional<std::uint64_t> frame) {
  if (frame && m_model != nullptr && *frame < m_model->view().frameCount) {
    select(*frame, false);
  } else if (m_current) {
    m_current.reset();
    m_selection = {};
    describe();
    viewport()->update();
    Q_EMIT currentFrameChanged(m_current);
  }
}

// A frame that the filter hides may be current as well: its place is shown.
void TraceView::select(std::uint64_t frame, bool extend) {
  const bool isNew = m_current != frame;
  if (!extend || !m_current) m_anchor = frame;
  m_current = frame;
  m_selection = {std::min(m_anchor, frame), std::max(m_anchor, frame) + 1};
  const std::uint64_t row = m_model->rowOf(frame);
  if (!m_scroll.shows(row) && m_scroll.rows > 0) {
    m_kept.reset();
    m_scroll.show(std::min(row, m_scroll.rows - 1));
    showScroll();
    setFollowing(m_scroll.isAtEnd());
  }
  notePlace();
  viewport()->update();
  if (!isNew) return;
  describe();
  Q_EMIT currentFrameChanged(m_current);
}

void TraceView::selectRow(std::uint64_t row, bool extend) {
  if (const auto frame = m_model->frameOf(row)) select(*frame, extend);
}

// All rows there are now; what is in sight, and looked at, stays.
void TraceView::selectAll() {
  if (m_scroll.rows == 0) return;
  if (!m_current) selectRow(m_scroll.top, false);
  m_selection = {0, m_model->view().frameCount};
  viewport()->update();
}

void TraceView::moveCurrent(std::int64_t by, bool extend) {
  if (m_scroll.rows == 0) return;
  if (!m_current) {
    // The first key picks what is in sight.
    selectRow(by < 0 ? std::min(m_scroll.top + m_scroll.pageRows, m_scroll.rows) - 1 : m_scroll.top, false);
    return;
  }
  const std::uint64_t last = m_scroll.rows - 1;
  const std::uint64_t row = m_model->rowOf(*m_current);
  // Where the filter hides the current frame, the row there is already the next.
  if (by > 0 && row <= last && m_model->frameOf(row) != m_current) --by;
  const std::uint64_t far = by < 0 ? 0 - static_cast<std::uint64_t>(by) : static_cast<std::uint64_t>(by);
  const std::uint64_t from = std::min(row, last);
  selectRow(by < 0 ? row - std::min(row, far) : from + std::min(last - from, far), extend);
}

void TraceView::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) {
    copy();
    return;
  }
  if (event->matches(QKeySequence::SelectAll)) {
    selectAll();
    return;
  }
  const bool extend = (event->modifiers() & Qt::ShiftModifier) != 0;
  const auto page = static_cast<std::int64_t>(std::max<std::uint64_t>(m_scroll.pageRows, 2) - 1);
  const std::uint64_t last = m_scroll.rows == 0 ? 0 : m_scroll.rows - 1;
  switch (event->key()) {
    case Qt::Key_Up: moveCurrent(-1, extend); break;
    case Qt::Key_Down: moveCurrent(1, extend); break;
    case Qt::Key_PageUp: moveCurrent(-page, extend); break;
    case Qt::Key_PageDown: moveCurrent(page, extend); break;
    case Qt::Key_Home: selectRow(0, extend); break;
    case Qt::Key_End:
      selectRow(last, extend);
      setFollowing(true);
      break;
    case Qt::Key_Left: horizontalScrollBar()->triggerAction(QAbstractSlider::SliderSingleStepSub); break;
    case Qt::Key_Right: horizontalScrollBar()->triggerAction(QAbstractSlider::SliderSingleStepAdd); break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (m_current) Q_EMIT cursorRequested(*m_current);
      break;
    case Qt::Key_Space:
      if (m_current) Q_EMIT detailRequested();
      break;
    default: QAbstractScrollArea::keyPressEvent(event);
  }
}

std::optional<std::uint64_t> TraceView::rowAt(QPointF point) const {
  if (m_model == nullptr || point.y() < 0) return {};
  const std::uint64_t row =
      m_scroll.top + static_cast<std::uint64_t>(point.y()) / static_cast<unsigned>(m_rowHeight);
  return row < m_scroll.rows ? std::optional(row) : std::nullopt;
}

void TraceView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (const auto row = rowAt(event->position()))
    selectRow(*row, (event->modifiers() & Qt::ShiftModifier) != 0);
}

void TraceView::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton) || !m_current) return;
  if (const auto row = rowAt(event->position())) selectRow(*row, true);
}

std::optional<TraceView::Cell> TraceView::cellAt(QPoint point) const {
  const auto row = rowAt(point);
  const auto frame = row ? m_model->frameOf(*row) : std::nullopt;
  if (!frame) return {};
  const int column = point.x() < TracePainter::kGutter ? -1 : m_header->logicalIndexAt(point.x());
  return Cell{*frame, column};
}

// By mouse for the cell under it, by key for the current row.
void TraceView::contextMenuEvent(QContextMenuEvent* event) {
  if (m_model == nullptr) return;
  if (event->reason() == QContextMenuEvent::Keyboard) {
    std::optional<Cell> cell;
    QPoint at(TracePainter::kGutter, 0);
    if (m_current) {
      cell = Cell{*m_current, -1};
      const std::uint64_t row = m_model->rowOf(*m_current);
      if (m_scroll.shows(row)) at.setY(static_cast<int>(row - m_scroll.top + 1) * m_rowHeight);
    }
    Q_EMIT menuRequested(cell, viewport()->mapToGlobal(at));
    return;
  }
  const auto cell = cellAt(viewport()->mapFromGlobal(event->globalPos()));
  if (cell && !m_selection.has(cell->frame)) select(cell->frame, false);
  Q_EMIT menuRequested(cell, event->globalPos());
}

void TraceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (const auto row = rowAt(event->position())) {
    if (const auto frame = m_model->frameOf(*row)) Q_EMIT cursorRequested(*frame);
  }
}

void TraceView::focusInEvent(QFocusEvent* event) {
  QAbstractScrollArea::focusInEvent(event);
  viewport()->update();
}

void TraceView::focusOutEvent(QFocusEvent* event) {
  QAbstractScrollArea::focusOutEvent(event);
  viewport()->update();
}

void TraceView::copy() {
  if (!m_current) return;
  QApplication::clipboard()->setText(copyText());
}

// The current row, for those who hear it and for whoever asks what it means.
void TraceView::describe() {
  const QModelIndex index = m_current ? indexOfFrame(*m_current, 0) : QModelIndex();
  setAccessibleDescription(index.data(Qt::AccessibleTextRole).toString());
  const QString story = index.data(Qt::WhatsThisRole).toString();
  setWhatsThis(story.isEmpty()
                   ? tr("Every frame of the log as it came, with what it says. Up and Down choose "
                        "a frame, which is then shown in detail; Enter or a double click puts the "
                        "cursor there. A right click filters by what is pointed at.")
                   : plainTip(story));
}

bool TraceView::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    showToolTip(help->pos(), help->globalPos());
    return true;
  }
  if (event->type() == QEvent::WhatsThis) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto row = rowAt(help->pos());
    const QString story = row ? indexOf(*row).data(Qt::WhatsThisRole).toString() : QString();
    QWhatsThis::showText(help->globalPos(), story.isEmpty() ? whatsThis() : plainTip(story), viewport());
    return true;
  }
  return QAbstractScrollArea::viewportEvent(event);
}

// A cell's own tooltip, or the whole text of one that is cut off; in the gutter its signs in words.
void TraceView::showToolTip(const QPoint& at, const QPoint& global) {
  QString text;
  if (const auto row = rowAt(at)) {
    if (at.x() < TracePainter::kGutter) {
      text = TraceModel::marksText(
          TraceModel::Marks::fromInt(indexOf(*row).data(TraceModel::MarksRole).toUInt()));
    } else if (const int column = m_header->logicalIndexAt(at.x()); column >= 0) {
      const QModelIndex index = indexOf(*row, column);
      text = index.data(Qt::ToolTipRole).toString();
      const QString shown = index.data().toString();
      const int room = m_header->sectionSize(column) - 2 * FlatHeader::kPadding;
      if (text.isEmpty() && QFontMetrics(m_fonts.of(column)).horizontalAdvance(shown) > room) text = shown;
    }
  }
  if (text.isEmpty()) {
    QToolTip::hideText();
  } else {
    QToolTip::showText(global, plainTip(text), viewport());
  }
}

}  // namespace deckpipe
