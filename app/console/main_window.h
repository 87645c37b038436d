// SPDX-License-Identifier: GPL-3.0-or-later
// The one window: status strip, devices, the chosen device's page, trace with its decode detail, and the
// transport bar at the foot. It hands each snapshot of the session to its panels and their wishes to the
// session; it decides nothing about a log itself.
#pragma once

#include <QMainWindow>
#include <optional>

#include "paint/palette.h"
#include "session/session.h"

class QActionGroup;
class QSplitter;
class QStackedWidget;

namespace deckpipe {

class DecodeModel;
class DecodePanel;
class DevicePanel;
class MonitorPage;
class StatusStrip;
class TraceModel;
class TraceView;
class TransportBar;

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
  QWidget* makeWorkspace();
  void makeMenus();
  void connectPanels();
  void showSnapshot();
  void showFrame(std::optional<std::uint64_t> frame);
  void openLogByHand();
  void chooseFirstMonitor();
  void saveLayout() const;

  Session& m_session;
  Theme m_theme = Theme::Light;
  const LogDocument* m_shown = nullptr;  // whose devices were chosen from
  StatusStrip* m_status;
  QStackedWidget* m_pages;
  QWidget* m_workspace = nullptr;
  TraceModel* m_traceModel;
  DecodeModel* m_decodeModel;
  DevicePanel* m_devices = nullptr;
  MonitorPage* m_page = nullptr;
  TraceView* m_trace = nullptr;
  DecodePanel* m_decode = nullptr;
  TransportBar* m_transport = nullptr;
  QSplitter* m_upper = nullptr;   // devices | page
  QSplitter* m_lower = nullptr;   // trace | decode detail
  QSplitter* m_halves = nullptr;  // one above the other
  QActionGroup* m_themes = nullptr;
};

}  // namespace deckpipe
