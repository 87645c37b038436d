// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/ask_rules.h"

#include <algorithm>

namespace deckpipe {

AskSet asksTakenBy(const Live& live, const Device& device) {
  AskSet set;
  if (device.kind == Device::Kind::Node || live.bus().book.isDrive(device.address)) return set;
  for (std::size_t i = 0; i < kAsks; ++i) {
    const auto& types = kAskRules[i].takenBy;
    if (types[0] == 0 || (!device.pin.isNull() && std::ranges::count(types, device.pin.deviceType()) > 0))
      set.add(static_cast<Ask>(i));
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

}  // namespace deckpipe
