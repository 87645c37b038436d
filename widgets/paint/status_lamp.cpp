// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/status_lamp.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "paint/app_style.h"
#include "paint/spoken.h"

namespace deckpipe {
namespace {

constexpr int kHeight = 32;
constexpr double kLamp = 22;  // side of the lamp itself
constexpr double kGap = 8;

}  // namespace

StatusLamp::StatusLamp(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("statusLamp"));
  speakAs(*this, QAccessible::Indicator);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  describe();
}

void StatusLamp::setLabel(const QString& label, const QString& spoken) {
  if (label == m_label && spoken == m_spoken) return;
  m_label = label;
  m_spoken = spoken;
  describe();
  m_hint = {};
  updateGeometry();
  update();
}

void StatusLamp::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  m_hint = {};
}

void StatusLamp::setWhenOn(Severity whenOn, std::optional<Glyph> sign) {
  m_whenOn = whenOn;
  m_signWhenOn = sign;
  update();
}

void StatusLamp::setState(std::optional<Status2> state, bool stale) {
  if (state == m_state && stale == m_stale) return;
  m_state = state;
  m_stale = stale;
  describe();
  update();
}

QString StatusLamp::word() const {
  if (!m_state) return tr("unknown");
  switch (*m_state) {
    case Status2::Off: return tr("off");
    case Status2::On: return tr("on");
    case Status2::Error: return tr("error");
    case Status2::NotAvailable: return tr("not available");
  }
  return {};
}

void StatusLamp::describe() {
  setAccessibleName(m_spoken.isEmpty() ? m_label : m_spoken);
  setAccessibleDescription(m_stale ? tr("%1, stale").arg(word()) : word());
}

StatusLamp::Look StatusLamp::lookIn(const Colours& c) const {
  if (!m_state) return {Glyph::Unknown, c.stale.ink, Qt::transparent, c.stale.ink, true};
  if (m_stale) return {Glyph::Stale, c.stale.ink, c.stale.fill, c.stale.onFill, true};
  switch (*m_state) {
    case Status2::Off: return {Glyph::Off, c.textSecondary, Qt::transparent, c.outline, false};
    case Status2::Error: return {Glyph::Warning, c.warning.ink, c.warning.fill, c.warning.onFill, false};
    case Status2::NotAvailable:
      return {Glyph::NotAvailable, c.textSecondary, Qt::transparent, c.textSecondary, true};
    case Status2::On: break;
  }
  const auto sign = [&](Glyph usual) { return m_signWhenOn.value_or(usual); };
  switch (m_whenOn) {
    case Severity::Fine: return {sign(Glyph::Fine), c.fine.ink, c.fine.fill, c.fine.onFill, false};
    case Severity::Warning: return {sign(Glyph::On), c.warning.ink, c.warning.fill, c.warning.onFill, false};
    case Severity::Fault: return {sign(Glyph::Fault), c.fault.ink, c.fault.fill, c.fault.onFill, false};
    default: return {sign(Glyph::On), c.text, c.text, c.surface, false};
  }
}

QSize StatusLamp::sizeHint() const {
  if (m_hint.isValid()) return m_hint;
  // The widest word, so that no change of state moves a neighbour.
  const QFontMetricsF metrics(font());
  double words = 0;
  for (const QString& w : {tr("unknown"), tr("off"), tr("on"), tr("error"), tr("not available")})
    words = std::max(words, metrics.horizontalAdvance(w));
  m_hint = {static_cast<int>(std::ceil(kLamp + metrics.horizontalAdvance(m_label) + words + 4 * kGap)),
            std::max(kHeight, static_cast<int>(metrics.height() * 1.6))};
  return m_hint;
}

QSize StatusLamp::minimumSizeHint() const { return {static_cast<int>(kLamp + 2 * kGap), kHeight}; }

void StatusLamp::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const Look look = lookIn(c);
  const double middle = height() / 2.0;
  const QRectF lamp(kGap / 2, middle - kLamp / 2, kLamp, kLamp);
  QPen frame(look.ink, 1.5 * c.stroke, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin);
  if (look.dashed) frame.setDashPattern({2, 1.5});
  p.setPen(frame);
  p.setBrush(look.fill);
  p.drawRoundedRect(lamp, 4, 4);
  const double inset = kLamp * 0.2;
  drawGlyph(p, lamp.adjusted(inset, inset, -inset, -inset), look.glyph, look.glyphInk, Qt::transparent,
            c.stroke);

  const QFontMetricsF metrics(font());
  const double baseline = middle + metrics.capHeight() / 2;
  const double left = lamp.right() + kGap;
  const double right = width() - kGap / 2;
  p.setFont(font());
  // The lamp says the state already: the word goes first when room is short, then the label is elided.
  const double wordWidth = metrics.horizontalAdvance(word());
  const bool wordFits = left + metrics.horizontalAdvance(m_label) + kGap + wordWidth <= right;
  if (wordFits) {
    p.setPen(look.ink);
    p.drawText(QPointF(right - wordWidth, baseline), word());
  }
  p.setPen(m_stale ? c.stale.ink : c.text);
  p.drawText(QPointF(left, baseline), metrics.elidedText(m_label, Qt::ElideRight, right - left));
}

}  // namespace deckpipe
