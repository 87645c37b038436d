// SPDX-License-Identifier: GPL-3.0-or-later
// The device table's view: rows under the headings of their groups. A heading is no row of its own, so
// keyboard and selection never stop on it.
#pragma once

#include <QTreeView>

namespace deckpipe {

class DeviceDelegate;
class DeviceHeader;

class DeviceList : public QTreeView {
  Q_OBJECT

 public:
  explicit DeviceList(QWidget* parent = nullptr);
  void setModel(QAbstractItemModel* model) override;  // a DeviceOrder
  // Opens the label of a row for editing, or says why it has none.
  void editLabel(const QModelIndex& index);
  // Holds a whole PIN, its address, the sign of its health and a scroll bar.
  int leastWidth() const;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void drawRow(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dataChanged(const QModelIndex& first, const QModelIndex& last, const QList<int>& roles) override;

 private:
  int widthOf(int column) const;
  void layOutColumns();

  DeviceDelegate* m_delegate;
  DeviceHeader* m_header;
};

}  // namespace deckpipe
