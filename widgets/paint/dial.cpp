// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/dial.h"

#include <QPaintEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "paint/app_style.h"
#include "paint/dial_painter.h"
#include "paint/dial_readout.h"
#include "paint/figures.h"
#include "paint/spoken.h"

namespace deckpipe {
namespace {

constexpr int kFrameMs = 66;
constexpr double kFramesPerSway = 30;  // two seconds to and fro
constexpr int kDescribeMs = 500;

// Ages run on with every tick; what counts is what is written of them.
bool looksTheSame(const DialValues& shown, DialValues next) {
  const auto settle = [](const DialAxis& old, DialAxis& axis) {
    if (old.age.kind == axis.age.kind && ageText(old.age.length) == ageText(axis.age.length))
      axis.age = old.age;
  };
  settle(shown.rotation, next.rotation);
  settle(shown.elevation, next.elevation);
  return shown == next;
}

// What an axis draws into the face.
DialAxis onFace(const DialAxis& axis) {
  DialAxis face;
  face.reading = axis.reading;
  face.limitLow = axis.limitLow;
  face.limitHigh = axis.limitHigh;
  face.areLimitsStale = axis.areLimitsStale;
  face.isOscillating = axis.isOscillating;
  return face;
}

std::vector<double> numbersOf(const DialView& view) {
  std::vector<double> numbers;
  for (const DialTick& tick : view.ticks)
    if (tick.numbered) numbers.push_back(tick.degrees);
  return numbers;
}

QRect areaOf(const DialView& view) { return (view.drawing | view.texts).toAlignedRect(); }

// What is drawn over the face, with room for the widest pen.
QRectF movingArea(const DialView& v) {
  const double hub = v.px(dial::kHub), pen = 8 + v.px(0.15);
  QRectF area(v.pivot.x() - hub, v.pivot.y() - hub, 2 * hub, 2 * hub);
  area |= v.needleShape.boundingRect();
  if (!v.command.isEmpty()) area |= v.command.boundingRect();
  if (v.offScale) area |= QPolygonF{v.offScale->p1(), v.offScale->p2()}.boundingRect();
  for (const auto* stop : {&v.plusStop, &v.minusStop})
    if (*stop) area |= (*stop)->shape.boundingRect();
  return area.adjusted(-pen, -pen, pen, pen);
}

// One rectangle: a clip of several makes every drawing slower.
QRect difference(const DialView& before, const DialView& after) {
  if (before.axis == after.axis) return {};
  const bool isSameFace = onFace(before.axis) == onFace(after.axis) && numbersOf(before) == numbersOf(after);
  if (!isSameFace || !before.needle || !after.needle) return areaOf(after);
  return (movingArea(before) | movingArea(after) | after.texts).toAlignedRect();
}

}  // namespace

Dial::Dial(QWidget* parent) : QWidget(parent) {
  speakAs(*this, QAccessible::Graphic);
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
  const DialValues before = std::exchange(m_values, values);
  if (looksTheSame(before, values)) return;
  updateTimer();
  const DialGeometry shown = std::exchange(m_geometry, dialGeometry(values, rect()));
  update(difference(shown.rotation, m_geometry.rotation) | difference(shown.elevation, m_geometry.elevation));
  if (before.enable != values.enable || before.stowed != values.stowed) update();
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
  update(areaOf(m_geometry.rotation));
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

void Dial::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  m_geometry = dialGeometry(m_values, rect());
}

void Dial::drawFace(double pixelRatio) {
  const Colours& c = coloursOf(this);
  Face face{.values = {.rotation = onFace(m_values.rotation),
                       .elevation = onFace(m_values.elevation),
                       .enable = m_values.enable,
                       .stowed = m_values.stowed},
            .numbers = numbersOf(m_geometry.rotation),
            .theme = c.theme,
            .font = font(),
            .size = size(),
            .pixelRatio = pixelRatio};
  std::ranges::copy(numbersOf(m_geometry.elevation), std::back_inserter(face.numbers));
  if (face == m_face) return;
  m_face = std::move(face);
  m_picture = QPixmap((QSizeF(size()) * pixelRatio).toSize());
  m_picture.setDevicePixelRatio(pixelRatio);
  m_picture.fill(c.surface);
  QPainter painter(&m_picture);
  DialPainter drawing(painter, c, m_face.font, m_geometry.layout.textSize);
  drawing.drawFace(m_geometry.rotation);
  drawing.drawFace(m_geometry.elevation);
  DialReadout(painter, c, m_face.font, m_geometry.layout).drawChips(m_values);
}

void Dial::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  drawFace(painter.deviceTransform().m11());
  painter.drawPixmap(0, 0, m_picture);
  // To and fro, not round: dashes that always ran one way would look like a direction.
  const double sway = std::sin(m_phase * 2 * std::numbers::pi);
  DialPainter drawing(painter, coloursOf(this), font(), m_geometry.layout.textSize);
  DialReadout texts(painter, coloursOf(this), font(), m_geometry.layout);
  for (const DialView* view : {&m_geometry.rotation, &m_geometry.elevation}) {
    if (!event->rect().intersects(areaOf(*view))) continue;
    drawing.drawMoving(*view, view->kind == DialAxisKind::Rotation ? sway : 0);
    texts.draw(*view);
  }
}

}  // namespace deckpipe
