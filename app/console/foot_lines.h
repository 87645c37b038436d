// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that come and go at the foot of the window's pages: they lie over the page's last rows and move nothing.
// MainWindow gives it the pages and puts the lines in.
#pragma once

#include <QWidget>

namespace deckpipe {

class FootLines : public QWidget {
  Q_OBJECT

 public:
  // Over the foot of `stage`, a sibling.
  explicit FootLines(QWidget* stage);
  // From top to bottom. A line shows and hides itself.
  void add(QWidget* line);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  QWidget* m_stage;
};

}  // namespace deckpipe
