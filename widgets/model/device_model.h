// SPDX-License-Identifier: GPL-3.0-or-later
// Who is on the bus at the cursor, a row each. A panel gives it a view at most 30 times a second; it tells
// only what changed in what is shown. Rows are known by their DeviceKey: a device keeps its row when its
// address changes, and an address keeps its row when the device there says who it is.
//
// Rows stand in order of first appearance; groups and sorting are a proxy's job (GroupRole, SortRole).
#pragma once

#include <vector>

#include "model/device_rows.h"
#include "model/table_model.h"
#include "state/log_view.h"

namespace deckpipe {

class DeviceModel : public TableModel {
  Q_OBJECT

 public:
  enum Column {
    DeviceColumn,
    TypeColumn,
    AddressColumn,
    AgeColumn,
    HealthColumn,
    RateColumn,
    FramesColumn,
    ColumnCount
  };
  enum Role {
    KeyRole = Qt::UserRole,  // DeviceKey
    GroupRole,               // int of DeviceGroup
    GroupTextRole,           // its heading
    DetailRole,       // the line under the device: PIN if it has a label, type, channel if there are several
    SearchRole,       // all that a person may look for a device by
    HealthRole,       // int of Severity
    HealthWordsRole,  // QStringList, the worst first
    SortRole,         // what a column sorts by; calm: it does not change while a device is well
  };

  explicit DeviceModel(QObject* parent = nullptr);

  void setView(const LogView& view);
  void setLabels(const DeviceLabels& labels);
  // Where a key's row is now; -1 where it has none.
  int rowOf(const DeviceKey& key) const;
  DeviceKey keyAt(int row) const;
  // What a table without rows says instead: what is missing, and what was heard all the same.
  QString emptyText() const;

  // The first column of what has a PIN: its label.
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

 Q_SIGNALS:
  // A person gave a device another label. The model keeps none: whoever does gives them back by setLabels().
  void labelEdited(const deckpipe::Pin& pin, const QString& label);
  // A row's device is known by another key from now on: what had no PIN said its own.
  void keyChanged(const deckpipe::DeviceKey& before, const deckpipe::DeviceKey& after);

 private:
  std::size_t count() const override { return m_rows.size(); }
  QVariant cell(int row, int column, int role) const override;
  QString textOf(const DeviceRow& row, int column) const;
  QString detailOf(const DeviceRow& row) const;
  QVariant sortKey(const DeviceRow& row, int column) const;
  void removeGone(const std::vector<DeviceRow>& next);
  void replace(int row, const DeviceRow& next);

  LogView m_view;
  DeviceLabels m_labels;
  std::vector<DeviceRow> m_rows;
};

}  // namespace deckpipe
