// SPDX-License-Identifier: GPL-3.0-or-later
// The time span of a log as a strip: how dense it is, where its clock jumped, what was noted, where the
// cursor stands, and the live edge. The transport bar fills in the values; the person points at an instant.
//
// Left and Right step by a second (with Shift by ten), Home goes to the begin, End to the live edge.
#pragma once

#include <QWidget>
#include <cstdint>
#include <vector>

#include "base/time.h"
#include "paint/palette.h"
#include "paint/timeline_geometry.h"

namespace deckpipe {

struct TimelineMark {
  enum class Kind : std::uint8_t { TimeJump, Note, Attend };
  Kind kind = Kind::Note;
  Instant time;
  QString text{};
  friend bool operator==(const TimelineMark&, const TimelineMark&) = default;
};

struct TimelineValues {
  Instant begin, end, cursor;
  bool isEmpty = true;           // no log, or none with a frame
  bool atEnd = true;             // the cursor goes with the live edge
  std::vector<float> density{};  // 0..1, of equal parts of the span
  std::vector<TimelineMark> marks{};
  friend bool operator==(const TimelineValues&, const TimelineValues&) = default;
};

class Timeline : public QWidget {
  Q_OBJECT

 public:
  explicit Timeline(QWidget* parent = nullptr);

  void setValues(const TimelineValues& values);
  const TimelineValues& values() const { return m_values; }
  void setColours(const Colours& colours);
  TimelineGeometry geometryNow() const;

  QSize sizeHint() const override { return {480, 48}; }
  QSize minimumSizeHint() const override { return {160, 40}; }

 Q_SIGNALS:
  void seekRequested(deckpipe::Instant time);
  void endRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void seekTo(Instant time);
  void paintDensity(QPainter& p, const TimelineGeometry& g, const QRectF& strip) const;
  void paintMarks(QPainter& p, const TimelineGeometry& g, const QRectF& strip) const;
  void paintCursor(QPainter& p, const TimelineGeometry& g, const QRectF& strip) const;
  QRectF strip() const;

  TimelineValues m_values;
  Colours m_colours;
};

}  // namespace deckpipe
