// SPDX-License-Identifier: GPL-3.0-or-later
// Paints the cells of the device table: the device over its type, under it to the right the words of its
// health, worst first, and its age; numbers in equal cells so that a running age moves nothing. The PIN has
// its line to itself but for the address; the words of the health take their room before the type does. Used
// by DeviceList alone, which paints backgrounds and group headings.
#pragma once

#include <QStyledItemDelegate>

#include "paint/palette.h"

namespace deckpipe {

class DeviceDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  static constexpr int kRowHeight = 48;
  static constexpr int kHeadingHeight = 28;

  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  // A row that opens its group is higher by the heading.
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintDevice(QPainter& p, const Colours& c, const QRectF& cell, const QModelIndex& index,
                   const QStyleOptionViewItem& option) const;
  void paintHealth(QPainter& p, const Colours& c, const QRectF& cell, const QModelIndex& index,
                   bool isSelected, double left) const;
  void paintNumber(QPainter& p, const Colours& c, const QRectF& cell, const QModelIndex& index,
                   bool isSelected) const;
};

}  // namespace deckpipe
