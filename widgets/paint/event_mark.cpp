// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/event_mark.h"

#include <QPainter>
#include <QPixmap>
#include <algorithm>

#include "paint/severity_look.h"

namespace deckpipe {

QColor eventInk(Severity weight, const Colours& colours) {
  return weight == Severity::Plain ? colours.textSecondary : inkOf(colours, inkOf(weight));
}

void drawEventMark(QPainter& painter, const QRectF& box, EventGroup group, const QColor& ink) {
  const double size = std::min(box.width(), box.height());
  const QRectF r(box.center().x() - size / 2, box.center().y() - size / 2, size, size);
  const QPointF c = r.center();
  const double half = size / 2, third = size / 3;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  switch (group) {
    case EventGroup::Presence: painter.drawEllipse(r.adjusted(0.5, 0.5, -0.5, -0.5)); break;
    case EventGroup::Address:
      painter.drawPolygon(
          QPolygonF{{c.x(), r.top()}, {r.right(), c.y()}, {c.x(), r.bottom()}, {r.left(), c.y()}});
      break;
    case EventGroup::Fault:
      painter.drawPolygon(QPolygonF{r.topLeft(), r.topRight(), {c.x(), r.bottom()}});
      break;
    case EventGroup::Mode: painter.drawRect(r.adjusted(1, 1, -1, -1)); break;
    case EventGroup::Stop:
      painter.drawRect(QRectF(c.x() - size / 8, r.top(), size / 4, size));
      painter.drawRect(QRectF(r.left(), r.bottom() - size / 4, size, size / 4));
      break;
    case EventGroup::Joystick:
      painter.drawPolygon(QPolygonF{r.bottomLeft(), r.bottomRight(), {c.x(), r.top()}});
      break;
    case EventGroup::Bus:
      painter.drawRect(QRectF(c.x() - third / 2, r.top(), third, size));
      painter.drawRect(QRectF(r.left(), c.y() - third / 2, size, third));
      break;
    case EventGroup::Note:
      painter.drawRect(QRectF(r.left(), r.top(), std::max(1.5, size / 7), size));
      painter.drawPolygon(
          QPolygonF{r.topLeft(), {r.right(), r.top() + half / 1.5}, {r.left(), r.top() + half * 4 / 3}});
      break;
    case EventGroup::Count: break;
  }
  painter.restore();
}

QIcon eventMarkIcon(EventGroup group, const Colours& colours) {
  constexpr int kSize = 16, kScale = 3;
  QPixmap pixmap(kSize * kScale, kSize * kScale);
  pixmap.setDevicePixelRatio(kScale);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  drawEventMark(painter, QRectF(3, 3, kSize - 6, kSize - 6), group, colours.text);
  return QIcon(pixmap);
}

}  // namespace deckpipe
