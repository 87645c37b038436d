// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/trace_view.h"

#include <QEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>
#include <algorithm>
#include <string>

#include "log/candump.h"
#include "paint/app_style.h"
#include "paint/spoken.h"
#include "panel/common/build.h"
#include "text/plural.h"

namespace deckpipe {
namespace {

constexpr int kMinTraceRow = 22;
constexpr int kMinDecoded = 240;

// What a column must hold without being cut; Name and Decoded hold what they can.
QString widestText(int column) {
  switch (column) {
    case TraceModel::Time: return QStringLiteral("1700000000.000000");
    case TraceModel::Delta: return QStringLiteral("000.000000");
    case TraceModel::ChannelName: return QStringLiteral("vcan00");
    case TraceModel::Direction: return QStringLiteral("Rx");
    case TraceModel::Identifier: return QStringLiteral("18EFFF80");
    case TraceModel::Pgn: return QStringLiteral("1FFFF");
    case TraceModel::Ends: return QStringLiteral("node 24");
    case TraceModel::Length: return QStringLiteral("8");
    case TraceModel::Data: return QStringLiteral("00 00 00 00 00 00 00 00");
    default: return QStringLiteral("Malformed: Position / limit st");
  }
}

}  // namespace

// A log grows with each tick, while the slider seldom moves by a pixel: only then is the bar drawn anew.
class TraceScrollBar : public QScrollBar {
 public:
  using QScrollBar::QScrollBar;
  void mirror(const TraceScroll& scroll) {
    const QRect before = slider();
    {
      const QSignalBlocker blocker(this);
      setRange(0, scroll.barMaximum());
      setPageStep(scroll.barPage());
      setValue(scroll.barValue());
    }
    if (slider() != before) update();
  }

 protected:
  void sliderChange(SliderChange change) override {
    if (!signalsBlocked()) QScrollBar::sliderChange(change);
  }

 private:
  QRect slider() const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    return style()->subControlRect(QStyle::CC_ScrollBar, &option, QStyle::SC_ScrollBarSlider, this);
  }
};

TraceView::TraceView(QWidget* parent)
    : QAbstractScrollArea(parent), m_bar(new TraceScrollBar(Qt::Vertical, this)), m_fonts(font()) {
  speakAs(*this, QAccessible::List);
  named(this, "traceView", tr("Trace"));
  setFocusPolicy(Qt::StrongFocus);
  setVerticalScrollBar(m_bar);
  // Always there: a bar that comes and goes moves everything.
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  viewport()->setObjectName(QStringLiteral("traceRows"));
  viewport()->setAttribute(Qt::WA_OpaquePaintEvent);
  m_header = named(new FlatHeader(this), "traceHeader", tr("Columns of the trace"));
  m_header->setMinimumSectionSize(24);
  m_header->setGutter(TracePainter::kGutter);
  m_header->setFocusPolicy(Qt::NoFocus);
  connect(m_header, &QHeaderView::sectionResized, this, [this](int column) {
    if (column != TraceModel::Decoded) stretchDecoded();
    layOut();
    viewport()->update();
  });
  connect(verticalScrollBar(), &QScrollBar::actionTriggered, this, &TraceView::barActed);
  updateFonts();
  describe();
}

void TraceView::setModel(TraceModel* model) {
  if (m_model != nullptr) m_model->disconnect(this);
  m_model = model;
  m_header->setModel(model);
  if (m_model != nullptr) {
    connect(m_model, &TraceModel::viewChanged, this, &TraceView::takeView);
    connect(m_model, &TraceModel::filterChanged, this, &TraceView::keepInPlace);
    connect(m_model, &QAbstractItemModel::modelReset, viewport(), qOverload<>(&QWidget::update));
    connect(m_model, &QAbstractItemModel::dataChanged, this,
            [this](const QModelIndex& first, const QModelIndex& last) {
              const std::uint64_t top = m_model->windowFirst();
              viewport()->update(rectOfRows(top + static_cast<std::uint64_t>(first.row()),
                                            top + static_cast<std::uint64_t>(last.row()) + 1));
            });
  }
  m_header->setSectionResizeMode(QHeaderView::Interactive);
  setUsualWidths();
  takeView();
}

