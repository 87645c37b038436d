// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks.h"

#include <QCoreApplication>
#include <algorithm>
#include <string_view>

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

// A signal of a panel, and what of the workspace it reaches.
template <auto Signal, auto Reached>
struct Wire {
  static constexpr auto kSignal = Signal;
  static constexpr auto kReached = Reached;
};
using W = Workspace;

template <typename P, typename... Wires>
P* makeWired(Workspace& workspace) {
  auto* panel = new P(&workspace);
  (QObject::connect(panel, Wires::kSignal, &workspace, Wires::kReached), ...);
  return panel;
}

template <typename P, typename... Wires>
Panel make(Workspace& workspace) {
  auto* panel = makeWired<P, Wires...>(workspace);
  return {panel, [panel](const PanelView& view) { panel->setView(view); }};
}

// A panel that shows nothing of a log.
template <typename P, typename... Wires>
Panel makeApart(Workspace& workspace) {
  return {makeWired<P, Wires...>(workspace), [](const PanelView&) {}};
}

constexpr auto makeDevices = make<DeviceListPanel, Wire<&DeviceListPanel::deviceSelected, &W::selectDevice>,
                                  Wire<&DeviceListPanel::labelEdited, &W::editLabel>>;
constexpr auto makeTrace = make<TracePanel, Wire<&TracePanel::currentFrameChanged, &W::showFrame>,
                                Wire<&TracePanel::detailRequested, &W::showDetail>,
                                Wire<&TracePanel::cursorRequested, &W::frameRequested>>;
constexpr auto makeEvents = make<EventPanel, Wire<&EventPanel::seekRequested, &W::seekRequested>>;
constexpr auto makeTerminal = make<TerminalPanel, Wire<&TerminalPanel::intended, &W::intended>,
                                   Wire<&TerminalPanel::unlockRequested, &W::unlockRequested>>;
constexpr auto makeRequests = make<RequestPanel, Wire<&RequestPanel::intended, &W::intended>,
                                   Wire<&RequestPanel::unlockRequested, &W::unlockRequested>,
                                   Wire<&RequestPanel::unlockForRequested, &W::unlockForRequested>,
                                   Wire<&RequestPanel::frameRequested, &W::frameRequested>>;
constexpr auto makeSimulator =
    makeApart<SimulatorPanel, Wire<&SimulatorPanel::simulatorIntended, &W::simulatorIntended>>;

using enum DockRow::Place;
constexpr auto kLeft = Qt::LeftDockWidgetArea, kRight = Qt::RightDockWidgetArea,
               kBottom = Qt::BottomDockWidgetArea;
constexpr DockRow kRows[] = {
    {kDevicesDock, QT_TRANSLATE_NOOP("deckpipe::Workspace", "Devices"), "Alt+1", kLeft, Own, true, false,
     makeDevices},
    {kTraceDock, QT_TRANSLATE_NOOP("deckpipe::Workspace", "Trace"), "Alt+2", kBottom, Own, true, false,
     makeTrace},
    {"eventsDock", QT_TRANSLATE_NOOP("deckpipe::Workspace", "Events"), "Alt+3", kBottom, Tab, true, false,
     makeEvents},
    {"terminalDock", QT_TRANSLATE_NOOP("deckpipe::Workspace", "Data pipe"), "Alt+4", kBottom, Tab, true,
     false, makeTerminal},
    // The trace has the room until somebody wants to take a frame apart.
    {kDecodeDock, QT_TRANSLATE_NOOP("deckpipe::Workspace", "Frame in detail"), "Alt+5", kBottom, Beside,
     false, false, make<DecodePanel>},
    // The page has the room until somebody wants to ask.
    {kRequestsDock, QT_TRANSLATE_NOOP("deckpipe::Workspace", "Requests"), "Alt+6", kRight, Own, false, false,
     makeRequests},
    {"simulatorDock", QT_TRANSLATE_NOOP("deckpipe::Workspace", "Simulated truck"), "Alt+7", kRight, Tab,
     false, true, makeSimulator},
    {kHelpDock, QT_TRANSLATE_NOOP("deckpipe::Workspace", "Explanation"), "Alt+8", kRight, Own, false, false,
     makeApart<HelpPanel>},
};

constexpr int versionOf(std::span<const DockRow> rows) {
  unsigned hash = 2166136261u;  // FNV-1a
  for (const DockRow& row : rows) {
    for (const char letter : std::string_view(row.id))
      hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
  }
  return static_cast<int>(hash >> 1);
}

constexpr bool isNamed(std::string_view id) {
  return std::ranges::find(kRows, id, &DockRow::id) != std::end(kRows);
}
static_assert(isNamed(kDevicesDock) && isNamed(kTraceDock) && isNamed(kDecodeDock) &&
              isNamed(kRequestsDock) && isNamed(kHelpDock));
static_assert(std::ranges::all_of(kRows, [](const DockRow& row) {
  return std::ranges::find(kRows, row.area, &DockRow::area)->place == Own;
}));

}  // namespace

std::span<const DockRow> dockRows() { return kRows; }
int layoutVersion() { return versionOf(kRows); }
Panel makeDevicePage(Workspace& workspace) {
  return make<DevicePage, Wire<&DevicePage::traceRequested, &W::traceDevice>>(workspace);
}
Panel makeOverview(Workspace& workspace) {
  return make<OverviewPanel, Wire<&OverviewPanel::pageRequested, &W::showPageOf>>(workspace);
}

}  // namespace deckpipe
