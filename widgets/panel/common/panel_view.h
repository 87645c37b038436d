// SPDX-License-Identifier: GPL-3.0-or-later
// What every panel is shown: the log at the cursor, the device that all of them follow, and what may begin. A
// panel takes it by setView(const PanelView&), on every tick and whenever something else is chosen.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "control/status.h"
#include "model/device_labels.h"
#include "state/log_view.h"

namespace deckpipe {

struct PanelView {
  PanelView(LogView shown = {}) : log(std::move(shown)) {}

  LogView log;
  DeviceKey device;                    // that is chosen; null: none
  QString name;                        // how the person calls it
  std::optional<std::uint64_t> frame;  // whose detail is shown
  DeviceLabels labels;
  // Of the live link, whatever the cursor shows. Never null.
  std::shared_ptr<const ServiceStatus> services = std::make_shared<const ServiceStatus>();
  bool isLive = false;       // the view stands at the live edge of a link: what is asked can be sent
  bool isMoving = false;     // the cursor goes on by itself
  bool isSimulated = false;  // behind the link is the simulated truck
};

}  // namespace deckpipe
