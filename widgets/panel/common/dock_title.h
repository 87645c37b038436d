// SPDX-License-Identifier: GPL-3.0-or-later
// The line over a dock: its name, and buttons that fingers in gloves can hit. While docks share a place, the
// tabs name them and the line gives its room to the content; a tab is drawn out to float its dock, and the
// menu of the tabs shows and hides them. The workspace gives one to every dock.
#pragma once

#include <QWidget>

class QDockWidget;

namespace deckpipe {

class DockTitle : public QWidget {
  Q_OBJECT

 public:
  // Puts itself over `dock`.
  explicit DockTitle(QDockWidget* dock);

  // A collapsed title takes no room.
  void setCollapsed(bool isCollapsed);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 private:
  class Button;

  Button* m_float;
  Button* m_close;
  bool m_isCollapsed = false;
};

}  // namespace deckpipe
