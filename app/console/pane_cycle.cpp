// SPDX-License-Identifier: GPL-3.0-or-later
#include "pane_cycle.h"

#include <QApplication>
#include <QWidget>

namespace deckpipe {
namespace {

bool takesFocus(const QWidget* widget) {
  while (widget->focusProxy() != nullptr) widget = widget->focusProxy();
  return widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) != 0;
}

// What of a pane Tab would come to first.
QWidget* firstFocus(QWidget* pane) {
  if (takesFocus(pane)) return pane;
  for (QWidget* next = pane->nextInFocusChain(); next != pane; next = next->nextInFocusChain()) {
    if (pane->isAncestorOf(next) && takesFocus(next)) return next;
  }
  return nullptr;
}

}  // namespace

void focusNextPane(const QList<QWidget*>& panes, bool backwards) {
  const QWidget* focus = QApplication::focusWidget();
  const qsizetype count = panes.size(), step = backwards ? -1 : 1;
  qsizetype here = backwards ? 0 : -1;
  for (qsizetype i = 0; i < count; ++i) {
    if (focus != nullptr && (panes[i] == focus || panes[i]->isAncestorOf(focus))) here = i;
  }
  for (qsizetype tried = 1; tried <= count; ++tried) {
    QWidget* target = firstFocus(panes[((here + tried * step) % count + count) % count]);
    if (target == nullptr) continue;
    target->setFocus(Qt::TabFocusReason);
    target->window()->setAttribute(Qt::WA_KeyboardFocusChange);  // its ring is drawn, whichever key it was
    return;
  }
}

}  // namespace deckpipe
