// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/events/event_panel.h"

#include <QHeaderView>
#include <QPainter>
#include <QScrollBar>
#include <QStackedLayout>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "model/event_model.h"
#include "paint/app_style.h"
#include "paint/figures.h"
#include "paint/glyph.h"
#include "panel/common/build.h"
#include "panel/common/flat_header.h"
#include "panel/common/labels.h"
#include "panel/events/event_filter_bar.h"

namespace deckpipe {
namespace {

constexpr int kSign = 16, kGap = 6;

}  // namespace

// How a row of the list of events is drawn: the sign of what wants attention beside its words, and lighter
// what has not happened yet at the cursor.
class EventDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  // The last row that has happened. True where that changes what is drawn.
  bool setLastRow(int row) { return std::exchange(m_lastRow, row) != row; }

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return {120, std::max(targetHeight(option.widget), option.fontMetrics.height() + 10)};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Colours& c = coloursOf(option.widget);
    const bool isSelected = (option.state & QStyle::State_Selected) != 0;
    const bool hasHappened = index.row() <= m_lastRow;
    const QColor ground = index.row() % 2 != 0 ? c.surfaceAlternate : c.surface;
    painter->fillRect(option.rect, isSelected ? c.accent.fill : ground);
    QColor ink = index.column() == EventModel::What ? c.text : c.textSecondary;
    if (!hasHappened) ink = c.stale.ink;
    if (isSelected) ink = c.accent.onFill;
    QRect area = option.rect.adjusted(FlatHeader::kPadding, 0, -FlatHeader::kPadding, 0);
    const QString text = index.data().toString();
    if (index.column() == EventModel::When) {
      drawFigures(*painter, QRectF(area), {text, {}, option.font, option.font, ink, ink});
      return;
    }
    if (index.column() == EventModel::What) {
      const QRect mark(area.left(), area.center().y() - kSign / 2, kSign, kSign);
      const auto group = static_cast<EventGroup>(index.data(EventModel::GroupRole).toInt());
      const auto weight = static_cast<Severity>(index.data(EventModel::WeightRole).toInt());
      drawEventMark(*painter, QRectF(mark).adjusted(3, 3, -3, -3), group,
                    isSelected || !hasHappened ? ink : eventInk(weight, c));
      const QRect sign(mark.right() + 1 + kGap, mark.top(), kSign, kSign);
      const QColor signInk = isSelected || !hasHappened ? ink : inkOf(c, inkOf(weight));
      if (const auto glyph = glyphOf(weight))
        drawGlyph(*painter, sign.adjusted(1, 1, -1, -1), *glyph, signInk, Qt::transparent, c.stroke);
      area.setLeft(sign.right() + 1 + kGap);
    }
    painter->setFont(option.font);
    painter->setPen(ink);
    const bool isName = index.column() == EventModel::Who;
    painter->drawText(area, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                      isName ? elidedPin(text, QFontMetricsF(option.font), area.width())
                             : option.fontMetrics.elidedText(text, Qt::ElideRight, area.width()));
  }

 private:
  int m_lastRow = -1;
};

