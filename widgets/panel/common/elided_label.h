// SPDX-License-Identifier: GPL-3.0-or-later
// A label of one line that ends in an ellipsis where there is too little room, instead of in half a letter.
// Its text stays whole for tooltips, screen readers and tests.
#pragma once

#include <QLabel>

namespace deckpipe {

class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr, Qt::TextElideMode mode = Qt::ElideRight);

  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Qt::TextElideMode m_mode;
};

}  // namespace deckpipe
