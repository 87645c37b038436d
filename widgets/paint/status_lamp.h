// SPDX-License-Identifier: GPL-3.0-or-later
// One status of two bits as a lamp: its sign, its label, its word. Panels line them up for the stops by axis
// and for the outputs. An output is lit as fine, a fault as a fault; a stop in the colour of text, for on is
// neither good nor bad there.
#pragma once

#include <QString>
#include <QWidget>
#include <optional>

#include "base/part_state.h"
#include "base/severity.h"
#include "paint/glyph.h"
#include "paint/palette.h"

namespace deckpipe {

class StatusLamp : public QWidget {
  Q_OBJECT

 public:
  explicit StatusLamp(QWidget* parent = nullptr);

  // `spoken` is for who does not see where the lamp stands: "Rotation, right stop" for a lamp labelled
  // "Right".
  void setLabel(const QString& label, const QString& spoken = {});
  // How it is lit, and its sign then: by default the severity's own.
  void setWhenOn(Severity whenOn, std::optional<Glyph> sign = {});
  // Nothing: never heard. Stale: the last state heard, drawn as old; never as a steady one.
  void setState(std::optional<Status2> state, bool stale = false);

  std::optional<Status2> state() const { return m_state; }
  bool isStale() const { return m_stale; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Look {
    Glyph glyph;
    QColor ink;       // of the frame and the word
    QColor fill;      // of the lamp
    QColor glyphInk;  // on the fill
    bool dashed;
  };
  Look lookIn(const Colours& colours) const;
  QString word() const;
  void describe();

  QString m_label;
  QString m_spoken;  // empty: the label
  std::optional<Status2> m_state;
  Severity m_whenOn = Severity::Plain;
  std::optional<Glyph> m_signWhenOn;
  bool m_stale = false;
  mutable QSize m_hint;  // as long as label, font and language are the same: pages are laid out often
};

}  // namespace deckpipe