EventPanel::EventPanel(QWidget* parent)
    : QWidget(parent),
      m_model(new EventModel(this)),
      m_filter(new EventFilter(m_model, this)),
      m_bar(new EventFilterBar(m_model, m_filter, this)),
      m_delegate(new EventDelegate(this)),
      m_list(named(new QTreeView(this), "eventList", tr("Events"))),
      m_header(new FlatHeader(m_list)),
      m_empty(makeMessage(this, "noEvents", tr("Why no event is listed"), 16)),
      m_cut(new QLabel(tr("More happened: only the first events are listed."), this)),
      m_untracked(new UntrackedLabel(QStringLiteral("untrackedEvents"), this)),
      m_pages(new QStackedLayout) {
  named(this, "eventPanel", tr("Events"));
  m_list->setToolTip(tr("A click puts the cursor there"));
  m_list->setHeader(m_header);
  m_list->setModel(m_filter);
  m_list->setItemDelegate(m_delegate);
  makeFlat(*m_list);
  m_list->setUniformRowHeights(true);
  m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_header->setObjectName(QStringLiteral("eventHeader"));
  m_header->setSectionResizeMode(QHeaderView::Interactive);
  m_header->setStretchLastSection(true);
  m_empty->setText(tr("Nothing happened so far."));
  m_pages->addWidget(m_empty);
  m_pages->addWidget(m_list);
  inColumn(this, {0, 0, 0, 0}, 0, {m_bar, {m_pages, 1}, m_cut, m_untracked});
  m_cut->setObjectName(QStringLiteral("eventsCut"));
  m_cut->setMargin(4);
  m_cut->hide();
  setFocusProxy(m_list);
  layOutColumns();

  for (const auto change : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
    connect(m_filter, change, this, &EventPanel::showPage);
  connect(m_list, &QTreeView::clicked, this, &EventPanel::seek);
  connect(m_list, &QTreeView::activated, this, &EventPanel::seek);
}

void EventPanel::setView(const PanelView& view) {
  // A list that stands at its end goes on with it.
  const QScrollBar* bar = m_list->verticalScrollBar();
  const bool isAtEnd = bar->value() == bar->maximum();
  const int rows = m_filter->rowCount(), all = m_model->rowCount();
  const bool isOther = view.log.document != m_model->view().document || view.labels != m_model->labels();
  m_model->setLabels(view.labels);
  m_model->setView(view.log);
  m_untracked->setView(view.log);
  if (isAtEnd && m_filter->rowCount() != rows) m_list->scrollToBottom();
  if (isOther || m_model->rowCount() != all) m_bar->updateDevices();
  showPage();
}

bool EventPanel::hasEvents() const { return m_model->rowCount() > 0; }

int EventPanel::chosenRow() const {
  const int row = m_list->currentIndex().row();
  if (row < 0) return -1;
  const Instant cursor = m_model->view().cursor.time, time = m_filter->time(row);
  return cursor == time || cursor == std::max(time - kBefore, m_model->view().begin) ? row : -1;
}

void EventPanel::goTo(int row, Duration before) {
  if (row < 0 || row >= m_filter->rowCount()) return;
  const QModelIndex index = m_filter->index(row, 0);
  m_list->setCurrentIndex(index);
  m_list->scrollTo(index);
  Q_EMIT seekRequested(std::max(m_filter->time(row) - before, m_model->view().begin));
}

// Events of one time are gone through one by one.
void EventPanel::goToNext() {
  const Instant cursor = m_model->view().cursor.time;
  const int chosen = chosenRow();
  goTo(chosen >= 0 && m_filter->time(chosen) == cursor ? chosen + 1 : m_filter->rowAfter(cursor),
       Duration{0});
}

void EventPanel::goToPrevious() {
  const Instant cursor = m_model->view().cursor.time;
  const int chosen = chosenRow();
  goTo(chosen >= 0 && m_filter->time(chosen) == cursor ? chosen - 1 : m_filter->rowBefore(cursor),
       Duration{0});
}

// Faults of one moment are one place.
void EventPanel::goToFault(bool isBack) {
  const Instant cursor = m_model->view().cursor.time;
  const int count = m_model->rowCount();
  for (int i = 0; i < count; ++i) {
    const int row = isBack ? count - 1 - i : i;
    const Instant time = m_model->time(row);
    if (m_model->weight(row) != Severity::Fault || (isBack ? time >= cursor : time <= cursor)) continue;
    if (const QModelIndex index = m_filter->mapFromSource(m_model->index(row, 0)); index.isValid()) {
      m_list->setCurrentIndex(index);
      m_list->scrollTo(index);
    }
    Q_EMIT seekRequested(time);
    return;
  }
}

void EventPanel::goToNextFault() { goToFault(false); }
void EventPanel::goToPreviousFault() { goToFault(true); }

void EventPanel::goBefore() {
  const int chosen = chosenRow();
  goTo(chosen >= 0 ? chosen : m_filter->rowAt(m_model->view().cursor.time), kBefore);
}

void EventPanel::showPage() {
  if (m_delegate->setLastRow(m_filter->rowAt(m_model->view().cursor.time))) m_list->viewport()->update();
  setText(*m_empty, m_model->rowCount() == 0 ? tr("Nothing happened so far.")
                                             : tr("Nothing that happened passes the filter above."));
  m_cut->setVisible(m_model->isCut());
  QWidget* page = m_filter->rowCount() == 0 ? static_cast<QWidget*>(m_empty) : m_list;
  if (m_pages->currentWidget() != page) m_pages->setCurrentWidget(page);
}

// The columns were laid out in the letters of another density.
void EventPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) layOutColumns();
}

void EventPanel::layOutColumns() {
  const int padding = 2 * FlatHeader::kPadding;
  const double time = figuresWidth(font(), QStringLiteral("000:00:00.000"));
  m_header->resizeSection(EventModel::When, static_cast<int>(std::ceil(time)) + padding);
  m_header->resizeSection(EventModel::Bus,
                          fontMetrics().horizontalAdvance(QStringLiteral("vcan00")) + padding);
  m_header->resizeSection(EventModel::Who,
                          fontMetrics().horizontalAdvance(QStringLiteral("1032AE1008010350")) + padding);
}

void EventPanel::seek(const QModelIndex& index) {
  Q_EMIT seekRequested({index.data(EventModel::TimeRole).toLongLong()});
}

}  // namespace deckpipe
