// SPDX-License-Identifier: GPL-3.0-or-later
// The main window's menus: what they are called, their keys, and what each calls.
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenuBar>
#include <QWhatsThis>

#include "kept_settings.h"
#include "main_window.h"
#include "mark_bar.h"
#include "pane_cycle.h"
#include "panel/common/settings_page.h"
#include "panel/events/event_panel.h"
#include "panel/trace/trace_panel.h"
#include "sending_actions.h"
#include "workspace.h"

namespace deckpipe {

QAction* MainWindow::named(QAction* action, const char* name) {
  action->setObjectName(QLatin1String(name));
  return action;
}

void MainWindow::makeMenus() {
  makeFileMenu();
  menuBar()->addMenu(m_sending->menu());
  m_sending->menu()->addSeparator();
  named(m_sending->menu()->addAction(tr("Ask the chosen &device…"), QKeySequence(Qt::CTRL | Qt::Key_R),
                                     m_workspace, &Workspace::showRequests),
        "askDeviceAction");
  makeViewMenu();
  makeEventsMenu();
  makeHelpMenu();
}

void MainWindow::makeFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  named(menu->addAction(tr("&Open log…"), QKeySequence::Open, this, &MainWindow::openLogByHand),
        "openLogAction");
  m_saveAction =
      named(menu->addAction(tr("&Save log as…"), QKeySequence::Save, this, &MainWindow::saveLogByHand),
            "saveLogAction");
  TracePanel* trace = m_workspace->trace();
  QAction* selection =
      named(menu->addAction(tr("Save the trace's se&lection…"), trace, &TracePanel::saveSelection),
            "saveSelectionAction");
  QAction* shown =
      named(menu->addAction(tr("Save all that &passes the trace's filter…"), trace, &TracePanel::saveShown),
            "saveShownAction");
  connect(menu, &QMenu::aboutToShow, this, [this, trace, selection, shown] {
    selection->setEnabled(m_saveAction->isEnabled() && trace->hasSelection());
    shown->setEnabled(m_saveAction->isEnabled() && trace->isFiltered());
  });
  named(menu->addAction(tr("&Recordings"), this, &MainWindow::showRecordings), "recordingsAction");
  menu->addSeparator();
  m_markAction = named(menu->addAction(tr("&Mark this place…"), QKeySequence(Qt::CTRL | Qt::Key_M), this,
                                       [this] { m_markBar->open(m_snapshot.view); }),
                       "markAction");
  menu->addSeparator();
  named(menu->addAction(tr("Start the simulated &truck"), this, &MainWindow::openDemo), "demoAction");
  named(menu->addAction(tr("&Close"), QKeySequence::Close, this, &MainWindow::closeSource), "closeAction");
  menu->addSeparator();
  named(menu->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close), "quitAction");
}

void MainWindow::makeViewMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  m_themes = new QActionGroup(this);
  for (const NamedTheme& theme : namedThemes()) {
    QAction* action = menu->addAction(QCoreApplication::translate("Appearance", theme.text), this,
                                      [this, chosen = theme.theme] { setTheme(chosen); });
    named(action, (QByteArray(theme.key) + "ThemeAction").constData());
    action->setCheckable(true);
    action->setData(static_cast<int>(theme.theme));
    m_themes->addAction(action);
  }
  menu->addSeparator();
  m_fieldAction = menu->addAction(tr("&Field size, for gloves"), this,
                                  [this](bool isOn) { setDensity(isOn ? Density::Field : Density::Desk); });
  named(m_fieldAction, "fieldDensityAction")->setCheckable(true);
  menu->addSeparator();
  menu->addActions(m_workspace->dockActions());
  menu->addSeparator();
  named(
      menu->addAction(tr("Large &dial"), QKeySequence(Qt::Key_F11), m_workspace, &Workspace::toggleFullDial),
      "fullDialAction");
  named(menu->addAction(tr("Only &this device in the trace"), QKeySequence(Qt::CTRL | Qt::Key_T), m_workspace,
                        &Workspace::traceDevice),
        "traceDeviceAction");
  menu->addSeparator();
  named(menu->addAction(tr("&Next pane"), QKeySequence(Qt::Key_F6), this,
                        [this] { focusNextPane(panes(), false); }),
        "nextPaneAction");
  named(menu->addAction(tr("&Previous pane"), QKeySequence(Qt::SHIFT | Qt::Key_F6), this,
                        [this] { focusNextPane(panes(), true); }),
        "previousPaneAction");
  named(menu->addAction(tr("&Reset layout"), m_workspace, &Workspace::resetLayout), "resetLayoutAction");
  menu->addSeparator();
  named(menu->addAction(tr("S&ettings"), QKeySequence(Qt::CTRL | Qt::Key_Comma), this,
                        [this] { showExtra(m_settings); }),
        "settingsAction");
}

void MainWindow::makeEventsMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Events"));
  EventPanel* events = m_workspace->events();
  named(menu->addAction(tr("&Next event"), QKeySequence(Qt::Key_F8), events, &EventPanel::goToNext),
        "nextEventAction");
  named(menu->addAction(tr("&Previous event"), QKeySequence(Qt::SHIFT | Qt::Key_F8), events,
                        &EventPanel::goToPrevious),
        "previousEventAction");
  named(menu->addAction(tr("&Five seconds before this event"), QKeySequence(Qt::Key_F9), events,
                        &EventPanel::goBefore),
        "beforeEventAction");
}

void MainWindow::makeHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  m_helpAction = named(menu->addAction(tr("&Explain what has the focus"), QKeySequence::HelpContents,
                                       m_workspace, &Workspace::showHelp),
                       "explainAction");
  QAction* pointed = QWhatsThis::createAction(this);  // Shift+F1, then a click
  pointed->setText(tr("Explain what is &pointed at"));
  pointed->setIcon({});
  menu->addAction(named(pointed, "whatsThisAction"));
  named(menu->addAction(tr("&About Deckpipe"), this, [this] { showExtra(m_about); }), "aboutAction");
}

}  // namespace deckpipe
