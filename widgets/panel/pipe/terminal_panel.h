// SPDX-License-Identifier: GPL-3.0-or-later
// The data-pipe terminal of the chosen device: what went both ways, what is typed, and files, paced by the
// device's acks. The window gives it the view, what was said in the log, the services' status and the device;
// it emits intents and sends nothing. It puts together PipeView, PipeInput, SendFileButton and FileSendBar.
//
//   1. The device it talks to stands there always, whatever was typed.
//   2. A missing ack is the person's to decide: the bar with resend, skip and abort stays until then. Whether
//      that is for the rest of the file or text too is asked anew each time.
//   3. Off the live edge what goes on can be stopped; nothing can be begun.
#pragma once

#include <QWidget>

#include "control/intent.h"
#include "panel/common/panel_view.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace deckpipe {

class ElidedLabel;
class FileSendBar;
class PipeInput;
class PipeView;
class SendFileButton;
class SendHint;

class TerminalPanel : public QWidget {
  Q_OBJECT

 public:
  explicit TerminalPanel(QWidget* parent = nullptr);

  // The title says that one of the devices' pipes waits for a decision.
  void setView(const PanelView& view);

  QSize sizeHint() const override { return {900, 300}; }

 Q_SIGNALS:
  void intended(const deckpipe::Intent& intent);
  void unlockRequested();

 private:
  QLayout* makeTop();
  QWidget* makeStallBar();
  QLayout* makeBottom();
  void showState();
  void showStall(const PipeStatus& pipe);
  QString stallWords(const PipeStatus& pipe) const;
  QString ownHint(const DeviceServices* device, const PipeStatus& pipe) const;
  QString restartHint(const PipeStatus& pipe) const;
  Instant now() const;
  void act(intent::PipeAction::What what, bool forTheRest = false) {
    Q_EMIT intended(intent::PipeAction{m_view.device, what, forTheRest});
  }
  void decide(intent::PipeAction::What what);
  void say(const QString& trouble);

  const ServiceStatus& services() const { return *m_view.services; }

  PanelView m_view;
  QString m_trouble;  // with a file, or with what was typed; until the next deed

  ElidedLabel* m_title = nullptr;
  QLabel* m_caution = nullptr;
  QWidget* m_stallBar = nullptr;
  QLabel* m_stall = nullptr;
  QCheckBox* m_forTheRest = nullptr;
  QPushButton* m_resend = nullptr;
  QPushButton* m_skip = nullptr;
  SendHint* m_hint;
  PipeView* m_text;
  FileSendBar* m_file;
  PipeInput* m_input;
  SendFileButton* m_sendFile;
  QPushButton* m_more = nullptr;
};

}  // namespace deckpipe
