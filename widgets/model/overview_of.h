// SPDX-License-Identifier: GPL-3.0-or-later
// All monitors of a bus as plain values, those with the gravest trouble first, and how many have which: what the
// overview shows. A pure function of the view, like a page.
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
  QString
      trouble{};  // the worst of them, if it is a warning or graver; or else why it does not move as commanded
  Severity troubleTone = Severity::Plain;
  Age age;
  QString stops{};  // the hard stops that it stands at, of axes 3 to 5, which the dial does not show
  bool areStopsStale = false;
  DialValues dial;
  friend bool operator==(const OverviewMonitor&, const OverviewMonitor&) = default;
};

std::vector<OverviewMonitor> overviewOf(const LogView& view, const DeviceLabels& labels = {});

// "30 monitors: 1 silent, 1 fault, 1 disabled, 27 fine": each monitor counts once, by its worst cause, and all that
// are faults count together.
QString overviewSummary(const std::vector<OverviewMonitor>& monitors);

}  // namespace deckpipe
