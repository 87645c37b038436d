// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/play/transport_button.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "paint/app_style.h"

namespace deckpipe {
namespace {

constexpr int kSide = 44;
constexpr double kButtonSign = 16;
constexpr int kButtonGap = 8;

// In a square of side 2 around the origin.
void drawSign(QPainter& p, const QRectF& box, TransportButton::Sign sign, const QColor& ink) {
  p.save();
  p.translate(box.center());
  p.scale(box.width() / 2, box.height() / 2);
  p.setPen(Qt::NoPen);
  p.setBrush(ink);
  switch (sign) {
    case TransportButton::Sign::Play: p.drawPolygon(QPolygonF{{-0.7, -0.95}, {0.95, 0}, {-0.7, 0.95}}); break;
    case TransportButton::Sign::Pause:
      p.drawRect(QRectF(-0.75, -0.9, 0.5, 1.8));
      p.drawRect(QRectF(0.25, -0.9, 0.5, 1.8));
      break;
    case TransportButton::Sign::StepBack:
      p.drawRect(QRectF(0.45, -0.8, 0.3, 1.6));
      p.drawPolygon(QPolygonF{{0.25, -0.8}, {-0.85, 0}, {0.25, 0.8}});
      break;
    case TransportButton::Sign::StepForward:
      p.drawRect(QRectF(-0.75, -0.8, 0.3, 1.6));
      p.drawPolygon(QPolygonF{{-0.25, -0.8}, {0.85, 0}, {-0.25, 0.8}});
      break;
    case TransportButton::Sign::ToEnd:
      p.drawPolygon(QPolygonF{{-0.9, -0.8}, {0, 0}, {-0.9, 0.8}});
      p.drawPolygon(QPolygonF{{-0.1, -0.8}, {0.75, 0}, {-0.1, 0.8}});
      p.drawRect(QRectF(0.7, -0.8, 0.25, 1.6));
      break;
    case TransportButton::Sign::Live: p.drawEllipse(QRectF(-0.7, -0.7, 1.4, 1.4)); break;
    case TransportButton::Sign::Loop: {
      // Round and round: an arc that is open where its arrow points down.
      p.setBrush(Qt::NoBrush);
      p.setPen(QPen(ink, 0.26, Qt::SolidLine, Qt::FlatCap));
      p.drawArc(QRectF(-0.75, -0.75, 1.5, 1.5), 50 * 16, 290 * 16);
      p.setPen(Qt::NoPen);
      p.setBrush(ink);
      p.drawPolygon(QPolygonF{{0.1, -0.95}, {0.95, -0.85}, {0.55, -0.1}});
      break;
    }
    case TransportButton::Sign::Skip:
      // Over a gap.
      p.drawRect(QRectF(-0.95, 0.4, 0.5, 0.5));
      p.drawRect(QRectF(0.45, 0.4, 0.5, 0.5));
      p.setBrush(Qt::NoBrush);
      p.setPen(QPen(ink, 0.24, Qt::SolidLine, Qt::FlatCap));
      p.drawArc(QRectF(-0.7, -0.6, 1.3, 1.6), 20 * 16, 160 * 16);
      p.setPen(Qt::NoPen);
      p.setBrush(ink);
      p.drawPolygon(QPolygonF{{0.2, -0.1}, {0.95, -0.3}, {0.75, 0.35}});
      break;
  }
  p.restore();
}

}  // namespace

TransportButton::TransportButton(Sign sign, QWidget* parent) : QAbstractButton(parent), m_sign(sign) {
  setAttribute(Qt::WA_Hover);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void TransportButton::setSign(Sign sign) {
  if (std::exchange(m_sign, sign) != sign) update();
}

void TransportButton::setOn(bool isOn) {
  if (std::exchange(m_isOn, isOn) != isOn) update();
}

void TransportButton::setWidestText(const QString& text) {
  m_widest = text;
  updateGeometry();
}

QSize TransportButton::sizeHint() const {
  if (m_widest.isEmpty()) return {kSide, kSide};
  return {static_cast<int>(kButtonSign) + 3 * kButtonGap + 4 + fontMetrics().horizontalAdvance(m_widest),
          kSide};
}

void TransportButton::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const Colours& c = coloursOf(this);
  const bool isFilled = isEnabled() && (m_isOn || isChecked() || isDown());
  const QColor ground = isFilled                      ? c.accent.fill
                        : isEnabled() && underMouse() ? c.surfaceAlternate
                                                      : c.surface;
  const QColor ink = !isEnabled() ? c.stale.ink : isFilled ? c.accent.onFill : c.accent.ink;
  QPen frame(isEnabled() ? (isFilled ? c.accent.ink : c.outline) : c.outline, c.stroke);
  if (!isEnabled()) frame.setDashPattern({2, 2});
  p.setPen(frame);
  p.setBrush(ground);
  p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
  const bool isPlain = m_widest.isEmpty();
  const double left = isPlain ? (width() - kButtonSign) / 2 : kButtonGap + 2;
  drawSign(p, QRectF(left, (height() - kButtonSign) / 2, kButtonSign, kButtonSign), m_sign, ink);
  if (!isPlain) {
    p.setPen(isFilled ? c.accent.onFill : isEnabled() ? c.text : c.stale.ink);
    p.drawText(
        QRectF(left + kButtonSign + kButtonGap, 0, width() - left - kButtonSign - kButtonGap, height()),
        Qt::AlignLeft | Qt::AlignVCenter, text());
  }
  if (hasFocus()) drawFocusRing(p, c, rect());
}

}  // namespace deckpipe
