// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen while a log is open: the chosen device's page in the middle, everything else in docks around
// it. The main window gives it each snapshot and acts on what it asks for. How a person arranged the docks is
// theirs: saved as a versioned state, and put back to the first arrangement by resetLayout().
#pragma once

#include <QHash>
#include <QMainWindow>
#include <memory>
#include <optional>

#include "base/time.h"
#include "control/intent.h"
#include "control/twin_control.h"
#include "model/device_labels.h"
#include "session/snapshot.h"
#include "state/conversations.h"

class QSettings;
class QTabWidget;

namespace deckpipe {

class DecodeModel;
class DecodePanel;
class DevicePanel;
class DockTitle;
class EventPanel;
class HelpPanel;
class MonitorPage;
class OverviewPanel;
class RequestPanel;
class TerminalPanel;
class TracePanel;
class TwinPanel;

class Workspace : public QMainWindow {
  Q_OBJECT
 public:
  // Labels are read from `labels` at once and written to it at every edit.
  explicit Workspace(LabelStorage& labels, QWidget* parent = nullptr);

  void setSnapshot(const Snapshot& snapshot);

  // One a dock, for the View menu: shows and hides it.
  QList<QAction*> dockActions() const;
  // What can be looked at now, in reading order, for going from one to the next by keyboard.
  QList<QWidget*> panes() const;
  TracePanel* trace() const { return m_trace; }
  EventPanel* events() const { return m_events; }
  // What devices are called: by the person, and where the person has no label, by the log that is shown.
  const DeviceLabels& labels() const { return m_shownLabels; }
  QMenu* createPopupMenu() override;
  void resetLayout();
  // The chosen device's dial over the whole window, and back.
  void toggleFullDial();
  // Filters the trace down to the chosen device's frames, and shows it.
  void traceDevice();
  // Opens the dock where the chosen device is asked.
  void showRequests();
  // Opens the dock that explains what has the focus.
  void showHelp();
  void saveTo(QSettings& settings) const;
  void restoreFrom(const QSettings& settings);

 Q_SIGNALS:
  // The cursor is wanted behind that frame: it has happened then.
  void frameRequested(std::uint64_t frame);
  void seekRequested(deckpipe::Instant time);
  void wished(const deckpipe::Wish& wish);
  void unlockRequested();
  void twinWished(const deckpipe::TwinWish& wish);
  void labelsChanged(const deckpipe::DeviceLabels& labels);

 public Q_SLOTS:
  // Of the demo; its dock is there only while one runs.
  void setTwin(const deckpipe::TwinStatus& status);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;
  void childEvent(QChildEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QList<QDockWidget*> docks() const;
  QDockWidget* makeDock(const char* name, const QString& title, QWidget* content);
  void arrange();
  void shareRoom();
  void showFrame(std::optional<std::uint64_t> frame);
  void chooseFirstMonitor(const LogView& view);
  void showPageOf(const DeviceKey& key);
  void editLabel(const Pin& pin, const QString& label);
  void showLabels();
  void readLabels(const LogView& view);
  void setTalk(const Snapshot& snapshot);
  QString nameOf(const DeviceKey& key) const;

  LabelStorage& m_labelStorage;
  DeviceLabels m_labels;         // the person's own
  DeviceLabels m_shownLabels;    // with those of the log
  std::size_t m_labelNotes = 0;  // notes of the log when its labels were read
  DecodeModel* m_decodeModel;
  DevicePanel* m_devices;
  QTabWidget* m_centre;
  MonitorPage* m_page;
  OverviewPanel* m_overview;
  TracePanel* m_trace;
  EventPanel* m_events;
  DecodePanel* m_decode;
  RequestPanel* m_requests;
  TerminalPanel* m_terminal;
  TwinPanel* m_twin;
  std::unique_ptr<Conversations> m_talk;  // of the log that is shown
  QDockWidget* m_requestsDock;
  QDockWidget* m_terminalDock;
  QDockWidget* m_twinDock;
  HelpPanel* m_help;
  QDockWidget* m_devicesDock = nullptr;
  QDockWidget* m_traceDock;
  QDockWidget* m_eventsDock;
  QDockWidget* m_decodeDock;
  QDockWidget* m_helpDock;
  QList<DockTitle*> m_titles;                 // one a dock
  QHash<const QWidget*, QAction*> m_actions;  // checked while the dock is seen
  double m_fontSize = 0;
  bool m_hasShared = false;              // the docks have sizes: the first, or a person's
  bool m_decodeWanted = true;            // a person did not close it
  bool m_hasDetailRoom = false;          // it was given its width, or a person gave it one
  QList<QDockWidget*> m_floatingHidden;  // hidden with the workspace, they come back with it
  const LogDocument* m_shown = nullptr;  // whose devices were chosen from
};

}  // namespace deckpipe
