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

class AskCard : public QWidget {
  Q_OBJECT

 public:
  enum class Tone : std::uint8_t { Plain, Waiting, Fine, Attend };
  struct Values {
    QString answer;  // empty: none yet
    QString state;
    Tone tone = Tone::Plain;
    bool isOffered = false;
    friend bool operator==(const Values&, const Values&) = default;
  };

  explicit AskCard(Ask ask, QWidget* parent = nullptr);

  void setValues(const Values& values);
  const Values& values() const { return m_values; }
  void setColours(const Colours& colours);
  Ask ask() const { return m_ask; }

 Q_SIGNALS:
  void pressed();

 private:
  void show();

  Ask m_ask;
  Values m_values;
  Colours m_colours;
  QLabel* m_answer;
  GlyphLabel* m_sign;
  QLabel* m_state;
  QPushButton* m_button;
};

}  // namespace deckpipe
