// SPDX-License-Identifier: GPL-3.0-or-later
// A check box whose box can be seen in every theme: Fusion derives its outline from the window's colour,
// which in the dark theme leaves nothing of it. Behaves as any QCheckBox; only the painting is its own.
#pragma once

#include <QCheckBox>

namespace deckpipe {

class TickBox : public QCheckBox {
  Q_OBJECT

 public:
  explicit TickBox(const QString& text, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  bool hitButton(const QPoint& at) const override { return rect().contains(at); }
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace deckpipe
