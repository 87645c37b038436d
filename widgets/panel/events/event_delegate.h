// SPDX-License-Identifier: GPL-3.0-or-later
// How a row of the list of events is drawn: the sign of what wants attention beside its words, and lighter
// what has not happened yet at the cursor.
#pragma once

#include <QStyledItemDelegate>

namespace deckpipe {

class EventDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  // The last row that has happened. True where that changes what is drawn.
  bool setLastRow(int row);

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int m_lastRow = -1;
};

}  // namespace deckpipe
