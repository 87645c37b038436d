// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons that are painted by themselves and behave as Qt's own.
#pragma once

#include <QCheckBox>
#include <QIcon>
#include <QPushButton>

namespace deckpipe {

// A check box whose box can be seen in every theme: Fusion derives its outline from the window's colour,
// which in the dark theme leaves nothing of it.
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

// The warning sign in the colours of the style that `on` has while it is painted.
QIcon warningIcon(const QWidget* on);

// A button of what changes a device: with the warning sign and a line around it, in every theme. Red is for faults
// alone, so it is not red.
class WarningButton : public QPushButton {
  Q_OBJECT

 public:
  explicit WarningButton(const QString& text, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace deckpipe