// The model has other rows from now on. The numbers of the rows before are still known here, no more what
// they were; the frame at the top was told to the model's window.
void TraceView::keepInPlace() {
  m_kept.reset();
  if (!m_isFollowing) m_kept = m_place;
}

// The log, its length or its cursor may be another.
void TraceView::takeView() {
  const LogView view = m_model != nullptr ? m_model->view() : LogView();
  const bool isAnother = view.document != m_log;
  const bool sawCursor = !isAnother && m_scroll.shows(m_cursorRow);
  const std::uint64_t passed = m_model != nullptr ? m_model->rowOf(view.cursor.frames) : 0;
  const std::uint64_t cursorRow = passed == 0 ? 0 : passed - 1;
  const bool cursorMoved = view.cursor.frames != m_cursorFrames;
  const TraceScroll before = m_scroll;
  const std::uint64_t cursorRowBefore = m_cursorRow;
  m_scroll.rows = m_model != nullptr ? m_model->rows() : 0;
  m_cursorRow = cursorRow;
  m_cursorFrames = view.cursor.frames;
  if (isAnother) {
    m_log = view.document;
    m_scroll.top = 0;
    m_kept.reset();
    setCurrentFrame({});
  }
  if (isAnother || view.atEnd != m_wasAtEnd) setFollowing(view.atEnd);
  m_wasAtEnd = view.atEnd;
  if (m_isFollowing) {
    m_scroll.moveTo(m_scroll.lastTop());
  } else if (m_kept) {
    const std::uint64_t row = m_model->rowOf(m_kept->frame);
    m_scroll.moveTo(row - std::min(row, m_kept->rowsBelowTop));
    if (m_model->filteredFrames() > m_kept->frame) m_kept.reset();
  } else if (cursorMoved && (sawCursor || isAnother)) {
    m_scroll.show(cursorRow);
  }
  if (isAnother) return showScroll();
  m_scroll.moveTo(m_scroll.top);
  showGrowth(before, cursorRowBefore);  // first: rows that change are damaged where they stand from now on
  syncScroll();
}

QRect TraceView::rectOfRows(std::uint64_t first, std::uint64_t end) const {
  const auto y = [this](std::uint64_t row) {
    const std::uint64_t below = std::min(row - std::min(row, m_scroll.top), m_scroll.pageRows + 1);
    return static_cast<int>(below) * m_rowHeight;
  };
  return {0, y(first), viewport()->width(), y(end) - y(first)};
}

void TraceView::showGrowth(const TraceScroll& before, std::uint64_t cursorRowBefore) {
  const std::uint64_t moved = m_scroll.top - std::min(before.top, m_scroll.top);
  // What is said without rows may change, and the mark of the focus stands over the first row.
  if (before.rows == 0 || m_scroll.rows < before.rows || m_scroll.top < before.top ||
      moved >= m_scroll.pageRows || hasFocus())
    return viewport()->update();
  if (moved > 0) viewport()->scroll(0, -static_cast<int>(moved) * m_rowHeight);
  if (m_scroll.rows != before.rows) {
    QRect added = rectOfRows(before.rows, m_scroll.rows);
    added.setBottom(viewport()->height());
    viewport()->update(added);
  }
  if (m_cursorRow != cursorRowBefore) {
    for (const std::uint64_t row : {cursorRowBefore, m_cursorRow})
      viewport()->update(rectOfRows(row, row + 1));
  }
}

void TraceView::showScroll() {
  syncScroll();
  viewport()->update();
}

