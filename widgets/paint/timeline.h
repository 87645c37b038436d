// SPDX-License-Identifier: GPL-3.0-or-later
// The time span of a log as a strip with a scale: how dense it is, where nothing came, where its clock jumped, what was
// noted, where the cursor stands, and the live edge. The transport bar fills in the values; the person points
// at an instant, looks closer, and selects a span.
//
//   Left, Right    by a second, with Shift by ten      Ctrl+Left, Ctrl+Right   to the mark before, behind
//   Home, End      to the begin, to the live edge      + − 0, wheel, pinch     closer, wider, all
//   [ ]            selection from, to the cursor       Delete, Escape          no selection
//   A drag in the strip moves the cursor; in the lane of the marks above it, or with Shift, it selects. The
//   wheel with Shift moves the part in sight.
#pragma once

#include <QTimer>
#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/event_kind.h"
#include "base/time.h"
#include "paint/palette.h"
#include "paint/timeline_geometry.h"
#include "paint/timeline_scale.h"

namespace deckpipe {

struct TimelineMark {
  enum class Kind : std::uint8_t {
    TimeJump,  // a line through the strip
    Event,     // the mark of its group (paint/glyph.h)
  };
  Kind kind = Kind::Event;
  Instant time;
  QString text{};
  EventGroup group = EventGroup::Note;
  Severity weight = Severity::Plain;
  friend bool operator==(const TimelineMark&, const TimelineMark&) = default;
};

struct TimelineGap {
  enum class Kind : std::uint8_t { Silence, LinkLost };
  Kind kind = Kind::Silence;
  TimelineSpan span;
  friend bool operator==(const TimelineGap&, const TimelineGap&) = default;
};

struct TimelineValues {
  Instant begin, end, cursor;    // of the log
  bool isEmpty = true;           // no log, or none with a frame
  bool atEnd = true;             // the cursor goes with the live edge
  std::vector<float> density{};  // 0..1, of equal parts of the span in sight
  std::vector<TimelineMark> marks{};
  std::vector<TimelineGap> gaps{};
  QString selection{};  // what is to be said of the span that is selected
  QString atCursor{};   // what is to be said beside the cursor
  TimelineUnit unit = TimelineUnit::Time;
  friend bool operator==(const TimelineValues&, const TimelineValues&) = default;
};

class Timeline : public QWidget {
  Q_OBJECT

 public:
  explicit Timeline(QWidget* parent = nullptr);

  void setValues(const TimelineValues& values);
  const TimelineValues& values() const { return m_values; }
  TimelineGeometry geometryNow() const;
  // The part of the log that is in sight.
  TimelineSpan shown() const;
  bool isZoomed() const { return m_shown.has_value(); }
  void showSpan(TimelineSpan span);
  void fit() { showSpan(whole()); }
  std::optional<TimelineSpan> selection() const { return m_selection; }
  void select(std::optional<TimelineSpan> span);
  // Groups whose marks are left out.
  const EnumSet<EventGroup>& hidden() const { return m_hidden; }
  void hide(EventGroup group, bool isHidden);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {160, sizeHint().height()}; }

 Q_SIGNALS:
  void seekRequested(deckpipe::Instant time);
  void endRequested();
  void shownChanged();
  void selectionChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void seekTo(Instant time);
  void describe();
  QString spoken() const;
  void paintDensity(QPainter& p, const Colours& c, const TimelineGeometry& g, const QRectF& strip) const;
  void paintMarks(QPainter& p, const Colours& c, const TimelineGeometry& g, const QRectF& strip) const;
  void paintGaps(QPainter& p, const Colours& c, const TimelineGeometry& g, const QRectF& strip) const;
  void paintSelection(QPainter& p, const Colours& c, const TimelineGeometry& g, const QRectF& strip) const;
  void paintCursor(QPainter& p, const Colours& c, const TimelineGeometry& g, const QRectF& strip) const;
  void paintBeyond(QPainter& p, const Colours& c, const QRectF& strip) const;
  void paintScale(QPainter& p, const Colours& c, const TimelineGeometry& g, const QRectF& strip) const;
  void paintWords(QPainter& p, const Colours& c, const QRectF& strip, double left,
                  const QString& words) const;
  QRectF strip() const;

  // A log that only grew by less than can be seen: all else moves to the left.
  bool looksTheSame(const TimelineValues& next) const;
  TimelineSpan whole() const { return {m_values.begin, m_values.end}; }
  void keepInSight(const TimelineValues& before);
  void zoom(Instant around, double factor);
  void goToMark(bool isBack);
  bool isShown(const TimelineMark& mark) const {
    return mark.kind == TimelineMark::Kind::TimeJump || !m_hidden.has(mark.group);
  }
  void selectTo(Instant time);
  void showToolTip(const QPoint& at, const QPoint& global);

  TimelineValues m_values;
  QTimer m_describe;                    // holds back what is spoken while values run
  Instant m_drawnEnd;                   // of the values that were drawn last
  std::optional<TimelineSpan> m_shown;  // nothing: the whole log
  std::optional<TimelineSpan> m_selection;
  std::optional<Instant> m_selectingFrom;  // while a span is dragged
  bool m_hasDragged = false;               // since then
  bool m_isPinching = false;
  EnumSet<EventGroup> m_hidden;
};

}  // namespace deckpipe
