// SPDX-License-Identifier: GPL-3.0-or-later
// Labels whose colour means something, changed only when it changes: a new palette or text lays out anew.
#pragma once

#include <QLabel>
#include <QPalette>

namespace deckpipe {

inline void setInk(QLabel& label, const QColor& ink) {
  QPalette palette = label.palette();
  // On a window labels write in one of these, on a surface in the other.
  if (palette.color(QPalette::WindowText) == ink && palette.color(QPalette::Text) == ink) return;
  palette.setColor(QPalette::WindowText, ink);
  palette.setColor(QPalette::Text, ink);
  label.setPalette(palette);
}

inline void setText(QLabel& label, const QString& text) {
  if (label.text() != text) label.setText(text);
}

}  // namespace deckpipe
