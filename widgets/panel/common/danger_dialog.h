// SPDX-License-Identifier: GPL-3.0-or-later
// The one kind of dialog there is: asks once before something dangerous is done, names what and to whom, and
// does it only on the verb. Esc keeps things as they are, and so does Enter until a person goes to the verb: Enter is
// the button that has the focus. It blocks its window, not the program.
#pragma once

#include <QDialog>
#include <QPointer>

#include <functional>
#include <utility>
#include <vector>

#include "panel/common/panel_view.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace deckpipe {

class WarningButton;

class DangerDialog : public QDialog {
  Q_OBJECT

 public:
  // What is so while the dialog stands open.
  struct Fact {
    QString name;    // "Rotation"
    QString value;   // "47.3° right"
    QString age;     // "< 1 s"; may be empty
    QString remark;  // "Right stop"; may be empty
    friend bool operator==(const Fact&, const Fact&) = default;
  };
  struct Question {
    QString title;                // "Reset: Roof (1032AE100801035)?"
    QString text;                 // what it does, and what it may lead to
    QString verb;                 // "Reset"
    QString otherwise = {};       // "Cancel" where nothing is said
    QString option = {};          // beside a box, ticked at first; empty: none
    QString whom = {};            // "6032 Universal II · address 80 hex"
    std::vector<Fact> facts{};    // as many as there ever are
    bool canBeWithdrawn = false;  // has room for the sentence
  };
  // Deletes itself. `act` is called where the person says the verb, with whether the option was ticked.
  static DangerDialog* request(QWidget* parent, const Question& question,
                               std::function<void(bool isTicked)> act);
  static DangerDialog* request(QWidget* parent, const Question& question, std::function<void()> act) {
    return request(parent, question, [act = std::move(act)](bool) { act(); });
  }

  void setFacts(const std::vector<Fact>& facts);
  // The question does not stand any more: `why` is said, and the verb cannot be said. It stays so.
  void withdraw(const QString& why);
  bool isWithdrawn() const;

 private:
  DangerDialog(QWidget* parent, const Question& question);
  QLayout* makeFacts(const std::vector<Fact>& facts);

  struct FactLabels {
    QLabel *value, *age, *remark;
  };

  std::vector<Fact> m_facts;
  std::vector<FactLabels> m_factLabels;
  QCheckBox* m_option = nullptr;
  QLabel* m_withdrawn = nullptr;
  WarningButton* m_verb = nullptr;
  QPushButton* m_no = nullptr;
};

// The danger question about one device, kept true while it stands open: it names the device, shows where it stands and
// who commands it, and is withdrawn with a sentence once what it asks cannot be done any more. A panel that sends has
// one and gives it every view.
class DeviceQuestion {
 public:
  // Asks about the chosen device of `view`, named at the end of `question.title`. The dialog belongs to `panel`.
  void ask(QWidget* panel, const PanelView& view, DangerDialog::Question question,
           std::function<void(bool isTicked)> act);
  void setView(const PanelView& view);

 private:
  QPointer<DangerDialog> m_dialog;
  DeviceKey m_device;
  Address m_address;  // where it was when the question was put
};

}  // namespace deckpipe
