// SPDX-License-Identifier: GPL-3.0-or-later
// A choice that the wheel does not change: scrolling past it must not begin to poll a bus, or change what
// goes to a device. Used in panels that send.
#pragma once

#include <QComboBox>
#include <QWheelEvent>

namespace deckpipe {

class CalmCombo : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

}  // namespace deckpipe
