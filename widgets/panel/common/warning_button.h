// SPDX-License-Identifier: GPL-3.0-or-later
// A button of what changes a device: with the warning sign and a line around it, in every theme. Red is for faults
// alone, so it is not red.
#pragma once

#include <QIcon>
#include <QPushButton>

namespace deckpipe {

// The warning sign in the colours of the style that `on` has while it is painted.
QIcon warningIcon(const QWidget* on);

class WarningButton : public QPushButton {
  Q_OBJECT

 public:
  explicit WarningButton(const QString& text, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace deckpipe
