// SPDX-License-Identifier: GPL-3.0-or-later
// A page that is longer than its place: about, settings, help. Called once while the page is built.
#pragma once

#include <QScrollArea>
#include <QVBoxLayout>

namespace deckpipe {

// Fills `page` with `content`, scrolled; the keys go to what is inside.
inline void fillScrolled(QWidget* page, QWidget* content, const QString& name) {
  auto* scroll = new QScrollArea(page);
  scroll->setObjectName(name);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidgetResizable(true);
  scroll->setWidget(content);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
}

}  // namespace deckpipe
