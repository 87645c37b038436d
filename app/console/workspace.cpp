// SPDX-License-Identifier: GPL-3.0-or-later
#include "workspace.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QHideEvent>
#include <QMenu>
#include <QSettings>
#include <QTabBar>
#include <QTabWidget>
#include <algorithm>
#include <utility>

#include "model/decode_model.h"
#include "model/device_rows.h"
#include "pane_cycle.h"
#include "panel/decode_panel.h"
#include "panel/device_panel.h"
#include "panel/dock_title.h"
#include "panel/event_panel.h"
#include "panel/help_panel.h"
#include "panel/monitor_page.h"
#include "panel/overview_panel.h"
#include "panel/request_panel.h"
#include "panel/terminal_panel.h"
#include "panel/trace_panel.h"
#include "panel/twin_panel.h"

namespace deckpipe {
namespace {

// Counted up when docks are added or renamed: an arrangement of another version is not taken.
constexpr int kLayoutVersion = 3;
// A look at so many frames a tick takes about two milliseconds.
constexpr std::uint64_t kFramesAtOnce = 100'000;
constexpr int kDevicesLetters = 56;
constexpr int kDetailWidth = 520, kTraceHeight = 208;

}  // namespace

Workspace::Workspace(LabelStorage& labels, QWidget* parent)
    : QMainWindow(parent),
      m_labelStorage(labels),
      m_labels(labels.read()),
      m_decodeModel(new DecodeModel(this)) {
  setObjectName(QStringLiteral("workspace"));
  setWindowFlags(Qt::Widget);  // QMainWindow makes itself a window, whatever it is told
  setDockOptions(AllowNestedDocks | AllowTabbedDocks | AnimatedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  // The device list keeps its height beside the page; trace and events have the whole width.
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);  // what is asked needs the height

  m_devices = new DevicePanel(this);
  m_page = new MonitorPage(this);
  m_page->setStage(this);  // what tells past from present and locked from unlocked stays in sight
  m_overview = new OverviewPanel(this);
  m_trace = new TracePanel(this);
  m_decode = new DecodePanel(this);
  m_decode->setModel(m_decodeModel);
  m_events = new EventPanel(this);
  m_requests = new RequestPanel(this);
  m_terminal = new TerminalPanel(this);
  m_twin = new TwinPanel(this);

  m_centre = new QTabWidget(this);
  m_centre->setObjectName(QStringLiteral("centreTabs"));
  m_centre->setAccessibleName(tr("Pages"));
  m_centre->setDocumentMode(true);
  m_centre->setTabBarAutoHide(true);
  m_centre->addTab(m_page, tr("Device"));
  m_centre->addTab(m_overview, tr("All monitors"));
  setCentralWidget(m_centre);
  m_devicesDock = makeDock("devicesDock", tr("Devices"), m_devices);
  m_traceDock = makeDock("traceDock", tr("Trace"), m_trace);
  m_eventsDock = makeDock("eventsDock", tr("Events"), m_events);
  m_decodeDock = makeDock("decodeDock", tr("Frame in detail"), m_decode);
  m_requestsDock = makeDock("requestsDock", tr("Ask"), m_requests);
  m_terminalDock = makeDock("terminalDock", tr("Data pipe"), m_terminal);
  m_twinDock = makeDock("twinDock", tr("Simulated truck"), m_twin);
  m_help = new HelpPanel(this);
  m_helpDock = makeDock("helpDock", tr("Explanation"), m_help);
  arrange();

  // What is in the explanation itself is not explained.
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (now != nullptr && now->window() == window() && !m_helpDock->isAncestorOf(now)) m_help->explain(now);
  });
  // Only a person closes a dock; that it is hidden while there is nothing to show is no wish of theirs.
  m_decodeDock->installEventFilter(this);
  connect(m_actions.value(m_decodeDock), &QAction::triggered, this,
          [this](bool isOn) { m_decodeWanted = isOn; });
  connect(m_devices, &DevicePanel::deviceSelected, m_page, &MonitorPage::setDevice);
  connect(m_devices, &DevicePanel::deviceSelected, m_overview, &OverviewPanel::setDevice);
  connect(m_page, &MonitorPage::traceRequested, this, &Workspace::traceDevice);
  connect(m_devices, &DevicePanel::labelEdited, this, &Workspace::editLabel);
  connect(m_overview, &OverviewPanel::deviceRequested, this, &Workspace::showPageOf);
  connect(m_trace, &TracePanel::currentFrameChanged, this, &Workspace::showFrame);
  connect(m_trace, &TracePanel::cursorRequested, this, &Workspace::frameRequested);
  connect(m_events, &EventPanel::seekRequested, this, &Workspace::seekRequested);
  connect(m_requests, &RequestPanel::wished, this, &Workspace::wished);
  connect(m_requests, &RequestPanel::unlockRequested, this, &Workspace::unlockRequested);
  connect(m_requests, &RequestPanel::frameRequested, this, &Workspace::frameRequested);
  connect(m_terminal, &TerminalPanel::wished, this, &Workspace::wished);
  connect(m_terminal, &TerminalPanel::unlockRequested, this, &Workspace::unlockRequested);
  connect(m_twin, &TwinPanel::wished, this, &Workspace::twinWished);
  showLabels();
}

