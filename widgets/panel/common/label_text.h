// SPDX-License-Identifier: GPL-3.0-or-later
// Text of a label, changed only when it changes: a new text lays out anew.
#pragma once

#include <QLabel>

namespace deckpipe {

inline void setText(QLabel& label, const QString& text) {
  if (label.text() != text) label.setText(text);
}

}  // namespace deckpipe
