// SPDX-License-Identifier: GPL-3.0-or-later
// The one window: status strip, the workspace with its docks, and the transport bar at the foot. It hands
// each snapshot of the session to them and their intents to the session; it decides nothing about a log.
#pragma once

#include <QMainWindow>
#include <functional>

#include "kept_settings.h"
#include "paint/app_style.h"
#include "panel/common/notice_bar.h"
#include "session/log_saving.h"
#include "session/session.h"

class QActionGroup;
class QFileDialog;
class QMenuBar;
class QStackedWidget;

namespace deckpipe {

class Connection;
class MarkBar;
class RecordingsList;
class SaveBar;
class SettingsPage;
class StatusStrip;
class TraceFilter;
class TransportBar;
class SendingActions;
class Workspace;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(Session& session, QWidget* parent = nullptr);
  ~MainWindow() override;

  // As a person chose: kept for the next time.
  void setTheme(Theme theme);
  void setDensity(Density density);
  // The look is of this run alone and is not kept.
  void setLook(Theme theme, Density density);
  Theme theme() const { return m_theme; }
  Density density() const { return m_density; }
  // Writes what is held of the open log; the line above the timeline shows how that goes.
  void saveLog(const QString& path);
  // What is seen. The session's, on its tick; pictures of every state come from here too.
  void setSnapshot(const Snapshot& snapshot);
  // Without a question: the system ends the program, and nobody may be there to answer.
  void quit();
  // As last time: theme, size, columns. The first time: as large as fits the screen.
  void restoreLayout();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void makeMenus();
  void makeFileMenu();
  void listRecentLogs(QMenu& menu, QAction* before);
  void makeViewMenu();
  void makeReplayMenu();
  void makeTraceMenu();
  void makeEventsMenu();
  void makeHelpMenu();
  void connectPanels();
  void showSnapshot();
  void rememberWhatWasRead();
  void showPage();
  // Settings, about, recordings: in the place of the work until closed. Null: none.
  void showExtra(QWidget* page);
  // Enables what can be done now; the tips of the others say why not.
  void offerActions();
  QFileDialog* fileDialog(const QString& title, const QStringList& filters);
  void openLogByHand();
  void saveLogByHand();
  // Frames [begin, end) that pass.
  void savePartByHand(std::uint64_t begin, std::uint64_t end, const TraceFilter& filter);
  QFileDialog* saveDialog(const QString& title);
  void save(const std::shared_ptr<const LogDocument>& document, const QString& path, SavedPart part);
  void connectRecordings();
  void showRecordings();
  void saveRecordingByHand(const QString& path);
  void deleteRecordingByHand(const QString& path);
  void follow(Notice::Action action);
  void chooseBitRate();
  QList<QWidget*> panes() const;
  void saveLayout() const;
  QStringList runningWork() const;
  // A question with a verb, and with a way to leave things as they are, which Enter takes.
  struct Question {
    const char* name;
    QString title, text, verb, otherwise;
  };
  void ask(const Question& question, std::function<void()> act);
  static QString lostMarksText(const UnkeptMarks& marks);
  // main_leaving.cpp: the ways out of the open log. Nothing else calls these of the session.
  void openLog(const QString& path);
  void addUpTimes();
  void openLink(const LinkSettings& link);
  void reconnect();
  void openDemo();
  void closeSource();
  void leave(std::function<void()> go);
  void onceMarksAreKept(std::function<void()> go);

  Session& m_session;
  Snapshot m_snapshot;
  Theme m_theme = Theme::Light, m_chosenTheme = m_theme;
  Density m_density = Density::Desk, m_chosenDensity = m_density;
  SettingsLabels m_labels;
  Notice m_addressNotice;  // until the settings were looked at
  QMenuBar* m_menus;
  StatusStrip* m_status;
  NoticeBar* m_notice;
  QStackedWidget* m_pages;
  Connection* m_connection;
  Workspace* m_workspace;
  SettingsPage* m_settings;
  QWidget* m_about;
  RecordingsList* m_recordings;
  Notice m_unsavedNotice;   // until the recordings were looked at
  bool m_mayClose = false;  // the person was asked
  std::function<void()> m_onceMarksAreKept;
  QWidget* m_extra = nullptr;                     // one of the pages, while it is seen
  const LogDocument* m_shown = nullptr;           // the last log
  std::weak_ptr<const LogDocument> m_remembered;  // the last log of a file that could be read
  MarkBar* m_markBar;
  SaveBar* m_saveBar;
  TransportBar* m_transport;
  QActionGroup* m_recentMenu = nullptr;  // the logs that the File menu lists
  QActionGroup* m_themes = nullptr;
  QActionGroup* m_replay = nullptr;  // all that moves the cursor of a log
  SendingActions* m_sending = nullptr;
  QList<QAction*> m_frameActions;  // want frames
  QList<QAction*> m_workActions;   // want the work in sight
  QList<QAction*> m_eventActions;  // … and an event in the list
  QAction* m_closeAction = nullptr;
  QAction* m_findAction = nullptr;
  QAction* m_dialAction = nullptr;
  QAction* m_askAllAction = nullptr;
  QAction* m_traceDeviceAction = nullptr;
  QAction* m_fieldAction = nullptr;
};

}  // namespace deckpipe
