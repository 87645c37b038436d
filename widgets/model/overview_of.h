// SPDX-License-Identifier: GPL-3.0-or-later
// All monitors of a bus as plain values, in order of first appearance: what each tile of the overview shows.
// A pure function of the view, like a page.
#pragma once

#include <vector>

#include "model/device_page_values.h"
#include "state/log_view.h"

namespace deckpipe {

struct OverviewMonitor {
  DeviceKey key{};
  QString title{};     // the person's label, or the PIN
  QString identity{};  // PIN, where the title is a label
  QString detail{};    // type, address, channel if there are several
  Health health;
  QStringList reasons{};  // sentences, the worst first
  Age age;
  QString stops{};  // the hard stops that it stands at, of axes 3 to 5, which the dial does not show
  bool areStopsStale = false;
  DialValues dial;
  friend bool operator==(const OverviewMonitor&, const OverviewMonitor&) = default;
};

std::vector<OverviewMonitor> overviewOf(const LogView& view, const DeviceLabels& labels = {});

}  // namespace deckpipe
