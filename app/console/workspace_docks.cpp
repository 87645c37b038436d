// SPDX-License-Identifier: GPL-3.0-or-later
// The docks of the workspace: made, arranged, shown, and named by titles or tabs.
#include <QAction>
#include <QChildEvent>
#include <QDockWidget>
#include <QMenu>
#include <QTabBar>
#include <algorithm>
#include <utility>

#include "model/decode_model.h"
#include "panel/dock_title.h"
#include "workspace.h"

namespace deckpipe {
namespace {

constexpr int kDevicesLetters = 56;
constexpr int kDetailWidth = 520, kTraceHeight = 208;

}  // namespace

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

}  // namespace deckpipe
