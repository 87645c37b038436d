// SPDX-License-Identifier: GPL-3.0-or-later
// One thing that can be asked of a device: what it is, the last answer in words, how the last request went,
// and the button that asks. Part of the request panel.
#pragma once

#include <QWidget>
#include <optional>

#include "control/ask.h"
#include "paint/palette.h"

class QLabel;
class QPushButton;

namespace deckpipe {

class GlyphLabel;

// Of the state. Only Fine has a tick.
enum class AskCardTone : std::uint8_t { Plain, Waiting, Fine, Attend };

struct AskCardValues {
  QString answer;  // empty: none yet
  QString state;
  AskCardTone tone = AskCardTone::Plain;
  bool isOld = false;    // the device restarted or fell silent after the answer
  bool isFault = false;  // the answer names a fault
  bool isOffered = false;
  friend bool operator==(const AskCardValues&, const AskCardValues&) = default;
};

class AskCard : public QWidget {
  Q_OBJECT

 public:
  using Tone = AskCardTone;
  using Values = AskCardValues;

  explicit AskCard(Ask ask, QWidget* parent = nullptr);

  void setValues(const Values& values);
  const Values& values() const { return m_values; }
  Ask ask() const { return m_ask; }

 Q_SIGNALS:
  void pressed();

 private:
  void showState();

  Ask m_ask;
  Values m_values;
  QLabel* m_answer;
  GlyphLabel* m_sign;
  QLabel* m_state;
  QPushButton* m_button;
};

}  // namespace deckpipe