void TraceView::syncScroll() {
  m_scroll.moveTo(m_scroll.top);
  if (m_model != nullptr) {
    // A page more at either side, so that small moves find their rows.
    const std::uint64_t margin = m_scroll.pageRows;
    const std::uint64_t first = m_scroll.top - std::min(m_scroll.top, margin);
    m_model->setWindow(first, static_cast<int>(std::min<std::uint64_t>(3 * margin + 1, 10'000)));
  }
  m_bar->mirror(m_scroll);
  notePlace();
}

// What would have to stay in place: the current frame if it is in sight, otherwise the frame at the top.
void TraceView::notePlace() {
  if (m_model == nullptr || m_kept) return;
  const auto top = m_model->frameOf(m_scroll.top);
  m_place = Kept{top.value_or(0), 0};
  if (!m_current) return;
  const std::uint64_t row = m_model->rowOf(*m_current);
  if (m_scroll.shows(row)) m_place = Kept{*m_current, row - m_scroll.top};
}

void TraceView::setFollowing(bool isFollowing) {
  const bool isNew = isFollowing != m_isFollowing;
  m_isFollowing = isFollowing;
  if (isFollowing && !m_scroll.isAtEnd()) {
    m_scroll.moveTo(m_scroll.lastTop());
    showScroll();
  }
  if (isNew) Q_EMIT followingChanged(isFollowing);
}

void TraceView::updateFonts() {
  m_fonts = TraceFonts(font());
  const int text = std::max(QFontMetrics(m_fonts.text).height(), QFontMetrics(m_fonts.figures).height());
  m_rowHeight = denseRowHeight(this, std::max(kMinTraceRow, text + 6));
  // As high as it makes itself, but now: its letters may come later than ours.
  m_header->setFixedHeight(std::max(targetHeight(this), QFontMetrics(m_fonts.text).height() + 12));
  setUsualWidths();
  layOut();
}

void TraceView::changeEvent(QEvent* event) {
  QAbstractScrollArea::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) updateFonts();
}

void TraceView::resizeEvent(QResizeEvent* event) {
  QAbstractScrollArea::resizeEvent(event);
  stretchDecoded();
  layOut();
}

void TraceView::layOut() {
  setViewportMargins(0, m_header->height(), 0, 0);
  const QRect area = viewport()->geometry();
  m_header->setGeometry(area.left(), area.top() - m_header->height(), area.width(), m_header->height());
  QScrollBar* bar = horizontalScrollBar();
  bar->setRange(0, std::max(0, m_header->length() + TracePainter::kGutter - area.width()));
  bar->setPageStep(area.width());
  bar->setSingleStep(32);
  m_header->scrollTo(bar->value());
  m_scroll.pageRows = static_cast<std::uint64_t>(std::max(1, area.height() / m_rowHeight));
  if (m_isFollowing) m_scroll.moveTo(m_scroll.lastTop());
  showScroll();
}

void TraceView::setUsualWidths() {
  if (m_header->count() == 0) return;
  QList<int> widths;
  for (int column = 0; column < TraceModel::Decoded; ++column) {
    const QFontMetrics metrics(m_fonts.of(column));
    const QString title = m_model->headerData(column, Qt::Horizontal).toString();
    const int widest = std::max(QFontMetrics(m_header->font()).horizontalAdvance(title),
                                metrics.horizontalAdvance(widestText(column)));
    widths.push_back(widest + 2 * FlatHeader::kPadding + 2);
  }
  const QSignalBlocker blocker(m_header);
  m_header->setUsualWidths(widths);
  stretchDecoded();
}

// The last column takes what is left, and never so little that nothing could be read.
void TraceView::stretchDecoded() {
  if (m_header->count() == 0 || m_header->isSectionHidden(TraceModel::Decoded)) return;
  const int others = m_header->length() - m_header->sectionSize(TraceModel::Decoded);
  const int left = viewport()->width() - TracePainter::kGutter - others;
  const QSignalBlocker blocker(m_header);
  m_header->resizeSection(TraceModel::Decoded, std::max(kMinDecoded, left));
}

void TraceView::setColumnShown(int column, bool isShown) {
  m_header->setSectionHidden(column, !isShown);
  stretchDecoded();
  layOut();
}

void TraceView::resetColumns() {
  m_header->showUsual();
  stretchDecoded();
  layOut();
}

QByteArray TraceView::saveState() const { return m_header->saveColumns(); }

bool TraceView::restoreState(const QByteArray& state) {
  const bool isTaken = m_header->restoreColumns(state);
  stretchDecoded();
  layOut();
  return isTaken;
}

std::vector<TraceColumn> TraceView::columns() const {
  std::vector<TraceColumn> columns;
  for (int column = 0; column < m_header->count(); ++column) {
    if (m_header->isSectionHidden(column)) continue;
    columns.push_back({column, m_header->sectionViewportPosition(column), m_header->sectionSize(column)});
  }
  return columns;
}

QModelIndex TraceView::indexOf(std::uint64_t row, int column) const {
  if (m_model == nullptr || row < m_model->windowFirst()) return {};
  const std::uint64_t inWindow = row - m_model->windowFirst();
  if (inWindow >= static_cast<std::uint64_t>(m_model->rowCount())) return {};
  return m_model->index(static_cast<int>(inWindow), column);
}

QModelIndex TraceView::indexOfFrame(std::uint64_t frame, int column) const {
  const QModelIndex index = m_model == nullptr ? QModelIndex() : indexOf(m_model->rowOf(frame), column);
  return index.data(TraceModel::FrameRole).toULongLong() == frame ? index : QModelIndex();
}

void TraceView::paintEvent(QPaintEvent* event) {
  const Colours& c = coloursOf(this);
  QPainter p(viewport());
  const QRect damaged = event->rect();
  p.fillRect(damaged, c.surface);
  if (m_scroll.rows == 0) {
    const bool isFiltered = m_model != nullptr && m_model->isFiltered() && m_model->view().frameCount > 0;
    p.setPen(c.textSecondary);
    p.drawText(viewport()->rect(), Qt::AlignCenter,
               !isFiltered              ? tr("No frames")
               : m_model->isFiltering() ? tr("Looking for frames that pass the filter…")
                                        : tr("No frame passes the filter"));
    return;
  }
  TracePainter painter(p, c, m_fonts, columns());
  const int width = viewport()->width();
  const int above = damaged.top() / m_rowHeight;
  std::uint64_t row = m_scroll.top + static_cast<std::uint64_t>(above);
  int y = above * m_rowHeight;
  for (; y <= damaged.bottom() && row < m_scroll.rows; y += m_rowHeight, ++row) {
    const QModelIndex index = indexOf(row);
    if (!index.isValid()) break;
    const auto frame = index.data(TraceModel::FrameRole).toULongLong();
    painter.row(QRect(0, y, width, m_rowHeight), index,
                {.isSelected = m_selection.has(frame),
                 .isOdd = row % 2 != 0,
                 .hasFocus = hasFocus() && m_current == frame});
  }
  p.fillRect(QRect(0, y, TracePainter::kGutter, viewport()->height() - y), c.surfaceAlternate);
  if (hasFocus()) p.fillRect(QRect(0, 0, width, 3), c.accent.ink);
}

QString TraceView::copyText() const {
  if (!m_log || m_selection.isEmpty()) return {};
  std::string text;
  const std::uint64_t row = m_model->rowOf(m_selection.first);
  const std::uint64_t all = m_model->rowOf(m_selection.end);
  const std::uint64_t end = std::min(all, row + kMaxCopied);
  for (const std::uint64_t i : m_model->framesOf(row, static_cast<std::size_t>(end - row))) {
    const Frame& frame = m_log->frames[i];
    writeCandump(frame, m_log->frames.channelName(frame.channel), text);
  }
  QString copied = QString::fromStdString(text);
  // Readers of the format pass over a line that begins so.
  if (end < all)
    copied += QStringLiteral("# ") +
              tr("%Ln more selected rows are not copied: save the selection instead.", nullptr,
                 forPlural(all - end)) +
              QLatin1Char('\n');
  return copied;
}

}  // namespace deckpipe
