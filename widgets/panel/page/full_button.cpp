// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/full_button.h"

#include <QPainter>

#include "paint/app_style.h"

namespace deckpipe {

FullButton::FullButton(QWidget* parent) : QAbstractButton(parent) {
  setObjectName(QStringLiteral("fullButton"));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setFocusPolicy(Qt::StrongFocus);
  setFull(false);
}

void FullButton::setFull(bool isFull) {
  m_isFull = isFull;
  setAccessibleName(isFull ? tr("Back to the page") : tr("Large dial"));
  setToolTip(isFull ? tr("Back to the page (Esc)") : tr("Large dial (F11)"));
  update();
}

void FullButton::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const QRectF box = QRectF(rect()).adjusted(2.5, 2.5, -2.5, -2.5);
  p.setPen(QPen(hasFocus() ? c.accent.ink : c.outline, hasFocus() ? 2 : 1));
  p.setBrush(isDown() ? c.surfaceAlternate : c.surface);
  p.drawRoundedRect(box, 6, 6);
  p.setPen(QPen(c.accent.ink, 2 * c.stroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(Qt::NoBrush);
  const double arm = 6, far = 9;
  const QPointF middle = box.center();
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      // Outwards the corner is far from the middle, inwards it is near it.
      const double corner = m_isFull ? far - arm : far, end = m_isFull ? far : far - arm;
      p.drawPolyline(QPolygonF{middle + QPointF(sx * end, sy * corner),
                               middle + QPointF(sx * corner, sy * corner),
                               middle + QPointF(sx * corner, sy * end)});
    }
  }
}

}  // namespace deckpipe
