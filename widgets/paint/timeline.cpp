// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/timeline.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>

#include "paint/plain_tip.h"

namespace deckpipe {
namespace {

constexpr Duration kStep = 1s;
constexpr Duration kLargeStep = 10s;
constexpr double kMarkHeight = 9;
constexpr double kNear = 5;  // pixels within which a mark is pointed at

}  // namespace

Timeline::Timeline(QWidget* parent) : QWidget(parent), m_colours(coloursOf(Theme::Light)) {
  setObjectName(QStringLiteral("timeline"));
  setAccessibleName(tr("Position in the log"));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void Timeline::setValues(const TimelineValues& values) {
  if (values == m_values) return;
  m_values = values;
  update();
}

void Timeline::setColours(const Colours& colours) {
  m_colours = colours;
  update();
}

TimelineGeometry Timeline::geometryNow() const {
  return {static_cast<double>(width()), m_values.begin, m_values.end};
}

QRectF Timeline::strip() const {
  const double left = TimelineGeometry::kInset;
  return {left, kMarkHeight + 3, std::max(1.0, width() - 2 * left), height() - kMarkHeight - 7};
}

void Timeline::seekTo(Instant time) {
  if (!m_values.isEmpty) Q_EMIT seekRequested(geometryNow().clamped(time));
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) seekTo(geometryNow().timeAt(event->position().x()));
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) seekTo(geometryNow().timeAt(event->position().x()));
}

void Timeline::keyPressEvent(QKeyEvent* event) {
  const Duration step = event->modifiers() & Qt::ShiftModifier ? kLargeStep : kStep;
  // The cursor may stand before all frames; stamps of hostile logs leave no room for sums.
  const Instant begin = m_values.begin, end = m_values.end;
  const Instant now = geometryNow().clamped(m_values.cursor);
  switch (event->key()) {
    case Qt::Key_Left: seekTo(begin + std::max(now - begin - step, Duration(0))); break;
    case Qt::Key_Right: seekTo(now + std::min(end - now, step)); break;
    case Qt::Key_Home: seekTo(m_values.begin); break;
    case Qt::Key_End:
      if (!m_values.isEmpty) Q_EMIT endRequested();
      break;
    default: QWidget::keyPressEvent(event);
  }
}

bool Timeline::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const TimelineGeometry g = geometryNow();
  QStringList lines;
  for (const TimelineMark& mark : m_values.marks) {
    if (std::abs(g.xOf(mark.time) - help->pos().x()) <= kNear && lines.size() < 8) lines += mark.text;
  }
  lines.removeDuplicates();
  if (lines.isEmpty()) {
    QToolTip::hideText();
  } else {
    QToolTip::showText(help->globalPos(), plainTip(lines.join(QLatin1Char('\n'))), this);
  }
  return true;
}

void Timeline::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const Colours& c = m_colours;
  const QRectF strip = this->strip();
  p.setPen(QPen(c.outline, c.stroke));
  p.setBrush(c.surface);
  p.drawRect(strip.adjusted(-0.5, -0.5, 0.5, 0.5));
  if (m_values.isEmpty) {
    p.setPen(c.textSecondary);
    p.drawText(strip, Qt::AlignCenter, tr("No frames"));
  } else {
    const TimelineGeometry g = geometryNow();
    paintDensity(p, g, strip);
    paintMarks(p, g, strip);
    paintCursor(p, g, strip);
  }
  if (hasFocus()) {
    p.setRenderHint(QPainter::Antialiasing, false);
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(c.accent.ink, 2));
    p.drawRect(rect().adjusted(1, 1, -1, -1));
  }
}

