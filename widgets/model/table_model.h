// SPDX-License-Identifier: GPL-3.0-or-later
// A flat table whose columns are described once: what stands over them, what that means, and on which side
// the cells stand. The models of the panels derive from it: each says how many rows it has, and what a cell
// is.
#pragma once

#include <QAbstractTableModel>
#include <vector>

namespace deckpipe {

struct TableColumn {
  QString title;
  QString tip{};           // what the title means; often empty
  bool isToRight = false;  // for figures
};

class TableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  int rowCount(const QModelIndex& parent = {}) const final;
  int columnCount(const QModelIndex& parent = {}) const final;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const final;
  QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const final;

 protected:
  TableModel(std::vector<TableColumn> columns, QObject* parent);

  virtual std::size_t count() const = 0;
  // The cell is there. Never asked for its alignment.
  virtual QVariant cell(int row, int column, int role) const = 0;

  void setColumn(int column, const TableColumn& facts);
  // Cells of all rows from `first` to `last` column; nothing where there are no rows.
  void sayChanged(int first, int last);

 private:
  std::vector<TableColumn> m_columns;
};

}  // namespace deckpipe
