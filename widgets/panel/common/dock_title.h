// SPDX-License-Identifier: GPL-3.0-or-later
// The line over a dock: its name, and buttons that fingers in gloves can hit. While docks share a place, the
// tabs name them and the line gives its room to the content; a tab is drawn out to float its dock, and the
// menu of the tabs shows and hides them. The workspace gives one to every dock.
#pragma once

#include <QString>
#include <QWidget>

#include "base/time.h"

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

// The line over a group of lamps or facts: what it is, a remark, and at the right how old it is.
class SectionTitle : public QWidget {
  Q_OBJECT

 public:
  explicit SectionTitle(QWidget* parent = nullptr);

  void setTitle(const QString& title, const QString& remark = {});
  // That nothing was heard is said, too, unless this is never called.
  void setAge(const Age& age, bool isStale);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void describe();

  QString m_title, m_remark, m_age;
  bool m_isStale = false;
};

}  // namespace deckpipe
