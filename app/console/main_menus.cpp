// SPDX-License-Identifier: GPL-3.0-or-later
// The main window's menus: what they are called, their keys, and what each calls.
#include <QActionGroup>
#include <QCoreApplication>
#include <QFileInfo>
#include <QMenuBar>
#include <QStackedWidget>
#include <QWhatsThis>
#include <algorithm>
#include <utility>

#include "kept_settings.h"
#include "main_window.h"
#include "mark_bar.h"
#include "pane_cycle.h"
#include "panel/common/build.h"
#include "panel/common/settings_page.h"
#include "panel/events/event_panel.h"
#include "panel/play/transport_bar.h"
#include "panel/trace/trace_panel.h"
#include "sending_actions.h"
#include "workspace.h"

namespace deckpipe {
namespace {

constexpr qsizetype kLogsInMenu = 5;

}  // namespace

void MainWindow::makeMenus() {
  makeFileMenu();
  m_menus->addMenu(m_sending->menu());
  m_sending->menu()->addSeparator();
  m_workActions << addNamed(m_sending->menu(), "askDeviceAction", tr("Ask the chosen &device…"),
                            QKeySequence(Qt::CTRL | Qt::Key_R), m_workspace, &Workspace::showRequests);
  m_askAllAction = addNamed(m_sending->menu(), "askAllAction", tr("Ask the chosen device &everything"),
                            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R), m_workspace, &Workspace::askAll);
  makeViewMenu();
  makeReplayMenu();
  makeTraceMenu();
  makeEventsMenu();
  makeHelpMenu();
  // Why something cannot be done now stands in its tip.
  for (QMenu* menu : m_menus->findChildren<QMenu*>()) menu->setToolTipsVisible(true);
  m_sending->menu()->setToolTipsVisible(true);
}

void MainWindow::makeFileMenu() {
  QMenu* menu = m_menus->addMenu(tr("&File"));
  addNamed(menu, "openLogAction", tr("&Open log…"), QKeySequence::Open, this, &MainWindow::openLogByHand);
  m_recentMenu = new QActionGroup(menu);
  QAction* behindRecent = menu->addSeparator();
  connect(menu, &QMenu::aboutToShow, this,
          [this, menu, behindRecent] { listRecentLogs(*menu, behindRecent); });
  m_frameActions << addNamed(menu, "saveLogAction", tr("&Save log as…"), QKeySequence::Save, this,
                             &MainWindow::saveLogByHand);
  TracePanel* trace = m_workspace->trace();
  QAction* selection = addNamed(menu, "saveSelectionAction", tr("Save the trace's se&lection…"), trace,
                                &TracePanel::saveSelection);
  QAction* shown = addNamed(menu, "saveShownAction", tr("Save all that &passes the trace's filter…"), trace,
                            &TracePanel::saveShown);
  connect(menu, &QMenu::aboutToShow, this, [this, trace, selection, shown] {
    const QString none = m_frameActions.first()->isEnabled() ? QString() : tr("There are no frames.");
    offer(*selection,
          !none.isEmpty() || trace->hasSelection() ? none : tr("No rows of the trace are selected."));
    offer(*shown, !none.isEmpty() || trace->isFiltered() ? none : tr("The trace has no filter."));
  });
  addNamed(menu, "recordingsAction", tr("&Recordings"), this, &MainWindow::showRecordings);
  menu->addSeparator();
  m_frameActions << addNamed(menu, "markAction", tr("&Mark this place…"), QKeySequence(Qt::CTRL | Qt::Key_M),
                             this, [this] { m_markBar->open(m_snapshot.view); });
  menu->addSeparator();
  addNamed(menu, "demoAction", tr("Start the simulated &truck"), this, &MainWindow::openDemo);
  m_closeAction =
      addNamed(menu, "closeAction", tr("&Close"), QKeySequence::Close, this, &MainWindow::closeSource);
  menu->addSeparator();
  addNamed(menu, "quitAction", tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);
}

