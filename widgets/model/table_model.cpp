// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/table_model.h"

#include <utility>

namespace deckpipe {

TableModel::TableModel(std::vector<TableColumn> columns, QObject* parent)
    : QAbstractTableModel(parent), m_columns(std::move(columns)) {}

int TableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(count());
}

int TableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
}

QVariant TableModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
  if (role == Qt::TextAlignmentRole) return headerData(index.column(), Qt::Horizontal, role);
  return cell(index.row(), index.column(), role);
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  const auto column = static_cast<std::size_t>(section);
  if (orientation != Qt::Horizontal || column >= m_columns.size())
    return QAbstractTableModel::headerData(section, orientation, role);
  const TableColumn& facts = m_columns[column];
  switch (role) {
    case Qt::DisplayRole: return facts.title;
    case Qt::ToolTipRole: return facts.tip.isEmpty() ? QVariant() : facts.tip;
    case Qt::TextAlignmentRole:
      return QVariant::fromValue(
          Qt::Alignment((facts.isToRight ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
    default: return {};
  }
}

void TableModel::setColumn(int column, const TableColumn& facts) {
  m_columns[static_cast<std::size_t>(column)] = facts;
  Q_EMIT headerDataChanged(Qt::Horizontal, column, column);
}

void TableModel::sayChanged(int first, int last) {
  if (count() > 0) Q_EMIT dataChanged(index(0, first), index(rowCount() - 1, last));
}

}  // namespace deckpipe
