// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/overview_of.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <map>

#include "model/device_details.h"
#include "model/page_parts.h"
#include "state/current.h"
#include "text/device_text.h"

namespace deckpipe {
namespace {

struct Overview {
  Q_DECLARE_TR_FUNCTIONS(Overview)
};

QString detailOf(const LogView& view, const DeviceRow& row) {
  QStringList parts;
  parts << typeText(row);
  if (!row.formerPin.isNull()) parts << Overview::tr("before the link went down");
  if (row.key.kind == DeviceKey::Kind::Pin) {
    parts << (row.hasLostAddress() ? Overview::tr("address lost") : addressText(row.address));
  }
  if (const QString channel = channelText(view, row.channel); !channel.isEmpty()) parts << channel;
  return parts.join(QStringLiteral(" · "));
}

QString stopsText(const PageStops& stops) {
  QStringList parts;
  for (std::size_t i = 2; i < stops.axes.size(); ++i) {
    for (const PageLamp* side : {&stops.axes[i].minus, &stops.axes[i].plus}) {
      if (side->state == Status2::On)
        parts << Overview::tr("%1 %2", "axis and its side, as Pattern Fog")
                     .arg(stops.axes[i].axis, side->label);
    }
  }
  return parts.join(QStringLiteral(", "));
}

}  // namespace

std::vector<OverviewMonitor> overviewOf(const LogView& view, const DeviceLabels& labels) {
  std::vector<OverviewMonitor> monitors;
  if (view.state == nullptr) return monitors;
  const State& state = *view.state;
  for (const Device& d : state.devices().all()) {
    if (d.kind == Device::Kind::Free || !isMonitor(d)) continue;
    const DeviceRow row = *deviceRow(state, keyOf(d));
    OverviewMonitor& m = monitors.emplace_back();
    m.key = row.key;
    m.title = labels.of(row.key);
    (m.title.isEmpty() ? m.title : m.identity) = deviceText(row);
    m.detail = detailOf(view, row);
    m.health = row.health;
    m.reasons = healthSentences(row.health, state.cursor().time);
    m.age = ageOf(state, d.channel, d.lastHeard);
    m.dial = dialOf(state, d);
    m.troubleTone = row.health.severity();
    if (m.troubleTone >= Severity::Warning) m.trouble = m.reasons.front();
    for (const PageReason& motion : motionReasons(state, d, m.dial)) {
      if (m.trouble.isEmpty()) {
        m.trouble = motion.text;
        m.troubleTone = motion.tone;
      }
      m.reasons << motion.text;
    }
    const PageStops stops = stopsOf(state, d);
    m.stops = stopsText(stops);
    m.areStopsStale = stops.isStale;
  }
  // Causes stand in the order of their gravity; in the same trouble the order of first appearance holds.
  std::ranges::stable_sort(monitors, {}, [](const OverviewMonitor& m) { return m.health.worst(); });
  return monitors;
}

QString overviewSummary(const std::vector<OverviewMonitor>& monitors) {
  std::map<HealthCause, int> counts;
  for (const OverviewMonitor& m : monitors) {
    const bool isFault = m.health.severity() == Severity::Fault;
    ++counts[isFault ? HealthCause::FaultsNamed : m.health.worst()];
  }
  QStringList parts;
  for (const auto& [cause, count] : counts) {
    parts << (cause == HealthCause::FaultsNamed
                  ? Overview::tr("%n fault(s)", nullptr, count)
                  : Overview::tr("%1 %2", "count of monitors, health").arg(count).arg(healthWord(cause)));
  }
  return Overview::tr("%n monitor(s): %1", nullptr, static_cast<int>(monitors.size()))
      .arg(parts.join(QStringLiteral(", ")));
}

}  // namespace deckpipe
