// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/glyph.h"

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace deckpipe {
namespace {

// All shapes live in a square of side 2 around the origin, y downwards.
QPolygonF regular(int corners, double radius, double firstDegrees) {
  QPolygonF shape;
  for (int i = 0; i < corners; ++i) {
    const double a = (firstDegrees + 360.0 * i / corners) * std::numbers::pi / 180.0;
    shape << QPointF(radius * std::cos(a), radius * std::sin(a));
  }
  return shape;
}

void questionMark(QPainter& p, const QColor& ink, double scale) {
  QPainterPath hook;
  hook.moveTo(-0.38 * scale, -0.34 * scale);
  hook.cubicTo(-0.38 * scale, -0.95 * scale, 0.46 * scale, -0.95 * scale, 0.42 * scale, -0.32 * scale);
  hook.cubicTo(0.38 * scale, 0.02 * scale, 0.0, -0.02 * scale, 0.0, 0.34 * scale);
  p.setBrush(Qt::NoBrush);
  p.drawPath(hook);
  p.setBrush(ink);
  p.drawEllipse(QPointF(0, 0.72 * scale), 0.05, 0.05);
}

void ring(QPainter& p) { p.drawEllipse(QPointF(0, 0), 0.84, 0.84); }

}  // namespace

void drawGlyph(QPainter& p, const QRectF& box, Glyph glyph, const QColor& ink, const QColor& fill,
               double weight) {
  const double half = std::min(box.width(), box.height()) / 2;
  if (half <= 0) return;
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.translate(box.center());
  p.scale(half, half);
  // Never thinner than 1.2 pixels: below that a stroke is a smear.
  const double width = std::max(0.2 * weight, 1.2 / half);
  p.setPen(QPen(ink, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(fill);
  switch (glyph) {
    case Glyph::Fine:
      p.setBrush(Qt::NoBrush);
      p.drawPolyline(QPolygonF{{-0.74, 0.06}, {-0.22, 0.58}, {0.76, -0.54}});
      break;
    case Glyph::Warning:
      p.drawPolygon(QPolygonF{{0, -0.8}, {0.88, 0.74}, {-0.88, 0.74}});
      p.drawLine(QPointF(0, -0.22), QPointF(0, 0.22));
      p.setBrush(ink);
      p.drawEllipse(QPointF(0, 0.5), 0.03, 0.03);
      break;
    case Glyph::Fault:
      ring(p);
      p.drawLine(QPointF(-0.34, -0.34), QPointF(0.34, 0.34));
      p.drawLine(QPointF(-0.34, 0.34), QPointF(0.34, -0.34));
      break;
    case Glyph::Stop:
      p.drawLine(QPointF(-0.8, 0), QPointF(0.12, 0));
      p.setBrush(ink);
      p.drawRect(QRectF(0.24, -0.74, 0.5, 1.48));
      break;
    case Glyph::Stale:
      ring(p);
      p.setBrush(Qt::NoBrush);
      p.drawPolyline(QPolygonF{{0, -0.44}, {0, 0.04}, {0.34, 0.26}});
      break;
    case Glyph::NoData:
      p.setPen(Qt::NoPen);
      p.setBrush(ink);
      for (const QPointF& dot : regular(8, 0.76, 0)) p.drawEllipse(dot, width * 0.62, width * 0.62);
      break;
    case Glyph::NotFitted:
      ring(p);
      p.drawLine(QPointF(-0.58, 0.58), QPointF(0.58, -0.58));
      break;
    case Glyph::Invalid:
      p.drawPolygon(regular(4, 0.98, 0));
      questionMark(p, ink, 0.56);
      break;
    case Glyph::Unknown: questionMark(p, ink, 0.9); break;
    case Glyph::NotAvailable: p.drawLine(QPointF(-0.62, 0), QPointF(0.62, 0)); break;
    case Glyph::Off: ring(p); break;
    case Glyph::On:
      ring(p);
      p.setBrush(ink);
      p.drawEllipse(QPointF(0, 0), 0.36, 0.36);
      break;
    case Glyph::Locked:
      p.drawRoundedRect(QRectF(-0.68, -0.1, 1.36, 0.96), 0.14, 0.14);
      p.setBrush(Qt::NoBrush);
      p.drawArc(QRectF(-0.42, -0.86, 0.84, 0.9), 0, 180 * 16);
      p.drawLine(QPointF(-0.42, -0.41), QPointF(-0.42, -0.12));
      p.drawLine(QPointF(0.42, -0.41), QPointF(0.42, -0.12));
      break;
    case Glyph::Stowed:
      p.setBrush(Qt::NoBrush);
      p.drawLine(QPointF(0, -0.84), QPointF(0, 0.28));
      p.drawPolyline(QPolygonF{{-0.38, -0.08}, {0, 0.3}, {0.38, -0.08}});
      p.drawPolyline(QPolygonF{{-0.82, 0.3}, {-0.82, 0.8}, {0.82, 0.8}, {0.82, 0.3}});
      break;
    case Glyph::CommandPlus:
      p.drawPolygon(QPolygonF{{-0.86, -0.28},
                              {0.06, -0.28},
                              {0.06, -0.72},
                              {0.88, 0},
                              {0.06, 0.72},
                              {0.06, 0.28},
                              {-0.86, 0.28}});
      break;
    case Glyph::Commanded: p.drawPolygon(regular(4, 0.62, 0)); break;
    case Glyph::Oscillating:
      p.setBrush(Qt::NoBrush);
      p.drawLine(QPointF(-0.8, 0), QPointF(0.8, 0));
      p.drawPolyline(QPolygonF{{-0.4, -0.42}, {-0.84, 0}, {-0.4, 0.42}});
      p.drawPolyline(QPolygonF{{0.4, -0.42}, {0.84, 0}, {0.4, 0.42}});
      break;
  }
  p.restore();
}

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