void Workspace::showPageOf(const DeviceKey& key) {
  m_devices->selectDevice(key);
  m_centre->setCurrentWidget(m_page);
  m_page->setFocus();
}

void Workspace::editLabel(const Pin& pin, const QString& label) {
  if (!m_labels.set(pin, label)) return;
  m_labelStorage.write(m_labels);
  showLabels();
}

void Workspace::showLabels() {
  m_devices->setLabels(m_labels);
  m_page->setLabels(m_labels);
  m_overview->setLabels(m_labels);
  m_requests->setLabels(m_labels);
}

QDockWidget* Workspace::makeDock(const char* name, const QString& title, QWidget* content) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(QLatin1String(name));
  dock->setWidget(content);
  m_titles.append(new DockTitle(dock));
  // Checked while it is seen: Qt's own action hides what lies behind another's tab.
  auto* action = new QAction(title, dock);
  action->setObjectName(QLatin1String(name) + QStringLiteral("Action"));
  action->setCheckable(true);
  connect(dock, &QDockWidget::visibilityChanged, action, &QAction::setChecked);
  connect(action, &QAction::triggered, dock, [dock](bool isOn) {
    if (!isOn) {
      dock->close();
      return;
    }
    dock->show();
    dock->raise();
  });
  m_actions.insert(dock, action);
  return dock;
}

void Workspace::arrange() {
  for (QDockWidget* dock : docks()) {
    dock->setFloating(false);
    removeDockWidget(dock);
  }
  addDockWidget(Qt::LeftDockWidgetArea, m_devicesDock);
  addDockWidget(Qt::BottomDockWidgetArea, m_traceDock);
  splitDockWidget(m_traceDock, m_decodeDock, Qt::Horizontal);
  tabifyDockWidget(m_traceDock, m_eventsDock);
  tabifyDockWidget(m_eventsDock, m_terminalDock);
  addDockWidget(Qt::RightDockWidgetArea, m_requestsDock);
  tabifyDockWidget(m_requestsDock, m_twinDock);
  addDockWidget(Qt::RightDockWidgetArea, m_helpDock);
  m_helpDock->hide();
  m_devicesDock->show();
  m_eventsDock->show();
  m_terminalDock->show();
  m_traceDock->show();
  m_traceDock->raise();
  m_requestsDock->hide();  // the page has the room until somebody wants to ask
  m_twinDock->hide();
  m_decodeDock->setVisible(m_decodeModel->frame().has_value());
  shareRoom();
}

// Sizes mean something to docks only once they are laid out.
void Workspace::shareRoom() {
  m_hasShared = isVisible();
  if (!m_hasShared) return;
  resizeDocks({m_devicesDock}, {kDevicesLetters * fontMetrics().averageCharWidth()}, Qt::Horizontal);
  resizeDocks({m_traceDock, m_decodeDock}, {width() - kDetailWidth, kDetailWidth}, Qt::Horizontal);
  resizeDocks({m_traceDock}, {kTraceHeight}, Qt::Vertical);
}

void Workspace::resetLayout() {
  m_decodeWanted = true;
  arrange();
}

void Workspace::toggleFullDial() {
  m_centre->setCurrentWidget(m_page);
  m_page->toggleFull();
}

void Workspace::traceDevice() {
  const QString expression = m_page->traceFilter();
  if (expression.isEmpty()) return;
  m_trace->setFilter(expression);
  m_traceDock->show();
  m_traceDock->raise();
}

