// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/event_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QStackedLayout>
#include <QTreeView>
#include <cmath>

#include "model/event_model.h"
#include "paint/figures.h"
#include "panel/event_delegate.h"
#include "panel/flat_header.h"
#include "panel/label_ink.h"

namespace deckpipe {

EventPanel::EventPanel(QWidget* parent)
    : QWidget(parent),
      m_model(new EventModel(this)),
      m_delegate(new EventDelegate(this)),
      m_list(new QTreeView(this)),
      m_header(new FlatHeader(m_list)),
      m_empty(new QLabel(tr("Nothing happened so far."), this)),
      m_pages(new QStackedLayout(this)) {
  setObjectName(QStringLiteral("eventPanel"));
  setAccessibleName(tr("Events"));
  m_list->setObjectName(QStringLiteral("eventList"));
  m_list->setAccessibleName(tr("Events"));
  m_list->setToolTip(tr("A click puts the cursor there"));
  m_list->setHeader(m_header);
  m_list->setModel(m_model);
  m_list->setItemDelegate(m_delegate);
  m_list->setRootIsDecorated(false);
  m_list->setItemsExpandable(false);
  m_list->setIndentation(0);
  m_list->setUniformRowHeights(true);
  m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setFrameShape(QFrame::NoFrame);
  m_header->setObjectName(QStringLiteral("eventHeader"));
  m_header->setSectionResizeMode(QHeaderView::Interactive);
  m_header->setStretchLastSection(true);
  m_empty->setObjectName(QStringLiteral("noEvents"));
  m_empty->setAccessibleName(tr("Why no event is listed"));
  m_empty->setAlignment(Qt::AlignCenter);
  m_empty->setWordWrap(true);
  m_empty->setMargin(16);
  m_empty->setAutoFillBackground(true);
  m_empty->setBackgroundRole(QPalette::Base);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(m_list);
  setFocusProxy(m_list);
  layOutColumns();

  connect(m_list, &QTreeView::clicked, this, &EventPanel::seek);
  connect(m_list, &QTreeView::activated, this, &EventPanel::seek);
}

void EventPanel::setView(const LogView& view) {
  // A list that stands at its end goes on with it.
  const QScrollBar* bar = m_list->verticalScrollBar();
  const bool isAtEnd = bar->value() == bar->maximum();
  const int rows = m_model->rowCount();
  m_model->setView(view);
  if (isAtEnd && m_model->rowCount() != rows) m_list->scrollToBottom();
  showPage();
}

void EventPanel::setColours(const Colours& colours) {
  setPalette(qtPalette(colours));
  setInk(*m_empty, colours.textSecondary);
  m_delegate->setColours(colours);
  m_header->setColours(colours);
  m_list->viewport()->update();
}

void EventPanel::showPage() {
  if (m_delegate->setLastRow(m_model->rowAtCursor())) m_list->viewport()->update();
  QWidget* page = m_model->rowCount() == 0 ? static_cast<QWidget*>(m_empty) : m_list;
  if (m_pages->currentWidget() != page) m_pages->setCurrentWidget(page);
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
