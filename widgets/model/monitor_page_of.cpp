// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/monitor_page_of.h"

#include <QCoreApplication>

#include "model/device_details.h"
#include "model/page_command.h"
#include "model/page_facts.h"
#include "model/page_lamps.h"
#include "model/page_stick.h"
#include "text/device_text.h"

namespace deckpipe {
namespace {

struct Page {
  Q_DECLARE_TR_FUNCTIONS(Page)
};

// One place for both axes: they differ in where they stand in the message only.
PageAxis axisOf(const Device& d, std::size_t axis, const PositionReading& reading, const auto& limits,
                bool areLimitsStale, Instant now) {
  PageAxis page;
  page.isStale = d.isStale(Periodic::Position);
  if (d.position.isKnown()) {
    page.reading = reading;
    page.age = now - d.position.at;
    page.plusStop = d.position.value().plusStop[axis];
    page.minusStop = d.position.value().minusStop[axis];
  }
  if (limits.isKnown()) page.limits = limits.value();
  page.areLimitsStale = areLimitsStale;
  return page;
}

PageDial dialOf(const State& state, const Device& d, Instant now) {
  PageDial dial;
  const PositionLimitStatus position = d.position.value();
  dial.rotation = axisOf(d, 0, position.rotation, d.rotationLimits, d.isStale(Periodic::RotationLimits), now);
  dial.elevation =
      axisOf(d, 1, position.elevation, d.elevationLimits, d.isStale(Periodic::ElevationLimits), now);
  const PageCommands commands = commandsTo(state, d);
  dial.rotation.command = commands.rotation;
  dial.elevation.command = commands.elevation;
  if (d.outputs.isKnown() && !d.isStale(Periodic::Outputs)) {
    dial.enable = d.outputs.value().enable;
    dial.stowed = d.outputs.value().stowed;
  }
  return dial;
}

QString placeText(const DeviceRow& row) {
  if (row.key.kind == DeviceKey::Kind::Node)
    return Page::tr("CANopen node %1 hex").arg(hexText(row.key.node.value));
  if (row.hasLostAddress()) return Page::tr("address lost");
  return Page::tr("address %1").arg(addressText(row.address));
}

void describeDevice(MonitorPageValues& page, const State& state, const Device& d, Instant now) {
  if (isMonitor(d)) page.dial = dialOf(state, d, now);
  page.stops = stopsOf(d, now);
  page.lamps = lampsOf(d, now);
  page.facts.push_back(faultsOf(d, now));
  page.facts.push_back(versionsOf(d, now));
  if (d.kind == Device::Kind::Node) page.facts.push_back(nodeOf(d, now));
}

void describeJoystick(MonitorPageValues& page, const Joystick& stick, Instant now) {
  page.stick = stickOf(stick, now);
  for (PageLampGroup& group : switchesOf(stick, now)) page.lamps.push_back(std::move(group));
  page.facts.insert(page.facts.begin(), joystickOf(stick, now));
}

}  // namespace

MonitorPageValues monitorPageOf(const LogView& view, const DeviceKey& key) {
  MonitorPageValues page;
  page.key = key;
  if (view.state == nullptr) return page;
  const State& state = *view.state;
  const Instant now = state.cursor().time;
  const std::optional<DeviceRow> row = deviceRow(state, key);
  if (!row) return page;
  page.isFound = true;
  page.key = row->key;
  page.title = deviceText(*row);
  page.type = typeText(*row);
  page.address = placeText(*row);
  page.channel = channelText(view, row->channel);
  page.age = row->age;
  page.health = row->health;

  const Device* device = findDevice(state, key);
  if (device != nullptr) describeDevice(page, state, *device, now);
  if (row->key.kind == DeviceKey::Kind::Node) return page;
  if (const Joystick* stick = state.channel(row->channel).joysticks.find(row->address);
      stick != nullptr && row->isJoystick)
    describeJoystick(page, *stick, now);
  page.facts.push_back(addressOf(state, row->channel, row->address, device));
  return page;
}

}  // namespace deckpipe
