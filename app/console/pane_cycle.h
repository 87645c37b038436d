// SPDX-License-Identifier: GPL-3.0-or-later
// From one pane of the window to the next by keyboard (F6, Shift+F6), as a person reads: the main window
// tells which panes can be seen and where the focus is now.
#pragma once

#include <QList>

class QWidget;

namespace deckpipe {

// Gives the focus to the pane after the one that has it, or before it; to the first where none has.
void focusNextPane(const QList<QWidget*>& panes, bool backwards);

}  // namespace deckpipe
