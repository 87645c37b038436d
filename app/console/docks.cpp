// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks.h"

#include <QCoreApplication>

#include "panel/common/help_panel.h"
#include "panel/common/simulator_panel.h"
#include "panel/devices/device_list_panel.h"
#include "panel/events/event_panel.h"
#include "panel/page/device_page.h"
#include "panel/page/overview_panel.h"
#include "panel/pipe/terminal_panel.h"
#include "panel/poll/request_panel.h"
#include "panel/trace/decode_panel.h"
#include "panel/trace/trace_panel.h"
#include "workspace.h"

namespace deckpipe {
namespace {

template <typename P>
void connectPanel(P* panel, Workspace* workspace) {
  if constexpr (requires { &P::intended; })
    QObject::connect(panel, &P::intended, workspace, &Workspace::intended);
  if constexpr (requires { &P::unlockRequested; })
    QObject::connect(panel, &P::unlockRequested, workspace, &Workspace::unlockRequested);
  if constexpr (requires { &P::simulatorIntended; })
    QObject::connect(panel, &P::simulatorIntended, workspace, &Workspace::simulatorIntended);
  if constexpr (requires { &P::frameRequested; })
    QObject::connect(panel, &P::frameRequested, workspace, &Workspace::frameRequested);
  if constexpr (requires { &P::seekRequested; })
    QObject::connect(panel, &P::seekRequested, workspace, &Workspace::seekRequested);
  if constexpr (requires { &P::deviceSelected; })
    QObject::connect(panel, &P::deviceSelected, workspace, &Workspace::selectDevice);
  if constexpr (requires { &P::pageRequested; })
    QObject::connect(panel, &P::pageRequested, workspace, &Workspace::showPageOf);
  if constexpr (requires { &P::traceRequested; })
    QObject::connect(panel, &P::traceRequested, workspace, &Workspace::traceDevice);
  if constexpr (requires { &P::labelEdited; })
    QObject::connect(panel, &P::labelEdited, workspace, &Workspace::editLabel);
  if constexpr (requires { &P::currentFrameChanged; })
    QObject::connect(panel, &P::currentFrameChanged, workspace, &Workspace::showFrame);
}

template <typename P>
Panel make(Workspace& workspace) {
  auto* panel = new P(&workspace);
  connectPanel(panel, &workspace);
  return {panel, [panel](const PanelView& view) {
            if constexpr (requires { panel->setView(view); }) panel->setView(view);
          }};
}

using enum DockRow::Place;
constexpr auto kLeft = Qt::LeftDockWidgetArea, kRight = Qt::RightDockWidgetArea,
               kBottom = Qt::BottomDockWidgetArea;
constexpr DockRow kRows[] = {
    {"devicesDock", QT_TRANSLATE_NOOP("deckpipe::Workspace", "Devices"), "Alt+1", kLeft, Own, true, false,
     make<DeviceListPanel>},
    {"traceDock", QT_TRANSLATE_NOOP("deckpipe::Workspace", "Trace"), "Alt+2", kBottom, Own, true, false,
     make<TracePanel>},
    {"eventsDock", QT_TRANSLATE_NOOP("deckpipe::Workspace", "Events"), "Alt+3", kBottom, Tab, true, false,
     make<EventPanel>},
    {"terminalDock", QT_TRANSLATE_NOOP("deckpipe::Workspace", "Data pipe"), "Alt+4", kBottom, Tab, true,
     false, make<TerminalPanel>},
    // It takes room only while a frame is chosen.
    {"decodeDock", QT_TRANSLATE_NOOP("deckpipe::Workspace", "Frame in detail"), "Alt+5", kBottom, Beside,
     false, false, make<DecodePanel>},
    // The page has the room until somebody wants to ask.
    {"requestsDock", QT_TRANSLATE_NOOP("deckpipe::Workspace", "Requests"), "Alt+6", kRight, Own, false, false,
     make<RequestPanel>},
    {"simulatorDock", QT_TRANSLATE_NOOP("deckpipe::Workspace", "Simulated truck"), "Alt+7", kRight, Tab,
     false, true, make<SimulatorPanel>},
    {"helpDock", QT_TRANSLATE_NOOP("deckpipe::Workspace", "Explanation"), "Alt+8", kRight, Own, false, false,
     make<HelpPanel>},
};

}  // namespace

std::span<const DockRow> dockRows() { return kRows; }
Panel makeDevicePage(Workspace& workspace) { return make<DevicePage>(workspace); }
Panel makeOverview(Workspace& workspace) { return make<OverviewPanel>(workspace); }

}  // namespace deckpipe
