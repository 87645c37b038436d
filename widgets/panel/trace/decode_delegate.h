// SPDX-License-Identifier: GPL-3.0-or-later
// How rows of the decode detail are drawn: what is off or has no value lighter, the message's name bold, bits
// in figures that stand under one another, a doubt in the colour of what wants attention, a frame around the
// row whose bits are pointed at.
#pragma once

#include <QStyledItemDelegate>

namespace deckpipe {

class DecodeDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  // -1: none.
  void setPointedRow(int row) { m_pointed = row; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int m_pointed = -1;
};

}  // namespace deckpipe
