// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/ask_rules.h"

#include <algorithm>

namespace deckpipe {

AskSet asksTakenBy(const Live& live, const Device& device) {
  AskSet set;
  if (device.kind == Device::Kind::Node || live.bus().book.isDrive(device.address)) return set;
  for (const Ask ask : kAllOf<Ask>) {
    const auto& types = kAskFacts[ask].takenBy;
    if (types[0] == 0 || (!device.pin.isNull() && std::ranges::count(types, device.pin.deviceType()) > 0))
      set.add(ask);
  }
  return set;
}

std::vector<DeviceKey> askableDevices(const Live& live) {
  std::vector<DeviceKey> keys;
  for (const Device& device : live.state.devices().all()) {
    if (device.kind == Device::Kind::Free || device.channel != live.channel || device.address == kNullAddress)
      continue;
    if (asksTakenBy(live, device).isEmpty()) continue;
    keys.push_back(live.canonical(DeviceKey::at(live.channel, device.address)));
  }
  return keys;
}

DeviceServices& statusOf(const Live& live, const DeviceKey& device, ServiceStatus& in) {
  const auto known = std::ranges::find(in.devices, device, &DeviceServices::device);
  if (known != in.devices.end()) return *known;
  DeviceServices& made = in.devices.emplace_back();
  made.device = device;
  made.address = live.addressOf(device).value_or(kNullAddress);
  if (const Device* found = live.find(device)) made.takes = asksTakenBy(live, *found);
  return made;
}

}  // namespace deckpipe
