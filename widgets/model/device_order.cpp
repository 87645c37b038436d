// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_order.h"

#include <algorithm>

#include "model/device_model.h"

namespace deckpipe {

DeviceOrder::DeviceOrder(QObject* parent) : QSortFilterProxyModel(parent) {
  setObjectName(QStringLiteral("deviceOrder"));
  orderBy(-1, Qt::AscendingOrder);
}

void DeviceOrder::orderBy(int column, Qt::SortOrder order) {
  const bool wasOther = m_column != column;
  m_column = column;
  // Sorting by the same column of the base class does nothing, and -1 stands for its first one.
  if (wasOther) invalidate();
  sort(column < 0 ? 0 : column, column < 0 ? Qt::AscendingOrder : order);
}

void DeviceOrder::setFilter(const QString& text) {
  m_words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  invalidateFilter();
}

bool DeviceOrder::filterAcceptsRow(int row, const QModelIndex& parent) const {
  if (m_words.isEmpty()) return true;
  const QString text =
      sourceModel()->index(row, DeviceModel::DeviceColumn, parent).data(DeviceModel::SearchRole).toString();
  return std::ranges::all_of(m_words,
                             [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

bool DeviceOrder::startsGroup(int row) const {
  const auto groupAt = [this](int r) { return index(r, 0).data(DeviceModel::GroupRole).toInt(); };
  return row == 0 || (row < rowCount() && groupAt(row) != groupAt(row - 1));
}

bool DeviceOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const int a = left.data(DeviceModel::GroupRole).toInt();
  const int b = right.data(DeviceModel::GroupRole).toInt();
  // Groups keep their order when a column is sorted backwards.
  if (a != b) return sortOrder() == Qt::AscendingOrder ? a < b : a > b;
  if (m_column < 0) return left.row() < right.row();
  const QVariant l = left.data(DeviceModel::SortRole), r = right.data(DeviceModel::SortRole);
  return QVariant::compare(l, r) == QPartialOrdering::Less;
}

}  // namespace deckpipe
