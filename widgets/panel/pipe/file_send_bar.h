// SPDX-License-Identifier: GPL-3.0-or-later
// How the sending of a file through a data pipe goes: progress, rate, time left, and how long the acks take;
// pause and cancel. Part of the terminal; hidden while no file was ever sent to the device.
#pragma once

#include <QWidget>

#include "base/time.h"
#include "control/status.h"

class QProgressBar;
class QPushButton;

namespace deckpipe {

class ElidedLabel;

class FileSendBar : public QWidget {
  Q_OBJECT

 public:
  explicit FileSendBar(QWidget* parent = nullptr);

  // Off the live edge it can be paused and cancelled, but does not go on.
  void setStatus(const PipeStatus& pipe, Instant now, bool isLive);

 Q_SIGNALS:
  void pauseRequested(bool pause);
  void cancelRequested();

 private:
  ElidedLabel* m_name;
  QProgressBar* m_progress;
  ElidedLabel* m_figures;
  QPushButton* m_pause;
  QPushButton* m_cancel;
  bool m_isPaused = false;
};

// "312 B/s", "1.8 kB/s"; empty before the first character.
QString rateText(const PipeStatus& pipe, Instant now);
// "about 40 s left"; empty where there is nothing to reckon with.
QString timeLeftText(const PipeStatus& pipe, Instant now);

}  // namespace deckpipe
