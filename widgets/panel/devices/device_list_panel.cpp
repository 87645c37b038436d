// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/devices/device_list_panel.h"

#include <QAbstractButton>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QShortcut>
#include <QStackedWidget>

#include "model/device_model.h"
#include "model/device_rows.h"
#include "panel/common/build.h"
#include "panel/common/labels.h"
#include "panel/devices/device_list.h"

namespace deckpipe {

DeviceListPanel::DeviceListPanel(QWidget* parent)
    : QWidget(parent),
      m_model(new DeviceModel(this)),
      m_order(new DeviceOrder(this)),
      m_list(new DeviceList(this)),
      m_filter(named(new QLineEdit(this), "deviceFilter", tr("Filter the devices"))),
      m_empty(makeMessage(this, "noDevices", tr("Why no device is listed"))),
      m_untracked(new UntrackedLabel(QStringLiteral("untrackedDevices"), this)),
      m_pages(new QStackedWidget(this)) {
  named(this, "devicePanel", tr("Devices on the bus"));
  m_order->setSourceModel(m_model);
  m_list->setModel(m_order);
  m_pages->setObjectName(QStringLiteral("devicePages"));
  m_pages->addWidget(m_empty);
  m_pages->addWidget(m_list);
  m_empty->setText(m_model->emptyText());
  m_filter->setPlaceholderText(tr("Filter devices (Ctrl+F)"));
  m_filter->setToolTip(tr("Every word is looked for in label, PIN, type, group, address and health."));
  m_filter->setClearButtonEnabled(true);
  for (QAbstractButton* clear : m_filter->findChildren<QAbstractButton*>())
    named(clear, "deviceFilterClear", tr("Show all devices"));
  m_filter->setMinimumHeight(32);
  m_filter->installEventFilter(this);
  setFocusProxy(m_list);
  auto* line = inRow(nullptr, {8, 4, 8, 4}, -1, {m_filter});
  inColumn(this, {0, 0, 0, 0}, 0, {line, {m_pages, 1}, m_untracked});

  connect(m_filter, &QLineEdit::textChanged, this, [this](const QString& text) {
    {
      const QScopedValueRollback updating(m_isUpdating, true);
      m_order->setFilter(text);
    }
    showSelection();
    showPage();
  });
  auto* find = new QShortcut(QKeySequence::Find, this);
  find->setContext(Qt::WidgetWithChildrenShortcut);
  connect(find, &QShortcut::activated, this, [this] {
    m_filter->setFocus(Qt::ShortcutFocusReason);
    m_filter->selectAll();
  });
  connect(m_model, &DeviceModel::labelEdited, this, &DeviceListPanel::labelEdited);
  m_list->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(m_list, &QWidget::customContextMenuRequested, this, &DeviceListPanel::showMenu);

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

QSize DeviceListPanel::minimumSizeHint() const { return {m_list->leastWidth(), 160}; }

void DeviceListPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) updateGeometry();
}

void DeviceListPanel::choose(const DeviceKey& key) {
  if (key == m_selected) return;
  m_selected = key;
  Q_EMIT deviceSelected(key);
}

void DeviceListPanel::setView(const PanelView& view) {
  m_selected = view.device;
  {
    const QScopedValueRollback updating(m_isUpdating, true);
    m_model->setLabels(view.labels);
    m_model->setView(view.log);
  }
  m_untracked->setView(view.log);
  showSelection();
  showPage();
}

void DeviceListPanel::showPage() {
  const bool isEmpty = m_model->rowCount() == 0;
  const bool isFiltered = !isEmpty && m_order->rowCount() == 0;
  if (isEmpty) setText(*m_empty, m_model->emptyText());
  if (isFiltered) setText(*m_empty, tr("No device matches “%1”.").arg(m_filter->text()));
  QWidget* page = isEmpty || isFiltered ? static_cast<QWidget*>(m_empty) : m_list;
  if (m_pages->currentWidget() != page) m_pages->setCurrentWidget(page);
}

// In the filter line Esc shows all devices again, and from there the keys go on into the table.
bool DeviceListPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_filter || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool isLeave =
      key == Qt::Key_Escape || key == Qt::Key_Down || key == Qt::Key_Return || key == Qt::Key_Enter;
  if (!isLeave) return false;
  if (key == Qt::Key_Escape) m_filter->clear();
  m_list->setFocus(Qt::OtherFocusReason);
  return true;
}

void DeviceListPanel::showMenu(const QPoint& at) {
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("deviceMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const QPersistentModelIndex current = m_list->currentIndex();
  if (current.isValid()) {
    const DeviceKey key = current.data(DeviceModel::KeyRole).value<DeviceKey>();
    QAction* edit = addNamed(menu, "editLabelAction", tr("Edit &label"), this,
                             [this, current] { m_list->editLabel(current); });
    edit->setEnabled(key.kind == DeviceKey::Kind::Pin);
    addNamed(menu, "copyDeviceAction", tr("&Copy %1").arg(keyText(key)), this,
             [key] { QApplication::clipboard()->setText(keyText(key)); });
    menu->addSeparator();
  }
  QMenu* sorts = menu->addMenu(tr("&Sort by"));
  sorts->setObjectName(QStringLiteral("deviceSortMenu"));
  auto* group = new QActionGroup(sorts);
  const auto add = [&](int column, const QString& text) {
    QAction* action = sorts->addAction(text, this, [this, column] {
      QHeaderView* header = m_list->header();
      const bool isUp =
          header->sortIndicatorSection() == column && header->sortIndicatorOrder() == Qt::AscendingOrder;
      header->setSortIndicator(column, isUp ? Qt::DescendingOrder : Qt::AscendingOrder);
    });
    action->setCheckable(true);
    action->setChecked(m_list->header()->sortIndicatorSection() == column);
    group->addAction(action);
  };
  add(-1, tr("First heard"));
  for (int column = 0; column < DeviceModel::ColumnCount; ++column)
    add(column, m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
  menu->popup(m_list->viewport()->mapToGlobal(at));
}

void DeviceListPanel::showSelection() {
  const QScopedValueRollback updating(m_isUpdating, true);
  const int row = m_model->rowOf(m_selected);
  if (row < 0) {
    m_list->selectionModel()->clear();
    return;
  }
  const QModelIndex at = m_order->mapFromSource(m_model->index(row, 0));
  if (!at.isValid()) {  // filtered away: it stays chosen all the same
    m_list->selectionModel()->clear();
    return;
  }
  if (m_list->currentIndex().row() != at.row() || !m_list->selectionModel()->isRowSelected(at.row()))
    m_list->setCurrentIndex(at);
}

}  // namespace deckpipe