// By number: Alt+F, 1 opens the log of last time.
void MainWindow::listRecentLogs(QMenu& menu, QAction* before) {
  qDeleteAll(m_recentMenu->actions());
  const QStringList paths = recentLogs();
  for (qsizetype i = 0; i < std::min(kLogsInMenu, paths.size()); ++i) {
    const QFileInfo file(paths[i]);
    QString name = file.fileName();
    name.replace(u'&', QLatin1String("&&"));
    auto* action = new QAction(tr("&%1 %2", "number and name of a log").arg(i + 1).arg(name), m_recentMenu);
    action->setObjectName(QStringLiteral("recentLogAction%1").arg(i + 1));
    action->setWhatsThis(paths[i]);
    offer(*action, file.exists() ? QString() : tr("%1\nis no longer there").arg(paths[i]));
    connect(action, &QAction::triggered, this, [this, path = paths[i]] { openLog(path); });
    menu.insertAction(before, action);
  }
}

void MainWindow::makeViewMenu() {
  QMenu* menu = m_menus->addMenu(tr("&View"));
  m_themes = new QActionGroup(this);
  for (const NamedTheme& theme : namedThemes()) {
    QAction* action = addNamed(menu, (QByteArray(theme.key) + "ThemeAction").constData(),
                               QCoreApplication::translate("Appearance", theme.text), this,
                               [this, chosen = theme.theme] { setTheme(chosen); });
    action->setCheckable(true);
    action->setData(static_cast<int>(theme.theme));
    m_themes->addAction(action);
  }
  menu->addSeparator();
  m_fieldAction = addNamed(menu, "fieldDensityAction", tr("&Field size, for gloves"), this,
                           [this](bool isOn) { setDensity(isOn ? Density::Field : Density::Desk); });
  m_fieldAction->setCheckable(true);
  menu->addSeparator();
  menu->addActions(m_workspace->dockActions());
  m_workActions << m_workspace->dockActions();
  m_workActions << addNamed(menu, "devicePageAction", tr("Device pa&ge"), QKeySequence(Qt::ALT | Qt::Key_9),
                            m_workspace, &Workspace::showDevicePage)
                << addNamed(menu, "overviewAction", tr("&All monitors"), QKeySequence(Qt::ALT | Qt::Key_0),
                            m_workspace, &Workspace::showOverview);
  menu->addSeparator();
  m_dialAction = addNamed(menu, "fullDialAction", tr("Large &dial"), QKeySequence(Qt::Key_F11), m_workspace,
                          &Workspace::toggleFullDial);
  menu->addSeparator();
  addNamed(menu, "nextPaneAction", tr("&Next pane"), QKeySequence(Qt::Key_F6), this,
           [this] { focusNextPane(panes(), false); });
  addNamed(menu, "previousPaneAction", tr("&Previous pane"), QKeySequence(Qt::SHIFT | Qt::Key_F6), this,
           [this] { focusNextPane(panes(), true); });
  m_workActions << addNamed(menu, "resetLayoutAction", tr("&Reset layout"), m_workspace,
                            &Workspace::resetLayout);
  menu->addSeparator();
  addNamed(menu, "settingsAction", tr("S&ettings"), QKeySequence(Qt::CTRL | Qt::Key_Comma), this,
           [this] { showExtra(m_settings); });
}

void MainWindow::makeReplayMenu() {
  QMenu* menu = m_menus->addMenu(tr("&Replay"));
  m_replay = new QActionGroup(this);
  m_replay->setExclusive(false);
  TransportBar* bar = m_transport;
  const auto add = [&](const char* name, const QString& text, const QKeySequence& key, auto what) {
    QAction* action = addNamed(menu, name, text, key, bar, what);
    m_replay->addAction(action);
    return action;
  };
  add("playAction", tr("&Play or pause"), QKeySequence(Qt::CTRL | Qt::Key_P), &TransportBar::playOrPause);
  add("fasterAction", tr("&Faster"), QKeySequence(Qt::CTRL | Qt::Key_Up), [bar] { bar->changeSpeed(1); });
  add("slowerAction", tr("Slo&wer"), QKeySequence(Qt::CTRL | Qt::Key_Down), [bar] { bar->changeSpeed(-1); });
  QAction* loop = add("loopAction", tr("Play the &selection again and again"),
                      QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P), &TransportBar::toggleLoop);
  QAction* silences = add("silencesAction", tr("S&kip silences"), {},
                          [bar] { Q_EMIT bar->silencesRequested(!bar->playState().skipsSilences); });
  menu->addSeparator();
  add("typeTimeAction", tr("&Go to a time…"), QKeySequence(Qt::CTRL | Qt::Key_G), &TransportBar::typeTime);
  for (QAction* toggle : {loop, silences}) toggle->setCheckable(true);
  connect(menu, &QMenu::aboutToShow, this, [this, bar, loop, silences] {
    loop->setEnabled(m_replay->isEnabled() && bar->canLoop());
    loop->setChecked(bar->playState().isLooping);
    silences->setChecked(bar->playState().skipsSilences);
  });
  // A key works also after the menu was seen without a selection.
  connect(menu, &QMenu::aboutToHide, this, [this, loop] { loop->setEnabled(m_replay->isEnabled()); });
}

