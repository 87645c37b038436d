// SPDX-License-Identifier: GPL-3.0-or-later
// The button that spreads a dial over the window, and takes it back: four corners, outwards or inwards. Used
// by PageHeader on a monitor's page and over the full dial.
#pragma once

#include <QAbstractButton>

namespace deckpipe {

class FullButton : public QAbstractButton {
  Q_OBJECT

 public:
  explicit FullButton(QWidget* parent = nullptr);

  void setFull(bool isFull);

  QSize sizeHint() const override { return {44, 44}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  bool m_isFull = false;
};

}  // namespace deckpipe
