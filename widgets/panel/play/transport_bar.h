// SPDX-License-Identifier: GPL-3.0-or-later
// The bar at the foot of the window that moves the cursor through the log: play and pause, step by a frame, the
// clock, which takes a typed time, the timeline, a loop, silences, speed, and the way to the live edge or the end. The
// console feeds it on each tick and acts on what it asks for; it is the same for a bus and for a file. While the
// timeline has the focus Space plays and pauses, Up and Down change the speed, comma and full stop step. With a filter
// in the trace, steps are its rows; with Shift they are frames.
//
// Where it is narrow, the buttons of loop and silences go first: the console's menu has them, too.
#pragma once

#include <QWidget>

#include "panel/play/log_marks.h"
#include "state/log_view.h"

class QComboBox;

namespace deckpipe {

class TimeField;
class TimeReadout;
class Timeline;
class TransportButton;

// How the cursor moves by itself.
struct PlayState {
  bool isPlaying = false;
  double speed = 1;     // times real time; infinite: as fast as it goes
  bool isLive = false;  // the log's end is the live edge of a link
  bool isLooping = false;
  bool skipsSilences = false;
  Duration skipped{0};  // a silence of this length has just been skipped
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

  void playOrPause();
  // By one of the speeds that the bar offers.
  void changeSpeed(int by);
  // Opens the field in which a time is typed.
  void typeTime();
  // Whether there is a selection to be played again and again, or one is.
  bool canLoop() const;
  void toggleLoop();
  const PlayState& playState() const { return m_playState; }

 Q_SIGNALS:
  void playRequested();
  void pauseRequested();
  void seekRequested(deckpipe::Instant time);
  void framesRequested(std::uint64_t frames);  // behind so many
  void stepRequested(int frames);              // -1 or 1
  void rowStepRequested(int rows);             // of the trace, -1 or 1
  // Only frames of a span are of interest: an expression of the trace's filter.
  void spanRequested(const QString& expression);
  // The frames of a span are wanted in a file.
  void saveRequested(std::uint64_t begin, std::uint64_t end);
  void endRequested();
  void speedRequested(double speed);
  void loopRequested(std::optional<deckpipe::TimelineSpan> span);
  void silencesRequested(bool areSkipped);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void seekOnScale(Instant at);
  void selectionChanged();
  void step(int by, bool isByFrame);
  void showMenu(const QPoint& at);
  QString selectionText() const;
  void showTimeline();
  void showControls();
  void showEnd();
  void fit();

  LogView m_view;
  PlayState m_playState;
  LogMarks m_marks;
  bool m_isFiltered = false;
  TransportButton* m_back;
  TransportButton* m_play;
  TransportButton* m_forward;
  TimeReadout* m_readout;
  TimeField* m_field;
  Timeline* m_timeline;
  TransportButton* m_loop;
  TransportButton* m_silences;
  QComboBox* m_speed;
  TransportButton* m_end;
};

}  // namespace deckpipe
