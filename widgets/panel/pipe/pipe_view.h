// SPDX-License-Identifier: GPL-3.0-or-later
// What went through the data pipe both ways, as text: shown, searched and saved. Part of the terminal, which
// gives it the view and the device. The transcript is read from the log: what stands there was on the bus,
// live and of a file alike.
#pragma once

#include <QWidget>

#include "model/pipe_transcript.h"
#include "paint/palette.h"

class QCheckBox;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace deckpipe {

class PipeView : public QWidget {
  Q_OBJECT

 public:
  explicit PipeView(QWidget* parent = nullptr);

  void setView(const LogView& view, const DeviceKey& device);
  // See PipeTranscript.
  Instant restartedSinceSent() const { return m_transcript.restartedSinceSent(); }
  // What is shown, search, and saving: a row of its own.
  void showTools(bool isOn);
  void beginSearch();

 Q_SIGNALS:
  // The search wants the tools, or the keyboard is to go back to typing.
  void toolsWanted();
  void searchLeft();
  // A file could not be written.
  void failed(const QString& why);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeTools();
  void rebuild();
  void append(std::size_t from);
  void find(bool backwards);
  void save(const QString& title, const QString& name, const QString& text);

  PipeTranscript m_transcript;
  std::size_t m_shown = 0;       // packets in the text
  Theme m_theme = Theme::Light;  // of the text
  Address m_lastSender;
  bool m_isFollowing = true;  // the end, until a person scrolls away from it
  bool m_isLineOpen = false;
  std::size_t m_restartsShown = 0;
  QPlainTextEdit* m_text;
  QWidget* m_tools = nullptr;
  QCheckBox* m_echo = nullptr;
  QCheckBox* m_hex = nullptr;
  QLineEdit* m_search = nullptr;
  QPushButton* m_saveText = nullptr;
  QPushButton* m_saveLedger = nullptr;
};

}  // namespace deckpipe
