// SPDX-License-Identifier: GPL-3.0-or-later
// How the sending of a file through a data pipe goes: progress, rate, time left, and how long the acks take;
// pause and cancel. Part of the terminal; hidden while no file was ever sent to the device.
#pragma once

#include <QPushButton>
#include <QWidget>

#include "base/time.h"
#include "control/intent.h"
#include "control/status.h"
#include "panel/common/danger_dialog.h"

class QProgressBar;
class QPushButton;

namespace deckpipe {

// "Send file…": chooses a file, reads it, and asks once by the device's name before it is sent over the data
// pipe: as it is, or, of a text whose lines end otherwise than the device takes them, with one chosen end a
// line. Part of the terminal; how the sending goes is the FileSendBar's.
class PipeInput;

class SendFileButton : public QPushButton {
  Q_OBJECT

 public:
  static constexpr qint64 kLargest = 8 << 20;  // at some hundred bytes a second more would take days

  // The lines of a text may go with the end that is chosen at `input` for what is typed.
  explicit SendFileButton(const PipeInput& input, QWidget* parent = nullptr);

  // The file goes to whom it was chosen for, whatever device is looked at by then.
  void setView(const PanelView& view);

 Q_SIGNALS:
  void intended(const deckpipe::Intent& intent);
  // Empty: another try begins.
  void failed(const QString& why);

 private:
  void choose();
  void confirm(const QString& path, const DeviceKey& device, const QString& name);

  const PipeInput& m_input;
  PanelView m_view;
  DeviceQuestion m_question;
};

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
