// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/dial_painter.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QTransform>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "paint/figures.h"
#include "paint/glyph.h"

namespace deckpipe {
namespace {

QPainterPath placed(const QPainterPath& unit, const QPointF& pivot, double radius) {
  return QTransform(radius, 0, 0, radius, pivot.x(), pivot.y()).map(unit);
}

// The apparatus' outline behind the needles, so that nobody has to remember which way 'right' or 'up' is. A
// fire engine in as few lines as are recognised at 100 px; the monitor stands on its deck behind the cab.
QPainterPath apparatusFromAbove(const QPointF& pivot, double radius) {
  QPainterPath unit;
  // Body.
  unit.addRoundedRect(QRectF(-0.2, -0.24, 0.4, 0.82), 0.03, 0.03);
  // Cab with a rounded nose, and its windscreen.
  unit.moveTo(-0.19, -0.27);
  unit.lineTo(-0.19, -0.54);
  unit.quadTo(-0.19, -0.64, -0.09, -0.65);
  unit.lineTo(0.09, -0.65);
  unit.quadTo(0.19, -0.64, 0.19, -0.54);
  unit.lineTo(0.19, -0.27);
  unit.closeSubpath();
  unit.moveTo(-0.15, -0.52);
  unit.quadTo(0, -0.57, 0.15, -0.52);
  // Mirrors.
  unit.moveTo(-0.19, -0.53);
  unit.lineTo(-0.245, -0.5);
  unit.moveTo(0.19, -0.53);
  unit.lineTo(0.245, -0.5);
  return placed(unit, pivot, radius);
}

QPainterPath apparatusFromLeft(const QPointF& pivot, double radius, double behind) {
  constexpr double kDeck = 0.22, kRoof = 0.16, kSill = 0.56, kFront = -0.66;
  QPainterPath unit;
  // Body, open to the right where the drawing ends.
  unit.moveTo(behind, kDeck);
  unit.lineTo(-0.24, kDeck);
  unit.lineTo(-0.24, kSill);
  unit.moveTo(behind, kSill);
  unit.lineTo(0.23, kSill);
  unit.moveTo(0.01, kSill);
  unit.lineTo(-0.39, kSill);
  unit.moveTo(-0.61, kSill);
  unit.lineTo(kFront, kSill);
  // Cab, windscreen ahead.
  unit.lineTo(kFront, 0.38);
  unit.lineTo(-0.6, kRoof);
  unit.lineTo(-0.28, kRoof);
  unit.lineTo(-0.28, kSill);
  unit.moveTo(-0.6, 0.22);
  unit.lineTo(-0.47, 0.22);
  unit.lineTo(-0.47, 0.36);
  unit.lineTo(-0.645, 0.36);
  // Wheels.
  unit.addEllipse(QPointF(-0.5, kSill), 0.1, 0.1);
  unit.addEllipse(QPointF(0.12, kSill), 0.1, 0.1);
  // The monitor's riser.
  unit.moveTo(-0.05, kDeck);
  unit.lineTo(-0.05, 0.1);
  unit.moveTo(0.05, kDeck);
  unit.lineTo(0.05, 0.1);
  return placed(unit, pivot, radius);
}

QRectF circle(const QPointF& centre, double radius) {
  return {centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius};
}

// QPainter counts sixteenths of a degree anticlockwise from the right; this room clockwise from the top.
void drawArc(QPainter& p, const QPointF& centre, double radius, double fromBearing, double toBearing) {
  const int start = static_cast<int>(std::lround((90 - toBearing) * 16));
  const int span = static_cast<int>(std::lround((toBearing - fromBearing) * 16));
  p.drawArc(circle(centre, radius), start, span);
}

}  // namespace

DialPainter::DialPainter(QPainter& painter, const Colours& colours, const QFont& font, double textSize)
    : m_painter(painter), m_colours(colours), m_font(font), m_textSize(textSize) {}

double DialPainter::line(double fraction, double least) const {
  // Only lines that grow with the dial grow with the theme: a small one would clog.
  return std::max(least, m_view->px(fraction) * m_colours.stroke);
}

void DialPainter::drawFace(const DialView& view) {
  if (view.radius <= 1) return;
  m_view = &view;
  m_painter.save();
  m_painter.setRenderHint(QPainter::Antialiasing);
  drawApparatus();
  if (view.axis.reading == PositionState::Ok) drawTicks();
  if (!view.axis.isOscillating) drawBand(0);
  m_painter.restore();
}

void DialPainter::drawMoving(const DialView& view, double sway) {
  if (view.radius <= 1) return;
  m_view = &view;
  m_painter.save();
  m_painter.setRenderHint(QPainter::Antialiasing);
  if (view.axis.isOscillating) drawBand(sway);
  if (view.axis.reading != PositionState::Ok) drawNoReading();
  drawCommand();
  drawNeedle();
  drawHub();
  if (view.plusStop) drawStop(*view.plusStop, view.axis.plusStop);
  if (view.minusStop) drawStop(*view.minusStop, view.axis.minusStop);
  m_painter.restore();
}

void DialPainter::drawApparatus() {
  const DialView& v = *m_view;
  // The apparatus stays thin in the sun too: it says where ahead is and must not compete with the needle.
  QPen pen(m_colours.outline, std::max(1.0, v.px(0.008)), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  m_painter.setPen(pen);
  m_painter.setBrush(Qt::NoBrush);
  const bool plan = v.kind == DialAxisKind::Rotation;
  m_painter.drawPath(plan ? apparatusFromAbove(v.pivot, v.radius)
                          : apparatusFromLeft(v.pivot, v.radius, 0.34));
  pen.setWidthF(line(0.008, 1.0));
  // The scale's line: dotted while nothing was ever heard, so that an empty dial is no dial at rest.
  if (!v.axis.reading) {
    pen.setStyle(Qt::CustomDashLine);
    pen.setDashPattern({0.1, 4});
    pen.setWidthF(line(0.02, 2.0));
  }
  m_painter.setPen(pen);
  drawArc(m_painter, v.pivot, v.px(dial::kBand), v.bearing(v.scale().from), v.bearing(v.scale().to));
}

void DialPainter::drawTicks() {
  QFont font = m_font;
  font.setPixelSize(std::max(10, static_cast<int>(m_textSize * 0.85)));
  const QFontMetricsF metrics(font);
  for (const DialTick& tick : m_view->ticks) {
    m_painter.setPen(QPen(tick.major ? m_colours.textSecondary : m_colours.outline,
                          line(tick.major ? 0.012 : 0.007, 1.0), Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(tick.line);
    if (!tick.numbered) continue;
    QString text = QString::number(std::abs(tick.degrees));
    if (tick.degrees < 0) text.prepend(QChar(0x2212));
    if (tick.degrees == 180) text.prepend(QChar(0x00B1));
    // Inwards by as much as the number is wide that way: a tick that touched a minus would lengthen it.
    const double width = metrics.horizontalAdvance(text);
    const double height = metrics.capHeight();
    const QPointF out = (tick.line.p2() - tick.line.p1()) / tick.line.length();
    const double inwards = m_textSize * 0.4 + (std::abs(out.x()) * width + std::abs(out.y()) * height) / 2;
    const QPointF middle = tick.line.p1() - out * inwards;
    m_painter.setFont(font);
    m_painter.setPen(m_colours.textSecondary);
    m_painter.drawText(middle + QPointF(-width / 2, height / 2), text);
  }
}

void DialPainter::drawBand(double sway) {
  const DialView& v = *m_view;
  const DialAxis& axis = v.axis;
  if (v.band) {
    const double from = v.bearing(v.band->from), to = v.bearing(v.band->to);
    const double width = std::max(4.0, v.px(dial::kBandWidth));
    const double radius = v.px(dial::kBand);
    if (axis.areLimitsStale) {
      // Two thin dashed lines where the band was: its ends are still worth knowing, its colour is not.
      QPen pen(m_colours.stale.ink, line(0.008, 1.0), Qt::CustomDashLine, Qt::FlatCap);
      pen.setDashPattern({4, 3});
      m_painter.setPen(pen);
      drawArc(m_painter, v.pivot, radius - width / 2, from, to);
      drawArc(m_painter, v.pivot, radius + width / 2, from, to);
    } else {
      QPen pen(m_colours.travel, width, Qt::SolidLine, Qt::FlatCap);
      if (axis.isOscillating) {
        // Whole dashes around the band, so that its ends look the same at any length.
        const double length = (to - from) * std::numbers::pi / 180 * radius / width;
        const double period = length / std::max(1.0, std::round(length / 3.2));
        pen.setStyle(Qt::CustomDashLine);
        pen.setDashPattern({period * 0.6, period * 0.4});
        pen.setDashOffset(period * (0.8 + sway));
      }
      m_painter.setPen(pen);
      drawArc(m_painter, v.pivot, radius, from, to);
    }
  }
  if (v.low) drawLimit(*v.low);
  if (v.high) drawLimit(*v.high);
}

void DialPainter::drawLimit(const DialLimit& limit) {
  const QColor ink = m_view->axis.areLimitsStale ? m_colours.stale.ink : m_colours.travel;
  m_painter.setPen(QPen(ink, line(0.022, 2.0), Qt::SolidLine, Qt::FlatCap));
  m_painter.drawLine(limit.end);
  if (limit.label.isNull()) return;
  const QString unit = QStringLiteral("°");
  Figures figures;
  figures.number = degreesText(limit.degrees);
  figures.unit = unit;
  figures.numberFont = fittedFont(m_font, m_textSize, QStringLiteral("−888.8°"), limit.label.width(), 9);
  figures.unitFont = figures.numberFont;
  figures.numberColour = m_view->axis.areLimitsStale ? m_colours.stale.ink : m_colours.text;
  figures.unitColour = m_view->axis.areLimitsStale ? m_colours.stale.ink : m_colours.textSecondary;
  // Against the end it belongs to: right alignment is for columns.
  QRectF slot = limit.label;
  const double spare = slot.width() - figuresWidth(figures.numberFont, figures.number + unit);
  const double outward = limit.end.dx() / std::max(1e-9, limit.end.length());
  slot.setRight(slot.right() - std::max(0.0, spare) * (1 + outward) / 2);
  drawFigures(m_painter, slot, figures);
}

void DialPainter::drawNeedle() {
  const DialView& v = *m_view;
  if (!v.needle) return;
  m_painter.setBrush(Qt::NoBrush);
  // A margin of the face's colour keeps the needle apart from whatever it crosses.
  m_painter.setPen(
      QPen(m_colours.surface, std::max(2.0, v.px(0.025)) * 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  m_painter.drawPolygon(v.needleShape);
  if (v.axis.isStale) {
    QPen pen(m_colours.stale.ink, line(0.016, 1.5), Qt::CustomDashLine, Qt::FlatCap, Qt::MiterJoin);
    pen.setDashPattern({3, 2});
    m_painter.setPen(pen);
    m_painter.setBrush(m_colours.surface);
    m_painter.drawPolygon(v.needleShape);
  } else {
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(m_colours.text);
    m_painter.drawPolygon(v.needleShape);
  }
  if (!v.offScale) return;
  const QColor ink = v.axis.isStale ? m_colours.stale.ink : m_colours.warning.ink;
  m_painter.setPen(QPen(ink, line(0.025, 2.0), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const QPointF along = v.offScale->p2() - v.offScale->p1();
  const QPointF across(-along.y(), along.x());
  m_painter.setBrush(Qt::NoBrush);
  for (const double shift : {0.0, 0.7}) {
    const QPointF tip = v.offScale->p1() + along * (0.8 + shift);
    const QPointF back = tip - along * 0.6;
    m_painter.drawPolyline(QPolygonF{back + across * 0.6, tip, back - across * 0.6});
  }
}

void DialPainter::drawHub() {
  const DialView& v = *m_view;
  if (!v.needle) return;
  const QColor ink = v.axis.isStale ? m_colours.stale.ink : m_colours.text;
  m_painter.setPen(QPen(ink, line(0.025, 1.5)));
  m_painter.setBrush(m_colours.surface);
  m_painter.drawEllipse(v.pivot, v.px(dial::kHub), v.px(dial::kHub));
}

void DialPainter::drawStop(const DialBlock& block, std::optional<Status2> stop) {
  const bool on = stop == Status2::On;
  if (m_view->axis.isStale) {
    QPen pen(m_colours.stale.ink, line(0.014, 1.5), Qt::CustomDashLine, Qt::FlatCap, Qt::MiterJoin);
    pen.setDashPattern({3, 2});
    m_painter.setPen(pen);
    m_painter.setBrush(m_colours.surface);
    m_painter.drawPolygon(block.shape);
    drawGlyph(m_painter, block.glyph, on ? Glyph::Stop : Glyph::Warning, m_colours.stale.ink);
    return;
  }
  const Tone& tone = m_colours.warning;
  m_painter.setPen(
      QPen(on ? m_colours.text : tone.ink, line(0.014, 1.5), Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
  m_painter.setBrush(on ? m_colours.text : tone.fill);
  m_painter.drawPolygon(block.shape);
  // A stop that is reached is its own sign: as solid as the needle that stands against it.
  if (!on) drawGlyph(m_painter, block.glyph, Glyph::Warning, tone.onFill);
}

void DialPainter::drawCommand() {
  if (m_view->command.isEmpty()) return;
  m_painter.setPen(QPen(m_colours.surface, line(0.06, 5.0), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  m_painter.setBrush(m_colours.surface);
  m_painter.drawPolygon(m_view->command);
  // Nobody knows whether a monitor that is not heard follows it.
  const QColor ink = m_view->axis.isStale ? m_colours.stale.ink : m_colours.text;
  m_painter.setPen(QPen(ink, line(0.018, 1.5), Qt::SolidLine, Qt::RoundCap, Qt::MiterJoin));
  m_painter.drawPolygon(m_view->command);
}

// No needle at all, so that none can be read; each cause has its own figure across the face.
void DialPainter::drawNoReading() {
  const DialView& v = *m_view;
  const bool plan = v.kind == DialAxisKind::Rotation;
  const bool stale = v.axis.isStale;
  const QRectF face =
      plan ? circle(v.pivot, v.px(0.86))
           : QRectF(v.pivot.x() - v.px(0.86), v.pivot.y() - v.px(0.86), v.px(0.86), v.px(1.72));
  const QPointF middle = plan ? v.pivot : QPointF(v.pivot.x() - v.px(0.36), v.pivot.y());
  const double sign = std::max(11.0, v.px(0.24));
  const QRectF box = circle(middle, sign);
  const auto plate = [&](Glyph glyph, const QColor& ink, const QColor& fill) {
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(m_colours.surface);
    m_painter.drawEllipse(circle(middle, sign * 1.38));
    drawGlyph(m_painter, box, glyph, ink, fill);
  };
  if (!v.axis.reading) return plate(Glyph::NoData, m_colours.stale.ink, Qt::transparent);
  switch (*v.axis.reading) {
    case PositionState::Ok: break;
    case PositionState::NotFitted:
      plate(Glyph::NotFitted, stale ? m_colours.stale.ink : m_colours.textSecondary, Qt::transparent);
      break;
    case PositionState::SensorError: {
      // The instrument is crossed out, as in a cockpit.
      const QPointF c = plan ? v.pivot : v.pivot - QPointF(v.px(0.41), 0);
      const QPointF a = plan ? QPointF(v.px(0.58), v.px(0.58)) : QPointF(v.px(0.28), v.px(0.42));
      const QPointF b(a.x(), -a.y());
      QPen pen(stale ? m_colours.stale.ink : m_colours.fault.ink, line(0.05, 3.0), Qt::SolidLine,
               Qt::FlatCap);
      if (stale) pen.setDashPattern({2, 1.5});
      for (const QPen& pass : {QPen(m_colours.surface, pen.widthF() * 2.2), pen}) {
        m_painter.setPen(pass);
        m_painter.drawLine(c - a, c + a);
        m_painter.drawLine(c - b, c + b);
      }
      break;
    }
    case PositionState::Invalid: {
      const Tone& tone = stale ? m_colours.stale : m_colours.warning;
      QPainterPath clip;
      if (plan) {
        clip.addEllipse(face);
      } else {
        clip.moveTo(v.pivot);
        clip.arcTo(circle(v.pivot, v.px(0.86)), 90, 180);
        clip.closeSubpath();
      }
      m_painter.save();
      m_painter.setClipPath(clip);
      m_painter.setPen(QPen(tone.ink, line(0.012, 1.0)));
      const double step = std::max(9.0, v.px(0.16));
      for (double x = face.left() - face.height(); x < face.right(); x += step)
        m_painter.drawLine(QPointF(x, face.bottom()), QPointF(x + face.height(), face.top()));
      m_painter.restore();
      plate(Glyph::Invalid, tone.ink, m_colours.surface);
      break;
    }
  }
}

}  // namespace deckpipe