void Workspace::showRequests() {
  m_requestsDock->show();
  m_requestsDock->raise();
  focusNextPane({m_requestsDock}, false);
}

void Workspace::showHelp() {
  if (m_page->full() != nullptr) m_page->toggleFull();
  m_help->explain(QApplication::focusWidget());
  m_helpDock->show();
  m_helpDock->raise();
}

void Workspace::setSnapshot(const Snapshot& snapshot) {
  const LogView& view = snapshot.view;
  if (m_shown != view.document.get()) {
    m_shown = view.document.get();
    m_talk.reset();
    m_devices->selectDevice({});
    m_page->setDevice({});
    m_trace->setCurrentFrame({});
    showFrame({});
  }
  m_devices->setView(view);
  chooseFirstMonitor(view);
  m_page->setView(view);
  m_page->setAnimated(view.atEnd || snapshot.playing);
  m_overview->setView(view);
  m_overview->setAnimated(view.atEnd || snapshot.playing);
  m_trace->setView(view);
  m_events->setView(view);
  m_decodeModel->setView(view);
  setTalk(snapshot);
}

QString Workspace::nameOf(const DeviceKey& key) const {
  if (key.isNull()) return {};
  const QString label = m_labels.of(key);
  return label.isEmpty() ? keyText(key) : tr("%1 (%2)").arg(label, keyText(key));
}

void Workspace::setTalk(const Snapshot& snapshot) {
  const LogView& view = snapshot.view;
  if (m_talk == nullptr) m_talk = std::make_unique<Conversations>();
  if (view.document != nullptr) m_talk->take(*view.document, view.frameCount, kFramesAtOnce);
  const DeviceKey device = m_devices->selectedDevice();
  const bool isLive = view.atEnd && snapshot.source.kind == SourceStatus::Kind::Link;
  m_requests->setDevice(device, nameOf(device));
  m_requests->setView(view, *m_talk, *snapshot.services, isLive);
  m_terminal->setDevice(device, nameOf(device));
  m_terminal->setView(view, *m_talk, *snapshot.services, isLive);
  const bool isWaiting = std::ranges::any_of(snapshot.services->devices, [](const DeviceServices& at) {
    return at.pipe && at.pipe->progress == PipeStatus::Progress::Stalled;
  });
  const QString title = isWaiting ? tr("Data pipe – waits for you") : tr("Data pipe");
  if (m_terminalDock->windowTitle() != title) m_terminalDock->setWindowTitle(title);
  m_actions.value(m_twinDock)->setVisible(snapshot.source.simulated);
  if (!snapshot.source.simulated) m_twinDock->hide();
}

void Workspace::setTwin(const TwinStatus& status) { m_twin->setStatus(status); }

void Workspace::setColours(const Colours& colours) {
  m_devices->setColours(colours);
  m_page->setColours(colours);
  m_overview->setColours(colours);
  m_trace->setColours(colours);
  m_events->setColours(colours);
  m_decode->setColours(colours);
  m_requests->setColours(colours);
  m_terminal->setColours(colours);
  m_twin->setColours(colours);
  m_help->setColours(colours);
  for (DockTitle* title : m_titles) title->setColours(colours);
}

// The detail takes room from the trace only while there is a frame to show.
void Workspace::showFrame(std::optional<std::uint64_t> frame) {
  m_decodeModel->setFrame(frame);
  const int height = m_traceDock->height();
  m_decodeDock->setVisible(m_decodeWanted && frame.has_value());
  // A dock that was never seen would come as large as it likes; its sizes count once it is laid out.
  if (!m_decodeDock->isVisible() || std::exchange(m_hasDetailRoom, true)) return;
  QMetaObject::invokeMethod(
      this,
      [this, height] {
        resizeDocks({m_traceDock, m_decodeDock}, {width() - kDetailWidth, kDetailWidth}, Qt::Horizontal);
        resizeDocks({m_traceDock}, {height}, Qt::Vertical);
      },
      Qt::QueuedConnection);
}

// Until a person chooses, the first monitor that is heard is looked at.
void Workspace::chooseFirstMonitor(const LogView& view) {
  if (m_devices->selectedDevice() != DeviceKey{}) return;
  for (const DeviceRow& row : deviceRows(*view.state)) {
    if (row.group != DeviceGroup::Monitors) continue;
    m_devices->selectDevice(row.key);
    m_page->setDevice(row.key);
    return;
  }
}

