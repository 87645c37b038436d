// SPDX-License-Identifier: GPL-3.0-or-later
#include "workspace.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QHideEvent>
#include <QScopedValueRollback>
#include <QSettings>
#include <QTabWidget>
#include <QTimer>
#include <utility>

#include "model/device_rows.h"
#include "pane_cycle.h"
#include "panel/common/build.h"
#include "panel/common/help_panel.h"
#include "panel/common/simulator_panel.h"
#include "panel/events/event_panel.h"
#include "panel/page/device_page.h"
#include "panel/poll/request_panel.h"
#include "panel/trace/decode_panel.h"
#include "panel/trace/trace_panel.h"

namespace deckpipe {
namespace {

const QString kDocksKey = QStringLiteral("window/docks"), kSizeKey = QStringLiteral("window/docksSize"),
              kPageKey = QStringLiteral("window/page"), kFrameBitsKey = QStringLiteral("window/frameBits");

}  // namespace

Workspace::Workspace(LabelStorage& labels, QWidget* parent)
    : QMainWindow(parent), m_labelStorage(labels), m_labels(labels.read()) {
  setObjectName(QStringLiteral("workspace"));
  setWindowFlags(Qt::Widget);  // QMainWindow makes itself a window, whatever it is told
  setDockOptions(AllowNestedDocks | AllowTabbedDocks | AnimatedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  // The device list keeps its height beside the page; trace and events have the whole width.
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);  // what is asked needs the height

  m_centre = named(new QTabWidget(this), "centreTabs", tr("Pages"));
  m_centre->setDocumentMode(true);
  m_centre->setTabBarAutoHide(true);
  m_pages = {makeDevicePage(*this), makeOverview(*this)};
  m_centre->addTab(m_pages[0].widget, tr("Device"));
  m_centre->addTab(m_pages[1].widget, tr("All monitors"));
  setCentralWidget(m_centre);
  for (const DockRow& row : dockRows()) m_docks.push_back(makeDock(row));
  m_page = findChild<DevicePage*>();
  m_page->setStage(this);  // what tells past from present and locked from unlocked stays in sight
  m_trace = findChild<TracePanel*>();
  m_events = findChild<EventPanel*>();
  m_help = findChild<HelpPanel*>();
  m_requests = findChild<RequestPanel*>();
  arrange();

  // What is in the explanation itself is not explained.
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (now != nullptr && now->window() == window() && !dock(kHelpDock).dock->isAncestorOf(now))
      m_help->explain(now);
  });
  m_view.labels = m_labels;
}

// While it is shown the view, the list of devices may choose the same device under the PIN that it has said
// now. The panels that are shown the view after it know that.
void Workspace::showView() {
  const QScopedValueRollback showing(m_isShowing, true);
  m_view.name = nameOf(m_view.device);
  for (const Dock& dock : m_docks) dock.panel.show(m_view);
  for (const Panel& page : m_pages) page.show(m_view);
  Q_EMIT viewShown();
}

void Workspace::selectDevice(const DeviceKey& key) {
  m_view.device = key;
  m_view.name = nameOf(key);
  if (!m_isShowing) showView();
}

void Workspace::showPageOf(const DeviceKey& key) {
  selectDevice(key);
  m_centre->setCurrentWidget(m_page);
  m_page->setFocus();
}

void Workspace::editLabel(const Pin& pin, const QString& label) {
  if (!m_labels.set(pin, label)) return;
  m_labelStorage.write(m_labels);
  Q_EMIT labelsEdited(m_labels);
  showLabels();
}

void Workspace::showLabels() {
  m_view.labels = m_labels;
  if (m_shown != nullptr) m_view.labels.fillFrom(labelsIn(m_shown->notes));
  if (!m_isShowing) showView();
  Q_EMIT labelsChanged(m_view.labels);
}

