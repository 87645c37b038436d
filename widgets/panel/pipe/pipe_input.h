// SPDX-License-Identifier: GPL-3.0-or-later
// What a person types into the data pipe: a line with its end, or every key at once. Part of the terminal;
// it hands over the bytes.
//
//   1. The pipe takes characters of one byte. Others are refused with words, whole: nothing of them is sent.
//   2. Lines that are pasted stay lines, each with the chosen end, whatever ended it before; the button
//      counts them.
//   3. In raw mode every key is sent but Esc, which is not a terminal's here: Ctrl+[ sends ESC. What comes
//      without keys, from an input method or pasted, is sent at once too.
#pragma once

#include <QStringList>
#include <QWidget>
#include <string>

class QComboBox;
class QKeyEvent;
class QLineEdit;
class QPushButton;

namespace deckpipe {

class PipeInput : public QWidget {
  Q_OBJECT

 public:
  explicit PipeInput(QWidget* parent = nullptr);

  // Whether there is a device that takes it, how the person calls it, and whether it has restarted since
  // something was sent to it last.
  void setOffered(bool mayType, const QString& name, bool hasRestarted);
  // What was typed was meant for another.
  void clear();
  // As chosen: what goes with each line, and its name for people.
  std::string lineEnd() const;
  QString lineEndName() const;

 Q_SIGNALS:
  void typed(const std::string& bytes);
  void refused(const QString& why);
  void findRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isRaw() const;
  // Nothing, said why, where a character does not fit into a byte.
  bool take(const QString& text, std::string& bytes);
  void showCount();
  void sendLine();
  void sendRest();
  bool sendKey(const QKeyEvent& event);
  void recall(int by);

  QStringList m_history;
  qsizetype m_recalled = 0;
  QComboBox* m_mode;
  QLineEdit* m_input;
  QComboBox* m_lineEnd;
  QPushButton* m_send;
};

}  // namespace deckpipe
