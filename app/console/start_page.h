// SPDX-License-Identifier: GPL-3.0-or-later
// What the window shows while nothing is open: what can be done, each with a button.
#pragma once

#include <QWidget>

namespace deckpipe {

class StartPage : public QWidget {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent = nullptr);

 Q_SIGNALS:
  void logRequested();
  void demoRequested();
};

}  // namespace deckpipe
