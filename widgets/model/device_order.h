// SPDX-License-Identifier: GPL-3.0-or-later
// The device table in groups, in each group in the order that a person asked for. A DeviceModel is its
// source; the table of the device panel shows it.
#pragma once

#include <QSortFilterProxyModel>
#include <QStringList>

namespace deckpipe {

class DeviceOrder : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit DeviceOrder(QObject* parent = nullptr);

  // -1: in order of first appearance.
  void orderBy(int column, Qt::SortOrder order);
  // Only rows that have every word of it somewhere, in their name, type, group, address or health.
  void setFilter(const QString& text);
  // Whether a row is the first of its group.
  bool startsGroup(int row) const;

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  int m_column = -1;
  QStringList m_words;
};

}  // namespace deckpipe
