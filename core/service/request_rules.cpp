// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/request_rules.h"

#include <algorithm>

#include "protocol/device_types.h"

namespace deckpipe {

RequestSet requestsTakenBy(const Live& live, const Device& device) {
  const AddressBook& book = live.bus().book;
  if (device.kind == Device::Kind::Node || book.isDrive(device.address) || book.isForeign(device.address))
    return {};
  const Name former = book.formerHolder(device.address);
  if ((!former.isNull() && !former.isAkron()) || live.bus().isBeforeGap(device.lastHeard)) return {};
  RequestSet set = kTakenByAll;
  const auto* type = device.pin.isNull() ? nullptr : deviceTypeOf(device.pin.deviceType());
  if (type != nullptr) set |= type->takes;
  return set;
}

std::vector<DeviceKey> requestTargets(const Live& live) {
  std::vector<DeviceKey> keys;
  for (const Device& device : live.state.devices().all()) {
    if (device.kind == Device::Kind::Free || device.channel != live.channel || device.address == kNullAddress)
      continue;
    if (requestsTakenBy(live, device).isEmpty()) continue;
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
  if (const Device* found = live.find(device)) made.takes = requestsTakenBy(live, *found);
  return made;
}

}  // namespace deckpipe
