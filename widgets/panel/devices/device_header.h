// SPDX-License-Identifier: GPL-3.0-or-later
// The head of the device table: flat, its words in line with the cells below, the sorted column marked by an
// arrow. Used by DeviceList alone.
#pragma once

#include <QHeaderView>

namespace deckpipe {

class DeviceHeader : public QHeaderView {
  Q_OBJECT

 public:
  explicit DeviceHeader(QWidget* parent = nullptr);

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int section) const override;
  void paintEvent(QPaintEvent* event) override;

 private:
};

}  // namespace deckpipe
