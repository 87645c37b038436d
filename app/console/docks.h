// SPDX-License-Identifier: GPL-3.0-or-later
// The docks of the workspace, a row each. To add one: a panel that takes setView(const PanelView&), its row
// in docks.cpp, and there a wire for each of its signals that the workspace acts on.
#pragma once

#include <Qt>
#include <functional>
#include <span>

#include "panel/common/panel_view.h"

class QWidget;

namespace deckpipe {

class Workspace;

// A panel, and how it is shown a view.
struct Panel {
  QWidget* widget = nullptr;
  std::function<void(const PanelView&)> show;
};

struct DockRow {
  enum class Place {
    Own,
    Beside,  // to the right of the first dock of its area
    Tab,     // behind the first dock of its area
  };
  const char* id;     // its object name, which stands in saved layouts: never changes
  const char* title;  // in English; translated in the context Workspace
  const char* shortcut;
  Qt::DockWidgetArea area;
  Place place;
  bool isShownAtFirst;
  bool isOfDemo;  // it is there only while the simulated truck runs
  Panel (*make)(Workspace& workspace);
};

// Docks that the workspace names.
inline constexpr const char *kDevicesDock = "devicesDock", *kTraceDock = "traceDock",
                            *kDecodeDock = "decodeDock", *kRequestsDock = "requestsDock",
                            *kHelpDock = "helpDock";

// In the order of the menu. In each area a dock of its own place comes first.
std::span<const DockRow> dockRows();
// Another one where docks were added, renamed or taken out: an arrangement of other docks is not restored.
int layoutVersion();

// The pages in the middle.
Panel makeDevicePage(Workspace& workspace);
Panel makeOverview(Workspace& workspace);

}  // namespace deckpipe
