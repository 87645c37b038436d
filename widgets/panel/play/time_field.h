// SPDX-License-Identifier: GPL-3.0-or-later
// The field in which a person types a place of the log (model/typed_place.h). It stands in the place of the clock while
// it is open, with a sentence over what is above the bar: what can be typed, or what is wrong. So nothing moves. Enter
// goes there; Escape, or leaving the field, closes it.
#pragma once

#include <QLineEdit>
#include <QPointer>

#include "state/log_view.h"

class QLabel;

namespace deckpipe {

class TimeField : public QLineEdit {
  Q_OBJECT

 public:
  // Over `clock`, which is a child of `bar`.
  TimeField(QWidget* clock, QWidget* bar);
  ~TimeField() override;

  void setView(const LogView& view) { m_view = view; }
  // With `text` in it, chosen, so that typing replaces it.
  void open(const QString& text);
  // After the bar was laid out.
  void place();

 Q_SIGNALS:
  void timeTyped(deckpipe::Instant time);
  // Behind so many frames.
  void framesTyped(std::uint64_t frames);
  // The person is done with it, and has not gone elsewhere.
  void done();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void take();
  void say(const QString& sentence, bool isWrong);

  QWidget* m_clock;
  QPointer<QLabel> m_sentence;  // a child of the window while it is seen
  LogView m_view;
};

}  // namespace deckpipe
