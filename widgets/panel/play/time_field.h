// SPDX-License-Identifier: GPL-3.0-or-later
// The field in which a person types a place of the log (model/typed_place.h). It stands in the place of the clock while
// it is open, with a sentence over what is above the bar: what can be typed, or what is wrong. So nothing moves. Enter
// goes there; Escape, or leaving the field, closes it.
#pragma once

#include <QAbstractButton>
#include <QLineEdit>
#include <QPointer>

#include <cstdint>
#include <optional>

#include "base/time.h"
#include "state/log_view.h"
#include "text/time_text.h"

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

// The time of day here, "2023-11-14 22:13:20.000"; seconds where the log counts from something else than
// 1970.
QString stampTimeText(std::int64_t stampNs);
// What the log's own clock says at the cursor; nothing before the first frame and in logs without times.
std::optional<std::int64_t> stampAt(const LogView& view);

// Where the cursor is, in figures that do not move: the time since the log's begin, under it the time of day
// that the log gives; in a log without times the number of frames. A click asks for the field in which another place
// is typed (TimeField).
class TimeReadout : public QAbstractButton {
  Q_OBJECT

 public:
  explicit TimeReadout(QWidget* parent = nullptr);

  void setView(const LogView& view);
  QString elapsed() const { return m_elapsed; }
  QString absolute() const { return m_absolute; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QFont elapsedFont() const;

  QString m_elapsed;
  QString m_absolute;
};

}  // namespace deckpipe
