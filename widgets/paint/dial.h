// SPDX-License-Identifier: GPL-3.0-or-later
// The monitor at a glance: plan and side view with position, limits, stops and commands. A panel sets the
// values on the UI tick; the dial keeps no history and asks for nothing. It takes no input.
//
// A position comes many times a second: the face below the needles is kept as a picture, and what is drawn
// anew is the needles' surroundings and the texts of an axis that changed.
#pragma once

#include <QPixmap>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "paint/dial_geometry.h"
#include "paint/palette.h"

namespace deckpipe {

class Dial : public QWidget {
  Q_OBJECT

 public:
  explicit Dial(QWidget* parent = nullptr);

  void setValues(const DialValues& values);
  const DialValues& values() const { return m_values; }

  // An oscillating band moves by itself while it can be seen. Off: it rests at the phase given, for a cursor
  // that stands still and for people who want no motion.
  void setAnimated(bool animated);
  bool isAnimating() const { return m_timer.isActive(); }
  // 0..1, one sway to and fro.
  void setPhase(double phase);

  QSize sizeHint() const override { return {640, 360}; }
  // The smallest form that is read at arm's length.
  QSize minimumSizeHint() const override { return {200, 112}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  // All that the picture of the face depends on.
  struct Face {
    DialValues values;            // without what moves
    std::vector<double> numbers;  // that the needles leave free
    Theme theme = Theme::Light;
    QFont font;
    QSize size;
    double pixelRatio = 0;
    friend bool operator==(const Face&, const Face&) = default;
  };
  void drawFace(double pixelRatio);
  void updateTimer();
  void describe();

  DialValues m_values;
  DialGeometry m_geometry;  // of m_values
  Face m_face;
  QPixmap m_picture;  // of m_face
  QTimer m_timer;     // the band's motion
  QTimer m_describe;  // holds back the spoken text while values run
  double m_phase = 0;
  bool m_animated = true;
};

}  // namespace deckpipe