void MainWindow::makeTraceMenu() {
  QMenu* menu = m_menus->addMenu(tr("&Trace"));
  m_findAction =
      addNamed(menu, "findAction", tr("&Find…"), QKeySequence::Find, m_workspace, &Workspace::findInTrace);
  // Written here; other panes have the same key for what they find.
  m_findAction->setShortcutContext(Qt::WidgetShortcut);
  m_workActions << m_findAction
                << addNamed(menu, "filterAction", tr("Show &only…"),
                            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F), m_workspace,
                            &Workspace::filterTrace);
  m_traceDeviceAction = addNamed(menu, "traceDeviceAction", tr("Only &this device"),
                                 QKeySequence(Qt::CTRL | Qt::Key_T), m_workspace, &Workspace::traceDevice);
}

void MainWindow::makeEventsMenu() {
  QMenu* menu = m_menus->addMenu(tr("&Events"));
  EventPanel* events = m_workspace->events();
  m_eventActions << addNamed(menu, "nextEventAction", tr("&Next event"), QKeySequence(Qt::Key_F8), events,
                             &EventPanel::goToNext)
                 << addNamed(menu, "previousEventAction", tr("&Previous event"),
                             QKeySequence(Qt::SHIFT | Qt::Key_F8), events, &EventPanel::goToPrevious)
                 << addNamed(menu, "beforeEventAction", tr("&Five seconds before this event"),
                             QKeySequence(Qt::Key_F9), events, &EventPanel::goBefore)
                 << addNamed(menu, "nextFaultAction", tr("Next f&ault"), QKeySequence(Qt::CTRL | Qt::Key_F8),
                             events, &EventPanel::goToNextFault)
                 << addNamed(menu, "previousFaultAction", tr("P&revious fault"),
                             QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F8), events,
                             &EventPanel::goToPreviousFault);
}

void MainWindow::offerActions() {
  const bool isWorkSeen = m_pages->currentWidget() == m_workspace;
  const QString noFrames = m_snapshot.view.frameCount > 0 ? QString() : tr("There are no frames.");
  for (QAction* action : std::as_const(m_frameActions)) offer(*action, noFrames);
  const bool isOpen = m_snapshot.view.document != nullptr;
  offer(*m_closeAction, isOpen ? QString() : tr("Nothing is open."));
  const QString notSeen = isWorkSeen ? QString()
                          : isOpen   ? tr("Another page is in the place of the work.")
                                     : tr("Nothing is open.");
  for (QAction* action : std::as_const(m_workActions)) offer(*action, notSeen);
  const auto ifSeen = [&](QAction* action, bool canBe, const QString& whyNot) {
    offer(*action, !notSeen.isEmpty() || canBe ? notSeen : whyNot);
  };
  ifSeen(m_dialAction, m_workspace->hasDial(), tr("The chosen device has no dial."));
  ifSeen(m_askAllAction, m_workspace->canAskAll(),
         tr("The chosen device cannot be asked now: the requests say why."));
  ifSeen(m_traceDeviceAction, m_workspace->canTraceDevice(), tr("No device with an address is chosen."));
  for (QAction* action : std::as_const(m_eventActions))
    ifSeen(action, m_workspace->events()->hasEvents(), tr("Nothing happened so far."));
}

void MainWindow::makeHelpMenu() {
  QMenu* menu = m_menus->addMenu(tr("&Help"));
  m_workActions << addNamed(menu, "explainAction", tr("&Explain what has the focus"),
                            QKeySequence::HelpContents, m_workspace, &Workspace::showHelp);
  QAction* pointed = QWhatsThis::createAction(this);  // Shift+F1, then a click
  pointed->setText(tr("Explain what is &pointed at"));
  pointed->setIcon({});
  pointed->setObjectName(QStringLiteral("whatsThisAction"));
  menu->addAction(pointed);
  addNamed(menu, "aboutAction", tr("&About Deckpipe"), this, [this] { showExtra(m_about); });
}

}  // namespace deckpipe
