// SPDX-License-Identifier: GPL-3.0-or-later
// The bar at the foot of the window that moves the cursor through the log: play and pause, step by a frame,
// the timeline, speed, and the way to the live edge. The console feeds it on each tick and acts on what it
// asks for; it is the same for a bus and for a file. Space plays and pauses while the timeline has the focus,
// comma and full stop step. With a filter in the trace, steps are its rows; with Shift they are frames.
#pragma once

#include <QWidget>

#include "panel/play/log_marks.h"
#include "state/log_view.h"

class QComboBox;

namespace deckpipe {

class TimeReadout;
class Timeline;
class TransportButton;

// How the cursor moves by itself.
struct PlayState {
  bool isPlaying = false;
  double speed = 1;
  friend bool operator==(const PlayState&, const PlayState&) = default;
};

class TransportBar : public QWidget {
  Q_OBJECT

 public:
  explicit TransportBar(QWidget* parent = nullptr);

  void setView(const LogView& view, const PlayState& play);
  void setLabels(const DeviceLabels& labels);
  // Whether the trace shows only some of the frames.
  void setFiltered(bool isFiltered);

 Q_SIGNALS:
  void playRequested();
  void pauseRequested();
  void seekRequested(deckpipe::Instant time);
  void stepRequested(int frames);   // -1 or 1
  void rowStepRequested(int rows);  // of the trace, -1 or 1
  // Only frames of a span are of interest: an expression of the trace's filter.
  void spanRequested(const QString& expression);
  // The frames of a span are wanted in a file.
  void saveRequested(std::uint64_t begin, std::uint64_t end);
  void endRequested();
  void speedRequested(double speed);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void playOrPause();
  void step(int by, bool isByFrame);
  void showMenu(const QPoint& at);
  QString selectionText() const;
  void showTimeline();
  void showControls();

  LogView m_view;
  PlayState m_playState;
  LogMarks m_marks;
  bool m_isFiltered = false;
  TransportButton* m_back;
  TransportButton* m_play;
  TransportButton* m_forward;
  TimeReadout* m_readout;
  Timeline* m_timeline;
  QComboBox* m_speed;
  TransportButton* m_end;
};

}  // namespace deckpipe
