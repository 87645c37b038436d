// SPDX-License-Identifier: GPL-3.0-or-later
// One thing that can be asked of a device: what it is, the last answer in words, how the last request went,
// and the button that asks. Part of the request panel.
#pragma once

#include <QWidget>
#include <optional>

#include "base/severity.h"
#include "control/request.h"

class QLabel;
class QPushButton;

namespace deckpipe {

class GlyphLabel;

struct RequestCardValues {
  QString answer;  // empty: none yet
  QString state;
  Severity tone = Severity::Plain;  // of the state; only Fine has a tick
  bool isOld = false;               // the device restarted or fell silent after the answer
  bool isFault = false;             // the answer names a fault
  bool isOffered = false;
  bool isBehindLock = false;  // a command that is offered after unlocking
  friend bool operator==(const RequestCardValues&, const RequestCardValues&) = default;
};

class RequestCard : public QWidget {
  Q_OBJECT

 public:
  using Values = RequestCardValues;

  explicit RequestCard(Request request, QWidget* parent = nullptr);

  void setValues(const Values& values);
  const Values& values() const { return m_values; }
  Request request() const { return m_request; }

 Q_SIGNALS:
  void pressed();

 private:
  void showState();

  Request m_request;
  Values m_values;
  QLabel* m_answer;
  GlyphLabel* m_sign;
  QLabel* m_state;
  QPushButton* m_button;
  QString m_verb;  // on the button while nothing is in the way
};

}  // namespace deckpipe
