// SPDX-License-Identifier: GPL-3.0-or-later
// What a person does to the timeline: mouse, wheel, fingers, keys, tooltips.
#include <QGestureEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPinchGesture>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "paint/plain_tip.h"
#include "paint/timeline.h"

namespace deckpipe {
namespace {

constexpr Duration kKeyStep = 1s;
constexpr Duration kLargeStep = 10s;
constexpr double kZoomStep = 1.3;  // a notch of the wheel
constexpr double kNear = 5;        // pixels within which a mark is pointed at

}  // namespace

void Timeline::seekTo(Instant time) {
  if (!m_values.isEmpty)
    Q_EMIT seekRequested(std::clamp(time, m_values.begin, std::max(m_values.begin, m_values.end)));
}

void Timeline::selectTo(Instant time) {
  select(TimelineSpan{std::min(*m_selectingFrom, time), std::max(*m_selectingFrom, time)});
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || m_values.isEmpty) return;
  const Instant time = geometryNow().timeAt(event->position().x());
  if (event->position().y() < strip().top() || (event->modifiers() & Qt::ShiftModifier)) {
    m_selectingFrom = time;
    m_hasDragged = false;
  } else if (event->source() != Qt::MouseEventSynthesizedByQt) {
    seekTo(time);  // a finger may be the first of two
  }
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton) || m_isPinching) return;
  const Instant time = geometryNow().timeAt(event->position().x());
  if (m_selectingFrom) {
    m_hasDragged = true;
    selectTo(time);
  } else {
    seekTo(time);
  }
}

void Timeline::mouseReleaseEvent(QMouseEvent* event) {
  const bool isTap = event->source() == Qt::MouseEventSynthesizedByQt && !m_isPinching;
  if (isTap && !m_selectingFrom) seekTo(geometryNow().timeAt(event->position().x()));
  if (m_selectingFrom && !m_hasDragged) select({});
  m_selectingFrom.reset();
  m_isPinching = false;
}

void Timeline::wheelEvent(QWheelEvent* event) {
  const QPoint angle = event->angleDelta();
  const bool isSideways = angle.x() != 0 || (event->modifiers() & Qt::ShiftModifier);
  const double notches = (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
  if (isSideways) {
    showSpan(spanMoved(shown(), whole(), -notches * 0.1));
  } else {
    zoom(geometryNow().timeAt(event->position().x()), std::pow(kZoomStep, notches));
  }
  event->accept();
}

void Timeline::goToMark(bool isBack) {
  const auto& marks = m_values.marks;  // by time
  if (isBack) {
    const auto at = std::find_if(marks.rbegin(), marks.rend(), [this](const TimelineMark& mark) {
      return isShown(mark) && mark.time < m_values.cursor;
    });
    if (at != marks.rend()) seekTo(at->time);
  } else {
    const auto at = std::find_if(marks.begin(), marks.end(), [this](const TimelineMark& mark) {
      return isShown(mark) && mark.time > m_values.cursor;
    });
    if (at != marks.end()) seekTo(at->time);
  }
}

void Timeline::keyPressEvent(QKeyEvent* event) {
  const Duration step = event->modifiers() & Qt::ShiftModifier ? kLargeStep : kKeyStep;
  const bool isToMark = (event->modifiers() & Qt::ControlModifier) != 0;
  // The cursor may stand before all frames; stamps of hostile logs leave no room for sums.
  const Instant begin = m_values.begin, end = m_values.end;
  const Instant now = std::clamp(m_values.cursor, begin, std::max(begin, end));
  switch (event->key()) {
    case Qt::Key_Left:
      if (isToMark) {
        goToMark(true);
      } else {
        seekTo(begin + std::max(now - begin - step, Duration(0)));
      }
      break;
    case Qt::Key_Right:
      if (isToMark) {
        goToMark(false);
      } else {
        seekTo(now + std::min(end - now, step));
      }
      break;
    case Qt::Key_Home: seekTo(m_values.begin); break;
    case Qt::Key_End:
      if (!m_values.isEmpty) Q_EMIT endRequested();
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoom(now, 2); break;
    case Qt::Key_Minus: zoom(now, 0.5); break;
    case Qt::Key_0: fit(); break;
    case Qt::Key_BracketLeft: select(TimelineSpan{now, m_selection ? m_selection->end : end}); break;
    case Qt::Key_BracketRight: select(TimelineSpan{m_selection ? m_selection->begin : begin, now}); break;
    case Qt::Key_Delete:
    case Qt::Key_Escape:
      if (!m_selection) {
        QWidget::keyPressEvent(event);
        break;
      }
      select({});
      break;
    default: QWidget::keyPressEvent(event);
  }
}

// Two fingers on a touchpad, or on the screen itself.
bool Timeline::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture) {
    const auto* gesture = static_cast<QNativeGestureEvent*>(event);
    if (gesture->gestureType() == Qt::ZoomNativeGesture) {
      zoom(geometryNow().timeAt(gesture->position().x()), std::max(0.1, 1 + gesture->value()));
      return true;
    }
  }
  if (event->type() == QEvent::Gesture) {
    const auto* gestures = static_cast<QGestureEvent*>(event);
    if (const auto* pinch = static_cast<QPinchGesture*>(gestures->gesture(Qt::PinchGesture))) {
      m_isPinching = true;  // until both fingers are gone
      const double x = mapFromGlobal(pinch->centerPoint()).x();
      zoom(geometryNow().timeAt(x), std::clamp(pinch->scaleFactor(), 0.1, 10.0));
      return true;
    }
  }
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  showToolTip(help->pos(), help->globalPos());
  return true;
}

void Timeline::showToolTip(const QPoint& at, const QPoint& global) {
  const TimelineGeometry g = geometryNow();
  QStringList lines;
  for (const TimelineMark& mark : m_values.marks) {
    if (isShown(mark) && shown().has(mark.time) && std::abs(g.xOf(mark.time) - at.x()) <= kNear &&
        lines.size() < 8)
      lines += mark.text;
  }
  lines.removeDuplicates();
  const Instant time = g.timeAt(at.x());
  for (const TimelineGap& gap : m_values.gaps) {
    if (!gap.span.has(time)) continue;
    const auto seconds =
        static_cast<double>((std::min(gap.span.end, m_values.end) - gap.span.begin).count()) / 1e9;
    const QString length = QLocale().toString(seconds, 'f', seconds < 100 ? 1 : 0);
    lines += gap.kind == TimelineGap::Kind::Silence ? tr("No frames for %1 s").arg(length)
                                                    : tr("Link lost for %1 s").arg(length);
  }
  if (m_selection && m_selection->has(time) && !m_values.selection.isEmpty())
    lines += tr("Selected: %1").arg(m_values.selection);
  if (lines.isEmpty()) {
    QToolTip::hideText();
  } else {
    QToolTip::showText(global, plainTip(lines.join(QLatin1Char('\n'))), this);
  }
}

}  // namespace deckpipe