void Workspace::readLabels(const LogView& view) {
  const std::size_t notes = view.document == nullptr ? 0 : view.document->notes.count();
  if (std::exchange(m_labelNotes, notes) == notes && m_shown == view.document.get()) return;
  m_shown = view.document.get();
  DeviceLabels labels = m_labels;
  if (m_shown != nullptr) labels.fillFrom(labelsIn(m_shown->notes));
  if (labels == m_view.labels) return;
  m_view.labels = labels;
  Q_EMIT labelsChanged(m_view.labels);
}

void Workspace::toggleFullDial() {
  m_centre->setCurrentWidget(m_page);
  m_page->toggleFull();
}

void Workspace::traceDevice() {
  const QString expression = m_page->traceFilter();
  if (expression.isEmpty()) return;
  m_trace->setFilter(expression);
  show(dock(kTraceDock));
}

bool Workspace::hasDial() const { return m_page->hasDial(); }

bool Workspace::canTraceDevice() const { return !m_page->traceFilter().isEmpty(); }

void Workspace::findInTrace() {
  show(dock(kTraceDock));
  m_trace->find();
}

void Workspace::filterTrace() {
  show(dock(kTraceDock));
  m_trace->goToFilter();
}

void Workspace::showRequests() { open(dock(kRequestsDock)); }

void Workspace::askAll() {
  show(dock(kRequestsDock));
  m_requests->askAll();
}

bool Workspace::canAskAll() const { return m_requests->canAskAll(); }

void Workspace::showDevicePage() { showPage(0); }

void Workspace::showOverview() { showPage(1); }

void Workspace::showPage(int index) {
  if (m_page->full() != nullptr) m_page->toggleFull();
  m_centre->setCurrentIndex(index);
  focusNextPane({m_centre->currentWidget()}, false);
}

void Workspace::showDetail() { show(dock(kDecodeDock)); }

void Workspace::showHelp() {
  if (m_page->full() != nullptr) m_page->toggleFull();
  m_help->explain(QApplication::focusWidget());
  show(dock(kHelpDock));
}

void Workspace::setSnapshot(const Snapshot& snapshot) {
  const bool isOther = m_shown != snapshot.view.document.get();
  m_view.log = snapshot.view;
  m_view.services = snapshot.services;
  m_view.isLive = snapshot.view.atEnd && snapshot.source.kind == SourceStatus::Kind::Link;
  m_view.isMoving = snapshot.view.atEnd || snapshot.playing;
  m_view.isSimulated = snapshot.source.simulated;
  readLabels(snapshot.view);
  if (isOther) {
    m_view.device = {};
    m_trace->setCurrentFrame({});
    showFrame({});
  }
  // Until a person chooses, the first monitor that is heard is looked at.
  if (m_view.device.isNull()) m_view.device = firstMonitor(m_view.log);
  showView();
  showDocksOfDemo();
}

void Workspace::showDocksOfDemo() {
  for (const Dock& dock : m_docks) {
    if (!dock.row->isOfDemo) continue;
    dock.action->setVisible(m_view.isSimulated);
    if (!m_view.isSimulated) dock.dock->hide();
  }
}

QString Workspace::nameOf(const DeviceKey& key) const {
  if (key.isNull()) return {};
  const QString label = m_view.labels.of(key);
  return label.isEmpty() ? keyText(key) : tr("%1 (%2)").arg(label, keyText(key));
}

void Workspace::setSimulator(const SimulatorStatus& status) {
  findChild<SimulatorPanel*>()->setStatus(status);
}

DeviceKey Workspace::firstMonitor(const LogView& log) const {
  for (const DeviceRow& row : deviceRows(*log.state)) {
    if (row.group == DeviceGroup::Monitors) return row.key;
  }
  return {};
}

// Docks that were never laid out have no sizes to be saved.
std::optional<Workspace::Arrangement> Workspace::arrangement() const {
  if (!isVisible() || m_isWaiting) return m_kept;
  return Arrangement{saveState(layoutVersion()), size()};
}

