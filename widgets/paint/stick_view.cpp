// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/stick_view.h"

#include <QPainter>
#include <algorithm>

#include "paint/app_style.h"
#include "paint/glyph.h"
#include "paint/spoken.h"

namespace deckpipe {

StickGeometry stickGeometry(const StickValues& values, const QRectF& bounds) {
  StickGeometry g;
  const double side = std::min(bounds.width(), bounds.height());
  g.knobRadius = std::max(8.0, side * 0.09);
  const double half = std::max(1.0, side / 2 - g.knobRadius - 2);
  const QPointF centre = bounds.center();
  g.gate = QRectF(centre.x() - half, centre.y() - half, 2 * half, 2 * half);
  const double x = std::clamp(values.x.value_or(0), -1.0, 1.0);
  const double y = std::clamp(values.y.value_or(0), -1.0, 1.0);
  g.knob = centre + QPointF(x * half, -y * half);
  return g;
}

StickView::StickView(QWidget* parent) : QWidget(parent) {
  speakAs(*this, QAccessible::Graphic);
  setObjectName(QStringLiteral("stickView"));
  setAccessibleName(tr("Stick"));
}

void StickView::setValues(const StickValues& values) {
  if (values == m_values) return;
  m_values = values;
  update();
}

void StickView::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const StickGeometry g = stickGeometry(m_values, QRectF(rect()).adjusted(1, 1, -1, -1));
  const Colours& c = coloursOf(this);
  const double stroke = c.stroke;
  const double r = g.knobRadius;
  const QRectF frame = g.gate.adjusted(-r, -r, r, r);
  p.setPen(QPen(c.outline, 1.5 * stroke));
  p.setBrush(c.surface);
  p.drawRoundedRect(frame, r, r);
  QPen fine(c.outline, stroke);
  fine.setDashPattern({2, 3});
  p.setPen(fine);
  p.drawLine(QPointF(g.gate.left(), g.gate.center().y()), QPointF(g.gate.right(), g.gate.center().y()));
  p.drawLine(QPointF(g.gate.center().x(), g.gate.top()), QPointF(g.gate.center().x(), g.gate.bottom()));

  const QRectF knob(g.knob.x() - r, g.knob.y() - r, 2 * r, 2 * r);
  const bool isKnown = m_values.x.has_value() && m_values.y.has_value();
  if (!isKnown || m_values.isStale) {
    // No position to show, or an old one: a sign in its place, never a knob that could be taken for live.
    QPen dashed(c.stale.ink, 1.5 * stroke);
    dashed.setDashPattern({2, 1.5});
    p.setPen(dashed);
    p.setBrush(c.stale.fill);
    p.drawEllipse(knob);
    const double inset = r * 0.5;
    drawGlyph(p, knob.adjusted(inset, inset, -inset, -inset), isKnown ? Glyph::Stale : Glyph::Unknown,
              c.stale.onFill, Qt::transparent, stroke);
    return;
  }
  p.setPen(QPen(c.text, 3 * stroke, Qt::SolidLine, Qt::RoundCap));
  if (g.knob != g.gate.center()) p.drawLine(g.gate.center(), g.knob);
  p.setPen(Qt::NoPen);
  p.setBrush(c.text);
  p.drawEllipse(knob);
}

}  // namespace deckpipe
