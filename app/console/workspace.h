// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen while a log is open: the chosen device's page in the middle, everything else in docks around
// it (docks.h). The main window gives it each snapshot and acts on what it asks for. How a person arranged
// the docks is theirs: saved as a versioned state, and put back to the first arrangement by resetLayout().
#pragma once

#include <QMainWindow>
#include <optional>
#include <vector>

#include "base/time.h"
#include "control/intent.h"
#include "control/simulator_control.h"
#include "docks.h"
#include "session/snapshot.h"

class QSettings;
class QTabWidget;

namespace deckpipe {

class DockTitle;
class EventPanel;
class HelpPanel;
class DevicePage;
class RequestPanel;
class TracePanel;

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
  const DeviceLabels& labels() const { return m_view.labels; }
  // The device that all panels show; null if none is chosen.
  const DeviceKey& device() const { return m_view.device; }
  QMenu* createPopupMenu() override;
  // A small screen's: what stands in a smaller place is squeezed, the window never grows for it.
  QSize minimumSizeHint() const override { return {640, 240}; }
  void resetLayout();
  bool hasDial() const;
  // Whether the trace can be filtered down to the chosen device.
  bool canTraceDevice() const;
  // Open the trace: to look for a frame in it, or at the line of its filter.
  void findInTrace();
  void filterTrace();
  // The chosen device's dial over the whole window, and back.
  void toggleFullDial();
  // Opens the dock where the chosen device is asked.
  void showRequests();
  // Asks the chosen device every poll that it takes, once sending is unlocked, and shows the answers.
  void askAll();
  bool canAskAll() const;
  // Pages of the middle, with the focus.
  void showDevicePage();
  void showOverview();
  // Opens the dock that takes the looked at frame apart.
  void showDetail();
  // Opens the dock that explains what has the focus.
  void showHelp();
  void saveTo(QSettings& settings) const;
  void restoreFrom(const QSettings& settings);

 Q_SIGNALS:
  // The cursor is wanted behind that frame: it has happened then.
  void frameRequested(std::uint64_t frame);
  void seekRequested(deckpipe::Instant time);
  void intended(const deckpipe::Intent& intent);
  void unlockRequested();
  void unlockForRequested(const std::function<void()>& then);
  void simulatorIntended(const deckpipe::SimulatorIntent& intent);
  // Every panel shows what is chosen now.
  void viewShown();
  void labelsChanged(const deckpipe::DeviceLabels& labels);
  // The person's own, after an edit.
  void labelsEdited(const deckpipe::DeviceLabels& labels);

 public Q_SLOTS:
  // Of the demo; its dock is there only while one runs.
  void setSimulator(const deckpipe::SimulatorStatus& status);
  // Panels ask for these.
  void selectDevice(const deckpipe::DeviceKey& key);
  void showPageOf(const deckpipe::DeviceKey& key);
  void showFrame(std::optional<std::uint64_t> frame);
  void editLabel(const deckpipe::Pin& pin, const QString& label);
  // Filters the trace down to the chosen device's frames, and shows it.
  void traceDevice();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void childEvent(QChildEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Dock {
    const DockRow* row;
    QDockWidget* dock;
    DockTitle* title;
    QAction* action;  // checked while the dock is seen
    Panel panel;
  };
  Dock makeDock(const DockRow& row);
  const Dock& dock(const char* id) const;
  void show(const Dock& dock);
  void open(const Dock& dock);
  void showPage(int index);
  void arrange();
  void shareRoom();
  // How the docks stand, in a workspace of which size.
  struct Arrangement {
    QByteArray docks;
    QSize size;
  };
  std::optional<Arrangement> arrangement() const;
  void settle();
  void setWaiting(bool isWaiting);
  void showDocksOfDemo();
  // Shows every panel the view as it is now.
  void showView();
  DeviceKey firstMonitor(const LogView& log) const;
  void showLabels();
  void readLabels(const LogView& view);
  QString nameOf(const DeviceKey& key) const;

  LabelStorage& m_labelStorage;
  DeviceLabels m_labels;         // the person's own
  std::size_t m_labelNotes = 0;  // notes of the log when its labels were read
  PanelView m_view;              // as shown; the one place that says what is chosen
  bool m_isShowing = false;      // showView() is under way
  QTabWidget* m_centre;
  std::vector<Panel> m_pages;  // of the middle
  std::vector<Dock> m_docks;   // in the order of their rows
  DevicePage* m_page;
  TracePanel* m_trace;
  EventPanel* m_events;
  HelpPanel* m_help;
  RequestPanel* m_requests;
  double m_fontSize = 0;
  bool m_isSettled = false;              // the docks have sizes: the first, or a person's
  std::optional<Arrangement> m_kept;     // of last time, or from when the workspace was hidden
  bool m_isWaiting = false;              // the one of last time, for the workspace to have its size
  QList<QDockWidget*> m_floatingHidden;  // hidden with the workspace, they come back with it
  const LogDocument* m_shown = nullptr;  // whose devices were chosen from
};

}  // namespace deckpipe
