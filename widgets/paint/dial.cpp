// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/dial.h"

#include <QPainter>
#include <cmath>
#include <numbers>

#include "paint/app_style.h"
#include "paint/dial_geometry.h"
#include "paint/dial_painter.h"
#include "paint/dial_readout.h"
#include "paint/dial_text.h"
#include "paint/figures.h"

namespace deckpipe {
namespace {

constexpr int kFrameMs = 66;
constexpr double kFramesPerSway = 30;  // two seconds to and fro
constexpr int kDescribeMs = 500;

// Ages run on with every tick; what counts is what is written of them.
bool looksTheSame(const DialValues& shown, DialValues next) {
  const auto settle = [](const DialAxis& old, DialAxis& axis) {
    if (old.age && axis.age && ageText(*old.age) == ageText(*axis.age)) axis.age = old.age;
  };
  settle(shown.rotation, next.rotation);
  settle(shown.elevation, next.elevation);
  return shown == next;
}

}  // namespace

Dial::Dial(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("dial"));
  setAccessibleName(tr("Position of the monitor"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  m_timer.setInterval(kFrameMs);
  connect(&m_timer, &QTimer::timeout, this, [this] { setPhase(m_phase + 1 / kFramesPerSway); });
  m_describe.setInterval(kDescribeMs);
  m_describe.setSingleShot(true);
  connect(&m_describe, &QTimer::timeout, this, &Dial::describe);
  describe();
}

void Dial::setValues(const DialValues& values) {
  const bool same = looksTheSame(m_values, values);
  m_values = values;
  if (same) return;
  updateTimer();
  update();
  // A screen reader would stutter at 30 sentences a second: at once, then at most every half second.
  if (!m_describe.isActive()) {
    describe();
    m_describe.start();
  }
}

void Dial::describe() { setAccessibleDescription(DialText::description(m_values)); }

void Dial::setAnimated(bool animated) {
  m_animated = animated;
  updateTimer();
}

void Dial::setPhase(double phase) {
  m_phase = phase - std::floor(phase);
  update();
}

void Dial::updateTimer() {
  const DialAxis& axis = m_values.rotation;
  const bool moves = axis.isOscillating && axis.limitLow && axis.limitHigh && !axis.areLimitsStale;
  const bool run = m_animated && moves && isVisible();
  if (run == m_timer.isActive()) return;
  if (run)
    m_timer.start();
  else
    m_timer.stop();
}

void Dial::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  updateTimer();
}

void Dial::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  updateTimer();
}

void Dial::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Colours& c = coloursOf(this);
  painter.fillRect(rect(), c.surface);
  const DialGeometry g = dialGeometry(m_values, rect());
  // To and fro, not round: dashes that always ran one way would look like a direction.
  const double sway = std::sin(m_phase * 2 * std::numbers::pi);
  DialPainter drawing(painter, c, font(), g.layout.textSize);
  drawing.draw(g.rotation, sway);
  drawing.draw(g.elevation, 0);
  DialReadout texts(painter, c, font(), g.layout);
  texts.draw(g.rotation);
  texts.draw(g.elevation);
  texts.drawChips(m_values);
}

}  // namespace deckpipe
