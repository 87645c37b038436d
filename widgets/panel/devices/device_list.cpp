// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/devices/device_list.h"

#include <QFontMetrics>
#include <QKeyEvent>
#include <QPainter>
#include <QResizeEvent>
#include <QToolTip>
#include <algorithm>

#include "model/device_model.h"
#include "model/device_order.h"
#include "paint/app_style.h"
#include "panel/common/secondary_font.h"
#include "panel/devices/device_delegate.h"
#include "panel/devices/device_header.h"

namespace deckpipe {
namespace {

constexpr int kCellPad = 8;

}  // namespace

DeviceList::DeviceList(QWidget* parent)
    : QTreeView(parent), m_delegate(new DeviceDelegate(this)), m_header(new DeviceHeader(this)) {
  setObjectName(QStringLiteral("deviceList"));
  setAccessibleName(tr("Devices"));
  setItemDelegate(m_delegate);
  setRootIsDecorated(false);
  setItemsExpandable(false);
  setIndentation(0);
  setUniformRowHeights(false);
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setEditTriggers(NoEditTriggers);
  setAllColumnsShowFocus(false);  // drawRow() frames the row
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(NoFrame);
  setHeader(m_header);
  // setHeader() takes these back where the view does not sort by itself; DeviceListPanel sorts through the proxy.
  m_header->setSectionsClickable(true);
  m_header->setSortIndicatorShown(true);
}

void DeviceList::setModel(QAbstractItemModel* model) {
  QTreeView::setModel(model);
  header()->setSectionResizeMode(QHeaderView::Fixed);
  header()->setSectionResizeMode(DeviceModel::DeviceColumn, QHeaderView::Stretch);
  setColumnHidden(DeviceModel::TypeColumn, true);  // it stands under the device
  connect(this, &QAbstractItemView::doubleClicked, this, &DeviceList::editLabel);
  layOutColumns();
}

void DeviceList::resizeEvent(QResizeEvent* event) {
  QTreeView::resizeEvent(event);
  layOutColumns();
}

// Widths by the widest text a column can have, never by what it has now: nothing moves while values run.
void DeviceList::layOutColumns() {
  if (model() == nullptr) return;
  const QFontMetrics metrics(font());
  const auto set = [&](int column, const QString& widest, int extra = 0) {
    setColumnWidth(column, std::max(40, metrics.horizontalAdvance(widest) + 2 * kCellPad + extra));
  };
  set(DeviceModel::AddressColumn, QStringLiteral("Addr."));
  set(DeviceModel::AgeColumn, QStringLiteral("99 min"));
  set(DeviceModel::HealthColumn, QStringLiteral("Health"));
  set(DeviceModel::RateColumn, QStringLiteral("9,999/s"));
  set(DeviceModel::FramesColumn, QStringLiteral("99,999,999"));
  setColumnHidden(DeviceModel::RateColumn, width() < 420);
  setColumnHidden(DeviceModel::FramesColumn, width() < 520);
}

void DeviceList::editLabel(const QModelIndex& index) {
  const QModelIndex device = index.siblingAtColumn(DeviceModel::DeviceColumn);
  if (!device.isValid()) return;
  if ((device.flags() & Qt::ItemIsEditable) != 0) {
    edit(device);
    return;
  }
  QToolTip::showText(viewport()->mapToGlobal(visualRect(device).bottomLeft()),
                     tr("Labels are kept by PIN, and this one has not said a PIN."), this);
}

// The words of the health reach from their cell to the left.
void DeviceList::dataChanged(const QModelIndex& first, const QModelIndex& last, const QList<int>& roles) {
  QTreeView::dataChanged(first, last, roles);
  if (first.column() > DeviceModel::HealthColumn || last.column() < DeviceModel::HealthColumn) return;
  const QRect from = visualRect(first.siblingAtColumn(DeviceModel::DeviceColumn));
  const QRect to = visualRect(last.siblingAtColumn(DeviceModel::HealthColumn));
  viewport()->update(from.united(to));
}

void DeviceList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_F2) {
    editLabel(currentIndex());
    return;
  }
  QTreeView::keyPressEvent(event);
}

void DeviceList::drawRow(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  const Colours& c = coloursOf(this);
  QStyleOptionViewItem row = option;
  const auto* order = qobject_cast<const DeviceOrder*>(model());
  if (order != nullptr && order->startsGroup(index.row())) {
    QRect heading = option.rect;
    heading.setHeight(DeviceDelegate::kHeadingHeight);
    painter->save();
    painter->fillRect(heading, c.surfaceAlternate);
    painter->setFont(secondaryFont(font()));
    painter->setPen(c.textSecondary);
    painter->drawText(heading.adjusted(kCellPad, 0, -kCellPad, 0), Qt::AlignVCenter | Qt::AlignLeft,
                      index.data(DeviceModel::GroupTextRole).toString());
    painter->restore();
    row.rect.setTop(heading.bottom() + 1);
  }
  // Once for all cells: the line under the device reaches into the next ones.
  painter->fillRect(row.rect, selectionModel()->isSelected(index) ? c.accent.fill : c.surface);
  QTreeView::drawRow(painter, row, index);
  painter->save();
  painter->setPen(QPen(c.stale.fill, 1));
  painter->drawLine(row.rect.bottomLeft(), row.rect.bottomRight());
  if (hasFocus() && index.row() == currentIndex().row()) {
    const bool isSelected = selectionModel()->isSelected(index);
    painter->setPen(QPen(isSelected ? c.accent.onFill : c.accent.ink, 1));
    painter->drawRect(QRectF(row.rect).adjusted(2.5, 2.5, -2.5, -2.5));
  }
  painter->restore();
}

}  // namespace deckpipe