// What has happened is filled, what lies after the cursor only outlined.
void Timeline::paintDensity(QPainter& p, const TimelineGeometry& g, const QRectF& strip) const {
  const Colours& c = m_colours;
  const double cursor = g.xOf(m_values.cursor);
  if (cursor < strip.right()) {
    QBrush after(c.stale.fill, Qt::SolidPattern);
    p.fillRect(QRectF(QPointF(cursor, strip.top()), strip.bottomRight()), after);
  }
  if (m_values.density.empty()) return;
  QPainterPath shape;
  const double bin = strip.width() / static_cast<double>(m_values.density.size());
  shape.moveTo(strip.bottomLeft());
  for (std::size_t i = 0; i < m_values.density.size(); ++i) {
    const double share = static_cast<double>(m_values.density[i]);
    // Few frames among many are still seen.
    const double height = share <= 0 ? 0 : std::max(2.0, share * (strip.height() - 2));
    const double x = strip.left() + static_cast<double>(i) * bin;
    shape.lineTo(x, strip.bottom() - height);
    shape.lineTo(x + bin, strip.bottom() - height);
  }
  shape.lineTo(strip.bottomRight());
  shape.closeSubpath();
  p.save();
  p.setRenderHint(QPainter::Antialiasing, false);
  p.setClipRect(QRectF(strip.topLeft(), QPointF(cursor, strip.bottom())));
  p.fillPath(shape, c.travel);
  p.setClipRect(QRectF(QPointF(cursor, strip.top()), strip.bottomRight()));
  p.setPen(QPen(c.textSecondary, 1));
  p.setBrush(Qt::NoBrush);
  p.drawPath(shape);
  p.restore();
}

// Above the strip, each kind with a shape of its own: a jump is a broken line, a note a flag, what needs a
// look a triangle.
void Timeline::paintMarks(QPainter& p, const TimelineGeometry& g, const QRectF& strip) const {
  const Colours& c = m_colours;
  double lastX = -1e9;
  TimelineMark::Kind lastKind{};
  for (const TimelineMark& mark : m_values.marks) {
    const double x = std::round(g.xOf(mark.time));
    if (x == lastX && mark.kind == lastKind) continue;
    lastX = x;
    lastKind = mark.kind;
    const double top = 2, foot = top + kMarkHeight - 1;
    switch (mark.kind) {
      case TimelineMark::Kind::TimeJump: {
        QPen broken(c.attend.ink, 1.5 * c.stroke, Qt::SolidLine, Qt::FlatCap);
        broken.setDashPattern({2, 2});
        p.setPen(broken);
        p.drawLine(QPointF(x, top), QPointF(x, strip.bottom()));
        break;
      }
      case TimelineMark::Kind::Note:
        p.setPen(QPen(c.text, 1.5 * c.stroke));
        p.setBrush(c.text);
        p.drawLine(QPointF(x, top), QPointF(x, strip.top() + 4));
        p.drawPolygon(QPolygonF{{x, top}, {x + 7, top + 3}, {x, top + 6}});
        break;
      case TimelineMark::Kind::Attend:
        p.setPen(QPen(c.attend.ink, c.stroke));
        p.setBrush(c.attend.fill);
        p.drawPolygon(QPolygonF{{x, top}, {x + 5, foot}, {x - 5, foot}});
        p.drawLine(QPointF(x, foot), QPointF(x, strip.top() + 4));
        break;
    }
  }
}

void Timeline::paintCursor(QPainter& p, const TimelineGeometry& g, const QRectF& strip) const {
  const Colours& c = m_colours;
  // The live edge: where the log ends for now.
  p.setPen(QPen(m_values.atEnd ? c.accent.ink : c.outline, 3 * c.stroke, Qt::SolidLine, Qt::FlatCap));
  p.drawLine(QPointF(strip.right(), strip.top() - 3), QPointF(strip.right(), strip.bottom() + 3));
  const double x = g.xOf(m_values.cursor);
  p.setPen(QPen(c.accent.ink, 2 * c.stroke, Qt::SolidLine, Qt::FlatCap));
  p.drawLine(QPointF(x, strip.top() - 3), QPointF(x, strip.bottom() + 3));
  p.setPen(QPen(c.surface, 1));
  p.setBrush(c.accent.fill);
  const double y = strip.bottom() + 3.5;
  p.drawPolygon(QPolygonF{{x, y - 9}, {x + 7, y}, {x - 7, y}});
}

}  // namespace deckpipe
