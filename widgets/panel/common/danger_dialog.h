// SPDX-License-Identifier: GPL-3.0-or-later
// The one kind of dialog there is: asks once before something dangerous is done, names what and to whom, and
// does it only on the verb. Enter and Esc keep things as they are. It blocks its window, not the program.
#pragma once

#include <QDialog>
#include <functional>
#include <utility>

class QCheckBox;

namespace deckpipe {

class DangerDialog : public QDialog {
  Q_OBJECT

 public:
  struct Question {
    QString title;           // "Reset 1032AE100801035?"
    QString text;            // what it does, and what it may lead to
    QString verb;            // "Reset"
    QString otherwise = {};  // "Cancel" where nothing is said
    QString option = {};     // beside a box, ticked at first; empty: none
  };
  // Deletes itself. `act` is called where the person says the verb, with whether the option was ticked.
  static void request(QWidget* parent, const Question& question, std::function<void(bool isTicked)> act);
  static void request(QWidget* parent, const Question& question, std::function<void()> act) {
    request(parent, question, [act = std::move(act)](bool) { act(); });
  }

 private:
  DangerDialog(QWidget* parent, const Question& question);

  QCheckBox* m_option = nullptr;
};

}  // namespace deckpipe
