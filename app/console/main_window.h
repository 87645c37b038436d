// SPDX-License-Identifier: GPL-3.0-or-later
// The one window: status strip, the workspace with its docks, and the transport bar at the foot. It hands
// each snapshot of the session to them and their wishes to the session; it decides nothing about a log
// itself.
#pragma once

#include <QMainWindow>

#include "paint/palette.h"
#include "session/session.h"
#include "settings_labels.h"

class QActionGroup;
class QStackedWidget;

namespace deckpipe {

class StatusStrip;
class TransportBar;
class SendingActions;
class Workspace;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(Session& session, QWidget* parent = nullptr);
  ~MainWindow() override;

  void setTheme(Theme theme);
  Theme theme() const { return m_theme; }
  // As last time: theme, size, columns.
  void restoreLayout();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void makeMenus();
  void connectPanels();
  void showSnapshot();
  void openLogByHand();
  QList<QWidget*> panes() const;
  void saveLayout() const;

  Session& m_session;
  Theme m_theme = Theme::Light;
  SettingsLabels m_labels;
  StatusStrip* m_status;
  QStackedWidget* m_pages;
  Workspace* m_workspace;
  TransportBar* m_transport;
  QActionGroup* m_themes = nullptr;
  SendingActions* m_sending = nullptr;
};

}  // namespace deckpipe