QList<QDockWidget*> Workspace::docks() const {
  return {m_devicesDock, m_traceDock,    m_eventsDock, m_terminalDock,
          m_decodeDock,  m_requestsDock, m_twinDock,   m_helpDock};
}

QList<QAction*> Workspace::dockActions() const {
  QList<QAction*> actions;
  for (QDockWidget* dock : docks()) actions.append(m_actions.value(dock));
  return actions;
}

QMenu* Workspace::createPopupMenu() {
  auto* menu = new QMenu(this);
  menu->addActions(dockActions());
  return menu;
}

QList<QWidget*> Workspace::panes() const {
  QList<QWidget*> panes{m_devicesDock, m_centre,     m_requestsDock, m_twinDock,  m_helpDock,
                        m_traceDock,   m_eventsDock, m_terminalDock, m_decodeDock};
  // A dock behind another's tab is not hidden, but shows nothing.
  panes.removeIf([this](const QWidget* pane) {
    const QAction* action = m_actions.value(pane);
    return !pane->isVisible() || (action != nullptr && !action->isChecked());
  });
  return panes;
}

void Workspace::saveTo(QSettings& settings) const {
  settings.setValue(QStringLiteral("window/docks"), saveState(kLayoutVersion));
  settings.setValue(QStringLiteral("window/frameDetail"), m_decodeWanted);
  settings.setValue(QStringLiteral("window/trace"), m_trace->saveState());
}

void Workspace::restoreFrom(const QSettings& settings) {
  m_decodeWanted = settings.value(QStringLiteral("window/frameDetail"), true).toBool();
  if (restoreState(settings.value(QStringLiteral("window/docks")).toByteArray(), kLayoutVersion))
    m_hasShared = m_hasDetailRoom = true;
  m_trace->restoreState(settings.value(QStringLiteral("window/trace")).toByteArray());
  showFrame(m_decodeModel->frame());
}

// Floating docks are windows of their own and would stay when the workspace makes room for another page.
void Workspace::hideEvent(QHideEvent* event) {
  QMainWindow::hideEvent(event);
  if (event->spontaneous()) return;
  for (QDockWidget* dock : docks()) {
    if (!dock->isFloating() || dock->isHidden()) continue;
    dock->hide();
    m_floatingHidden.append(dock);
  }
}

void Workspace::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (!m_hasShared) shareRoom();
  for (QDockWidget* dock : std::exchange(m_floatingHidden, {})) dock->show();
}

// QMainWindow makes the tabs of docks by itself, without a name and without a menu.
void Workspace::childEvent(QChildEvent* event) {
  QMainWindow::childEvent(event);
  if (event->type() != QEvent::ChildPolished) return;
  auto* tabs = qobject_cast<QTabBar*>(event->child());
  if (tabs == nullptr) return;
  tabs->setAccessibleName(tr("Docks"));
  tabs->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(tabs, &QWidget::customContextMenuRequested, this, [this, tabs](QPoint at) {
    QMenu* menu = createPopupMenu();
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->popup(tabs->mapToGlobal(at));
  });
}

// Docks were put together or taken apart: nothing else tells.
bool Workspace::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) {
    for (DockTitle* title : m_titles) {
      auto* dock = qobject_cast<QDockWidget*>(title->parentWidget());
      const QList<QDockWidget*> others = tabifiedDockWidgets(dock);
      const bool isTabbed =
          std::ranges::any_of(others, [](QDockWidget* other) { return !other->isHidden(); });
      title->setCollapsed(isTabbed && !dock->isFloating());
    }
  }
  return QMainWindow::event(event);
}

// Larger letters need wider docks; what a person chose is kept in proportion.
void Workspace::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  const double before = std::exchange(m_fontSize, font().pointSizeF());
  if (before > 0 && m_hasShared && m_devicesDock != nullptr && !m_devicesDock->isFloating())
    resizeDocks({m_devicesDock}, {static_cast<int>(m_devicesDock->width() * m_fontSize / before)},
                Qt::Horizontal);
}

bool Workspace::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_decodeDock && event->type() == QEvent::Close) m_decodeWanted = false;
  return QMainWindow::eventFilter(watched, event);
}

}  // namespace deckpipe
