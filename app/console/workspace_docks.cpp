// SPDX-License-Identifier: GPL-3.0-or-later
// The docks of the workspace: made, arranged, shown, and named by titles or tabs.
#include <QAction>
#include <QChildEvent>
#include <QDockWidget>
#include <QMenu>
#include <QTabBar>
#include <QTabWidget>
#include <algorithm>
#include <cstring>
#include <utility>

#include "dock_frame.h"
#include "pane_cycle.h"
#include "panel/common/dock_title.h"
#include "workspace.h"

namespace deckpipe {
namespace {

constexpr int kDevicesLetters = 56;
constexpr int kTraceHeight = 208;
constexpr int kPageLines = 14;  // height of a page with its whole dial

}  // namespace

// A panel that gives itself a window title has that for its dock's, as long as it does.
Workspace::Dock Workspace::makeDock(const DockRow& row) {
  const QString title = tr(row.title), id = QLatin1String(row.id);
  const Panel panel = row.make(*this);
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(id);
  dock->setWidget(new DockFrame(panel.widget));
  connect(panel.widget, &QWidget::windowTitleChanged, dock,
          [dock, title](const QString& own) { dock->setWindowTitle(own.isEmpty() ? title : own); });
  // Checked while it is seen: Qt's own action hides what lies behind another's tab.
  auto* action = new QAction(title, dock);
  action->setObjectName(id + QStringLiteral("Action"));
  action->setShortcut(QKeySequence(QLatin1String(row.shortcut)));
  action->setCheckable(true);
  connect(dock, &QDockWidget::visibilityChanged, action, &QAction::setChecked);
  connect(action, &QAction::triggered, dock, [this, id = row.id](bool isOn) {
    if (isOn) {
      open(this->dock(id));
    } else {
      this->dock(id).dock->close();
    }
  });
  return {&row, dock, new DockTitle(dock), action, panel};
}

const Workspace::Dock& Workspace::dock(const char* id) const {
  return *std::ranges::find_if(m_docks,
                               [id](const Dock& dock) { return std::strcmp(dock.row->id, id) == 0; });
}

void Workspace::show(const Dock& dock) {
  dock.dock->show();
  dock.dock->raise();
}

// A person opens it to work in it.
void Workspace::open(const Dock& dock) {
  show(dock);
  focusNextPane({dock.dock}, false);
}

void Workspace::arrange() {
  for (const Dock& each : m_docks) {
    each.dock->setFloating(false);
    removeDockWidget(each.dock);
  }
  const auto firstOf = [this](Qt::DockWidgetArea area) {
    return std::ranges::find(m_docks, area, [](const Dock& dock) { return dock.row->area; })->dock;
  };
  for (const DockRow::Place place : {DockRow::Place::Own, DockRow::Place::Beside, DockRow::Place::Tab}) {
    for (const Dock& each : m_docks) {
      if (each.row->place != place) continue;
      const Qt::DockWidgetArea area = each.row->area;
      switch (place) {
        case DockRow::Place::Own: addDockWidget(area, each.dock); break;
        case DockRow::Place::Beside: splitDockWidget(firstOf(area), each.dock, Qt::Horizontal); break;
        case DockRow::Place::Tab: tabifyDockWidget(firstOf(area), each.dock); break;
      }
    }
  }
  for (const Dock& each : m_docks) each.dock->setVisible(each.row->isShownAtFirst);
  dock(kTraceDock).dock->raise();
  shareRoom();
}

// Sizes mean something to docks only once they are laid out.
void Workspace::shareRoom() {
  if (!isVisible()) return;
  resizeDocks({dock(kDevicesDock).dock}, {kDevicesLetters * fontMetrics().averageCharWidth()},
              Qt::Horizontal);
  // The tabs below the docks stand outside of their size.
  const int forTrace = height() - kPageLines * fontMetrics().height() - targetHeight(this);
  resizeDocks({dock(kTraceDock).dock}, {std::clamp(forTrace, 0, kTraceHeight)}, Qt::Vertical);
}

void Workspace::resetLayout() {
  setWaiting(false);
  m_kept.reset();
  m_isSettled = isVisible();
  arrange();
}

// Its detail takes room from the trace, so it is opened by hand alone.
void Workspace::showFrame(std::optional<std::uint64_t> frame) {
  m_view.frame = frame;
  if (!m_isShowing) dock(kDecodeDock).panel.show(m_view);
}

QList<QAction*> Workspace::dockActions() const {
  QList<QAction*> actions;
  for (const Dock& each : m_docks) actions.append(each.action);
  return actions;
}

QMenu* Workspace::createPopupMenu() {
  auto* menu = new QMenu(this);
  menu->addActions(dockActions());
  return menu;
}

QList<QWidget*> Workspace::panes() const {
  QList<QWidget*> panes;
  const auto addArea = [&](Qt::DockWidgetArea area) {
    for (const Dock& each : m_docks) {
      // A dock behind another's tab is not hidden, but shows nothing.
      const bool isSeen = each.dock->isVisible() && each.action->isChecked();
      if (each.row->area == area && isSeen) panes.append(each.dock);
    }
  };
  addArea(Qt::LeftDockWidgetArea);
  if (m_centre->isVisible()) panes.append(m_centre);
  addArea(Qt::RightDockWidgetArea);
  addArea(Qt::BottomDockWidgetArea);
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
    for (const Dock& each : m_docks) {
      const QList<QDockWidget*> others = tabifiedDockWidgets(each.dock);
      const bool isTabbed =
          std::ranges::any_of(others, [](QDockWidget* other) { return !other->isHidden(); });
      each.title->setCollapsed(isTabbed && !each.dock->isFloating());
    }
  }
  return QMainWindow::event(event);
}

}  // namespace deckpipe
