// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_page_values.h"

#include <QCoreApplication>

#include <algorithm>

#include "model/device_details.h"
#include "model/page_parts.h"
#include "state/current.h"
#include "text/device_text.h"

namespace deckpipe {
namespace {

struct Page {
  Q_DECLARE_TR_FUNCTIONS(Page)
};

QString placeText(const DeviceRow& row) {
  if (row.key.kind == DeviceKey::Kind::Node)
    return Page::tr("CANopen node %1 hex").arg(hexText(row.key.node.value));
  if (row.hasLostAddress()) return Page::tr("address lost");
  return Page::tr("address %1").arg(addressText(row.address));
}

QString traceFilterOf(const DeviceRow& row, const QString& channel) {
  QString filter;
  if (row.key.kind == DeviceKey::Kind::Node) {
    filter = QStringLiteral("node=") + hexText(row.key.node.value);
  } else if (!row.hasLostAddress()) {
    filter = QStringLiteral("sa=") + hexText(row.address.value);
  }
  return filter.isEmpty() || channel.isEmpty() ? filter : filter + QStringLiteral(" and ch=") + channel;
}

std::vector<PageReason> reasonsOf(const Health& health, Instant now) {
  if (health.isFine())
    return {{Page::tr("It has no faults, and its messages come in time."), Severity::Fine}};
  std::vector<PageReason> reasons;
  for (const HealthReason& reason : healthReasons(health, now))
    reasons.push_back({reason.text, kHealthCauses[reason.cause].severity, healthAdvice(reason.cause)});
  return reasons;
}

void describeDevice(DevicePageValues& page, const State& state, const Device& d) {
  if (isMonitor(d)) {
    page.dial = dialOf(state, d);
    for (PageReason& reason : motionReasons(state, d, *page.dial)) page.reasons.push_back(std::move(reason));
    std::ranges::stable_sort(page.reasons, std::ranges::greater(), &PageReason::tone);
    if (std::optional<PageStick> stick = leadingStick(state, d)) page.sticks.push_back(std::move(*stick));
  }
  page.stops = stopsOf(state, d);
  page.lamps = lampsOf(state, d);
  page.facts.push_back(faultsOf(state, d));
  page.facts.push_back(versionsOf(state, d));
  if (d.kind == Device::Kind::Node) page.facts.push_back(nodeOf(state, d));
}

void describeJoystick(DevicePageValues& page, const State& state, Channel channel, const Joystick& stick,
                      const DeviceLabels& labels) {
  page.sticks.push_back(stickOf(state, channel, stick));
  if (stick.extended.isKnown()) page.sticks.push_back(gripOf(state, channel, stick));
  for (PageLampGroup& group : switchesOf(state, channel, stick)) page.lamps.push_back(std::move(group));
  page.facts.insert(page.facts.begin(),

                    {joystickOf(state, channel, stick), arbitrationOf(state, channel, stick, labels)});
}

}  // namespace

DevicePageValues devicePageOf(const LogView& view, const DeviceKey& key, const DeviceLabels& labels) {
  DevicePageValues page;
  page.key = key;
  if (view.state == nullptr) return page;
  const State& state = *view.state;
  const Instant now = state.cursor().time;
  const std::optional<DeviceRow> row = deviceRow(state, key);
  if (!row) return page;
  page.isFound = true;
  page.key = row->key;
  page.title = labels.of(row->key);
  if (page.title.isEmpty()) {
    page.title = deviceText(*row);
  } else {
    page.identity = deviceText(*row);
  }
  page.type = typeText(*row);
  page.address = placeText(*row);
  page.channel = channelText(view, row->channel);
  page.traceFilter = traceFilterOf(*row, page.channel);
  page.age = ageOf(state, row->channel, now - row->age.value_or(0ns));
  page.health = row->health;
  page.reasons = reasonsOf(row->health, now);

  if (const QString former = formerText(*row, labels); !former.isEmpty())
    page.reasons.insert(
        page.reasons.begin(),
        {Page::tr("Who is at this address has not said its PIN since the link came back: it %1.").arg(former),
         Severity::Unknown});
  const Device* device = findDevice(state, key);
  if (device != nullptr) describeDevice(page, state, *device);
  if (row->key.kind == DeviceKey::Kind::Node) return page;
  if (const Joystick* stick = state.channel(row->channel).joysticks.find(row->address);
      stick != nullptr && row->isJoystick)
    describeJoystick(page, state, row->channel, *stick, labels);
  if (isControl(*row) && !row->isJoystick) page.facts.push_back(sourcesOf(state, row->channel));
  page.facts.push_back(addressOf(state, row->channel, row->address, device));
  return page;
}

}  // namespace deckpipe
