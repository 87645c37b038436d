// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/device_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QScopedValueRollback>
#include <QStackedLayout>

#include "model/device_model.h"
#include "model/device_order.h"
#include "panel/device_list.h"
#include "panel/label_ink.h"

namespace deckpipe {

DevicePanel::DevicePanel(QWidget* parent)
    : QWidget(parent),
      m_model(new DeviceModel(this)),
      m_order(new DeviceOrder(this)),
      m_list(new DeviceList(this)),
      m_empty(new QLabel(this)),
      m_pages(new QStackedLayout(this)) {
  setObjectName(QStringLiteral("devicePanel"));
  setAccessibleName(tr("Devices on the bus"));
  m_order->setSourceModel(m_model);
  m_list->setModel(m_order);
  m_empty->setObjectName(QStringLiteral("noDevices"));
  m_empty->setAccessibleName(tr("Why no device is listed"));
  m_empty->setAlignment(Qt::AlignCenter);
  m_empty->setWordWrap(true);
  m_empty->setMargin(24);
  m_empty->setAutoFillBackground(true);
  m_empty->setBackgroundRole(QPalette::Base);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(m_list);
  m_empty->setText(m_model->emptyText());
  setFocusProxy(m_list);

  connect(m_list->header(), &QHeaderView::sortIndicatorChanged, m_order, &DeviceOrder::orderBy);
  // The selection, not the current row: a list that gets the focus makes its first row current by itself.
  connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    const QModelIndexList rows = m_list->selectionModel()->selectedRows();
    if (!m_isUpdating && !rows.isEmpty()) choose(rows.front().data(DeviceModel::KeyRole).value<DeviceKey>());
  });
  connect(m_model, &DeviceModel::keyChanged, this, [this](const DeviceKey& before, const DeviceKey& after) {
    if (before == m_selected) choose(after);
  });
}

void DevicePanel::choose(const DeviceKey& key) {
  if (key == m_selected) return;
  m_selected = key;
  Q_EMIT deviceSelected(key);
}

void DevicePanel::selectDevice(const DeviceKey& key) {
  choose(key);
  showSelection();
}

void DevicePanel::setView(const LogView& view) {
  {
    const QScopedValueRollback updating(m_isUpdating, true);
    m_model->setView(view);
  }
  showSelection();
  const bool isEmpty = m_model->rowCount() == 0;
  if (isEmpty) m_empty->setText(m_model->emptyText());
  QWidget* page = isEmpty ? static_cast<QWidget*>(m_empty) : m_list;
  if (m_pages->currentWidget() != page) m_pages->setCurrentWidget(page);
}

void DevicePanel::showSelection() {
  const QScopedValueRollback updating(m_isUpdating, true);
  const int row = m_model->rowOf(m_selected);
  if (row < 0) {
    m_list->selectionModel()->clear();
    return;
  }
  const QModelIndex at = m_order->mapFromSource(m_model->index(row, 0));
  if (m_list->currentIndex().row() != at.row() || !m_list->selectionModel()->isRowSelected(at.row()))
    m_list->setCurrentIndex(at);
}

void DevicePanel::setColours(const Colours& colours) {
  setPalette(qtPalette(colours));
  setInk(*m_empty, colours.textSecondary);
  m_list->setColours(colours);
}

}  // namespace deckpipe
