// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/timeline.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "paint/app_style.h"
#include "paint/glyph.h"
#include "paint/spoken.h"

namespace deckpipe {
namespace {

constexpr double kMarkHeight = 9;
constexpr double kMinGap = 3;  // pixels
constexpr double kUnseen = 3;  // pixels that all may lag behind a log that grows
constexpr int kStripHeight = 26;
constexpr int kTickHeight = 4;
constexpr std::chrono::milliseconds kDescribe = 500ms, kDescribeLive = 10s;
constexpr double kFewestFrames = 10;  // in sight, of a log without times

double widthOfWords(const QFont& font, const QString& words) {
  return QFontMetricsF(font).horizontalAdvance(words) + 12;
}

}  // namespace

Timeline::Timeline(QWidget* parent) : QWidget(parent) {
  speakAs(*this, QAccessible::Slider);
  setObjectName(QStringLiteral("timeline"));
  setAccessibleName(tr("Position in the log"));
  m_describe.setSingleShot(true);
  connect(&m_describe, &QTimer::timeout, this, &Timeline::describe);
  describe();
  setWhatsThis(
      tr("The log from begin to end: how dense it is, where nothing came, marks, and the cursor. Space plays "
         "and pauses, "
         "Up and Down make it faster and slower. Left and Right move the cursor by a second, in a log "
         "without times by a "
         "frame, with Shift by ten, with Ctrl to the next mark; Home and End to either end. + and − or the "
         "wheel look "
         "closer, 0 shows all. [ and ] select from, or to, the cursor, as does a drag with Shift."));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  grabGesture(Qt::PinchGesture);
}

void Timeline::setValues(const TimelineValues& values) {
  if (values == m_values) return;
  const bool isSame = looksTheSame(values);
  const TimelineValues before = std::exchange(m_values, values);
  keepInSight(before);
  // Where the cursor goes with the bus, its time alone is no news.
  if (!m_describe.isActive() || before.atEnd != values.atEnd || before.isEmpty != values.isEmpty) {
    describe();
    m_describe.start(values.atEnd ? kDescribeLive : kDescribe);
  }
  if (isSame) return;
  m_drawnEnd = values.end;
  update();
}

void Timeline::describe() {
  const auto seconds = [this](Instant time) {
    return static_cast<double>((time - m_values.begin).count()) / 1e9;
  };
  sayValue(*this, {.most = seconds(m_values.end), .now = seconds(m_values.cursor), .words = spoken()},
           !m_values.atEnd);
}

// "at 12.3 s of 95.0 s, 14 marks"
QString Timeline::spoken() const {
  if (m_values.isEmpty) return tr("no frames");
  const auto place = [this](Instant time) {
    const Duration since = time - m_values.begin;
    const QLocale locale;
    if (m_values.unit == TimelineUnit::Frames)
      return locale.toString(static_cast<qlonglong>(since / kFrameOnScale));
    const auto whole = static_cast<qlonglong>(since.count() / 1'000'000'000);
    if (whole < 100) return tr("%1 s").arg(locale.toString(static_cast<double>(since.count()) / 1e9, 'f', 1));
    if (whole < 3'600) return tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
    return tr("%1 h %2 min %3 s").arg(whole / 3'600).arg(whole / 60 % 60).arg(whole % 60);
  };
  QStringList parts{(m_values.unit == TimelineUnit::Time ? tr("at %1 of %2") : tr("at frame %1 of %2"))
                        .arg(place(m_values.cursor), place(m_values.end))};
  if (m_values.atEnd) parts << tr("live edge");
  const auto marks =
      std::ranges::count_if(m_values.marks, [this](const TimelineMark& mark) { return isShown(mark); });
  parts << tr("%n marks", nullptr, static_cast<int>(marks));
  if (!m_values.selection.isEmpty()) parts << tr("selected: %1").arg(m_values.selection);
  if (!m_values.atCursor.isEmpty()) parts << m_values.atCursor;
  return parts.join(QStringLiteral(", "));
}

bool Timeline::looksTheSame(const TimelineValues& next) const {
  const auto stands = [](const TimelineValues& v) { return v.atEnd && v.cursor == v.end; };
  if (m_shown || next.isEmpty || !stands(next) || !stands(m_values)) return false;
  const double grown = static_cast<double>((next.end - m_drawnEnd).count());
  if (grown < 0 || grown * width() > kUnseen * static_cast<double>((next.end - next.begin).count()))
    return false;
  TimelineValues then = next;
  then.end = then.cursor = m_values.end;
  return then == m_values;
}

TimelineSpan Timeline::shown() const { return m_shown.value_or(whole()); }

void Timeline::showSpan(TimelineSpan span) {
  const TimelineSpan before = shown();
  m_shown = span == whole() ? std::nullopt : std::optional(span);
  if (shown() == before) return;
  update();
  Q_EMIT shownChanged();
}

// A cursor that was in sight stays in sight; another log is shown whole.
void Timeline::keepInSight(const TimelineValues& before) {
  if (m_values.begin != before.begin || m_values.isEmpty) {
    m_shown.reset();
    select({});
    return;
  }
  if (!m_shown || m_values.cursor == before.cursor || !m_shown->has(before.cursor)) return;
  if (m_values.cursor > m_shown->end) {
    const Instant begin = m_values.cursor - (m_shown->end - m_shown->begin);
    showSpan(spanWithin(m_values.atEnd ? TimelineSpan{begin, m_values.cursor}
                                       : spanMoved({begin, m_values.cursor}, whole(), 0.9),
                        whole()));
  } else if (m_values.cursor < m_shown->begin) {
    showSpan(spanWithin({m_values.cursor, m_values.cursor + (m_shown->end - m_shown->begin)}, whole()));
  }
}

void Timeline::select(std::optional<TimelineSpan> span) {
  if (span && span->end <= span->begin) span.reset();
  if (span == m_selection) return;
  m_selection = span;
  update();
  Q_EMIT selectionChanged();
}

TimelineGeometry Timeline::geometryNow() const {
  return {static_cast<double>(width()), shown().begin, shown().end};
}

void Timeline::zoom(Instant around, double factor) {
  const bool isOfFrames = m_values.unit == TimelineUnit::Frames;
  const double least = isOfFrames ? kFewestFrames * static_cast<double>(kFrameOnScale.count()) : kMinSpanNs;
  showSpan(spanZoomed(shown(), whole(), around, factor, least));
}

QSize Timeline::sizeHint() const {
  return {480, static_cast<int>(kMarkHeight) + 3 + kStripHeight + kTickHeight + fontMetrics().height()};
}

QRectF Timeline::strip() const {
  const double left = TimelineGeometry::kInset, top = kMarkHeight + 3;
  return {left, top, std::max(1.0, width() - 2 * left),
          std::max(1.0, height() - top - kTickHeight - fontMetrics().height())};
}

void Timeline::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const Colours& c = coloursOf(this);
  const QRectF strip = this->strip();
  p.setPen(QPen(c.outline, c.stroke));
  p.setBrush(c.surface);
  p.drawRect(strip.adjusted(-0.5, -0.5, 0.5, 0.5));
  if (m_values.isEmpty) {
    p.setPen(c.textSecondary);
    p.drawText(strip, Qt::AlignCenter, tr("No frames"));
  } else {
    const TimelineGeometry g = geometryNow();
    paintScale(p, c, g, strip);
    paintDensity(p, c, g, strip);
    paintGaps(p, c, g, strip);
    paintMarks(p, c, g, strip);
    paintSelection(p, c, g, strip);
    paintCursor(p, c, g, strip);
    paintBeyond(p, c, strip);
  }
  if (hasFocus()) drawFocusRing(p, c, rect());
}

// What has happened is filled, what lies after the cursor only outlined.
void Timeline::paintDensity(QPainter& p, const Colours& c, const TimelineGeometry& g,
                            const QRectF& strip) const {
  const double cursor = g.xOf(m_values.cursor);
  if (cursor < strip.right() && m_values.cursor < shown().end) {
    QBrush after(c.stale.fill, Qt::SolidPattern);
    p.fillRect(QRectF(QPointF(cursor, strip.top()), strip.bottomRight()), after);
  }
  if (m_values.density.empty()) return;
  p.save();
  p.setRenderHint(QPainter::Antialiasing, false);
  QPainterPath outline;
  const double bin = strip.width() / static_cast<double>(m_values.density.size());
  for (std::size_t i = 0; i < m_values.density.size(); ++i) {
    const double share = static_cast<double>(m_values.density[i]);
    // Few frames among many are still seen.
    const double height = share <= 0 ? 0 : std::max(2.0, share * (strip.height() - 2));
    const double x = strip.left() + static_cast<double>(i) * bin;
    // Rectangles side by side are drawn many times faster than one path.
    const double top = strip.bottom() - height;
    if (x < cursor)
      p.fillRect(QRectF(QPointF(x, top), QPointF(std::min(x + bin, cursor), strip.bottom())), c.travel);
    if (x + bin <= cursor + 0.5) continue;
    if (outline.isEmpty()) outline.moveTo(std::max(x, cursor), strip.bottom());
    outline.lineTo(std::max(x, cursor), top);
    outline.lineTo(x + bin, top);
  }
  if (!outline.isEmpty()) {
    outline.lineTo(strip.bottomRight());
    p.setPen(QPen(c.textSecondary, 1));
    p.setBrush(Qt::NoBrush);
    p.drawPath(outline);
  }
  p.restore();
}

void Timeline::hide(EventGroup group, bool isHidden) {
  if (isHidden) {
    m_hidden.add(group);
  } else {
    m_hidden.remove(group);
  }
  update();
}

// Above the strip, a jump of the clock as a broken line through it. Where marks of one group meet, the
// gravest is seen; graver ones cover others.
void Timeline::paintMarks(QPainter& p, const Colours& c, const TimelineGeometry& g,
                          const QRectF& strip) const {
  const TimelineSpan inSight = shown();
  constexpr double kTop = 2;
  for (const Severity weight : kEventWeights) {
    EnumArray<EventGroup, double> lastX;
    for (double& x : lastX) x = -1e9;
    for (const TimelineMark& mark : m_values.marks) {
      if (mark.weight != weight || !isShown(mark) || !inSight.has(mark.time)) continue;
      const double x = std::round(g.xOf(mark.time));
      if (mark.kind == TimelineMark::Kind::TimeJump) {
        QPen broken(c.warning.ink, 1.5 * c.stroke, Qt::SolidLine, Qt::FlatCap);
        broken.setDashPattern({2, 2});
        p.setPen(broken);
        p.drawLine(QPointF(x, kTop), QPointF(x, strip.bottom()));
        continue;
      }
      if (x - lastX[mark.group] < 2) continue;
      lastX[mark.group] = x;
      const QColor ink =
          mark.group == EventGroup::Note && weight == Severity::Plain ? c.text : eventInk(weight, c);
      p.setPen(QPen(ink, c.stroke));
      p.drawLine(QPointF(x, kTop + kMarkHeight - 1), QPointF(x, strip.top() + 4));
      drawEventMark(p, QRectF(x - kMarkHeight / 2, kTop, kMarkHeight, kMarkHeight), mark.group, ink);
    }
  }
}

// Hatched, each kind its own way: nothing came, or nothing could come.
void Timeline::paintGaps(QPainter& p, const Colours& c, const TimelineGeometry& g,
                         const QRectF& strip) const {
  for (const TimelineGap& gap : m_values.gaps) {
    const double from = g.xOf(gap.span.begin), to = g.xOf(gap.span.end);
    if (to - from < kMinGap) continue;
    const bool isLost = gap.kind == TimelineGap::Kind::LinkLost;
    const QRectF area(from, strip.top() + 1, to - from, strip.height() - 2);
    p.fillRect(area,
               QBrush(isLost ? c.warning.ink : c.outline, isLost ? Qt::DiagCrossPattern : Qt::BDiagPattern));
  }
}

void Timeline::paintSelection(QPainter& p, const Colours& c, const TimelineGeometry& g,
                              const QRectF& strip) const {
  if (!m_selection) return;
  const QRectF area(QPointF(g.xOf(m_selection->begin), 1), QPointF(g.xOf(m_selection->end), strip.bottom()));
  QColor veil = c.accent.fill;
  veil.setAlphaF(0.25F);
  p.fillRect(area, veil);
  p.setPen(QPen(c.accent.ink, 2 * c.stroke, Qt::SolidLine, Qt::FlatCap));
  for (const double x : {area.left(), area.right()}) p.drawLine(QPointF(x, 1), QPointF(x, strip.bottom()));
  p.drawLine(area.topLeft() + QPointF(0, 1), area.topRight() + QPointF(0, 1));
  if (!m_values.atCursor.isEmpty()) return;  // it would be covered
  // Inside where there is room, otherwise beside it.
  const double width = widthOfWords(font(), m_values.selection);
  double left = area.center().x() - width / 2;
  if (area.width() < width + 4)
    left = area.right() + width + 4 < strip.right() ? area.right() + 4 : area.left() - width - 4;
  paintWords(p, c, strip, left, m_values.selection);
}

// On a ground of their own, within the strip.
void Timeline::paintWords(QPainter& p, const Colours& c, const QRectF& strip, double left,
                          const QString& words) const {
  if (words.isEmpty()) return;
  const double width = widthOfWords(font(), words);
  const double height = QFontMetricsF(font()).height() + 2;
  const QRectF box(std::clamp(left, strip.left(), std::max(strip.left(), strip.right() - width)),
                   strip.center().y() - height / 2, width, height);
  p.setPen(QPen(c.accent.ink, 1));
  p.setBrush(c.surface);
  p.drawRect(box);
  p.setPen(c.text);
  p.drawText(box, Qt::AlignCenter, words);
}

void Timeline::paintScale(QPainter& p, const Colours& c, const TimelineGeometry& g,
                          const QRectF& strip) const {
  const QFontMetricsF metrics(font());
  const double top = strip.bottom() + 1;
  p.setPen(QPen(c.textSecondary, c.stroke, Qt::SolidLine, Qt::FlatCap));
  const auto ticks =
      timelineTicks(g, m_values.unit == TimelineUnit::Time ? m_values.begin : Instant{}, m_values.unit,
                    [&metrics](const QString& text) { return metrics.horizontalAdvance(text); });
  for (const TimelineTick& tick : ticks) {
    const double x = std::round(tick.x) + 0.5;
    p.drawLine(QPointF(x, top), QPointF(x, top + (tick.text.isEmpty() ? kTickHeight - 2 : kTickHeight)));
    if (!tick.text.isEmpty())
      p.drawText(QPointF(tick.left, top + kTickHeight - 1 + metrics.ascent()), tick.text);
  }
}

// While only a part is in sight: an arrow where the log goes on, filled where the cursor is that way.
void Timeline::paintBeyond(QPainter& p, const Colours& c, const QRectF& strip) const {
  const TimelineSpan inSight = shown();
  const auto draw = [&](double x, double tip, bool isCursor) {
    const double y = strip.center().y();
    p.setPen(
        QPen(isCursor ? c.accent.ink : c.text, 1.5 * c.stroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.setBrush(isCursor ? QBrush(c.accent.fill) : QBrush(Qt::NoBrush));
    const QPolygonF arrow{{x, y - 6}, {x + tip, y}, {x, y + 6}};
    if (isCursor) {
      p.drawPolygon(arrow);
    } else {
      p.drawPolyline(arrow);
    }
  };
  if (inSight.begin > m_values.begin) draw(strip.left() - 3, -5, m_values.cursor < inSight.begin);
  if (inSight.end < m_values.end) draw(strip.right() + 3, 5, m_values.cursor > inSight.end);
}

void Timeline::paintCursor(QPainter& p, const Colours& c, const TimelineGeometry& g,
                           const QRectF& strip) const {
  // The live edge: where the log ends for now.
  if (shown().end >= m_values.end) {
    p.setPen(QPen(m_values.atEnd ? c.accent.ink : c.outline, 3 * c.stroke, Qt::SolidLine, Qt::FlatCap));
    p.drawLine(QPointF(strip.right(), strip.top() - 3), QPointF(strip.right(), strip.bottom() + 3));
  }
  if (m_shown && !m_shown->has(m_values.cursor)) return;
  const double x = g.xOf(m_values.cursor);
  p.setPen(QPen(c.accent.ink, 2 * c.stroke, Qt::SolidLine, Qt::FlatCap));
  p.drawLine(QPointF(x, strip.top() - 3), QPointF(x, strip.bottom() + 3));
  p.setPen(QPen(c.surface, 1));
  p.setBrush(c.accent.fill);
  const double y = strip.bottom() + 3.5;
  p.drawPolygon(QPolygonF{{x, y - 9}, {x + 7, y}, {x - 7, y}});
  const double words = widthOfWords(font(), m_values.atCursor);
  paintWords(p, c, strip, x + 8 + words < strip.right() ? x + 8 : x - 8 - words, m_values.atCursor);
}

}  // namespace deckpipe
