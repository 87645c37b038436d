// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/full_button.h"

#include <QPainter>

namespace deckpipe {

FullButton::FullButton(QWidget* parent) : QAbstractButton(parent), m_colours(coloursOf(Theme::Light)) {
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

void FullButton::setColours(const Colours& colours) {
  m_colours = colours;
  update();
}

void FullButton::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const QRectF box = QRectF(rect()).adjusted(2.5, 2.5, -2.5, -2.5);
  p.setPen(QPen(hasFocus() ? m_colours.accent.ink : m_colours.outline, hasFocus() ? 2 : 1));
  p.setBrush(isDown() ? m_colours.surfaceAlternate : m_colours.surface);
  p.drawRoundedRect(box, 6, 6);
  p.setPen(QPen(m_colours.accent.ink, 2 * m_colours.stroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
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