void Workspace::saveTo(QSettings& settings) const {
  if (const auto now = arrangement()) {
    settings.setValue(kDocksKey, now->docks);
    settings.setValue(kSizeKey, now->size);
  } else {
    settings.remove(kDocksKey);
  }
  settings.setValue(kPageKey, m_centre->currentIndex());
  settings.setValue(QStringLiteral("window/trace"), m_trace->saveState());
  settings.setValue(kFrameBitsKey, findChild<DecodePanel*>()->areBitsShown());
}

void Workspace::restoreFrom(const QSettings& settings) {
  const QByteArray docks = settings.value(kDocksKey).toByteArray();
  if (!docks.isEmpty()) {
    m_kept = Arrangement{docks, settings.value(kSizeKey).toSize()};
    setWaiting(true);
    m_isSettled = false;
  }
  m_centre->setCurrentIndex(settings.value(kPageKey, 0).toInt());
  m_trace->restoreState(settings.value(QStringLiteral("window/trace")).toByteArray());
  findChild<DecodePanel*>()->showBits(settings.value(kFrameBitsKey, false).toBool());
}

// An arrangement means something only to a workspace of the size that it was made for: in another one docks are
// squeezed, and what they lost goes to their neighbours. So the one of last time waits for that size, which
// comes late where the window is maximised; until a person acts, from when on the docks are as they are.
void Workspace::setWaiting(bool isWaiting) {
  if (std::exchange(m_isWaiting, isWaiting) == isWaiting) return;
  if (isWaiting) {
    qApp->installEventFilter(this);
  } else {
    qApp->removeEventFilter(this);
  }
}

void Workspace::settle() {
  m_fontSize = QApplication::font().pointSizeF();
  if (m_isWaiting && !restoreState(m_kept->docks, layoutVersion())) setWaiting(false);
  if (m_isWaiting) {
    showDocksOfDemo();
  } else {
    shareRoom();
  }
}

// Floating docks are windows of their own and would stay when the workspace makes room for another page.
void Workspace::hideEvent(QHideEvent* event) {
  QMainWindow::hideEvent(event);
  if (event->spontaneous()) return;
  if (m_isSettled && !m_isWaiting) m_kept = Arrangement{saveState(layoutVersion()), size()};
  for (const Dock& each : m_docks) {
    if (!each.dock->isFloating() || each.dock->isHidden()) continue;
    each.dock->hide();
    m_floatingHidden.append(each.dock);
  }
}

void Workspace::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (!m_isSettled) {
    settle();
    // Again with the letters of a look that was just set: they come by events of their own.
    QTimer::singleShot(0, this, [this] {
      if (!isVisible() || std::exchange(m_isSettled, true)) return;
      settle();
      if (m_isWaiting && size() == m_kept->size) setWaiting(false);
    });
  }
  for (QDockWidget* dock : std::exchange(m_floatingHidden, {})) dock->show();
}

void Workspace::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  if (!m_isWaiting || !m_isSettled) return;
  // Not at once: restoring may resize the workspace again, and Qt loses what it held where it restores inside of
  // restoring.
  QTimer::singleShot(0, this, [this] {
    if (!m_isWaiting || !isVisible()) return;
    settle();
    if (size() == m_kept->size) setWaiting(false);
  });
}

// Larger letters need wider docks; what a person chose is kept in proportion. Widgets get new letters some turns
// after the application has them.
void Workspace::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  const double before = std::exchange(m_fontSize, QApplication::font().pointSizeF());
  if (before <= 0 || before == m_fontSize || !m_isSettled || m_isWaiting) return;
  QDockWidget* devices = dock(kDevicesDock).dock;
  if (!devices->isFloating())
    resizeDocks({devices}, {static_cast<int>(devices->width() * m_fontSize / before)}, Qt::Horizontal);
}

bool Workspace::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::KeyPress) setWaiting(false);
  return QMainWindow::eventFilter(watched, event);
}

}  // namespace deckpipe
