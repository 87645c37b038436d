// SPDX-License-Identifier: GPL-3.0-or-later
#include "workspace.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QHideEvent>
#include <QSettings>
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
  m_shownLabels = m_labels;
  if (m_shown != nullptr) m_shownLabels.fillFrom(labelsIn(m_shown->notes));
  m_devices->setLabels(m_shownLabels);
  m_page->setLabels(m_shownLabels);
  m_overview->setLabels(m_shownLabels);
  m_requests->setLabels(m_shownLabels);
  m_events->setLabels(m_shownLabels);
  Q_EMIT labelsChanged(m_shownLabels);
}

void Workspace::readLabels(const LogView& view) {
  const std::size_t notes = view.document == nullptr ? 0 : view.document->notes.count();
  if (std::exchange(m_labelNotes, notes) == notes && m_shown == view.document.get()) return;
  m_shown = view.document.get();
  DeviceLabels labels = m_labels;
  if (m_shown != nullptr) labels.fillFrom(labelsIn(m_shown->notes));
  if (labels != m_shownLabels) showLabels();
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
  const bool isOther = m_shown != view.document.get();
  readLabels(view);
  if (isOther) {
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
  const QString label = m_shownLabels.of(key);
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
