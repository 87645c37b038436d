// SPDX-License-Identifier: GPL-3.0-or-later
// The data-pipe terminal of the chosen device: what went both ways, a line to type, or every key at once, and
// files, paced by the device's acks. The window gives it the view, what was said in the log, the services'
// status and the device; it emits wishes and sends nothing.
//
//   1. The transcript is read from the log: what stands there was on the bus, live and of a file alike.
//   2. A missing ack is the person's to decide: the bar with resend, skip and abort stays until then.
//   3. In raw mode every key is sent but Esc, which is not a terminal's here: Ctrl+[ sends ESC.
#pragma once

#include <QWidget>

#include "control/intent.h"
#include "control/status.h"
#include "model/pipe_transcript.h"
#include "paint/palette.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace deckpipe {

class FileSendBar;

class TerminalPanel : public QWidget {
  Q_OBJECT

 public:
  explicit TerminalPanel(QWidget* parent = nullptr);

  void setDevice(const DeviceKey& device, const QString& name);
  void setView(const LogView& view, const Conversations& talk, const ServiceStatus& services, bool isLive);
  void setColours(const Colours& colours);

  QSize sizeHint() const override { return {900, 300}; }

 Q_SIGNALS:
  void wished(const deckpipe::Wish& wish);
  void unlockRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeHint();
  QWidget* makeStallBar();
  QWidget* makeInput();
  QWidget* makeTools();
  QPushButton* makeButton(const char* name, const QString& text);
  void showState();
  void appendPackets(std::size_t from);
  void rebuild();
  void sendLine();
  bool sendKey(const QKeyEvent& event);
  std::string lineEnd() const;
  void recall(int by);
  void find(bool backwards);
  void chooseFile();
  void confirmFile(const QString& path);
  void save(const QString& title, const QString& name, const QString& text);
  void act(wish::PipeAction::What what) { Q_EMIT wished(wish::PipeAction{m_device, what}); }
  bool isRaw() const;
  void say(const QString& trouble);

  Colours m_colours;
  DeviceKey m_device;
  QString m_name;
  LogView m_view;
  ServiceStatus m_services;
  bool m_isLive = false;
  QString m_trouble;  // with a file; until the next deed
  PipeTranscript m_transcript;
  std::size_t m_shown = 0;  // packets in the text
  bool m_wasFromDevice = true;
  bool m_isLineOpen = false;
  QStringList m_history;
  qsizetype m_recalled = 0;

  QLabel* m_caution;
  QWidget* m_hintBar = nullptr;
  QLabel* m_hint = nullptr;
  QPushButton* m_unlock = nullptr;
  QWidget* m_stallBar = nullptr;
  QLabel* m_stall = nullptr;
  QPushButton* m_resend = nullptr;
  QPushButton* m_skip = nullptr;
  QPlainTextEdit* m_text;
  FileSendBar* m_file;
  QLineEdit* m_input = nullptr;
  QComboBox* m_mode = nullptr;
  QComboBox* m_lineEnd = nullptr;
  QPushButton* m_send = nullptr;
  QPushButton* m_sendFile = nullptr;
  QPushButton* m_more = nullptr;
  QWidget* m_tools = nullptr;
  QPushButton* m_saveText = nullptr;
  QPushButton* m_saveLedger = nullptr;
  QCheckBox* m_echo = nullptr;
  QCheckBox* m_hex = nullptr;
  QLineEdit* m_search = nullptr;
};

}  // namespace deckpipe
