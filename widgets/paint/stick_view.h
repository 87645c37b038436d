// SPDX-License-Identifier: GPL-3.0-or-later
// A joystick's stick seen from above: forward is up, right is right. It draws what a message said; it is no
// control. Used by the page of whatever sends joystick messages.
#pragma once

#include <QWidget>

#include "paint/stick_values.h"

namespace deckpipe {

// Where things are in a square of the widget; pure.
struct StickGeometry {
  QRectF gate;   // full deflection to both sides
  QPointF knob;  // at the centre where an axis gives nothing
  double knobRadius = 0;
};
StickGeometry stickGeometry(const StickValues& values, const QRectF& bounds);

class StickView : public QWidget {
  Q_OBJECT

 public:
  explicit StickView(QWidget* parent = nullptr);

  void setValues(const StickValues& values);

  QSize sizeHint() const override { return {176, 176}; }
  QSize minimumSizeHint() const override { return {96, 96}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  StickValues m_values;
};

}  // namespace deckpipe
