// SPDX-License-Identifier: GPL-3.0-or-later
// What this program is: version, licence, what it is built on, where it keeps things, and which manuals its
// words come from. The console says the facts it knows.
#pragma once

#include <QWidget>

namespace deckpipe {

struct AboutFacts {
  QString version{};
  QString settingsPath{};
  QString spillFolder{};  // where a log larger than memory goes
};

class AboutPage : public QWidget {
  Q_OBJECT

 public:
  explicit AboutPage(const AboutFacts& facts, QWidget* parent = nullptr);

 Q_SIGNALS:
  void closeRequested();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace deckpipe
